// Pictures of measurements, as the JSON that their modules draw (src/report/page/README.md): curves over an axis, polar
// plots, colours of cells, bars, circular tests in the machine.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/page/page.hpp"

namespace plumbline::report {

/// Colour and pattern of a line or a bar: 1 to 6.
using Style = int;

struct Curve {
  std::string name;
  Style style = 1;
  Style dash = 0;              // the pattern of another style; 0: its own
  std::vector<double> values;  // in the panel's unit; what is not finite is missing
  bool has_points = false;     // each value is marked
};
struct CurveLimit {
  std::string name;
  double value = 0;
};
struct CurvePanel {
  std::string name, unit;
  std::vector<Curve> curves;
  int digits = 3;         // after the point, in words
  double quantum = 1e-5;  // to which values are rounded
  std::vector<CurveLimit> limits = {};
  bool from_zero = false;
};
/// Panels that are shown together.
struct CurveGroup {
  std::string name;
  std::vector<double> x;  // rising
  std::vector<CurvePanel> panels;
  std::string note = {};
};
struct CurveAxis {
  std::string name, unit = {};
  int digits = 1;
  std::vector<std::string> names = {};                  // of whole numbers, in place of these
  std::optional<std::pair<double, double>> range = {};  // else as far as values go
};
struct CurveOptions {
  std::string choose = "Run";  // what groups are
  bool same_scale = true;      // panels of one unit
  std::string words = {};
};
Json curves_section(std::string title, const CurveAxis& axis, const std::vector<CurveGroup>& groups,
                    const CurveOptions& options = {});

/// Deviations from a nominal circle.
struct PolarCurve {
  std::string name;
  Style style = 1;
  Style dash = 0;                 // as a curve's
  std::vector<double> angle_deg;  // from +X towards +Y, within one turn, rising
  std::vector<double> deviation_um;
};
struct PolarFigure {
  std::string name;
  double value = 0;
  std::string unit = "um";
  int digits = 2;
};
struct PolarGroup {
  std::string name;
  double radius_mm = 0;  // of the nominal circle
  std::vector<PolarCurve> curves;
  std::vector<PolarFigure> figures = {};
  std::string note = {};
};
Json polar_section(std::string title, const std::vector<PolarGroup>& groups, std::string words = {});

struct HeatAxis {
  std::string name, unit = {};
  std::vector<std::string> labels = {};  // or
  std::vector<double> values = {};
};
struct HeatPlane {
  std::string name;
  std::vector<double> values;     // row by row; what is not finite has a reason
  std::vector<int> reasons = {};  // alike: which of the section's, -1: none
};
struct HeatFigure {
  std::string name, unit = {};
  int digits = 2;
  std::vector<HeatPlane> planes;
  std::optional<std::pair<double, double>> range = {};  // of the colours; else as far as values go
  bool is_logarithmic = false;
  double quantum = 1e-3;
};
struct HeatMap {
  HeatAxis rows, columns;
  std::vector<HeatFigure> figures;
  std::string choose_plane = "Plane";
  std::vector<std::string> reasons = {};  // why cells have no value
  bool has_square_cells = false;
  std::string words = {};
};
Json heat_section(std::string title, const HeatMap& map);

struct Bar {
  std::optional<double> value;
  std::optional<double> low = {}, high = {};  // of its interval
  Style style = 1;
  std::string why = {};  // there is no value
};
struct BarRow {
  std::string name;
  std::vector<Bar> bars;  // one of each of the series
};
struct BarChart {
  std::string unit;
  int digits = 2;
  std::vector<std::pair<std::string, Style>> series;
  std::vector<BarRow> rows;
  std::vector<CurveLimit> references = {};  // lines across
  std::string words = {};
};
Json bars_section(std::string title, const BarChart& chart);

}  // namespace plumbline::report

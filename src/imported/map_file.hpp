// A map: how the files of an instrument or a control are written, and which circles they hold.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/dataset.hpp"

namespace plumbline::imported {

/// How the text of a table is written.
struct TableForm {
  std::string encoding = "auto";                       // or utf-8, utf-16le, utf-16be, latin-1
  char delimiter = ',';                                // ' ': any number of blanks
  char decimal = '.';                                  // or ','
  std::vector<std::string> comments;                   // lines that begin so are passed over
  std::size_t skip_lines = 0;                          // before everything else
  bool header = true;                                  // a line names the columns; else they are counted
  std::size_t unit_lines = 0;                          // below it
  std::vector<std::string> missing{"", "NaN", "nan"};  // where there is no reading
  std::string lost;                                    // a line of this word alone says that samples were lost
};

/// What a column may be.
enum class Quantity { time, angle, radial, torque1, torque2, torque3, torque4, torque5, torque6, x, y };
inline constexpr std::size_t kQuantities = 11;
std::string_view to_text(Quantity quantity);

/// A column of the file and what is made of it: SI = (number - minus) x factor, minus in the file's unit.
struct ColumnSource {
  Quantity quantity = Quantity::time;
  std::string name;        // in the header; empty: by its number
  std::size_t number = 0;  // from 1
  std::string unit;
  double factor = 1;
  double minus = 0;
  Place place;  // in the map
};

struct Source {
  TableForm form;
  std::vector<ColumnSource> columns;

  const ColumnSource* find(Quantity quantity) const;
};

/// A circle that is to become a run.
struct MapRun {
  measure::Run run;                   // what is said of it; no samples. run.file: the file that holds it
  std::string motors_file;            // empty: the torques stand in the same file
  std::size_t circle = 0;             // of those in the file, from 1; 0: the next one
  std::optional<double> start_angle;  // where its first sample is, rad, if only the time tells the angle
  std::optional<double> run_in;       // rad before the turn that is measured; nothing: as much as after it
};

struct Map {
  std::string machine;
  Source source;
  std::optional<Source> motors;  // of files of their own
  double motors_later = 0;       // s, that the motors' clock is ahead of the bar's
  std::size_t samples = 0;       // of a turn, that readings are averaged to; 0: as they are
  std::vector<MapRun> runs;
};

/// Refuses with toml-syntax, import-map, import-key, import-value, and what measure::read_run refuses.
Map read_map(const std::string& path);
Map parse_map(std::string text, const std::string& file);

/// A map to start from, with comments: "general" or the name of a preset. Refuses with import-value another name.
std::string_view example_map(std::string_view name);
std::vector<std::string_view> example_names();

}  // namespace plumbline::imported

#include "report/page/run_sections.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "report/page/measured_sections.hpp"

namespace plumbline::report {
namespace {

using jobs::ModelProfile;
using jobs::RunProfile;
using jobs::RunsAndModels;

constexpr Style kMeasured = 6;
constexpr Style kWhole = 1;  // the pattern without gaps

// Simulated and compensated, of the first two models.
Style simulated_style(std::size_t model) { return 1 + static_cast<int>(model % 2); }
Style dashed(Style style) { return style == 1 ? 2 : 4; }
Style compensated_style(std::size_t model) { return 3 + static_cast<int>(model % 2); }

bool any_bar(const RunsAndModels& of) {
  return std::any_of(of.runs.begin(), of.runs.end(), [](const RunProfile& run) { return run.radial.size() > 0; });
}
bool any_torque(const RunsAndModels& of) {
  return std::any_of(of.runs.begin(), of.runs.end(), [](const RunProfile& run) { return run.run.has_torque(); });
}

double rms_of(const std::array<double, machine::kStruts>& rms) {
  const double squares = std::inner_product(rms.begin(), rms.end(), rms.begin(), 0.0);
  return std::sqrt(squares / static_cast<double>(rms.size()));
}

// "centre 0, 100, -1008 mm, A -22 B 0 deg, ccw, F1000"
std::string design_text(const measure::Run& run) {
  const Vector3<double> c = run.centre_W / kMm;
  std::string text =
      fmt::format("Centre {:.4g}, {:.4g}, {:.4g} mm, radius {:.6g} mm, A {:.4g} B {:.4g} C {:.4g} deg, {}, F{:.6g}",
                  c.x(), c.y(), c.z(), run.radius / kMm, run.tilt.x() / kDeg, run.tilt.y() / kDeg, run.tilt.z() / kDeg,
                  to_text(run.direction), run.feed / kMmPerMin);
  if (run.payload_mass > 0) text += fmt::format(", {:.4g} kg at the tip", run.payload_mass);
  return text + ".";
}

PolarGroup polar_group(const RunProfile& run, const RunsAndModels& of_all) {
  const std::vector<std::string>& models = of_all.models;
  PolarGroup group{run.run.id, run.run.radius / kMm};
  const std::vector<double> angle = in_unit(run.angle, kDeg);
  group.curves.push_back({of_all.readings, kMeasured, kWhole, angle, in_unit(run.radial, kUm)});
  const measure::CircularityFigures& f = *run.figures;
  group.figures = {{"Circularity, " + of_all.readings, f.least_squares / kUm},
                   {"Circular deviation G", f.minimum_zone / kUm},
                   {"Radial deviation F max", f.radial_max / kUm},
                   {"Radial deviation F min", f.radial_min / kUm}};
  for (std::size_t m = 0; m < run.models.size(); ++m) {
    const ModelProfile& model = run.models[m];
    const std::string of = models.size() > 1 ? " (" + models[m] + ")" : "";
    group.curves.push_back(
        {"simulated" + of, simulated_style(m), dashed(simulated_style(m)), angle, in_unit(model.radial, kUm)});
    group.curves.push_back({"compensated" + of, compensated_style(m), 0, angle, in_unit(model.compensated, kUm)});
    group.figures.push_back({"Circularity, compensated" + of, model.compensated_circularity / kUm});
    group.figures.push_back({"Left by the model, rms" + of, *model.radial_rms / kUm});
  }
  group.note = design_text(run.run);
  return group;
}

// A column of a run or of a model, in a file's unit.
using ColumnOf = Eigen::VectorXd (*)(const RunProfile& run, const ModelProfile* model, int channel);

Eigen::VectorXd column(const RunProfile& run, const ModelProfile* model, int channel) {
  if (channel == 0) return model == nullptr ? run.radial : model->radial;
  const auto motor = static_cast<std::size_t>(channel - 1);
  return model == nullptr ? run.torque[motor] : model->torque[motor];
}
Eigen::VectorXd left(const RunProfile& run, const ModelProfile* model, int channel) {
  return column(run, nullptr, channel) - column(run, model, channel);
}

CurvePanel channel_panel(const RunProfile& run, const RunsAndModels& of, int channel, ColumnOf column_of,
                         bool with_measured) {
  const bool bar = channel == 0;
  CurvePanel panel{bar ? "Bar" : fmt::format("Motor {}", channel), bar ? "um" : "N m"};
  panel.digits = bar ? 2 : 3;
  panel.quantum = bar ? 1e-3 : 1e-5;
  const double unit = bar ? kUm : 1;
  if (with_measured)
    panel.curves.push_back({of.readings, kMeasured, kWhole, in_unit(column(run, nullptr, channel), unit)});
  for (std::size_t m = 0; m < run.models.size(); ++m) {
    const std::string name = with_measured ? "simulated" : "measured minus simulated";
    const Style style = simulated_style(m);
    panel.curves.push_back({of.models.size() > 1 ? fmt::format("{} ({})", name, of.models[m]) : name, style,
                            with_measured ? dashed(style) : 0, in_unit(column_of(run, &run.models[m], channel), unit)});
  }
  return panel;
}

Json along_turn(const RunsAndModels& of, std::string title, ColumnOf column_of, bool with_measured) {
  std::vector<CurveGroup> groups;
  for (const RunProfile& run : of.runs) {
    CurveGroup group{run.run.id, in_unit(run.angle, kDeg)};
    group.note = design_text(run.run);
    if (run.radial.size() > 0) group.panels.push_back(channel_panel(run, of, 0, column_of, with_measured));
    for (int channel = 1; run.run.has_torque() && channel <= machine::kStruts; ++channel) {
      group.panels.push_back(channel_panel(run, of, channel, column_of, with_measured));
    }
    if (!group.panels.empty()) groups.push_back(std::move(group));
  }
  if (groups.empty()) return nullptr;
  return curves_section(std::move(title), {.name = "Angle", .unit = "deg", .range = {{0, 360}}}, groups);
}

BarChart chart_of(const RunsAndModels& of, std::string unit, int digits) {
  BarChart chart{std::move(unit), digits};
  for (std::size_t m = 0; m < of.models.size(); ++m) chart.series.emplace_back(of.models[m], simulated_style(m));
  return chart;
}

}  // namespace

std::vector<double> in_unit(const Eigen::VectorXd& values, double unit) {
  std::vector<double> list(values.begin(), values.end());
  for (double& value : list) value /= unit;
  return list;
}

Json circles_section(const RunsAndModels& of, std::string title) {
  std::vector<PolarGroup> groups;
  for (const RunProfile& run : of.runs) {
    if (run.radial.size() > 0) groups.push_back(polar_group(run, of));
  }
  if (groups.empty()) return nullptr;
  std::string words = "Readings of the bar minus its length, without the mean and the first harmonic of what was " +
                      of.readings +
                      ", which the centring of the balls makes. G and F as ISO 230-4 has them: F with the mean kept.";
  if (!of.models.empty()) {
    words += " Compensated: what the bar would read if the program were compensated with the model; noise stays in it.";
  }
  return polar_section(std::move(title), groups, words);
}

std::vector<Json> left_by_run_sections(const RunsAndModels& of) {
  std::vector<Json> sections;
  if (of.models.empty()) return sections;
  if (any_bar(of)) {
    BarChart chart = chart_of(of, "um", 2);
    chart.words = "Rms of the bar readings, measured minus simulated, the set-up of the run fitted.";
    for (const RunProfile& run : of.runs) {
      BarRow row{run.run.id, {}};
      for (std::size_t m = 0; m < run.models.size(); ++m) {
        const std::optional<double>& rms = run.models[m].radial_rms;
        row.bars.push_back(
            {rms ? std::optional(*rms / kUm) : std::nullopt, {}, {}, simulated_style(m), "not measured"});
      }
      chart.rows.push_back(std::move(row));
    }
    sections.push_back(bars_section("Bar: what is left, by run", chart));
  }
  if (any_torque(of)) {
    BarChart chart = chart_of(of, "N m", 4);
    chart.words = "Rms of the torques of all six motors, measured minus simulated.";
    for (const RunProfile& run : of.runs) {
      BarRow row{run.run.id, {}};
      for (std::size_t m = 0; m < run.models.size(); ++m) {
        const bool measured = run.run.has_torque();
        row.bars.push_back({measured ? std::optional(rms_of(run.models[m].torque_rms)) : std::nullopt,
                            {},
                            {},
                            simulated_style(m),
                            "not measured"});
      }
      chart.rows.push_back(std::move(row));
    }
    sections.push_back(bars_section("Motor torques: what is left, by run", chart));
  }
  return sections;
}

Json torque_map_section(const RunsAndModels& of, std::string title) {
  if (of.models.empty() || !any_torque(of)) return nullptr;
  HeatMap map;
  map.rows = {"Run"};
  map.columns = {"Motor", "", {"1", "2", "3", "4", "5", "6"}};
  map.reasons = {"not measured"};
  for (const RunProfile& run : of.runs) map.rows.labels.push_back(run.run.id);
  for (std::size_t m = 0; m < of.models.size(); ++m) {
    HeatPlane plane{""};
    for (const RunProfile& run : of.runs) {
      for (const double rms : run.models[m].torque_rms) {
        plane.values.push_back(run.run.has_torque() ? rms : std::nan(""));
        plane.reasons.push_back(run.run.has_torque() ? -1 : 0);
      }
    }
    map.figures.push_back({"rms torque left, " + of.models[m], "N m", 4, {std::move(plane)}, {}, false, 1e-5});
  }
  return heat_section(std::move(title), map);
}

Json turn_section(const RunsAndModels& of, std::string title) { return along_turn(of, std::move(title), column, true); }

Json left_along_turn_section(const RunsAndModels& of, std::string title) {
  if (of.models.empty()) return nullptr;
  return along_turn(of, std::move(title), left, false);
}

void add_section(Page& page, Json section) {
  if (!section.is_null()) page.sections.push_back(std::move(section));
}

}  // namespace plumbline::report

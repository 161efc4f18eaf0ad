#include "report/program/simulation_text.hpp"

#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "report/program/csv_columns.hpp"
#include "report/program/expected_text.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

constexpr std::string_view kSimulationColumns =
    "line,motion,time_s,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,dx_um,dy_um,dz_um,rx_urad,ry_urad,rz_urad,"
    "length1_mm,length2_mm,length3_mm,length4_mm,length5_mm,length6_mm,"
    "nut_tension1_N,nut_tension2_N,nut_tension3_N,nut_tension4_N,nut_tension5_N,nut_tension6_N,"
    "torque1_Nm,torque2_Nm,torque3_Nm,torque4_Nm,torque5_Nm,torque6_Nm\n";

std::string_view simulated_name(nc::MotionKind kind) {
  switch (kind) {
    case nc::MotionKind::rapid:
      return "rapid";
    case nc::MotionKind::arc:
      return "arc";
    default:
      return "feed";
  }
}

}  // namespace

std::string_view simulation_columns() { return kSimulationColumns.substr(0, kSimulationColumns.size() - 1); }

SimulationTable::SimulationTable(OutputFile& output, bool with_expected)
    : output_(output), with_expected_(with_expected) {
  output_.write(simulation_columns());
  if (with_expected_) output_.write(expected_columns());
  output_.write("\n");
}

void SimulationTable::add(const jobs::SimulatedPoint& point) {
  row_.clear();
  fmt::format_to(std::back_inserter(row_), "{},{},{:.6f}", point.line, simulated_name(point.motion), point.time_s);
  for (const Axis axis : kAllAxes) {
    row_ += ',';
    append_decimal(row_, point.pose[axis], 6);
  }
  append_columns(row_, point.error.head<3>(), kUm, 4);
  append_columns(row_, point.error.tail<3>(), kUrad, 4);
  append_columns(row_, point.lengths, kMm, 7);
  append_columns(row_, point.nut_tension, 1, 4);
  append_columns(row_, point.torque, 1, 6);
  if (with_expected_) append_expected(row_, point.doubt);
  row_ += '\n';
  output_.write(row_);
}

std::string simulation_text(const jobs::SimulationSummary& summary) {
  const std::string beyond =
      summary.beyond_travel == 0 ? "" : fmt::format(" ({} beyond the limits)", count_text(summary.beyond_travel));
  std::string text = fmt::format("{}{} in {}", count_text(summary.points, "point"), beyond, time_text(summary.seconds));
  if (summary.points > 0) {
    text += fmt::format(": the tip up to {:.3f} um off (line {}), rms {:.3f} um", summary.largest_um,
                        summary.largest_line, summary.rms_um);
  }
  text += '\n';
  if (summary.untimed_moves > 0) {
    text += fmt::format("time not known of {} under G95, or in strokes that a cycle makes in its own way\n",
                        count_text(summary.untimed_moves, "move"));
  }
  if (summary.passed_moves > 0) {
    text += fmt::format("{} left out of the table: machine coordinates, probing, or from where nobody knows\n",
                        count_text(summary.passed_moves, "move"));
  }
  return text + expected_text(summary.expected);
}

std::string simulation_json(const jobs::SimulationSummary& summary) {
  const nlohmann::ordered_json json{{"plumbline", "simulation 1"},
                                    {"points", summary.points},
                                    {"passed_moves", summary.passed_moves},
                                    {"beyond_travel", summary.beyond_travel},
                                    {"largest_um", summary.largest_um},
                                    {"largest_line", summary.largest_line},
                                    {"rms_um", summary.rms_um},
                                    {"seconds", summary.seconds},
                                    {"untimed_moves", summary.untimed_moves},
                                    {"expected", expected_json(summary.expected)}};
  return json.dump(2) + "\n";
}

std::string dataset_simulation_text(const jobs::DatasetSimulationSummary& summary) {
  return fmt::format("{}, {}\n", count_text(summary.runs, "run"), count_text(summary.samples, "sample"));
}

}  // namespace plumbline::report

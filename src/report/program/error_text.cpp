#include "report/program/error_text.hpp"

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

constexpr int kPoseDecimals = 3;

constexpr std::string_view kErrorColumns =
    "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,"
    "length1_mm,length2_mm,length3_mm,length4_mm,length5_mm,length6_mm,"
    "nut_tension1_N,nut_tension2_N,nut_tension3_N,nut_tension4_N,nut_tension5_N,nut_tension6_N,"
    "stretch1_um,stretch2_um,stretch3_um,stretch4_um,stretch5_um,stretch6_um,"
    "dx_um,dy_um,dz_um,rx_urad,ry_urad,rz_urad\n";

}  // namespace

std::string_view error_columns() { return kErrorColumns.substr(0, kErrorColumns.size() - 1); }

ErrorTable::ErrorTable(OutputFile& output, bool with_expected) : output_(output), with_expected_(with_expected) {
  output_.write(error_columns());
  if (with_expected_) output_.write(expected_columns());
  output_.write("\n");
}

void ErrorTable::add(const jobs::PoseError& error) {
  row_.clear();
  for (const Axis axis : kAllAxes) {
    if (axis != Axis::X) row_ += ',';
    append_decimal(row_, error.pose[axis], kMostDecimals, kPoseDecimals);
  }
  append_columns(row_, error.lengths, kMm, 9);
  append_columns(row_, error.nut_tension, 1, 7);
  append_columns(row_, error.stretch, kUm, 8);
  append_columns(row_, error.error.head<3>(), kUm, 8);
  append_columns(row_, error.error.tail<3>(), kUrad, 8);
  if (with_expected_) append_expected(row_, error.doubt);
  row_ += '\n';
  output_.write(row_);
}

std::string error_json(const jobs::ErrorTableSummary& summary) {
  const nlohmann::ordered_json json{{"plumbline", "error 1"},
                                    {"poses", summary.poses},
                                    {"beyond_travel", summary.beyond_travel},
                                    {"largest_um", summary.largest_um},
                                    {"expected", expected_json(summary.expected)}};
  return json.dump(2) + "\n";
}

std::string error_text(const jobs::ErrorTableSummary& summary) {
  const std::string beyond =
      summary.beyond_travel == 0 ? "" : fmt::format(" ({} beyond the limits)", count_text(summary.beyond_travel));
  return fmt::format("{}{}, the tip up to {:.3f} um off\n", count_text(summary.poses, "pose"), beyond,
                     summary.largest_um) +
         expected_text(summary.expected);
}

}  // namespace plumbline::report

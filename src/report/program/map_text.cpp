#include "report/program/map_text.hpp"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "report/program/csv_columns.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

constexpr std::string_view kColumns =
    "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,in_reach,limit,error_um,dx_um,dy_um,dz_um,stiffness_N_um,condition,"
    "largest_force_N";

std::string figure_text(std::string_view name, const jobs::MapFigure& figure, double unit, std::string_view unit_name,
                        bool low_is_bad = false) {
  const jobs::Spread& spread = figure.spread;
  const double worst = low_is_bad ? spread.least() : spread.largest();
  const double half = spread.bound_of(0.5);
  // of what is bad where it is low, a twentieth is below
  const double most = low_is_bad ? spread.bound_of(0.05) : spread.bound_of(0.95);
  return fmt::format("  {:<34}{:>10.4g}{:>10.4g}{:>10.4g} {:<5} at {}\n", name, half / unit, most / unit, worst / unit,
                     unit_name, pose_text(figure.worst));
}

}  // namespace

std::string round_um_text(double metres) {
  const double um = metres / kUm;
  return um < 1000 ? fmt::format("{:.3g} um", um) : fmt::format("{:.0f} um", um);
}

std::string pose_text(const AxisWords& pose) {
  std::string text;
  for (const Axis axis : kAllAxes)
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", letter(axis), to_decimal(pose[axis], 3));
  return text;
}

MapTable::MapTable(OutputFile& output, bool has_uncertainty) : output_(output), has_uncertainty_(has_uncertainty) {
  output_.write(kColumns);
  output_.write(has_uncertainty ? ",uncertainty_um,touched_off_uncertainty_um\n" : "\n");
}

void MapTable::add(const jobs::MapCell& cell) {
  row_.clear();
  for (const Axis axis : kAllAxes) {
    append_decimal(row_, cell.pose[axis], kMostDecimals, 3);
    row_ += ',';
  }
  row_ += cell.reached() ? "1," : "0,";
  for (const std::string& limit : cell.out) row_ += (&limit == &cell.out.front() ? "" : "; ") + limit;
  if (cell.reached()) {
    fmt::format_to(std::back_inserter(row_), ",{:.4f}", cell.error.norm() / kUm);
    append_columns(row_, cell.error, kUm, 4);
    fmt::format_to(std::back_inserter(row_), ",{:.4f},{:.4f},{:.2f}", cell.stiffness / kNewtonPerMicrometre,
                   cell.condition, cell.largest_force);
    if (has_uncertainty_) append_columns(row_, std::array{cell.uncertainty, cell.touched_off}, kUm, 4);
  } else {
    row_ += has_uncertainty_ ? ",,,,,,,,," : ",,,,,,,";
  }
  row_ += '\n';
  output_.write(row_);
}

std::string map_text(const jobs::MapSummary& summary) {
  const double share = 100 * static_cast<double>(summary.reached) / static_cast<double>(summary.poses);
  std::string text = fmt::format("{}, {:.1f} % in reach\n", count_text(summary.poses, "pose"), share);
  for (const auto& [limit, count] : summary.out) text += fmt::format("  out of reach, {}: {}\n", limit, count);
  if (summary.reached == 0) return text;
  text += fmt::format("  {:<34}{:>10}{:>10}{:>10}\n", "in reach", "half", "95 %", "worst");
  text += figure_text("error of the tip, up to", summary.error, kUm, "um");
  text += figure_text("stiffness, softest direction, from", summary.stiffness, kNewtonPerMicrometre, "N/um", true);
  text += figure_text("condition number, up to", summary.condition, 1, "");
  text += figure_text("largest force of a strut, up to", summary.force, 1, "N");
  if (summary.has_uncertainty) {
    text += figure_text("uncertainty (1 sigma), up to", summary.uncertainty, kUm, "um");
    text += figure_text("  zero touched off in the middle", summary.touched_off, kUm, "um");
    text += fmt::format(
        "the model knows the tip within {} (1 sigma) on 95 % of what is in reach, {} once the zero is touched off\n",
        round_um_text(summary.uncertainty.spread.bound_of(0.95)),
        round_um_text(summary.touched_off.spread.bound_of(0.95)));
  } else {
    text += "  uncertainty: not known, the model has no [uncertainty]\n";
  }
  return text;
}

}  // namespace plumbline::report

#include "report/page/map_page.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "report/page/measured_sections.hpp"
#include "report/page/sections.hpp"
#include "report/program/map_text.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

constexpr double kWideRange = 8;  // largest over least
constexpr double kOutOfReach = std::numeric_limits<double>::quiet_NaN();

// A figure of the map, in the order of the page's columns.
struct MapColumn {
  const char* name;
  const char* short_name;
  const char* unit;
  double si;   // of the unit
  int digits;  // after the point
  const jobs::MapFigure jobs::MapSummary::*figure;
  double (*value)(const jobs::MapCell&);
  bool low_is_bad = false;
};

const std::array<MapColumn, 6> kMapColumns{
    MapColumn{"uncertainty, zero touched off", "touched off", "um", kUm, 1, &jobs::MapSummary::touched_off,
              [](const jobs::MapCell& cell) { return cell.touched_off; }},
    MapColumn{"uncertainty of the tip", "uncertainty", "um", kUm, 1, &jobs::MapSummary::uncertainty,
              [](const jobs::MapCell& cell) { return cell.uncertainty; }},
    MapColumn{"error of the tip, nothing corrected", "error", "um", kUm, 1, &jobs::MapSummary::error,
              [](const jobs::MapCell& cell) { return cell.error.norm(); }},
    MapColumn{"stiffness in the softest direction", "stiffness", "N/um", kNewtonPerMicrometre, 1,
              &jobs::MapSummary::stiffness, [](const jobs::MapCell& cell) { return cell.stiffness; }, true},
    MapColumn{"condition number", "condition number", "", 1, 2, &jobs::MapSummary::condition,
              [](const jobs::MapCell& cell) { return cell.condition; }},
    MapColumn{"largest force of a strut", "strut force", "N", 1, 0, &jobs::MapSummary::force,
              [](const jobs::MapCell& cell) { return cell.largest_force; }}};

bool is_known(const MapColumn& column, const jobs::MapSummary& summary) {
  const bool is_judged =
      column.figure == &jobs::MapSummary::uncertainty || column.figure == &jobs::MapSummary::touched_off;
  return !is_judged || summary.has_uncertainty;
}

// What is written beside a row or column: a step that is a third of something needs no nine digits.
double axis_mm(double metres) { return from_ticks(to_ticks(metres / kMm, 1), 1); }

std::string tilt_name(const AxisWords& tilt) {
  std::string name = fmt::format("A{} B{}", to_decimal(tilt[Axis::A], 3), to_decimal(tilt[Axis::B], 3));
  if (tilt[Axis::C] != 0) name += fmt::format(" C{}", to_decimal(tilt[Axis::C], 3));
  return name;
}

// Where one place is much worse than another, equal steps of colour are equal ratios.
bool is_wide(const MapColumn& column, const jobs::MapSummary& summary) {
  const jobs::Spread& spread = (summary.*column.figure).spread;
  return spread.least() > 0 && spread.largest() > kWideRange * spread.least();
}

// What that share of the reach does not exceed; of what is bad where it is low: does not fall below.
double bound(const MapColumn& column, const jobs::MapSummary& summary, double share) {
  const jobs::Spread& spread = (summary.*column.figure).spread;
  if (!column.low_is_bad) return spread.bound_of(share) / column.si;
  return (share >= 1 ? spread.least() : spread.bound_of(1 - share)) / column.si;
}

double share_in_reach(const jobs::MapSummary& summary) {
  return 100 * static_cast<double>(summary.reached) / static_cast<double>(summary.poses);
}

std::string lead_of(const jobs::MapSummary& summary) {
  if (summary.reached == 0) return "Nothing of this box is in reach of the machine.";
  const std::string reach = fmt::format("{:.1f} % of the box is in reach.", share_in_reach(summary));
  if (summary.has_uncertainty) {
    return fmt::format(
        "Once programs are compensated and the zero is touched off in the middle, the tip is to be trusted within {} "
        "(1 "
        "sigma) on 95 % of the reachable box; within {} if nothing is touched off; {}",
        round_um_text(summary.touched_off.spread.bound_of(0.95)),
        round_um_text(summary.uncertainty.spread.bound_of(0.95)), reach);
  }
  return fmt::format(
      "With nothing corrected the tip is within {} on 95 % of the reachable box; how sure that is nobody can say, the "
      "model has no [uncertainty]; {}",
      round_um_text(summary.error.spread.bound_of(0.95)), reach);
}

Json figures_of(const jobs::MapSummary& summary, const std::string& machine) {
  std::vector<Fact> facts{{"machine", machine},
                          {"poses looked at", count_text(summary.poses)},
                          {"in reach", share_in_reach(summary), "%", 1}};
  for (const MapColumn& column : kMapColumns) {
    if (!is_known(column, summary) || summary.reached == 0) continue;
    const jobs::MapFigure& figure = summary.*column.figure;
    facts.push_back({fmt::format("{}, {}", column.name, column.low_is_bad ? "at least" : "at most"),
                     bound(column, summary, 1), column.unit, column.digits, "at " + pose_text(figure.worst)});
  }
  return facts_section("", facts);
}

Json shares_of(const jobs::MapSummary& summary) {
  std::vector<TableColumn> columns{{"of the reachable box", "%", 0}};
  for (const MapColumn& column : kMapColumns) {
    if (is_known(column, summary))
      columns.push_back(
          {fmt::format("{} {}", column.short_name, column.low_is_bad ? "from" : "up to"), column.unit, column.digits});
  }
  std::vector<Json> rows;
  for (const double share : {0.5, 0.8, 0.9, 0.95, 0.99, 1.0}) {
    Json row = Json::array({100 * share});
    for (const MapColumn& column : kMapColumns) {
      if (is_known(column, summary)) row.push_back(bound(column, summary, share));
    }
    rows.push_back(std::move(row));
  }
  return table_section("How much of the reach is within what", columns, std::move(rows));
}

Json limits_of(const jobs::MapSummary& summary) {
  std::vector<Json> rows;
  for (const auto& [limit, count] : summary.out) {
    rows.push_back(Json::array(
        {limit, static_cast<double>(count), 100 * static_cast<double>(count) / static_cast<double>(summary.poses)}));
  }
  return table_section("What keeps the machine from the rest", {{"limit"}, {"poses", "", 0}, {"of all", "%", 1}},
                       std::move(rows), "A pose may break several.");
}

}  // namespace

MapPage::MapPage(const machine::MachineModel& model, const jobs::MapOptions& options)
    : machine_(model.name), grid_(jobs::workspace_grid(model, options)), columns_(kMapColumns.size()) {
  if (grid_.poses() > kMostPosesOfPage) {
    refuse("map-page",
           fmt::format("{} are more than a page is drawn from ({})", count_text(grid_.poses(), "pose"),
                       count_text(kMostPosesOfPage)),
           "take a larger --step, fewer planes with --z, or the table alone", {});
  }
}

void MapPage::add(const jobs::MapCell& cell) {
  for (std::size_t i = 0; i < kMapColumns.size(); ++i)
    columns_[i].push_back(cell.reached() ? kMapColumns[i].value(cell) / kMapColumns[i].si : kOutOfReach);
  if (cell.reached()) return reasons_.push_back(-1);
  std::string text;
  for (const std::string& limit : cell.out) text += (text.empty() ? "out of reach: " : ", ") + limit;
  const auto [found, is_new] = reason_of_.emplace(text, static_cast<int>(reason_texts_.size()));
  if (is_new) reason_texts_.push_back(text);
  reasons_.push_back(found->second);
}

std::string MapPage::plane_name(std::size_t plane) const {
  const std::size_t planes = grid_.axes[2].size();
  const AxisWords& tilt = grid_.tilts[plane / planes];
  const std::string name = fmt::format("Z {} mm", to_decimal(grid_.axes[2][plane % planes] / kMm, 3));
  return grid_.tilts.size() < 2 && tilt.values == AxisWords{}.values ? name : name + " " + tilt_name(tilt);
}

Json MapPage::colours(const jobs::MapSummary& summary) const {
  const std::size_t wide = grid_.axes[0].size();
  const std::size_t high = grid_.axes[1].size();
  HeatMap map;
  map.columns = {.name = "X", .unit = "mm"};
  map.rows = {.name = "Y", .unit = "mm"};
  for (const double x : grid_.axes[0]) map.columns.values.push_back(axis_mm(x));
  for (const double y : grid_.axes[1]) map.rows.values.insert(map.rows.values.begin(), axis_mm(y));
  map.reasons = reason_texts_;
  map.has_square_cells = true;
  for (std::size_t i = 0; i < kMapColumns.size(); ++i) {
    const MapColumn& column = kMapColumns[i];
    if (!is_known(column, summary)) continue;
    HeatFigure figure{.name = column.name, .unit = column.unit, .digits = column.digits, .planes = {}};
    figure.is_logarithmic = is_wide(column, summary);
    for (std::size_t plane = 0; plane < reasons_.size() / (wide * high); ++plane) {
      HeatPlane drawn{.name = plane_name(plane), .values = {}};
      for (std::size_t row = 0; row < high; ++row) {
        const auto first = static_cast<std::ptrdiff_t>(plane * wide * high + (high - 1 - row) * wide);
        const auto last = first + static_cast<std::ptrdiff_t>(wide);
        drawn.values.insert(drawn.values.end(), columns_[i].begin() + first, columns_[i].begin() + last);
        drawn.reasons.insert(drawn.reasons.end(), reasons_.begin() + first, reasons_.begin() + last);
      }
      figure.planes.push_back(std::move(drawn));
    }
    map.figures.push_back(std::move(figure));
  }
  map.words = "Seen from above, the largest Y at the top. The colours of a figure mean the same in all planes.";
  return heat_section("Over the workspace", map);
}

// The worst of each plane and tilt: where to look.
Json MapPage::planes(const jobs::MapSummary& summary) const {
  const std::size_t heights = grid_.axes[2].size();
  const std::size_t size = grid_.axes[0].size() * grid_.axes[1].size();
  HeatMap map;
  map.columns = {.name = "Z", .unit = "mm"};
  map.rows = {.name = "tilt", .unit = "deg"};
  for (const double z : grid_.axes[2]) map.columns.values.push_back(axis_mm(z));
  for (const AxisWords& tilt : grid_.tilts) map.rows.labels.push_back(tilt_name(tilt));
  map.reasons = {"nothing of this plane is in reach"};
  for (std::size_t i = 0; i < kMapColumns.size(); ++i) {
    const MapColumn& column = kMapColumns[i];
    if (!is_known(column, summary)) continue;
    HeatFigure figure{.name = fmt::format("{}, {}", column.name, column.low_is_bad ? "least" : "largest"),
                      .unit = column.unit,
                      .digits = column.digits,
                      .planes = {}};
    figure.is_logarithmic = is_wide(column, summary);
    HeatPlane all;
    for (std::size_t plane = 0; plane < grid_.tilts.size() * heights; ++plane) {
      double worst = kOutOfReach;
      for (std::size_t cell = plane * size; cell < (plane + 1) * size; ++cell) {
        const double value = columns_[i][cell];
        // fmin and fmax leave out what is no number
        worst = column.low_is_bad ? std::fmin(worst, value) : std::fmax(worst, value);
      }
      all.values.push_back(worst);
      all.reasons.push_back(std::isnan(worst) ? 0 : -1);
    }
    figure.planes.push_back(std::move(all));
    map.figures.push_back(std::move(figure));
  }
  map.words = "Each cell is the worst of a whole plane, of what is in reach.";
  return heat_section("Plane by plane", map);
}

Page MapPage::page(const jobs::MapSummary& summary) const {
  Page page{.title = fmt::format("The workspace of {}", machine_), .lead = lead_of(summary)};
  page.sections.push_back(figures_of(summary, machine_));
  if (grid_.tilts.size() * grid_.axes[2].size() > 1) page.sections.push_back(planes(summary));
  page.sections.push_back(colours(summary));
  if (summary.reached > 0) page.sections.push_back(shares_of(summary));
  if (!summary.out.empty()) page.sections.push_back(limits_of(summary));
  page.sections.push_back(text_section(
      "What the figures mean",
      {"All of it is what the model says of the machine at rest, without friction.",
       "Error of the tip: where the machine stands when it is sent to the pose, nothing corrected. That is what "
       "compensate takes away.",
       "Uncertainty: how far from that the tip may be, as [uncertainty] of the model says what is not known exactly; "
       "what it "
       "does not list counts as exact. One sigma, X, Y and Z together. It is what the best compensation leaves. Where "
       "the "
       "zero is touched off in the middle of the travel, not tilted, what is the same everywhere goes.",
       "Stiffness: force for each micrometre that the tip gives way, in the direction in which it gives way most.",
       "Condition number: how unevenly the struts hold the platform, 1 at best; it grows without end towards a "
       "singularity."}));
  return page;
}

}  // namespace plumbline::report

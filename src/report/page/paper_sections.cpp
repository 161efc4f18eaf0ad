#include "report/page/paper_sections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "base/units.hpp"
#include "base/version.hpp"
#include "report/page/measured_sections.hpp"
#include "report/page/run_sections.hpp"
#include "report/page/sections.hpp"

namespace plumbline::report {

Json figures_table(const jobs::CircularityTable& table) {
  std::vector<Json> rows;
  for (const jobs::RunCircularity& run : table.runs) {
    const measure::CircularityFigures& f = run.figures;
    rows.push_back({run.id, f.least_squares / kUm, f.minimum_zone / kUm, f.radial_max / kUm, f.radial_min / kUm});
  }
  return table_section("Figures of ISO 230-4",
                       {{"Run"}, {"circularity", "um", 2}, {"G", "um", 2}, {"F max", "um", 2}, {"F min", "um", 2}},
                       std::move(rows),
                       "Circularity: max - min about the least-squares circle. G: width of the narrowest ring. F: "
                       "radial deviation from the nominal radius, the centre removed.");
}

Json pairs_table(const jobs::CircularityTable& table) {
  if (table.pairs.empty()) return nullptr;
  std::vector<Json> rows;
  for (const jobs::PairCircularity& pair : table.pairs) {
    rows.push_back({pair.ccw, pair.cw, pair.figures.minimum_zone / kUm, pair.figures.mean_radial / kUm});
  }
  return table_section("Both directions", {{"counterclockwise"}, {"clockwise"}, {"G(b)", "um", 2}, {"D", "um", 2}},
                       std::move(rows),
                       "G(b): width of the narrowest ring that holds both. D: mean bidirectional radial deviation.");
}

namespace {

Json protocol_section(const jobs::Paper& paper) {
  std::vector<Json> rows{{"machine", paper.machine.empty() ? "not said" : paper.machine}};
  for (const auto& [name, text] : paper.protocol.rows()) rows.push_back({name, text});
  for (const auto& [file, protocol] : paper.further) {
    for (const auto& [name, text] : protocol.rows()) rows.push_back({fmt::format("{}, {}", name, file), text});
  }
  rows.push_back({"software", fmt::format("plumbline {}", version())});
  for (const jobs::Paper::File& file : paper.files) {
    rows.push_back({file.what, fmt::format("{} (FNV-1a {:016x})", file.name, file.hash)});
  }
  rows.push_back({"runs", std::to_string(paper.runs.size())});
  for (const char* const line : {"checked by", "date", "signature"}) rows.push_back({line, "____________________"});
  return table_section(
      "Protocol", {{""}, {""}}, std::move(rows),
      paper.protocol.rows().empty()
          ? "The dataset has no [protocol]: serial, instrument, operator, date, place, remarks."
          : "As [protocol] of the dataset says; the hashes are those of the files that this rests on.");
}

// The torques of a run in the order of their angles.
CurveGroup torques_of(const measure::Run& run) {
  std::vector<std::size_t> order(run.samples());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto angle = [&](std::size_t i) {
    const double deg = run.angle[i] / kDeg;
    return deg - 360 * std::floor(deg / 360);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
  CurveGroup group{run.id};
  for (const std::size_t i : order) group.x.push_back(angle(i));
  for (std::size_t j = 0; j < run.torque.size(); ++j) {
    Curve curve{"measured"};
    for (const std::size_t i : order) curve.values.push_back(run.torque[j][i]);
    group.panels.push_back({fmt::format("motor {}", j + 1), "N m", {std::move(curve)}});
  }
  return group;
}

Json torque_profiles(const std::vector<measure::Run>& runs) {
  std::vector<CurveGroup> groups;
  for (const measure::Run& run : runs) {
    if (run.has_torque()) groups.push_back(torques_of(run));
  }
  if (groups.empty()) return nullptr;
  return curves_section("Torque profiles", {"angle", "deg", 0}, groups,
                        {"Run", true, "As measured; the run that is chosen."});
}

Json torque_table(const std::vector<measure::Run>& runs) {
  std::vector<Json> rows;
  for (const measure::Run& run : runs) {
    if (!run.has_torque()) continue;
    Json row{run.id};
    for (const std::vector<double>& torque : run.torque) {
      const auto [least, most] = std::minmax_element(torque.begin(), torque.end());
      row.push_back(fmt::format("{:.2f} to {:.2f}", *least, *most));
    }
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return nullptr;
  std::vector<TableColumn> columns{{"Run"}};
  for (int j = 1; j <= 6; ++j) columns.push_back({fmt::format("motor {}", j), "N m"});
  return table_section("Torques, least to most", columns, std::move(rows));
}

}  // namespace

void add_paper(Page& page, const jobs::Paper& paper, bool with_figures) {
  if (with_figures && !paper.figures.runs.empty()) {
    add_section(page, figures_table(paper.figures));
    add_section(page, pairs_table(paper.figures));
  }
  add_section(page, torque_profiles(paper.runs));
  add_section(page, torque_table(paper.runs));
  page.sections.push_back(protocol_section(paper));
}

}  // namespace plumbline::report

#include "report/page/compare_page.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "report/page/measured_sections.hpp"
#include "report/page/paper_sections.hpp"
#include "report/page/run_sections.hpp"
#include "report/page/sections.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

using jobs::Comparison;
using jobs::RunsAndModels;

Json measured_value(const std::optional<double>& value) { return value ? Json(*value) : Json("not measured"); }

std::string rms_text(const Comparison& of) {
  std::string text;
  if (of.radial_rms_um) text += fmt::format("{:.2f} um in readings of the bar", *of.radial_rms_um);
  if (of.torque_rms_Nm) text += fmt::format("{}{:.3f} N m in torques", text.empty() ? "" : " and ", *of.torque_rms_Nm);
  return text.empty() ? "no readings" : text + " (rms)";
}

std::string compare_lead(const std::vector<Comparison>& of, const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < of.size(); ++i) {
    text += fmt::format("{}{} is off by {}", i > 0 ? "; " : "", names[i], rms_text(of[i]));
  }
  return text + ".";
}

std::vector<Fact> compare_facts(const std::vector<Comparison>& of, const std::vector<std::string>& names) {
  std::vector<Fact> facts;
  for (std::size_t i = 0; i < of.size(); ++i) {
    const std::string whose = of.size() > 1 ? ", " + names[i] : "";
    facts.push_back({"Bar, rms" + whose, measured_value(of[i].radial_rms_um), "um", 2, "over all samples of all runs"});
    facts.push_back(
        {"Torque, rms" + whose, measured_value(of[i].torque_rms_Nm), "N m", 4, "over all samples and motors"});
  }
  return facts;
}

Json set_up_table(const Comparison& of, const std::string& name) {
  std::vector<Json> rows;
  for (const jobs::RunComparison& run : of.runs) {
    if (!run.radial_rms_um) continue;
    rows.push_back({run.id, run.ball_um[0], run.ball_um[1], run.ball_um[2], run.bar_um});
  }
  if (rows.empty()) return nullptr;
  return table_section("Set-up of the runs, " + name,
                       {{"Run"}, {"ball X", "um", 1}, {"ball Y", "um", 1}, {"ball Z", "um", 1}, {"bar", "um", 1}},
                       std::move(rows),
                       "Where the ball on the table stood, from the ideal place, and how much longer the bar was than "
                       "stated, as fitted to each run.");
}

// Places of the largest waves are told with their order.
Json wave_map(const jobs::CircularityTable& table) {
  HeatMap map;
  map.rows = {"Run"};
  map.columns = {"Order of the wave"};
  map.reasons = {"the samples do not tell it"};
  std::size_t most = 0;
  for (const jobs::RunCircularity& run : table.runs) most = std::max(most, run.harmonics.size());
  for (std::size_t k = 2; k <= most; ++k) map.columns.labels.push_back(std::to_string(k));
  HeatFigure figure{"amplitude", "um", 2, {{""}}};
  for (const jobs::RunCircularity& run : table.runs) {
    map.rows.labels.push_back(run.id);
    for (std::size_t k = 1; k < most; ++k) {
      const bool told = k < run.harmonics.size();
      figure.planes[0].values.push_back(told ? run.harmonics[k].amplitude / kUm : std::nan(""));
      figure.planes[0].reasons.push_back(told ? -1 : 0);
    }
  }
  if (map.columns.labels.empty()) return nullptr;
  map.figures.push_back(std::move(figure));
  map.words = "Waves around the circle; the first is the centring of the balls and left out.";
  return heat_section("Waves around the circle", map);
}

// The readings of a run about another circle than its own.
Eigen::VectorXd about(const jobs::RunProfile& run, const measure::CircleFit& circle) {
  const measure::CircleFit& own = run.figures->circle;
  return run.radial.array() + (own.mean - circle.mean) + (own.x - circle.x) * run.angle.array().cos() +
         (own.y - circle.y) * run.angle.array().sin();
}

Json pair_circles(const jobs::CircularityTable& table, const RunsAndModels& runs) {
  std::vector<PolarGroup> groups;
  const auto find = [&](const std::string& id) {
    return std::find_if(runs.runs.begin(), runs.runs.end(), [&](const auto& run) { return run.run.id == id; });
  };
  for (const jobs::PairCircularity& pair : table.pairs) {
    const auto ccw = find(pair.ccw);
    const auto cw = find(pair.cw);
    const measure::CircleFit common =
        measure::least_squares_circle(measure::joined(measure::profile_of(ccw->run), measure::profile_of(cw->run)));
    PolarGroup group{pair.ccw + ", " + pair.cw, ccw->run.radius / kMm};
    group.curves = {{"counterclockwise", 1, 0, in_unit(ccw->angle, kDeg), in_unit(about(*ccw, common), kUm)},
                    {"clockwise", 2, 0, in_unit(cw->angle, kDeg), in_unit(about(*cw, common), kUm)}};
    group.figures = {{"Bidirectional deviation G(b)", pair.figures.minimum_zone / kUm},
                     {"Mean radial deviation D", pair.figures.mean_radial / kUm}};
    groups.push_back(std::move(group));
  }
  if (groups.empty()) return nullptr;
  return polar_section(
      "Both directions laid over each other", groups,
      "About the least-squares circle of both, so that a difference of their radii shows. What differs between the "
      "directions comes from friction, backlash and lag.");
}

std::string circularity_lead(const jobs::CircularityTable& table) {
  if (table.runs.empty()) return "No run has readings of a bar.";
  const auto larger = [](const jobs::RunCircularity& a, const jobs::RunCircularity& b) {
    return a.figures.least_squares < b.figures.least_squares;
  };
  const auto most = std::max_element(table.runs.begin(), table.runs.end(), larger);
  const auto least = std::min_element(table.runs.begin(), table.runs.end(), larger);
  if (table.runs.size() == 1)
    return fmt::format("The circle is {:.1f} um out of round.", most->figures.least_squares / kUm);
  return fmt::format("{} are between {:.1f} um ({}) and {:.1f} um ({}) out of round.",
                     count_text(table.runs.size(), "circle"), least->figures.least_squares / kUm, least->id,
                     most->figures.least_squares / kUm, most->id);
}

}  // namespace

Page compare_page(const std::vector<Comparison>& comparisons, const RunsAndModels& runs) {
  Page page{"Model and measurements: " + fmt::format("{}", fmt::join(runs.models, " beside ")),
            compare_lead(comparisons, runs.models)};
  page.sections.push_back(facts_section("At a glance", compare_facts(comparisons, runs.models)));
  add_section(page, circles_section(runs, "Circles"));
  for (Json& section : left_by_run_sections(runs)) page.sections.push_back(std::move(section));
  add_section(page, screen_only(torque_map_section(runs, "Motor torques: where they are off")));
  add_section(page, screen_only(turn_section(runs, "Along the turn")));
  add_section(page, screen_only(left_along_turn_section(runs, "What is left along the turn")));
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    add_section(page, screen_only(set_up_table(comparisons[i], runs.models[i])));
  }
  return page;
}

Page circularity_page(const jobs::CircularityTable& table, const RunsAndModels& runs) {
  Page page{"Circularity", circularity_lead(table)};
  add_section(page, circles_section(runs, "Circles"));
  page.sections.push_back(figures_table(table));
  add_section(page, pairs_table(table));
  add_section(page, screen_only(pair_circles(table, runs)));
  if (!table.runs.empty()) add_section(page, screen_only(wave_map(table)));
  for (Json& section : left_by_run_sections(runs)) page.sections.push_back(screen_only(std::move(section)));
  return page;
}

}  // namespace plumbline::report

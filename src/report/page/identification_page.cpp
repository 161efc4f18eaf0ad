#include "report/page/identification_page.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "identify/unknowns/geometry.hpp"
#include "report/measured/objection_text.hpp"
#include "report/measured/observability_text.hpp"
#include "report/page/measured_sections.hpp"
#include "report/page/run_sections.hpp"
#include "report/page/sections.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

using identify::Fit;
using identify::Misfit;
using identify::Stage;
using identify::Unknown;

constexpr std::size_t kMostShifts = 30;
constexpr std::size_t kMostCorrelated = 48;  // unknowns whose correlations are shown

double found_value(const Fit& fit, std::size_t i) { return fit.values[static_cast<Eigen::Index>(i)]; }

// "2.79 um -> 0.47 um in readings of the bar"
std::string misfit_words(const Misfit& before, const Misfit& after) {
  std::vector<std::string> parts;
  if (after.radial_readings > 0) {
    parts.push_back(fmt::format("{:.2f} um in readings of the bar ({:.2f} um before)", after.radial_rms / kUm,
                                before.radial_rms / kUm));
  }
  if (after.torque_readings > 0) {
    parts.push_back(fmt::format("{:.3f} N m in torques ({:.3f} N m before)", after.torque_rms, before.torque_rms));
  }
  if (after.tracker_readings > 0) {
    parts.push_back(fmt::format("{:.2f} um in the tracker's coordinates ({:.2f} um before)", after.tracker_rms / kUm,
                                before.tracker_rms / kUm));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

Fact rms_fact(const char* name, double before, double after, double unit, const char* unit_name, int digits) {
  return {name, fmt::format("{:.{}f} \u2192 {:.{}f} {}", before / unit, digits, after / unit, digits, unit_name), "", 0,
          "rms of what the model leaves, before and after"};
}

Json misfit_facts(const jobs::IdentifiedModel& model) {
  const Misfit& before = model.found.before;
  const Misfit& after = model.found.after;
  std::vector<Fact> facts;
  if (after.radial_readings > 0) {
    facts.push_back(rms_fact("Bar", before.radial_rms, after.radial_rms, kUm, "um", 2));
  }
  if (after.torque_readings > 0) {
    facts.push_back(rms_fact("Torques", before.torque_rms, after.torque_rms, 1, "N m", 4));
  }
  if (after.tracker_readings > 0) {
    facts.push_back(rms_fact("Tracker", before.tracker_rms, after.tracker_rms, kUm, "um", 2));
  }
  if (after.tilt_readings > 0) {
    facts.push_back(rms_fact("Tracker's angles", before.tilt_rms, after.tilt_rms, kUrad, "urad", 1));
  }
  for (const Stage& stage : model.found.stages) {
    facts.push_back({stage.name + " fit", count_text(static_cast<std::uint64_t>(stage.fit.readings), "reading"), "", 0,
                     fmt::format("{}, {}", count_text(stage.fit.unknowns.size(), "unknown"),
                                 stage.borne_out ? "borne out by circles that the fit did not see"
                                                 : "not borne out by circles that the fit did not see")});
  }
  return facts_section("At a glance", facts);
}

Json values_section(const Stage& stage) {
  const Fit& fit = stage.fit;
  std::vector<Json> rows;
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    const Unknown& u = fit.unknowns[i];
    const double si = u.unit.si;
    const double error = fit.standard_error(i);
    rows.push_back({u.label, fmt::format("{:.6g}", u.start / si), fmt::format("{:.6g}", found_value(fit, i) / si),
                    std::isfinite(error) ? fmt::format("{:.2g}", error / si) : "not told",
                    u.free() ? "free" : fmt::format("{:.2g}", u.sigma / si), std::string(u.unit.name)});
  }
  return table_section("What was found: " + stage.name + " fit",
                       {{"number"}, {"before"}, {"found"}, {"standard error"}, {"known to"}, {"unit"}}, std::move(rows),
                       "Known to: one sigma of what [uncertainty] says of it beforehand.");
}

// Those with priors, the furthest first.
Json shift_section(const Stage& stage) {
  const Fit& fit = stage.fit;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    if (!fit.unknowns[i].free() && fit.unknowns[i].sigma > 0) places.push_back(i);
  }
  const auto shift = [&](std::size_t i) {
    return (found_value(fit, i) - fit.unknowns[i].start) / fit.unknowns[i].sigma;
  };
  std::stable_sort(places.begin(), places.end(),
                   [&](std::size_t a, std::size_t b) { return std::abs(shift(a)) > std::abs(shift(b)); });
  if (places.empty()) return nullptr;
  BarChart chart{"sigma", 2, {{"shift", 1}}};
  for (const std::size_t i : places) {
    if (chart.rows.size() == kMostShifts) break;
    const double error = fit.standard_error(i) / fit.unknowns[i].sigma;
    chart.rows.push_back({fit.unknowns[i].label, {{shift(i), shift(i) - 2 * error, shift(i) + 2 * error, 1}}});
  }
  chart.references = {{"1 sigma", 1}, {"", -1}};
  chart.words =
      "How far each number moved, in units of what [uncertainty] says of it; whiskers: two standard errors. A whisker "
      "of "
      "two on either side means that the data told nothing.";
  if (places.size() > kMostShifts)
    chart.words += fmt::format(" The {} that moved furthest of {}.", kMostShifts, places.size());
  return bars_section("How far the numbers moved: " + stage.name + " fit", chart);
}

Json correlation_section(const Stage& stage) {
  const Fit& fit = stage.fit;
  const std::size_t count = fit.unknowns.size();
  if (count < 2 || count > kMostCorrelated) return nullptr;
  HeatMap map;
  map.rows = {"Number"};
  map.columns = {"Number"};
  map.reasons = {"the data do not tell it"};
  HeatFigure figure{"size of the correlation", "", 2, {{""}}, {{0, 1}}};
  for (std::size_t i = 0; i < count; ++i) {
    map.rows.labels.push_back(fit.unknowns[i].label);
    map.columns.labels.push_back(std::to_string(i + 1));
    for (std::size_t k = 0; k < count; ++k) {
      const double value = std::abs(fit.correlation(i, k));
      figure.planes[0].values.push_back(value);
      figure.planes[0].reasons.push_back(std::isfinite(value) ? -1 : 0);
    }
  }
  map.figures.push_back(std::move(figure));
  map.words =
      "Columns count the numbers from the top. Near 1: the data tell the two only together. Priors are taken into "
      "account.";
  return heat_section("Which numbers the data do not tell apart: " + stage.name + " fit", map);
}

constexpr std::string_view kAxes = "XYZ";

// One figure of every pose, as given and as found.
CurvePanel tracked_panel(const jobs::IdentifiedModel& model, std::string name, std::string unit, int digits,
                         const std::function<double(const jobs::TrackedResidual&)>& figure) {
  CurvePanel panel{std::move(name), std::move(unit), {{"as given", 2, 2, {}, true}, {"as found", 1, 1, {}, true}}};
  panel.digits = digits;
  panel.quantum = 1e-3;
  for (const jobs::TrackedGap& gap : model.poses) {
    panel.curves[0].values.push_back(figure(gap.before));
    panel.curves[1].values.push_back(figure(gap.after));
  }
  return panel;
}

Json tracker_section(const jobs::IdentifiedModel& model) {
  if (model.poses.empty()) return nullptr;
  CurveGroup group{""};
  for (std::size_t i = 0; i < model.poses.size(); ++i) group.x.push_back(static_cast<double>(i + 1));
  group.panels.push_back(
      tracked_panel(model, "Distance", "um", 2, [](const jobs::TrackedResidual& of) { return of.shift.norm() / kUm; }));
  group.panels.back().from_zero = true;
  for (int a = 0; a < 3; ++a) {
    group.panels.push_back(tracked_panel(model, fmt::format("Along {}", kAxes[static_cast<std::size_t>(a)]), "um", 2,
                                         [a](const jobs::TrackedResidual& of) { return of.shift[a] / kUm; }));
  }
  for (int a = 0; a < 3 && model.poses.front().before.turn; ++a) {
    group.panels.push_back(tracked_panel(model, fmt::format("Turn about {}", kAxes[static_cast<std::size_t>(a)]),
                                         "urad", 1,
                                         [a](const jobs::TrackedResidual& of) { return (*of.turn)[a] / kUrad; }));
  }
  CurveAxis axis{"Pose"};
  axis.digits = 0;
  CurveOptions options;
  options.words =
      "What the tracker measured of each pose less what the model says of it, in the tracker's axes, its frame fitted.";
  return curves_section("Poses of the tracker: what is left", axis, {group}, options);
}

void add_stage(Page& page, const Stage& stage) {
  page.sections.push_back(values_section(stage));
  add_section(page, screen_only(shift_section(stage)));
  if (std::vector<std::string> notes = observability_text(stage); !notes.empty()) {
    for (std::string& note : notes) note = sentence(std::move(note));
    page.sections.push_back(text_section("What the data do not tell: " + stage.name + " fit", std::move(notes)));
  }
  add_section(page, screen_only(correlation_section(stage)));
}

}  // namespace

jobs::RunsAndModels profiles_of(const jobs::IdentifiedModel& model) {
  const physics::ForceModel given(model.machine);
  jobs::RunsAndModels both;
  both.models = {"as given", "as found"};
  both.runs = jobs::run_profiles(model.runs,
                                 std::vector<jobs::NamedModel>{{both.models[0], &model.machine, &given},
                                                               {both.models[1], &model.machine, &model.found.forces}});
  return both;
}

Page identification_page(const jobs::IdentifiedModel& model, const jobs::RunsAndModels& profiles) {
  const bool converged = model.found.converged();
  Page page{(model.calibrated ? "Calibration of " : "Identification of ") + model.machine.name};
  page.lead =
      fmt::format("The model as found is off by {} (rms).", misfit_words(model.found.before, model.found.after));
  page.verdict = !converged ? Verdict::bad : model.objected() ? Verdict::warn : Verdict::good;
  std::vector<std::string> warnings;
  if (!converged) warnings.emplace_back("The fit did not converge: do not use the numbers.");
  if (model.objected()) warnings.push_back(fmt::format("Not to be believed: {}.", objection_text(model)));
  if (!warnings.empty()) page.sections.push_back(warnings_section("Before you use it", std::move(warnings)));
  page.sections.push_back(misfit_facts(model));
  add_section(page, circles_section(profiles, "Circles"));
  for (Json& section : left_by_run_sections(profiles)) page.sections.push_back(std::move(section));
  add_section(page, tracker_section(model));
  for (const Stage& stage : model.found.stages) add_stage(page, stage);
  add_section(page, screen_only(torque_map_section(profiles, "Motor torques: where they are off")));
  add_section(page, screen_only(turn_section(profiles, "Along the turn")));
  add_section(page, screen_only(left_along_turn_section(profiles, "What is left along the turn")));
  return page;
}

}  // namespace plumbline::report

#include "report/page/plan_page.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "report/measured/plan_text.hpp"
#include "report/page/measured_sections.hpp"
#include "report/page/run_sections.hpp"
#include "report/page/sections.hpp"
#include "report/page/test_section.hpp"
#include "report/program/map_text.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

using jobs::PlannedTests;

constexpr std::size_t kMostErrors = 30;

// Of the standard errors asked for: the median share of them that the plan leaves.
double median_left(const PlannedTests& plan) {
  std::vector<double> shares;
  for (const std::size_t i : plan.asked) {
    const double before = plan.before.standard_error(i);
    const double after = plan.after.standard_error(i);
    if (!std::isfinite(after)) continue;
    shares.push_back(std::isfinite(before) && before > 0 ? after / before : 0);
  }
  if (shares.empty()) return 1;
  std::sort(shares.begin(), shares.end());
  return shares[shares.size() / 2];
}

std::string lead(const PlannedTests& plan) {
  const std::string circles = count_text(plan.dataset.runs.size(), "circle");
  if (!plan.apart.empty()) {
    return fmt::format("{} tell the two effects apart by {:.3g} and {:.3g} sigma, for a hundredth of their range.",
                       circles, plan.apart[0], plan.apart[1]);
  }
  if (plan.tip) {
    const jobs::TipOverBox& after = plan.tip->after.back();
    return fmt::format(
        "{} bring the tip's uncertainty over the box from {:.3g} to {:.3g} um as it stands, with the zero touched off "
        "from {:.3g} to {:.3g} um (1 sigma, rms).",
        circles, plan.tip->before.stands.rms / kUm, after.stands.rms / kUm, plan.tip->before.touched_off.rms / kUm,
        after.touched_off.rms / kUm);
  }
  return fmt::format("{} bring the standard errors of what is asked for down to {:.0f} % (median of {}).", circles,
                     100 * median_left(plan), count_text(plan.asked.size(), "number"));
}

Json runs_table(const PlannedTests& plan) {
  std::vector<Json> rows;
  double seconds = 0;
  for (std::size_t i = 0; i < plan.dataset.runs.size(); ++i) {
    const measure::Run& run = plan.dataset.runs[i];
    const Vector3<double> c = run.centre_W / kMm;
    const Vector3<double> t = run.tilt / kDeg;
    rows.push_back({run.id, c.x(), c.y(), c.z(), run.radius / kMm, t.x(), t.y(), to_text(run.direction),
                    run.feed / kMmPerMin, run.payload_mass, plan.criterion[i]});
    seconds += 2 * 2 * std::numbers::pi * run.radius / run.feed;
  }
  return table_section(
      "The circles",
      {{"run"},
       {"X", "mm", 1},
       {"Y", "mm", 1},
       {"Z", "mm", 1},
       {"radius", "mm", 1},
       {"A", "deg", 1},
       {"B", "deg", 1},
       {"direction"},
       {"feed", "mm/min", 0},
       {"payload", "kg", 1},
       {"criterion", "", 2}},
      std::move(rows),
      fmt::format(
          "Those that tell most first; the criterion is that of all down to the row. Chosen of {}. In all {} of "
          "motion, run-in and run-out counted.",
          count_text(plan.candidates, "candidate"), time_text(seconds)));
}

// Standard errors without and with the plan, as shares of the one without; those that stay largest first.
Json errors_section(const PlannedTests& plan) {
  std::vector<std::pair<double, std::size_t>> shares;
  for (const std::size_t i : plan.asked) {
    const double before = plan.before.standard_error(i);
    const double after = plan.after.standard_error(i);
    if (std::isfinite(before) && before > 0 && std::isfinite(after)) shares.emplace_back(after / before, i);
  }
  if (shares.empty()) return nullptr;
  std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  BarChart chart{"% of the standard error before", 1, {{"with the plan", 1}}};
  for (std::size_t k = 0; k < std::min(shares.size(), kMostErrors); ++k) {
    chart.rows.push_back({plan.after.unknowns[shares[k].second].label, {{100 * shares[k].first, {}, {}, 1}}});
  }
  chart.references = {{"without the plan", 100}};
  if (shares.size() > kMostErrors) {
    chart.words = fmt::format("The {} that stay largest of {}.", kMostErrors, shares.size());
  }
  return bars_section("What the plan tells", chart);
}

Json errors_table(const PlannedTests& plan) {
  std::vector<Json> rows;
  const auto text = [](double error) -> Json {
    return std::isfinite(error) ? fmt::format("{:.3g}", error) : "not told";
  };
  for (const std::size_t i : plan.asked) {
    const identify::Unknown& u = plan.after.unknowns[i];
    rows.push_back({u.label, text(plan.before.standard_error(i) / u.unit.si),
                    text(plan.after.standard_error(i) / u.unit.si), std::string(u.unit.name)});
  }
  return table_section("Standard errors", {{"number"}, {"without the plan"}, {"with it"}, {"unit"}}, std::move(rows));
}

Json tip_table(const jobs::PlannedTip& tip) {
  std::vector<Json> rows;
  const jobs::TipOverBox& after = tip.after.back();
  const auto add = [&](const char* name, const jobs::TipFigures& before, const jobs::TipFigures& now) {
    rows.push_back(
        {name, before.rms / kUm, now.rms / kUm, before.worst / kUm, now.worst / kUm, pose_text(now.worst_at)});
  };
  add("as it stands", tip.before.stands, after.stands);
  add("zero touched off", tip.before.touched_off, after.touched_off);
  return table_section("The tip over the box",
                       {{""},
                        {"rms without the plan", "um", 2},
                        {"with it", "um", 2},
                        {"worst without", "um", 2},
                        {"with it", "um", 2},
                        {"worst at"}},
                       std::move(rows),
                       fmt::format("1 sigma of X, Y and Z together, over {}, at rest. The zero is touched off in the "
                                   "middle of the box, not tilted.",
                                   box_text(tip)));
}

// How sure the tip is after each run.
Json tip_section(const jobs::PlannedTip& tip) {
  CurveGroup group{""};
  CurveAxis axis{"Runs"};
  axis.digits = 0;
  Curve stands{"as it stands", 1, 0, {tip.before.stands.rms / kUm}, true};
  Curve touched_off{"zero touched off", 2, 0, {tip.before.touched_off.rms / kUm}, true};
  for (const jobs::TipOverBox& after : tip.after) {
    stands.values.push_back(after.stands.rms / kUm);
    touched_off.values.push_back(after.touched_off.rms / kUm);
  }
  for (std::size_t i = 0; i < stands.values.size(); ++i) group.x.push_back(static_cast<double>(i));
  CurvePanel panel{"Tip, 1 sigma, rms over the box", "um", {std::move(stands), std::move(touched_off)}, 2, 1e-4};
  panel.from_zero = true;
  group.panels.push_back(std::move(panel));
  CurveOptions options;
  options.words = "Where the curves are flat, more circles tell little more.";
  return curves_section("What each circle adds", axis, {group}, options);
}

Json criterion_section(const PlannedTests& plan) {
  if (plan.criterion.size() < 2) return nullptr;
  CurveGroup group{""};
  CurveAxis axis{"Runs"};
  CurvePanel panel{"Criterion", "", {{"criterion", 1, 0, plan.criterion}}, 2, 1e-4};
  axis.digits = 0;
  for (std::size_t i = 0; i < plan.criterion.size(); ++i) group.x.push_back(static_cast<double>(i + 1));
  group.panels.push_back(std::move(panel));
  CurveOptions options;
  options.words = "Where the curve is flat, more circles tell little more.";
  return curves_section("What each circle adds", axis, {group}, options);
}

}  // namespace

Page plan_page(const PlannedTests& plan, const machine::MachineModel& machine, const std::vector<std::string>& programs,
               const jobs::RunsAndModels& predicted) {
  Page page{"Plan of circular tests for " + machine.name, lead(plan)};
  page.sections.push_back(runs_table(plan));
  std::vector<ShownTest> tests;
  for (std::size_t i = 0; i < plan.dataset.runs.size(); ++i) {
    tests.push_back({plan.dataset.runs[i].id, plan.dataset.runs[i], "", i < programs.size() ? programs[i] : ""});
  }
  page.sections.push_back(tests_section("The circles in the machine", machine, tests));
  add_section(page, errors_section(plan));
  if (plan.tip) page.sections.push_back(tip_table(*plan.tip));
  add_section(page, plan.tip ? tip_section(*plan.tip) : criterion_section(plan));
  if (std::vector<std::string> notes = unseen_text(plan); !notes.empty()) {
    for (std::string& note : notes) note = sentence(std::move(note));
    page.sections.push_back(text_section("What the plan does not tell", std::move(notes)));
  }
  page.sections.push_back(screen_only(errors_table(plan)));
  add_section(page, screen_only(circles_section(predicted, "What the model predicts")));
  add_section(page, screen_only(turn_section(predicted, "Predicted along the turn")));
  return page;
}

}  // namespace plumbline::report

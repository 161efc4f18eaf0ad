#include "report/page/diagnosis_page.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/units.hpp"
#include "report/measured/diagnosis_text.hpp"
#include "report/measured/functions_text.hpp"
#include "report/measured/next_test_text.hpp"
#include "report/measured/objection_text.hpp"
#include "report/measured/where_json.hpp"
#include "report/page/evidence_sections.hpp"
#include "report/page/measured_sections.hpp"
#include "report/page/run_sections.hpp"
#include "report/page/sections.hpp"
#include "report/page/test_section.hpp"
#include "report/page/where_sections.hpp"

namespace plumbline::report {
namespace {

using diagnose::Diagnosis;
using diagnose::Gap;
using diagnose::NamedEffect;

std::string noise_words(const Diagnosis& d) {
  const identify::ChannelNoise& bar = d.noise.channels[identify::kRadial];
  const identify::ChannelNoise& torque = d.noise.channels[1];
  std::vector<std::string> parts;
  if (bar.samples > 0) parts.push_back(fmt::format("bar {:.2f} um", bar.sigma / kUm));
  if (torque.samples > 0) parts.push_back(fmt::format("torque {:.3f} N m", torque.sigma));
  return fmt::format("{}", fmt::join(parts, ", "));
}

// "backlash moves the tip by up to 2.3 um in these circles (0.9 um rms)"
std::string tip_words(const jobs::AtTip& at, const std::string& effect) {
  if (at.largest == 0) return effect + " does not move the tip and shows in the torques alone";
  return fmt::format("{} moves the tip by up to {:.1f} um in these circles ({:.2f} um rms)", effect, at.largest / kUm,
                     at.rms / kUm);
}

std::string gap_words(const diagnose::Rms& rms) {
  if (rms.radial) return fmt::format("{:.2f} um in readings of the bar", *rms.radial / kUm);
  if (rms.torque) return fmt::format("{:.3f} N m in torques", *rms.torque);
  return "unknown size";
}

std::string verdict_words(const jobs::DiagnoseResult& result) {
  const Diagnosis& d = result.diagnosis;
  if (d.verdict == diagnose::Verdict::nothing_missing) {
    return "Nothing is missing that these runs could show: what model and measurements differ by is noise (" +
           noise_words(d) + ").";
  }
  if (d.verdict == diagnose::Verdict::unknown) {
    return fmt::format("There is a gap of {} (rms; noise: {}), and no effect of the catalogue explains it.",
                       gap_words(d.fit.before), noise_words(d));
  }
  std::vector<std::string> moves;
  const bool alone = d.effects.size() == 1 && d.confidence_set.size() == 1;
  for (const jobs::AtTip& at : result.at_tip) moves.push_back(tip_words(at, alone ? "it" : at.effect));
  std::string text = fmt::format("The model misses {}", names_text(d));
  if (!moves.empty()) text += fmt::format(": {}", fmt::join(moves, "; "));
  return text + ".";
}

Verdict mark_of(const Diagnosis& d) {
  if (!d.converged) return Verdict::bad;
  if (d.verdict == diagnose::Verdict::nothing_missing) return Verdict::good;
  return d.verdict == diagnose::Verdict::named ? Verdict::warn : Verdict::bad;
}

std::vector<std::string> cautions(const Diagnosis& d) {
  std::vector<std::string> items;
  if (!d.converged) items.emplace_back("The last fit did not converge: do not use the numbers found.");
  if (d.withheld) items.push_back(fmt::format("The model stays as it was given: {}.", objection_text(*d.withheld)));
  if (d.doubt) items.push_back(fmt::format("What was not believed: {}.", doubt_text(*d.doubt)));
  return items;
}

Fact change_fact(const char* name, const std::optional<double>& before, const std::optional<double>& after, double unit,
                 const char* unit_name, int digits) {
  if (!before || !after) return {name, "not measured"};
  return {name, fmt::format("{:.{}f} \u2192 {:.{}f} {}", *before / unit, digits, *after / unit, digits, unit_name), "",
          0, "rms, before and after"};
}

Json glance(const jobs::DiagnoseResult& result) {
  const Diagnosis& d = result.diagnosis;
  std::vector<Fact> facts;
  for (const jobs::AtTip& at : result.at_tip) {
    facts.push_back({at.effect + ", at the tip", at.largest / kUm, "um", 2,
                     fmt::format("largest in these circles; {:.2f} um rms", at.rms / kUm)});
  }
  facts.push_back(change_fact("Bar, fitted runs", d.fit.before.radial, d.fit.after.radial, kUm, "um", 2));
  const bool left_out = std::any_of(d.runs.begin(), d.runs.end(), [](const auto& run) { return run.held_out; });
  if (left_out) {
    facts.push_back(change_fact("Bar, runs left out", d.held_out.before.radial, d.held_out.after.radial, kUm, "um", 2));
  }
  facts.push_back(change_fact("Torque, fitted runs", d.fit.before.torque, d.fit.after.torque, 1, "N m", 3));
  if (left_out) {
    facts.push_back(
        change_fact("Torque, runs left out", d.held_out.before.torque, d.held_out.after.torque, 1, "N m", 3));
  }
  if (const CircularityOfRuns all = circularity_of(d.runs); all.runs > 0) {
    facts.push_back({"Circularity, compensated",
                     fmt::format("{:.1f} \u2192 {:.1f} um", all.mean.given / kUm, all.mean.found / kUm), "", 0,
                     fmt::format("mean of {} circles: with the model as given, with what was found; {:.1f} um without "
                                 "compensation",
                                 all.runs, all.mean.measured / kUm)});
  }
  facts.push_back({"Noise", noise_words(d), "", 0, "from the spectrum of what is left"});
  return facts_section("At a glance", facts);
}

Json value_or_none(const std::optional<double>& value, double unit) {
  return value ? Json(*value / unit) : Json("not measured");
}

Json gap_section(const Diagnosis& d) {
  std::vector<TableColumn> columns{{"rms"}, {"before", "", 3}};
  if (!d.runner_up.empty()) columns.push_back({"with " + d.runner_up, "", 3});
  columns.push_back({"after", "", 3});
  std::vector<Json> rows;
  const auto add = [&](const char* name, const Gap& gap, std::optional<double> diagnose::Rms::*which, double unit) {
    Json row{name, value_or_none(gap.before.*which, unit)};
    if (!d.runner_up.empty()) row.push_back(value_or_none(gap.runner_up.*which, unit));
    row.push_back(value_or_none(gap.after.*which, unit));
    rows.push_back(std::move(row));
  };
  add("bar, um: fitted runs", d.fit, &diagnose::Rms::radial, kUm);
  add("bar, um: runs left out", d.held_out, &diagnose::Rms::radial, kUm);
  add("torque, N m: fitted runs", d.fit, &diagnose::Rms::torque, 1);
  add("torque, N m: runs left out", d.held_out, &diagnose::Rms::torque, 1);
  return table_section("The gap, before and after", columns, std::move(rows),
                       "Before: the model as given, what [uncertainty] lists fitted anew. After: with what was found. "
                       "Runs left out did not take part in the last fit. Noise: " +
                           noise_words(d) + ".");
}

Json found_section(const NamedEffect& effect) {
  std::vector<Json> rows;
  for (const diagnose::NamedParameter& p : effect.parameters) {
    for (std::size_t i = 0; i < p.values.size(); ++i) {
      rows.push_back({p.single ? p.key : fmt::format("{} {}", p.key, i + 1), fmt::format("{:.4g}", p.values[i]),
                      p.errors[i] > 0 ? fmt::format("{:.2g}", p.errors[i]) : "not fitted", p.unit});
    }
  }
  std::string note = fmt::format("The readings are {} with it as without.", odds_words(effect.log_odds));
  if (!effect.alternatives.empty()) {
    note += fmt::format(" No data of this plan tell it from {}.", fmt::join(effect.alternatives, ", "));
  }
  return table_section("Found: " + effect.name, {{"number"}, {"value"}, {"standard error"}, {"unit"}}, std::move(rows),
                       note);
}

// Functions of one coordinate, each with its 95 % band.
Json functions_section(const Diagnosis& d) {
  std::vector<CurveGroup> groups;
  for (const diagnose::LearntFunction& function : d.functions) {
    if (function.along.empty()) continue;
    const ShownCoordinate coordinate = shown_coordinate(function, 0, d.forces.machine);
    const ShownUnit unit = shown_unit(function);
    CurveGroup group{fmt::format("{}, {} {}", function_name(function), coordinate.name, coordinate.unit), {}, {}};
    CurvePanel panel{"value", std::string(unit.name), {{"learnt", 1}, {"95 % from", 2}, {"95 % to", 2}}};
    constexpr double kTimes = 1.96;
    for (const diagnose::FunctionValue& here : function.along) {
      group.x.push_back(coordinate.value(here.at[0]));
      panel.curves[0].values.push_back(here.value / unit.si);
      panel.curves[1].values.push_back((here.value - kTimes * here.sigma) / unit.si);
      panel.curves[2].values.push_back((here.value + kTimes * here.sigma) / unit.si);
    }
    group.panels.push_back(std::move(panel));
    groups.push_back(std::move(group));
  }
  if (groups.empty()) return {};
  return curves_section("Functions that were learnt", {"where it is measured", "", 3}, groups, {"Function", false, {}});
}

Json could_show_section(const Diagnosis& d) {
  if (d.verdict != diagnose::Verdict::nothing_missing || d.visible.empty()) return nullptr;
  std::vector<Json> rows;
  for (const diagnose::Visible& one : d.visible) {
    rows.push_back({one.name, one.shows ? fmt::format("{:.2g} {}", one.smallest, one.unit) : "at no size", one.key});
  }
  return table_section("What these runs could have shown", {{"effect"}, {"from this size on"}, {"number"}},
                       std::move(rows),
                       "The smallest size that would have been named with 95 %, on the strut where it shows least. "
                       "What shows at no size may be there.");
}

void add_open_questions(Page& page, const jobs::DiagnoseResult& result, const std::vector<std::string>& programs) {
  const Diagnosis& d = result.diagnosis;
  if (d.confidence_set.size() > 1) {
    page.sections.push_back(text_section(
        "What else is not ruled out",
        {fmt::format("These runs leave {} as the strongest cause: {}.",
                     fmt::format("{} effects", d.confidence_set.size()), fmt::join(d.confidence_set, ", "))}));
  }
  std::vector<std::string> sentences;
  std::vector<ShownTest> tests;
  for (const diagnose::Separation& next : d.next) {
    sentences.push_back(sentence(next_test_text(next)));
    if (!next.test) continue;
    const std::size_t place = tests.size();
    const std::string& strongest = d.confidence_set.front();
    tests.push_back({fmt::format("{} or {}", strongest, next.from), next.test->run,
                     fmt::format("Tells {} from {}: what the two make of the readings there differs by {:.0f} standard "
                                 "deviations of the noise.",
                                 strongest, next.from, next.test->separation),
                     place < programs.size() ? programs[place] : ""});
  }
  if (sentences.empty()) return;
  page.sections.push_back(text_section("What next", sentences));
  if (!tests.empty()) page.sections.push_back(tests_section("The next test", result.machine, tests));
}

}  // namespace

Page diagnosis_page(const jobs::DiagnoseResult& result, const jobs::RunsAndModels& profiles,
                    const std::vector<std::string>& programs) {
  const Diagnosis& d = result.diagnosis;
  Page page{"Diagnosis of " + result.machine.name, verdict_words(result), mark_of(d)};
  if (std::vector<std::string> items = cautions(d); !items.empty()) {
    page.sections.push_back(warnings_section("Before you use it", std::move(items)));
  }
  page.sections.push_back(glance(result));
  for (const NamedEffect& effect : d.effects) page.sections.push_back(found_section(effect));
  add_section(page, could_show_section(d));
  add_open_questions(page, result, programs);
  if (d.remainder) {
    page.sections.push_back(
        listing_section("What the catalogue does not explain", remainder_text(*d.remainder),
                        fmt::format("A description, not a cause; {:.0f} times the noise in all.", d.remainder->snr)));
  }
  if (!d.functions.empty()) {
    page.sections.push_back(listing_section("What is corrected all the same",
                                            fmt::format("{}", fmt::join(function_lines(d), "\n")),
                                            "Learnt from these runs, confirmed by poses left out, and held as it is at "
                                            "the border outside of what was measured."));
    add_section(page, functions_section(d));
  }
  page.sections.push_back(gap_section(d));
  add_section(page, residual_circles_section(d, result.runs));
  std::vector<Json> evidence = evidence_sections(d);
  if (!evidence.empty()) page.sections.push_back(std::move(evidence.front()));
  std::vector<Json> rest{circularity_section(d), gap_map_section(d)};
  for (Json& section : around_circle_sections(d)) rest.push_back(std::move(section));
  for (Json& section : run_contrast_sections(d)) rest.push_back(std::move(section));
  for (std::size_t i = 1; i < evidence.size(); ++i) rest.push_back(std::move(evidence[i]));
  rest.push_back(circles_section(profiles, "Circles, measured and simulated"));
  rest.push_back(turn_section(profiles, "Along the turn"));
  for (Json& section : rest) add_section(page, screen_only(std::move(section)));
  return page;
}

}  // namespace plumbline::report

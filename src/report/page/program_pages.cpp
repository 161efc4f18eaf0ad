#include "report/page/program_pages.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/files/input_name.hpp"
#include "base/units.hpp"
#include "compensate/limits.hpp"
#include "report/micrometres.hpp"
#include "report/page/program_section.hpp"
#include "report/page/sections.hpp"
#include "report/program/line_text.hpp"
#include "report/program/summary_text.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

using compensate::Summary;
using compensate::Worst;

std::string at_line(const Worst& worst) {
  return worst.line == 0 ? "" : fmt::format("at line {}", line_text(worst.line, worst.file));
}

std::string file_name(const std::string& path) {
  const std::string name = input_name(path);
  return name.substr(name.find_last_of('/') + 1);
}

std::string lead(const Summary& s, const std::optional<jobs::ExpectedError>& expected) {
  if (s.identical) return "Nothing had to change: the program is written as it was.";
  std::string text =
      fmt::format("The program moves the tool tip by up to {:.1f} um to make up for what the machine sags",
                  s.correction_mm.value * kUmPerMm);
  if (s.replayed > 0)
    text += fmt::format("; rounding and subdivision leave at most {:.2f} um", s.residual_mm.value * kUmPerMm);
  text += ".";
  if (expected) {
    text += fmt::format(" On the machine {:.1f} um are expected to be left on average, 95 % within {:.1f} um",
                        expected->stands.mean / kUm, expected->stands.within / kUm);
    if (expected->touched_off)
      text += fmt::format("; with the zero touched off {:.1f} um, within {:.1f} um", expected->touched_off->mean / kUm,
                          expected->touched_off->within / kUm);
    text += ".";
  }
  return text;
}

// What is expected at the tip, as facts.
void add_expected(std::vector<Fact>& facts, const std::optional<jobs::ExpectedError>& expected) {
  if (!expected) return;
  const auto add = [&](std::string name, const jobs::ExpectedFigures& figures) {
    std::string note = fmt::format("95 % are within {:.1f} um, at the worst within {:.1f} um", figures.within / kUm,
                                   figures.largest_within / kUm);
    if (figures.line > 0) note += fmt::format(" at line {}", line_text(figures.line, figures.file));
    facts.push_back({std::move(name), figures.mean / kUm, "um", 1, std::move(note)});
  };
  add("expected error on the machine", expected->stands);
  if (expected->touched_off) add("the same, zero touched off", *expected->touched_off);
}

Json figures(const Summary& s, const machine::MachineModel& model, const std::optional<jobs::ExpectedError>& expected) {
  std::vector<Fact> facts{{"machine", model.name},
                          {"largest correction", s.correction_mm.value * kUmPerMm, "um", 1, at_line(s.correction_mm)},
                          {"largest turn", s.correction_deg.value * 1000, "mdeg", 2, at_line(s.correction_deg)}};
  if (s.replayed > 0) {
    facts.push_back({"rounding and subdivision, at most", s.residual_mm.value * kUmPerMm, "um", 3,
                     at_line(s.residual_mm) + (s.residual_mm.line > 0 ? ", on the model" : "")});
  }
  add_expected(facts, expected);
  facts.push_back({"rounding, at most", s.rounding_mm.value * kUmPerMm, "um", 3, at_line(s.rounding_mm)});
  if (s.seconds_before > 0) {
    facts.push_back(
        {"cutting time", time_text(s.seconds_after), "", 0, fmt::format("{} before", time_text(s.seconds_before))});
  }
  facts.push_back({"moves changed", fmt::format("{} of {}", count_text(s.changed_blocks), count_text(s.moves))});
  facts.push_back({"points", count_text(s.points)});
  if (s.bytes_before > 0) {
    facts.push_back({"size of the file", fmt::format("{:.2f} times", static_cast<double>(s.bytes_after) /
                                                                         static_cast<double>(s.bytes_before))});
  }
  if (s.short_pieces.below_1_ms > 0) {
    facts.push_back({"blocks shorter than 1 ms", count_text(s.short_pieces.below_1_ms), "", 0,
                     fmt::format("the shortest {:.3g} ms at line {}", s.short_pieces.least_s / kMs,
                                 line_text(s.short_pieces.line, s.short_pieces.file))});
  }
  facts.push_back({"condition number, at most", s.condition.value, "", 1, at_line(s.condition)});
  return facts_section("", facts);
}

}  // namespace

Page compensation_page(const jobs::Compensation& compensation, const std::string& program,
                       const settings::Options& options) {
  const Summary& s = compensation.summary;
  Page page{.title = fmt::format("{} on {}", file_name(program), compensation.model.name),
            .lead = lead(s, compensation.expected.error)};
  page.has_scene = true;
  page.verdict = s.warnings.empty() ? Verdict::good : Verdict::warn;
  page.sections.push_back(figures(s, compensation.model, compensation.expected.error));
  if (!s.warnings.empty()) {
    std::vector<std::string> items;
    for (const Diagnostic& warning : s.warnings) items.push_back(warning.message + ": " + warning.help);
    page.sections.push_back(warnings_section("Before you cut", std::move(items)));
  }
  page.sections.push_back(
      program_section(*compensation.path, &compensation.model,
                      {.corrected = true, .program = input_name(program), .doubts = compensation.expected.drawn}));
  page.sections.push_back(
      screen_only(listing_section("All figures", summary_text(s, options, compensation.expected.error))));
  return page;
}

Page simulation_page(const jobs::SimulationSummary& summary, const jobs::ProgramPicture& picture,
                     const std::string& program) {
  Page page{.title = fmt::format("{} on {}", file_name(program), picture.model.name),
            .lead = fmt::format("As it stands, the program leaves the tool tip up to {:.1f} um off its path.",
                                summary.largest_um),
            .has_scene = true};
  std::vector<Fact> facts{
      {"machine", picture.model.name},
      {"largest error at the tip", summary.largest_um, "um", 2, fmt::format("at line {}", summary.largest_line)},
      {"rms", summary.rms_um, "um", 2},
      {"cutting time", time_text(summary.seconds)},
      {"points", count_text(summary.points)}};
  add_expected(facts, summary.expected);
  if (summary.passed_moves > 0) {
    facts.push_back({"moves left out", count_text(summary.passed_moves), "", 0,
                     "machine coordinates, probing, or from where nobody knows"});
  }
  page.sections = {
      facts_section("", facts),
      program_section(picture.path, &picture.model, {.program = input_name(program), .doubts = picture.doubts})};
  return page;
}

Page check_page(const jobs::CheckSummary& summary, const jobs::ProgramPicture& picture, const std::string& program) {
  const bool kept = summary.violations == 0;
  Page page{.title = fmt::format("{} on {}: limits", file_name(program), picture.model.name),
            .verdict = kept ? (summary.refusal ? Verdict::warn : Verdict::good) : Verdict::bad,
            .has_scene = true};
  page.lead = kept ? "The program, compensated, keeps all limits of the machine."
                   : fmt::format("The program, compensated, goes beyond the limits of the machine in {}.",
                                 count_text(summary.violations, "place"));
  page.sections.push_back(facts_section("", {{"machine", picture.model.name},
                                             {"blocks", count_text(summary.blocks)},
                                             {"points looked at", count_text(summary.points)},
                                             {"moves not looked at", count_text(summary.passed_moves)}}));
  if (summary.refusal) {
    page.sections.push_back(
        warnings_section("compensate would refuse it", {fmt::format("line {}: {}: {}", summary.refusal->place.line,
                                                                    summary.refusal->message, summary.refusal->help)}));
  }
  if (!kept) {
    std::vector<Json> rows;
    for (const jobs::CheckFinding& finding : summary.findings) {
      const machine::Violation& v = finding.violation;
      if (v.what == compensate::kOutOfReach) {
        rows.push_back({static_cast<double>(finding.line), "no command leads there", "", "", "", ""});
      } else {
        rows.push_back({static_cast<double>(finding.line), v.what, v.value, v.limit, v.by_how_much, v.unit});
      }
    }
    page.sections.push_back(
        table_section("Beyond a limit", {{"line", "", 0}, {"what"}, {"value"}, {"limit"}, {"beyond it by"}, {"unit"}},
                      std::move(rows), summary.findings.size() < summary.violations ? "the first of them" : ""));
  }
  page.sections.push_back(program_section(
      picture.path, &picture.model, {.corrected = true, .program = input_name(program), .doubts = picture.doubts}));
  return page;
}

Page diff_page(const jobs::DiffSummary& summary, const compensate::DrawnPath& path, const std::string& a,
               const std::string& b) {
  Page page{.title = fmt::format("{} against {}", file_name(b), file_name(a)), .has_scene = true};
  double largest_mm = 0;
  std::vector<Fact> facts;
  for (const Axis axis : kAllAxes) {
    const jobs::AxisShift& shift = summary.shift[index(axis)];
    if (!is_rotary(axis)) largest_mm = std::max(largest_mm, shift.largest);
    facts.push_back({fmt::format("largest shift of {}", letter(axis)),
                     shift.largest * (is_rotary(axis) ? 1000 : kUmPerMm), is_rotary(axis) ? "mdeg" : "um", 2,
                     shift.line_a > 0
                         ? fmt::format("line {} of the first, {} of the second", shift.line_a, shift.line_b)
                         : std::string()});
  }
  facts.push_back({"time", fmt::format("{} and {}", time_text(summary.seconds_a), time_text(summary.seconds_b)), "", 0,
                   "of cutting and waiting"});
  facts.push_back(
      {"moves that correspond", fmt::format("{} of {}", count_text(summary.matched), count_text(summary.moves_a))});
  page.lead = fmt::format("The second program stands up to {:.1f} um off the first in an axis.", largest_mm * kUmPerMm);
  if (!summary.out_of_line.empty()) {
    page.lead += fmt::format(" {} of the first and {} of the second have no counterpart.",
                             count_text(summary.out_of_line_a, "move"), count_text(summary.out_of_line_b, "move"));
    page.verdict = Verdict::warn;
  }
  page.sections = {
      facts_section("", facts),
      program_section(
          path, nullptr,
          {.corrected = true, .shift = "shift", .told = "the second program", .replaced = "the second program has"})};
  return page;
}

}  // namespace plumbline::report

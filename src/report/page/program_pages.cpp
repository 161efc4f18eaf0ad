#include "report/page/program_pages.hpp"

#include <fmt/format.h>

#include "base/files/input_name.hpp"
#include "base/units.hpp"
#include "report/page/program_section.hpp"
#include "report/page/sections.hpp"
#include "report/program/summary_text.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

using compensate::Summary;
using compensate::Worst;

constexpr double kPageUm = kMm / kUm;  // per mm

std::string at_line(const Worst& worst) { return worst.line == 0 ? "" : fmt::format("at line {}", worst.line); }

std::string file_name(const std::string& path) {
  const std::string name = input_name(path);
  return name.substr(name.find_last_of('/') + 1);
}

std::string lead(const Summary& s) {
  if (s.identical) return "Nothing had to change: the program is written as it was.";
  std::string text =
      fmt::format("The program moves the tool tip by up to {:.1f} um to make up for what the machine sags",
                  s.correction_mm.value * kPageUm);
  if (s.replayed > 0) text += fmt::format("; on the model, at most {:.2f} um is left", s.residual_mm.value * kPageUm);
  return text + ".";
}

Json figures(const Summary& s, const machine::MachineModel& model) {
  std::vector<Fact> facts{{"machine", model.name},
                          {"largest correction", s.correction_mm.value * kPageUm, "um", 1, at_line(s.correction_mm)},
                          {"largest turn", s.correction_deg.value * 1000, "mdeg", 2, at_line(s.correction_deg)}};
  if (s.replayed > 0) {
    facts.push_back({"left at the tip, at most", s.residual_mm.value * kPageUm, "um", 3,
                     at_line(s.residual_mm) + (s.residual_mm.line > 0 ? ", on the model" : "")});
  }
  facts.push_back({"rounding, at most", s.rounding_mm.value * kPageUm, "um", 3, at_line(s.rounding_mm)});
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
    facts.push_back(
        {"blocks shorter than 1 ms", count_text(s.short_pieces.below_1_ms), "", 0,
         fmt::format("the shortest {:.3g} ms at line {}", s.short_pieces.least_s / kMs, s.short_pieces.line)});
  }
  facts.push_back({"condition number, at most", s.condition.value, "", 1, at_line(s.condition)});
  return facts_section("", facts);
}

}  // namespace

Page compensation_page(const jobs::Compensation& compensation, const std::string& program,
                       const settings::Options& options) {
  const Summary& s = compensation.summary;
  Page page{.title = fmt::format("{} on {}", file_name(program), compensation.model.name), .lead = lead(s)};
  page.has_scene = true;
  page.verdict = s.warnings.empty() ? Verdict::good : Verdict::warn;
  page.sections.push_back(figures(s, compensation.model));
  if (!s.warnings.empty()) {
    std::vector<std::string> items;
    for (const Diagnostic& warning : s.warnings) items.push_back(warning.message + ": " + warning.help);
    page.sections.push_back(warnings_section("Before you cut", std::move(items)));
  }
  page.sections.push_back(
      program_section(*compensation.path, compensation.model, {.corrected = true, .told = "corrected"}));
  page.sections.push_back(listing_section("All figures", summary_text(s, options)));
  return page;
}

}  // namespace plumbline::report

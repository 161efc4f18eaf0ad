#include "report/program/check_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/program/expected_text.hpp"
#include "report/program/line_text.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

constexpr std::size_t kFindingsShown = 20;
using Json = nlohmann::ordered_json;

std::string message_of(const jobs::CheckFinding& finding) {
  if (finding.violation.what == "reach") return "no command puts the tool there";
  std::string message = machine::to_text(finding.violation);
  if (finding.left_by > 0)
    message += fmt::format(", where line {} left it", line_text(finding.left_by, finding.left_by_file));
  return message;
}

}  // namespace

std::string check_text(const jobs::CheckSummary& summary) {
  std::string text;
  const std::size_t shown = std::min(kFindingsShown, summary.findings.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const jobs::CheckFinding& finding = summary.findings[i];
    text += fmt::format("{}:{}: {}\n", finding.file, finding.line, message_of(finding));
  }
  if (summary.violations > shown) text += fmt::format("and {} more\n", count_text(summary.violations - shown));
  TextTable table;
  table.add("blocks", fmt::format("{}, {} looked at", count_text(summary.blocks), count_text(summary.points, "point")));
  if (summary.passed_moves > 0) {
    table.add("not looked at", fmt::format("{}: machine coordinates, probing, or from where nobody knows",
                                           count_text(summary.passed_moves, "move")));
  }
  if (summary.violations == 0) table.add("limits", "all kept");
  for (const auto& [kind, count] : summary.kinds) {
    table.add(kind, fmt::format("beyond its limit in {}", count_text(count, "block")));
  }
  if (summary.expected.error) add_expected(table, *summary.expected.error);
  return text + table.text();
}

std::string check_json(const jobs::CheckSummary& summary) {
  Json findings = Json::array();
  for (const jobs::CheckFinding& f : summary.findings) {
    findings.push_back({{"file", f.file},
                        {"line", f.line},
                        {"what", f.violation.what},
                        {"value", f.violation.value},
                        {"limit", f.violation.limit},
                        {"by_how_much", f.violation.by_how_much},
                        {"unit", f.violation.unit},
                        {"message", message_of(f)}});
    if (f.left_by > 0) findings.back()["left_by"] = f.left_by;
    if (!f.left_by_file.empty()) findings.back()["left_by_file"] = f.left_by_file;
  }
  Json refusal;  // null: none
  if (const auto& r = summary.refusal) {
    refusal = {{"code", r->code},
               {"message", r->message},
               {"help", r->help},
               {"file", r->place.file},
               {"line", r->place.line}};
  }
  Json kinds = Json::object();
  for (const auto& [kind, count] : summary.kinds) kinds[kind] = count;
  const Json json{{"plumbline", "check 1"},
                  {"blocks", summary.blocks},
                  {"points", summary.points},
                  {"passed_moves", summary.passed_moves},
                  {"violations", summary.violations},
                  {"blocks_by_kind", kinds},
                  {"findings", findings},
                  {"refusal", refusal},
                  {"expected", expected_json(summary.expected.error)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plumbline::report

#include "report/program/batch_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text/printable.hpp"
#include "report/diagnostic_json.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

using Item = jobs::BatchItem;
using Json = nlohmann::ordered_json;

std::string_view name_of(Item::State state) {
  switch (state) {
    case Item::State::done:
      return "done";
    case Item::State::unchanged:
      return "unchanged";
    case Item::State::failed:
      return "refused";
    case Item::State::subprogram:
      return "subprogram";
    case Item::State::compensated:
      break;
  }
  return "compensated";
}

std::string quoted(const std::string& text) { return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace); }

void add_count(std::string& text, const std::string& count, std::string_view what) {
  if (!count.starts_with("0")) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
}

}  // namespace

std::string batch_heading() {
  return fmt::format("{:>10} {:>10} {:>14} {:>12} {:>20}  {}\n", "blocks", "points", "correction", "left",
                     "cutting time", "output");
}

std::string batch_line(const Item& item) {
  const Json json = item.summary.empty() ? Json() : Json::parse(item.summary, nullptr, false);
  if (!json.is_object()) return fmt::format("{:>70}  {}\n", name_of(item.state), printable(item.program));
  const Json& left = json["worst_residual_um"];
  return fmt::format("{:>10} {:>10} {:>11.4f} mm {:>12} {:>20}  {}\n", count_text(json["blocks"].get<std::uint64_t>()),
                     count_text(json["points"].get<std::uint64_t>()),
                     json["largest_correction_mm"]["value"].get<double>(),
                     left.is_null() ? "" : fmt::format("{:.2f} um", left["value"].get<double>()),
                     time_text(json["time_after_s"].get<double>()),
                     printable(item.output) + (item.state == Item::State::unchanged ? "  (unchanged)" : ""));
}

std::string batch_total(const jobs::BatchSummary& summary) {
  std::string text;
  add_count(text, count_text(summary.done), "compensated");
  add_count(text, count_text(summary.unchanged), "unchanged");
  add_count(text, count_text(summary.failed), "refused");
  add_count(text, count_text(summary.subprograms, "subprogram"), "of others");
  if (text.empty()) text = "no programs";
  text += fmt::format(" in {}", time_text(summary.seconds));
  std::string others;
  add_count(others, count_text(summary.passed_over.size(), "file"), "passed over");
  add_count(others, count_text(summary.compensated), "compensated before");
  add_count(others, count_text(summary.vanished.size(), "output"), "whose program is gone");
  return text + (others.empty() ? "" : "; " + others) + "\n";
}

std::string batch_json_line(const Item& item) {
  std::string diagnostics;
  for (const Diagnostic& one : item.diagnostics) {
    if (!diagnostics.empty()) diagnostics += ',';
    diagnostics += diagnostic_json(one);
  }
  return fmt::format(
      R"({{"plumbline":"batch 1","program":{},"output":{},"state":"{}","summary":{},"diagnostics":[{}]}})"
      "\n",
      quoted(item.program), quoted(item.output), name_of(item.state), item.summary.empty() ? "null" : item.summary,
      diagnostics);
}

std::string batch_json_total(const jobs::BatchSummary& summary) {
  const Json json{{"plumbline", "batch total 1"},           {"done", summary.done},
                  {"unchanged", summary.unchanged},         {"refused", summary.failed},
                  {"subprograms", summary.subprograms},     {"compensated", summary.compensated},
                  {"passed_over", summary.passed_over},     {"vanished", summary.vanished},
                  {"among_outputs", summary.among_outputs}, {"time_s", summary.seconds}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plumbline::report

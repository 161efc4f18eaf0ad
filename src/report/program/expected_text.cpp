#include "report/program/expected_text.hpp"

#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "base/units.hpp"
#include "report/program/csv_columns.hpp"
#include "report/program/line_text.hpp"

namespace plumbline::report {
namespace {

using jobs::Cause;
using jobs::ExpectedFigures;
using Json = nlohmann::ordered_json;

constexpr double kLeastNamed = 5e-8;  // m, rms: a cause that makes less is not named
constexpr std::size_t kPerDoubt = 11;

std::string_view words_of(Cause cause) {
  switch (cause) {
    case Cause::geometry:
      return "geometry";
    case Cause::elasticity:
      return "elasticity and loads";
    case Cause::friction:
      return "friction";
    case Cause::noise:
      return "noise of the fit";
    case Cause::which_effect:
      return "which effect it is";
    case Cause::unexplained:
      break;
  }
  return "what is unexplained";
}

// "5.2 um on average, 95 % within 9.4 um, at the worst within 11.3 um (line 812)"
std::string figures_text(const ExpectedFigures& figures) {
  std::string text = fmt::format("{:.1f} um on average, 95 % within {:.1f} um, at the worst within {:.1f} um",
                                 figures.mean / kUm, figures.within / kUm, figures.largest_within / kUm);
  if (figures.line > 0) text += fmt::format(" (line {})", line_text(figures.line, figures.file));
  return text;
}

// "rms by geometry 4.9, friction 0.6 um"
std::string causes_text(const ExpectedFigures& figures) {
  std::string text;
  for (const Cause cause : jobs::kAllCauses) {
    const double rms = figures.rms[jobs::index(cause)];
    if (rms >= kLeastNamed)
      text += fmt::format("{}{} {:.1f}", text.empty() ? "rms by " : ", ", words_of(cause), rms / kUm);
  }
  return text.empty() ? text : text + " um";
}

Json figures_json(const ExpectedFigures& figures) {
  Json json{{"mean_um", figures.mean / kUm},
            {"within_95_um", figures.within / kUm},
            {"largest_within_95_um", {{"value", figures.largest_within / kUm}, {"line", figures.line}}}};
  if (!figures.file.empty()) json["largest_within_95_um"]["file"] = figures.file;
  Json& causes = json["rms_by_cause_um"] = Json::object();
  for (const Cause cause : jobs::kAllCauses)
    causes[std::string(jobs::key_of(cause))] = figures.rms[jobs::index(cause)] / kUm;
  return json;
}

void append_numbers(std::vector<double>& all, const jobs::TipDoubt& doubt) {
  for (const double number : {doubt.mean, doubt.within}) all.push_back(number / kUm);
  for (const double number : doubt.axis_within) all.push_back(number / kUm);
  for (const double number : doubt.rms) all.push_back(number / kUm);
}

}  // namespace

void add_expected(TextTable& table, const jobs::ExpectedError& expected) {
  table.add("expected at the tip", figures_text(expected.stands));
  table.add("", causes_text(expected.stands));
  if (expected.touched_off) {
    table.add("zero touched off", figures_text(*expected.touched_off));
    table.add("", causes_text(*expected.touched_off));
  }
  table.add("", fmt::format("known from {}", expected.made_by));
}

std::string expected_text(const std::optional<jobs::ExpectedError>& expected) {
  if (!expected) return "";
  TextTable table;
  add_expected(table, *expected);
  return table.text();
}

Json expected_json(const std::optional<jobs::ExpectedError>& expected) {
  if (!expected) return {};
  Json zero;
  for (const Axis axis : kAllAxes) {
    const char lower = static_cast<char>(letter(axis) - 'A' + 'a');
    zero[std::string(1, lower) + (is_rotary(axis) ? "_deg" : "_mm")] = expected->zero[axis];
  }
  return {{"from", expected->made_by},
          {"from_data", expected->from_data},
          {"poses", expected->poses},
          {"stands", figures_json(expected->stands)},
          {"touched_off", expected->touched_off ? figures_json(*expected->touched_off) : Json()},
          {"zero", zero}};
}

std::string_view expected_columns() {
  static const std::string columns = [] {
    std::string names;
    for (const std::string_view which : {"", "touched_off_"}) {
      for (const std::string_view what : {"expected", "within_95", "within_95_x", "within_95_y", "within_95_z"})
        names += fmt::format(",{}{}_um", which, what);
      for (const Cause cause : jobs::kAllCauses) names += fmt::format(",{}{}_um", which, jobs::key_of(cause));
    }
    return names;
  }();
  return columns;
}

std::vector<double> expected_numbers(const std::optional<jobs::PoseDoubt>& doubt) {
  std::vector<double> all;
  all.reserve(2 * kPerDoubt);
  if (doubt) append_numbers(all, doubt->stands);
  all.resize(kPerDoubt, std::numeric_limits<double>::quiet_NaN());
  if (doubt && doubt->touched_off) append_numbers(all, *doubt->touched_off);
  all.resize(2 * kPerDoubt, std::numeric_limits<double>::quiet_NaN());
  return all;
}

void append_expected(std::string& row, const std::optional<jobs::PoseDoubt>& doubt) {
  for (const double number : expected_numbers(doubt)) {
    if (std::isnan(number)) {
      row += ',';
    } else {
      append_columns(row, std::array{number}, 1, 4);
    }
  }
}

}  // namespace plumbline::report

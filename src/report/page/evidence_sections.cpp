#include "report/page/evidence_sections.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "report/page/measured_sections.hpp"
#include "report/page/sections.hpp"
#include "report/text_table.hpp"

namespace plumbline::report {
namespace {

using diagnose::Evidence;

constexpr std::size_t kMostBars = 10;
constexpr double kManyTimes = 1e6;  // beyond that the number says nothing to anybody

double tens(double nats) { return nats / std::numbers::ln10; }

Json tens_or_none(const Evidence& e, double diagnose::LeftOut::*which) {
  return e.left_out ? Json(tens((*e.left_out).*which)) : Json("not computed");
}

// Two digits of a number of at least ten.
std::uint64_t two_digits(double odds) {
  const double magnitude = std::pow(10, std::floor(std::log10(odds)) - 1);
  return static_cast<std::uint64_t>(std::round(odds / magnitude) * magnitude);
}

// "1,200", "1 / 3.2": how many times as likely.
std::string times_text(double nats) {
  const double odds = std::exp(std::abs(nats));
  const std::string number = odds > kManyTimes ? "more than a million"
                             : odds < 10       ? fmt::format("{:.1f}", odds)
                                               : count_text(two_digits(odds));
  return nats < 0 ? "1 / " + number : number;
}

Json evidence_bars(const diagnose::Diagnosis& d) {
  BarChart chart{"powers of ten", 1, {{"evidence", 1}}};
  for (std::size_t i = 0; i < std::min(d.evidence.size(), kMostBars); ++i) {
    const Evidence& e = d.evidence[i];
    const bool stays = std::find(d.confidence_set.begin(), d.confidence_set.end(), e.name) != d.confidence_set.end();
    chart.rows.push_back({e.name, {{tens(e.log_odds), {}, {}, stays ? 2 : 1}}});
  }
  chart.references = {{"chance", tens(d.threshold)}};
  chart.words =
      "How much more likely the readings are with the effect than without it, each in the place of the strongest: 1 "
      "means ten times, 2 a hundred times, 3 a thousand times. Orange: not ruled out as the strongest. The line: what "
      "the best of the catalogue reaches by chance in 0.3 % of machines that lack nothing.";
  return bars_section("Which effect it is", chart);
}

}  // namespace

std::string odds_words(double nats) {
  const double odds = std::exp(std::abs(nats));
  const char* const than = nats < 0 ? "less" : "as";
  if (odds > kManyTimes) return fmt::format("more than a million times {} likely", than);
  if (odds < 10) return fmt::format("{:.1f} times {} likely", odds, than);
  return fmt::format("about {} times {} likely", count_text(two_digits(odds)), than);
}

std::vector<Json> evidence_sections(const diagnose::Diagnosis& d) {
  if (d.evidence.empty()) return {};
  std::vector<Json> rows;
  for (const Evidence& e : d.evidence) {
    rows.push_back({e.name, tens(e.log_odds), times_text(e.log_odds), tens_or_none(e, &diagnose::LeftOut::poses),
                    tens_or_none(e, &diagnose::LeftOut::runs)});
  }
  return {evidence_bars(d), table_section("All effects that were compared",
                                          {{"effect"},
                                           {"all fitted runs", "", 1},
                                           {"times as likely"},
                                           {"each pose from the others", "", 1},
                                           {"each run from the others", "", 1}},
                                          std::move(rows),
                                          "In powers of ten. Poses and runs from the others: each left out in turn and "
                                          "predicted; what is no cause does not "
                                          "predict them better.")};
}

}  // namespace plumbline::report

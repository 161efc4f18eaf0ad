// The search, and the rivals that it weighs: on readings with one thing hidden.
#include "diagnose/search/search.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "diagnose/hidden.hpp"

namespace plumbline::diagnose {
namespace {

Model searched(const testing::Hidden& hidden, std::vector<std::string>& steps) {
  SearchOptions options;
  options.threshold.draws = 1000;
  return search(hidden.bench(), options, {[&](const std::string& step) { steps.push_back(step); }});
}

}  // namespace

TEST_CASE("the search finds the effect that is missing on the strut where it acts, and nothing beside it") {
  const testing::Hidden hidden("backlash", "width_um", 2, 6e-6);
  std::vector<std::string> steps;
  const Model model = searched(hidden, steps);
  REQUIRE(model.found.size() == 1);
  const Found& found = model.found.front();
  CHECK(found.pick.candidate->name == "backlash");
  CHECK(found.log_odds > model.threshold);
  CHECK_FALSE(model.one_more);
  const int width = hidden.candidates.unknowns.find("backlash", "width_um", 2);
  CHECK(std::abs(model.fit.values[width] - 6e-6) < 0.5e-6);
  CHECK(model.fit.misfit < model.base.fit.misfit);
  // it is no rival of itself; those fitted come first, the likeliest of them at the front
  REQUIRE_FALSE(found.rivals.empty());
  for (const Rival& rival : found.rivals) CHECK(rival.pick.candidate != found.pick.candidate);
  CHECK(std::is_partitioned(found.rivals.begin(), found.rivals.end(), [](const Rival& r) { return r.refitted; }));
  CHECK(std::any_of(steps.begin(), steps.end(), [](const std::string& s) { return s.starts_with("threshold "); }));
}

TEST_CASE("where nothing is missing the search finds nothing") {
  const testing::Hidden nothing("backlash", "width_um", 2, 0);
  std::vector<std::string> steps;
  const Model model = searched(nothing, steps);
  CHECK(model.found.empty());
  CHECK_FALSE(model.one_more);
  CHECK(model.fit.misfit == model.base.fit.misfit);
}

TEST_CASE("a pick takes another's place, stands beside it or leaves") {
  Candidate one;
  Candidate other;
  const std::vector<Pick> picks{{&one}};
  CHECK(with(picks, {&other}, 0).front().candidate == &other);
  CHECK(with(picks, {&other}, 1).size() == 2);
  CHECK(without(picks, 0).empty());
  CHECK(without(picks, 1).size() == 1);
}

}  // namespace plumbline::diagnose

#include "compensate/limits.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "compensate/opened.hpp"

using namespace plumbline;

namespace {

compensate::Target target_at(double x, double a = 0) { return {{{x, 0, -1008, a, 0, 0}}, {}, {}, std::nullopt}; }

}  // namespace

TEST_CASE("a line is looked at every 10 mm or 1 deg") {
  CHECK(compensate::chord_steps({}) == 1);
  CHECK(compensate::chord_steps({{10, 0, 0, 0, 0, 0}}) == 1);
  CHECK(compensate::chord_steps({{10.5, 0, 0, 0, 0, 0}}) == 2);
  CHECK(compensate::chord_steps({{1, 0, 0, 0, -7.5, 0}}) == 8);
}

TEST_CASE("a target breaks limits as it is programmed and as it is commanded") {
  const machine::MachineModel model = Job().model;
  const compensate::Settings settings;
  const compensate::Corrector corrector(model, settings);
  const compensate::Command within = compensate::command(corrector, model.limits, target_at(0));
  CHECK(within.corrected.converged);
  CHECK(within.violations.empty());
  const compensate::Command tilted = compensate::command(corrector, model.limits, target_at(0, 30));
  REQUIRE_FALSE(tilted.violations.empty());
  CHECK(tilted.violations.front().what == "tilt");
  const compensate::Command beyond = compensate::command(corrector, model.limits, target_at(310));
  CHECK(std::any_of(beyond.violations.begin(), beyond.violations.end(),
                    [](const machine::Violation& violation) { return violation.what == "X"; }));
}

TEST_CASE("of each kind of violation the worst is kept") {
  std::vector<machine::Violation> kept;
  compensate::keep_worst(kept, {{"X", 301, 300, 1, "mm"}, {"tilt", 26, 25, 1, "deg"}});
  compensate::keep_worst(kept, {{"X", 303, 300, 3, "mm"}, {"tilt", 25.5, 25, 0.5, "deg"}, {"Y", 301, 300, 1, "mm"}});
  REQUIRE(kept.size() == 3);
  CHECK(kept[0].value == 303);
  CHECK(kept[1].value == 26);
  CHECK(kept[2].what == "Y");
}

TEST_CASE("the first violation is refused at its block, and what no command reaches as unreachable") {
  const Opened opened("G21 G90\n  G0 X1\nM2\n", standing_at_zero());
  compensate::MoveReader reader = reader_of(opened);
  reader.next();
  const nc::Step* const step = reader.next();
  REQUIRE(step != nullptr);
  compensate::refuse_violations({}, *step);
  const auto refused = [&](const std::string& what) {
    return testing::refusal_of([&] { compensate::refuse_violations({{what, 2, 1, 1, "mm"}, {"tilt"}}, *step); });
  };
  CHECK(refused("X").code == "limit-travel");
  CHECK(refused("X").place.line == 2);
  CHECK(refused("X").place.column == 3);
  CHECK(refused("strut 2").code == "limit-strut");
  CHECK(refused("tilt").code == "limit-tilt");
  CHECK(refused("condition").code == "limit-condition");
  CHECK(refused(std::string(compensate::kOutOfReach)).code == "compensate-unreachable");
}

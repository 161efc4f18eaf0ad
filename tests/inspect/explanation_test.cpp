#include "inspect/explanation.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"

using namespace plumbline;
using inspect::FaultKind;
using inspect::Tried;

TEST_CASE("what explains a run takes most of what is off and leaves little more than noise") {
  const inspect::InspectOptions options;
  const measure::Run run;
  const auto with = [&](double before, double after) {
    return inspect::explanation({Tried{{FaultKind::bar_sign, {0}}, after, 0}}, run, before, 100, 1, options);
  };
  CHECK(with(400, 110).has_value());
  CHECK(with(400, 110)->before == Approx(2));
  CHECK_FALSE(with(400, 240).has_value());   // more than half is left
  CHECK_FALSE(with(2000, 300).has_value());  // most is gone, and what is left is no noise
  CHECK_FALSE(with(140, 100).has_value());   // too few nats
}

TEST_CASE("of faults that explain a run about as well the others are named with the best one") {
  const inspect::InspectOptions options;
  const measure::Run run;
  const auto found =
      inspect::explanation({Tried{{FaultKind::bar_sign, {0}}, 120, 0}, Tried{{FaultKind::direction, {0}}, 110, 0},
                            Tried{{FaultKind::motor_sign, {0}}, 300, 0}},
                           run, 400, 100, 1, options);
  REQUIRE(found.has_value());
  CHECK(found->kind == FaultKind::direction);
  CHECK(found->or_these == std::vector<FaultKind>{FaultKind::bar_sign});
}

TEST_CASE("a number that is off by less than people get wrong is no mistake") {
  const inspect::InspectOptions options;
  measure::Run run;
  run.payload_mass = 10;
  const auto payload = [](double kg) {
    Tried one{{FaultKind::payload, {0}}, 100, 0};
    one.fault.values = {kg};
    return one;
  };
  std::vector<Tried> all{payload(10.2), payload(11), payload(9)};
  inspect::leave_large_ones(all, run, options);
  CHECK(all.size() == 2);
}

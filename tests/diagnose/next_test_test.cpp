#include "diagnose/next_test.hpp"

#include <catch2/catch.hpp>

#include "diagnose/usual_noise.hpp"
#include "identify/plans.hpp"
#include "measure/planned_run.hpp"

namespace plumbline::diagnose {
namespace {

using physics::ForceModel;

ForceModel model_with(const std::string& effect, const std::string& key, double value) {
  ForceModel forces(testing::pm600_like());
  forces.add(effect);
  forces.parameters[static_cast<std::size_t>(forces.find(effect, key))] = value;
  return forces;
}

// Few designs: quick.
NextTestOptions few() {
  NextTestOptions options;
  options.samples = 12;
  return options;
}

std::optional<NextTest> between(const ForceModel& one, const ForceModel& other, const NextTestOptions& options) {
  measure::Run like = testing::papers_plan(120)[0];
  measure::lay_samples(like, 120, true, true);
  return next_test(testing::pm600_like(), one, other, like, testing::usual_noise(), options);
}

TEST_CASE("no test separates a model from itself") {
  const ForceModel model = model_with("inertia", "mass_kg", 100);
  CHECK_FALSE(between(model, model, few()));
}

TEST_CASE("what grows with speed is separated by a fast test, within the machine's limits") {
  const ForceModel still(testing::pm600_like());
  const auto fast = between(still, model_with("inertia", "mass_kg", 400), few());
  REQUIRE(fast);
  CHECK(fast->run.feed == Approx(6000 * kMmPerMin));
  CHECK(fast->separation > 1);
  CHECK(measure::within_limits(testing::pm600_like(), fast->run));
  NextTestOptions slow = few();
  slow.feeds_mm_min = {1000};
  const auto next = between(still, model_with("inertia", "mass_kg", 400), slow);
  CHECK((!next || next->separation < 0.2 * fast->separation));
}

}  // namespace
}  // namespace plumbline::diagnose

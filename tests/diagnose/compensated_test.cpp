#include "diagnose/compensated.hpp"

#include <catch2/catch.hpp>

#include "identify/plans.hpp"

namespace plumbline::diagnose {
namespace {

using physics::ForceModel;

ForceModel forces_with(const std::string& effect, const std::string& key, double value) {
  ForceModel forces(testing::pm600_like());
  forces.add(effect);
  forces.parameters[static_cast<std::size_t>(forces.find(effect, key))] = value;
  return forces;
}

measure::Run made_by(const ForceModel& forces) {
  testing::Random random(3);
  return testing::measured({testing::papers_plan()[1]}, forces, 0, 0, random)[0];
}

double left_of_circle(const measure::Run& run, const ForceModel& by) {
  return *compensated_circularity(testing::pm600_like().rotation, run, by);
}

TEST_CASE("a circle that is compensated with the model that it was made by is round") {
  // no friction: its turns are compensated more slowly than the machine makes them
  ForceModel forces(testing::pm600_like());
  const int friction = forces.find("screw-friction", "coulomb_friction_N");
  REQUIRE(friction >= 0);
  for (int j = 0; j < machine::kStruts; ++j) forces.parameters[static_cast<std::size_t>(friction + j)] = 0;
  const measure::Run run = made_by(forces);
  CHECK(*measured_circularity(run) > 50e-6);
  CHECK(left_of_circle(run, forces) < 0.02 * *measured_circularity(run));
}

TEST_CASE("the model with what it lacked leaves less than the one without") {
  const ForceModel complete = forces_with("payload", "mass_kg", 20);
  const measure::Run run = made_by(complete);
  const ForceModel given(testing::pm600_like());
  CHECK(left_of_circle(run, given) < *measured_circularity(run));
  CHECK(left_of_circle(run, complete) < 0.6 * left_of_circle(run, given));
}

TEST_CASE("what a control shapes itself is not compensated") {
  const ForceModel lagging = forces_with("servo-lag", "lag_ms", 0.04);
  const measure::Run run = made_by(lagging);
  CHECK(left_of_circle(run, lagging) == Approx(left_of_circle(run, ForceModel(testing::pm600_like()))));
}

TEST_CASE("without readings of the bar there is no circularity") {
  measure::Run run = testing::papers_plan()[0];
  run.radial.clear();
  CHECK_FALSE(measured_circularity(run));
  CHECK_FALSE(compensated_circularity(testing::pm600_like().rotation, run, ForceModel(testing::pm600_like())));
}

}  // namespace
}  // namespace plumbline::diagnose

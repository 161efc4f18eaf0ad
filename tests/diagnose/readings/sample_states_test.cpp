#include "diagnose/readings/sample_states.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "machine/machines.hpp"
#include "measure/runs.hpp"

namespace plumbline::diagnose {
namespace {

std::vector<SampleState> states_of(const measure::Run& run) {
  const machine::MachineModel machine = testing::pm600_like();
  return sample_states(machine.rotation, physics::ForceModel(machine), run);
}

TEST_CASE("a sample's speed is how fast its struts become longer, and time is the dataset's") {
  measure::Run run = testing::circle_run({0, 100, -1008}, {-18, 0, 0}, measure::Direction::ccw, 720);
  run.start = 3600;
  const std::vector<SampleState> states = states_of(run);
  REQUIRE(states.size() == 720);
  CHECK(states[7].time == Approx(3600 + run.time[7]));
  const double apart = run.time[102] - run.time[100];
  for (int j = 0; j < machine::kStruts; ++j) {
    // the way that the machine stands off from its commands hardly changes in half a degree
    const double grown = states[102].struts.length[j] - states[100].struts.length[j];
    CHECK(states[101].speed[j] == Approx(grown / apart).epsilon(0.01).margin(1e-5));
    CHECK(states[101].sign[j] * states[101].speed[j] > 0);
  }
}

TEST_CASE("the other way round struts go the other way at the same places") {
  const std::vector<SampleState> ccw = states_of(testing::circle_run({0, 0, -1008}, {0, 0, 0}));
  const std::vector<SampleState> cw = states_of(testing::circle_run({0, 0, -1008}, {0, 0, 0}, measure::Direction::cw));
  for (int j = 0; j < machine::kStruts; ++j) {
    CHECK(cw[0].speed[j] == Approx(-ccw[0].speed[j]));
    CHECK(cw[0].acceleration[j] == Approx(ccw[0].acceleration[j]));
  }
  CHECK((cw[0].pose.p_WT - ccw[0].pose.p_WT).norm() < 1e-4);
}

TEST_CASE("what is hung at the tip is carried by the struts, by as much as it weighs") {
  measure::Run run = testing::circle_run({0, 0, -1008}, {0, 0, 0}, measure::Direction::ccw, 12);
  const std::vector<SampleState> bare = states_of(run);
  run.payload_mass = 20;
  const std::vector<SampleState> loaded = states_of(run);
  for (std::size_t i = 0; i < bare.size(); ++i) {
    const auto carried = [](const SampleState& state) {
      return std::abs(state.struts.direction.row(2) * state.nut_tension);
    };
    CHECK(carried(loaded[i]) - carried(bare[i]) == Approx(20 * kStandardGravity).epsilon(0.01));
    CHECK((loaded[i].pose.p_WT - bare[i].pose.p_WT).norm() > 1e-7);  // and bends them
  }
}

}  // namespace
}  // namespace plumbline::diagnose

// Two programs that share no code must say the same of a machine: plumbline and the stand-in.
#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "measure/runs.hpp"
#include "measure/simulation.hpp"
#include "truth/catalogue.hpp"
#include "truth/plan.hpp"

using namespace plumbline;
using namespace plumbline::measure;
using namespace plumbline::testing;

namespace {

const std::string kModel = source_path("models/pm600-like.toml");

truth::PlannedRun planned(const Run& run) {
  return {run.id,
          {run.centre_W, run.radius, run.bar_length(), run.tilt, run.direction == Direction::ccw ? 1 : -1, run.feed,
           run.payload_mass, run.start},
          static_cast<int>(run.samples())};
}

// The largest differences of bar readings (m) and torques (N m) between the two.
struct Apart {
  double radial = 0, torque = 0;
};
Apart apart(const machine::MachineModel& machine, const physics::ForceModel& forces, const truth::Truth& truly,
            const Run& run) {
  const RunSimulation simulation = simulate_run(machine, forces, run);
  const Eigen::VectorXd radial = simulation.radial(ideal_ball(run), run.bar_length());
  const truth::Samples samples = truth::measured(truly, planned(run), truth::FrictionLaw::tanh, truth::Vec::Zero(), 0);
  Apart most;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const truth::Reading& reading = samples[i].reading;
    most.radial = std::max(most.radial, std::abs(radial[static_cast<Eigen::Index>(i)] - reading.radial));
    for (std::size_t j = 0; j < 6; ++j) {
      const double torque = simulation.samples[i].torque[static_cast<int>(j)];
      most.torque = std::max(most.torque, std::abs(torque - reading.torque[j]));
    }
  }
  return most;
}

}  // namespace

TEST_CASE("plumbline's simulation of a run is the stand-in's") {
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  const truth::Truth truly{truth::read_model(kModel).machine, {}};
  std::vector<Run> runs{circle_run({0, 100, -1008}, {-25, 0, 0}, Direction::ccw, 24),
                        circle_run({-70, -70, -1008}, {-17, -17, 0}, Direction::cw, 24),
                        circle_run({60, 0, -950}, {10, 10, 8}, Direction::ccw, 24)};
  runs[2].payload_mass = 20;
  for (const Run& run : runs) {
    const Apart most = apart(machine, forces, truly, run);
    CHECK(most.radial < 1e-10);
    CHECK(most.torque < 1e-5);
  }
}

TEST_CASE("each effect of the catalogue does in plumbline what it does in the stand-in") {
  const machine::MachineModel machine = pm600_like();
  truth::Random random(73);
  Run run = circle_run({-70, -70, -1008}, {-15, -12, 0}, Direction::cw, 12);
  run.feed *= 6;
  for (double& time : run.time) time /= 6;
  run.start = 3000;
  for (const std::string_view effect : physics::catalogue_names()) {
    const std::string name(effect);
    if (!physics::effect_infos()[physics::effect_index(name)].is_cause()) continue;  // whatever a formula says
    INFO(name);
    truth::Truth truly{truth::read_model(kModel).machine, {}};
    truly.flaws = truth::scaled(truth::drawn_flaws(name, random), name, 0.05);
    physics::ForceModel forces(machine);
    const auto first = static_cast<std::size_t>(forces.add(name));
    const physics::EffectInfo& info = physics::effect_infos()[physics::effect_index(name)];
    const truth::Effect hidden = truth::effect_in(truly.flaws, name);
    for (const truth::Key& key : hidden.keys) {
      INFO(key.name);
      const int offset = info.offset_of(key.name);
      REQUIRE(offset >= 0);
      for (std::size_t i = 0; i < key.numbers.size(); ++i) {
        forces.parameters[first + static_cast<std::size_t>(offset) + i] = *key.numbers[i];
      }
    }
    const Apart with = apart(machine, forces, truly, run);
    const Apart without = apart(machine, physics::ForceModel(machine), truly, run);
    CHECK((without.radial > 1e-8 || without.torque > 1e-3));
    // joints that lie elsewhere: the catalogue has their first order, the stand-in moves them
    CHECK(with.radial < (name == "joint-position" ? 0.01 * without.radial : 1e-9 + 1e-5 * without.radial));
    CHECK(with.torque < (name == "joint-position" ? 5e-3 : 1e-4));
  }
}

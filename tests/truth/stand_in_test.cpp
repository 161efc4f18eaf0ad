// Two programs that share no code must say the same of a machine: plumbline and the stand-in.
#include "truth/stand_in.hpp"

#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "measure/runs.hpp"
#include "measure/setup.hpp"

using namespace plumbline;
using namespace plumbline::measure;
using namespace plumbline::testing;

namespace {

truth::Circle circle_of(const Run& run) {
  return {run.centre_W, run.radius,      run.bar_length(), run.tilt, run.direction == Direction::ccw ? 1 : -1,
          run.feed,     run.payload_mass};
}

const std::string kModel = source_path("models/pm600-like.toml");

}  // namespace

TEST_CASE("plumbline's simulation of a run is the stand-in's") {
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  const truth::Machine truly = truth::read_model(kModel).machine;
  std::vector<Run> runs{circle_run({0, 100, -1008}, {-25, 0, 0}, Direction::ccw, 24),
                        circle_run({-70, -70, -1008}, {-17, -17, 0}, Direction::cw, 24),
                        circle_run({60, 0, -950}, {10, 10, 8}, Direction::ccw, 24)};
  runs[2].payload_mass = 20;
  for (const Run& run : runs) {
    const RunSimulation simulation = simulate_run(machine, forces, run);
    const Eigen::VectorXd radial = simulation.radial(ideal_ball(run), run.bar_length());
    for (std::size_t i = 0; i < run.samples(); ++i) {
      const truth::Reading reading =
          truth::measure(truly, circle_of(run), run.angle[i], truth::Vec::Zero(), truth::FrictionLaw::tanh);
      CHECK(radial[static_cast<Eigen::Index>(i)] == Approx(reading.radial).margin(1e-10).epsilon(0));
      for (std::size_t j = 0; j < 6; ++j) {
        CHECK(simulation.samples[i].torque[static_cast<int>(j)] == Approx(reading.torque[j]).margin(1e-5).epsilon(0));
      }
    }
  }
}

TEST_CASE("a drawn machine, its ball off and noisy, is told from the model by what the spread and the noise leave") {
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  std::mt19937_64 random(61);
  truth::Model model = truth::read_model(kModel);
  CHECK(model.spread.joint >= 0);
  model.spread = {8e-6, 5e-6, 0.05, 6, 1.5e-3};
  const truth::Machine truly = truth::drawn(model, random);
  Run run = circle_run({0, 100, -1008}, {-15, 0, 0}, Direction::ccw, 120);
  const std::vector<double> radial_noise = truth::noise(run.samples(), 0.5 * kUm, 0.5, random);
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const truth::Reading reading =
        truth::measure(truly, circle_of(run), run.angle[i], {8e-6, -5e-6, 3e-6}, truth::FrictionLaw::root);
    run.radial[i] = std::round((reading.radial + radial_noise[i]) / (0.1 * kUm)) * 0.1 * kUm;
  }
  const RunSimulation simulation = simulate_run(machine, forces, run);
  const Eigen::VectorXd left = radial_residuals(run, simulation, fit_setup(run, simulation));
  const double rms_um = std::sqrt(left.squaredNorm() / static_cast<double>(left.size())) / kUm;
  INFO(rms_um);
  CHECK(rms_um > 0.4);
  CHECK(rms_um < 8);
}

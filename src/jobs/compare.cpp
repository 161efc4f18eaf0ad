#include "jobs/compare.hpp"

#include <cmath>

#include "base/units.hpp"
#include "jobs/measured/inspect.hpp"
#include "jobs/measured/joined.hpp"
#include "machine/model_file.hpp"
#include "measure/setup.hpp"

namespace plumbline::jobs {
namespace {

// Squares and magnitudes of deviations, summed.
struct Pool {
  double squares = 0;
  double count = 0;
  std::array<double, machine::kStruts> magnitudes{};
  double samples = 0;

  std::optional<double> rms() const { return count > 0 ? std::optional(std::sqrt(squares / count)) : std::nullopt; }
  std::array<double, machine::kStruts> mean_abs() const {
    std::array<double, machine::kStruts> means{};
    for (std::size_t j = 0; j < means.size(); ++j) means[j] = samples > 0 ? magnitudes[j] / samples : 0;
    return means;
  }
  void add(const Pool& other) {
    squares += other.squares;
    count += other.count;
    samples += other.samples;
    for (std::size_t j = 0; j < magnitudes.size(); ++j) magnitudes[j] += other.magnitudes[j];
  }
};

Pool torque_pool(const measure::Run& run, const measure::RunSimulation& simulation) {
  Pool pool;
  if (!run.has_torque()) return pool;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    for (std::size_t j = 0; j < run.torque.size(); ++j) {
      const double off = run.torque[j][i] - simulation.samples[i].torque[static_cast<int>(j)];
      pool.squares += off * off;
      pool.magnitudes[j] += std::abs(off);
    }
  }
  pool.samples = static_cast<double>(run.samples());
  pool.count = pool.samples * machine::kStruts;
  return pool;
}

Pool radial_pool(const measure::Run& run, const measure::RunSimulation& simulation, RunComparison& found) {
  Pool pool;
  if (!run.has_radial()) return pool;
  const measure::Setup setup = measure::fit_setup(run, simulation);
  const Eigen::VectorXd off = measure::radial_residuals(run, simulation, setup) / kUm;
  const Vector3<double> ball = (setup.ball_W - measure::ideal_ball(run)) / kUm;
  found.ball_um = {ball.x(), ball.y(), ball.z()};
  found.bar_um = (setup.bar - run.bar_length()) / kUm;
  pool.squares = off.squaredNorm();
  pool.count = static_cast<double>(off.size());
  return pool;
}

}  // namespace

Comparison compare(const Source& model, const measure::Dataset& measured) {
  const machine::MachineModel machine = machine::read_model(model);
  const physics::ForceModel forces(machine);
  Comparison comparison;
  comparison.other_model = other_model(measured, machine);
  Pool radial;
  Pool torque;
  Judged looked = judged(machine, measured.runs, measured.instrument, {});
  comparison.inspection = std::move(looked.inspection);
  for (const measure::Run& run : looked.runs) {
    const measure::RunSimulation simulation = measure::simulate_run(machine, forces, run);
    RunComparison& found = comparison.runs.emplace_back();
    found.id = run.id;
    const Pool of_torque = torque_pool(run, simulation);
    const Pool of_radial = radial_pool(run, simulation, found);
    found.radial_rms_um = of_radial.rms();
    found.torque_rms_Nm = of_torque.rms();
    found.torque_mean_abs_Nm = of_torque.mean_abs();
    radial.add(of_radial);
    torque.add(of_torque);
  }
  comparison.radial_rms_um = radial.rms();
  comparison.torque_rms_Nm = torque.rms();
  comparison.torque_mean_abs_Nm = torque.mean_abs();
  return comparison;
}

}  // namespace plumbline::jobs

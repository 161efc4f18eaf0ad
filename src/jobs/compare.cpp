#include "jobs/compare.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/units.hpp"
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

std::string figure(const std::optional<double>& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

nlohmann::ordered_json number(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace

Comparison compare(const std::string& model, const measure::Dataset& measured) {
  const machine::MachineModel machine = machine::read_model(model);
  const physics::ForceModel forces(machine);
  Comparison comparison;
  Pool radial;
  Pool torque;
  for (const measure::Run& run : measured.runs) {
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

std::string compare_text(const Comparison& comparison) {
  std::string text =
      fmt::format("{:<24}{:>14}{:>14}   ball off by x, y, z and bar (um)\n", "run", "radial rms um", "torque rms Nm");
  for (const RunComparison& run : comparison.runs) {
    text += fmt::format("{:<24}{:>14}{:>14}", run.id, figure(run.radial_rms_um, 3), figure(run.torque_rms_Nm, 4));
    if (run.radial_rms_um) {
      text +=
          fmt::format("   {:.1f}, {:.1f}, {:.1f}, {:.1f}", run.ball_um[0], run.ball_um[1], run.ball_um[2], run.bar_um);
    }
    text += '\n';
  }
  text += fmt::format("{:<24}{:>14}{:>14}\n", "all", figure(comparison.radial_rms_um, 3),
                      figure(comparison.torque_rms_Nm, 4));
  if (comparison.torque_rms_Nm) {
    text += fmt::format("mean absolute torque error per strut (N m): {:.4f}\n",
                        fmt::join(comparison.torque_mean_abs_Nm, ", "));
  }
  return text;
}

std::string compare_json(const Comparison& comparison) {
  nlohmann::ordered_json json;
  json["radial_rms_um"] = number(comparison.radial_rms_um);
  json["torque_rms_Nm"] = number(comparison.torque_rms_Nm);
  json["torque_mean_abs_Nm"] = comparison.torque_mean_abs_Nm;
  json["runs"] = nlohmann::ordered_json::array();
  for (const RunComparison& run : comparison.runs) {
    json["runs"].push_back({{"id", run.id},
                            {"radial_rms_um", number(run.radial_rms_um)},
                            {"torque_rms_Nm", number(run.torque_rms_Nm)},
                            {"torque_mean_abs_Nm", run.torque_mean_abs_Nm},
                            {"setup", {{"ball_um", run.ball_um}, {"bar_um", run.bar_um}}}});
  }
  return json.dump(1) + "\n";
}

}  // namespace plumbline::jobs

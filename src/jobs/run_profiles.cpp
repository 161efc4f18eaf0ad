#include "jobs/run_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "base/angle.hpp"
#include "base/files/path_of.hpp"
#include "base/parallel.hpp"
#include "diagnose/compensated.hpp"
#include "machine/model_file.hpp"
#include "measure/setup.hpp"

namespace plumbline::jobs {
namespace {

using Order = std::vector<std::size_t>;

Eigen::VectorXd angles_of(const measure::Run& run) {
  Eigen::VectorXd angle(static_cast<Eigen::Index>(run.samples()));
  for (Eigen::Index i = 0; i < angle.size(); ++i) angle[i] = within_turn(run.angle[static_cast<std::size_t>(i)]);
  return angle;
}

template <class Values>
Eigen::VectorXd in_order(const Order& order, const Values& values) {
  Eigen::VectorXd sorted(static_cast<Eigen::Index>(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i) {
    sorted[static_cast<Eigen::Index>(i)] = values[static_cast<Eigen::Index>(order[i])];
  }
  return sorted;
}

Eigen::Map<const Eigen::VectorXd> vector_of(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

double rms(const Eigen::VectorXd& values) {
  return values.norm() / std::sqrt(static_cast<double>(std::max<Eigen::Index>(values.size(), 1)));
}

void add_radial(ModelProfile& of, const NamedModel& model, const measure::Run& run,
                const measure::RunSimulation& simulation, const RunProfile& measured, const Order& order) {
  const measure::Setup setup = measure::fit_setup(run, simulation);
  const Eigen::VectorXd residuals = in_order(order, measure::radial_residuals(run, simulation, setup));
  of.radial = measured.radial - residuals;
  of.radial_rms = rms(residuals);
  const measure::Profile left = diagnose::compensated_profile(model.machine->rotation, run, *model.forces);
  const Eigen::VectorXd centred = measure::without_setup(left, measure::least_squares_circle(left));
  of.compensated = in_order(order, centred);
  of.compensated_circularity = centred.maxCoeff() - centred.minCoeff();
}

ModelProfile profile_with(const NamedModel& model, const measure::Run& run, const RunProfile& measured,
                          const Order& order) {
  ModelProfile of;
  const measure::RunSimulation simulation = measure::simulate_run(*model.machine, *model.forces, run);
  if (run.has_radial()) add_radial(of, model, run, simulation, measured, order);
  for (std::size_t j = 0; run.has_torque() && j < of.torque.size(); ++j) {
    Eigen::VectorXd torque(static_cast<Eigen::Index>(run.samples()));
    for (Eigen::Index i = 0; i < torque.size(); ++i) {
      torque[i] = simulation.samples[static_cast<std::size_t>(i)].torque[static_cast<Eigen::Index>(j)];
    }
    of.torque_rms[j] = rms(torque - vector_of(run.torque[j]));
    of.torque[j] = in_order(order, torque);
  }
  return of;
}

RunProfile profile_of(const measure::Run& run, std::span<const NamedModel> models) {
  RunProfile profile;
  profile.run = run;
  const Eigen::VectorXd angle = angles_of(run);
  Order order(run.samples());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return angle[static_cast<Eigen::Index>(a)] < angle[static_cast<Eigen::Index>(b)];
  });
  profile.angle = in_order(order, angle);
  if (run.has_radial()) {
    const measure::Profile read = measure::profile_of(run);
    profile.figures = measure::circularity_figures(read);
    profile.radial = in_order(order, measure::without_setup(read, profile.figures->circle));
  }
  for (std::size_t j = 0; run.has_torque() && j < profile.torque.size(); ++j) {
    profile.torque[j] = in_order(order, vector_of(run.torque[j]));
  }
  for (const NamedModel& model : models) profile.models.push_back(profile_with(model, run, profile, order));
  return profile;
}

}  // namespace

std::vector<RunProfile> run_profiles(const std::vector<measure::Run>& runs, std::span<const NamedModel> models) {
  std::vector<RunProfile> profiles(runs.size());
  for_each_index(runs.size(), [&](std::size_t i) { profiles[i] = profile_of(runs[i], models); });
  return profiles;
}

RunsAndModels profiles_of_files(const std::vector<measure::Run>& runs, const std::vector<std::string>& models) {
  std::vector<machine::MachineModel> machines;
  std::vector<physics::ForceModel> forces;
  machines.reserve(models.size());
  for (const std::string& model : models) {
    machines.push_back(machine::read_model(model));
    forces.emplace_back(machines.back());
  }
  RunsAndModels both;
  std::vector<NamedModel> named;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const bool alike = std::any_of(machines.begin(), machines.end(), [&](const machine::MachineModel& other) {
      return &other != &machines[i] && other.name == machines[i].name;
    });
    both.models.push_back(alike ? path_of(models[i]).filename().generic_string() : machines[i].name);
    named.push_back({both.models.back(), &machines[i], &forces[i]});
  }
  both.runs = run_profiles(runs, named);
  return both;
}

}  // namespace plumbline::jobs

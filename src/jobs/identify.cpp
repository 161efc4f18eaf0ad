#include "jobs/identify.hpp"

#include <algorithm>
#include <utility>

#include "base/text/hash.hpp"
#include "diagnose/doubt.hpp"
#include "diagnose/posterior.hpp"
#include "jobs/measured/inspect.hpp"
#include "jobs/measured/joined.hpp"
#include "machine/model_file.hpp"

namespace plumbline::jobs {
namespace {

using identify::Identification;

// Where the joints really are becomes what the controller believes, and no longer adds to it.
void believe_joints(IdentifiedModel& model) {
  identify::BelievedJoints joints{model.machine.geometry.base_joints_W, model.machine.geometry.platform_joints_P};
  for (auto [key, positions] : {std::pair("base_um", &joints.base_W), std::pair("platform_um", &joints.platform_P)}) {
    double* const off = model.forces.parameters.data() + model.forces.find(physics::JointPosition::name, key);
    *positions += Eigen::Map<machine::StrutVectors<double>>(off);
    for (int i = 0; i < positions->size(); ++i) {
      const int place = model.posterior->unknowns.find(physics::JointPosition::name, key, i);
      if (place >= 0) model.posterior->states.front().mean[place] -= off[i];
    }
    std::fill_n(off, positions->size(), 0.0);
  }
  model.joints = joints;
}

// A gap that is no noise, and that the fit did not close; where it is borne out, another model would not close it.
std::optional<diagnose::OpenGap> open_gap(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                                          const Identification& found, double share) {
  if (runs.empty() || found.objected() != nullptr || found.borne_out()) return std::nullopt;
  const auto rms = [](const identify::Misfit& of) {
    return diagnose::Rms{of.radial_readings > 0 ? std::optional(of.radial_rms) : std::nullopt,
                         of.torque_readings > 0 ? std::optional(of.torque_rms) : std::nullopt};
  };
  const auto residuals = diagnose::residuals(machine, runs, found.forces, found.stages.back().fit.noise);
  return diagnose::open_gap(diagnose::recurring(diagnose::contrasts_of(runs, residuals), {}),
                            {rms(found.before), {}, rms(found.after)}, share, {});
}

identify::Posterior posterior_of(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                                 const Identification& found) {
  identify::Posterior posterior = identify::posterior_of(machine, found);
  const auto residuals = diagnose::residuals(machine, runs, found.forces, found.stages.back().fit.noise);
  posterior.unexplained = diagnose::recurring_radial(diagnose::contrasts_of(runs, residuals));
  return posterior;
}

identify::Posterior posterior_as_given(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                                       const Identification& found) {
  const physics::ForceModel forces(machine);
  return diagnose::posterior_as_given(machine, runs,
                                      diagnose::residuals(machine, runs, forces, found.stages.back().fit.noise));
}

// Of a parameter that several stages fitted, the largest.
std::vector<double> errors_of(const Identification& found) {
  std::vector<double> errors(found.forces.parameters.size(), 0);
  for (const identify::Stage& stage : found.stages) {
    const std::vector<double> of_stage = stage.fit.parameter_errors();
    for (std::size_t i = 0; i < of_stage.size(); ++i) errors[i] = std::max(errors[i], of_stage[i]);
  }
  return errors;
}

std::vector<TrackedResidual> tracked_residuals(const machine::MachineModel& machine, const physics::ForceModel& forces,
                                               const identify::NoiseModel& noise, const identify::Tracked& tracked) {
  const std::vector<measure::Run> no_runs;
  identify::Objective objective(machine.rotation, no_runs, identify::Unknowns(forces), {}, &tracked);
  objective.set_noise(noise);
  const identify::RunEquations equations = objective.equations(Eigen::VectorXd(0)).back();
  const auto count = static_cast<Eigen::Index>(tracked.table.poses.size());
  std::vector<TrackedResidual> residuals;
  for (Eigen::Index i = 0; i < count; ++i) {
    TrackedResidual& of = residuals.emplace_back();
    of.shift = equations.residual.segment<3>(3 * i);
    if (tracked.table.has_tilt()) of.turn = equations.residual.segment<3>(3 * (count + i));
  }
  return residuals;
}

std::vector<TrackedGap> tracked_gaps(const machine::MachineModel& machine, const Identification& found,
                                     const identify::Tracked& tracked) {
  const identify::NoiseModel& noise = found.stages.back().fit.noise;
  const std::vector<TrackedResidual> before = tracked_residuals(machine, physics::ForceModel(machine), noise, tracked);
  const std::vector<TrackedResidual> after = tracked_residuals(machine, found.forces, noise, tracked);
  std::vector<TrackedGap> gaps;
  for (std::size_t i = 0; i < before.size(); ++i) gaps.push_back({before[i], after[i]});
  return gaps;
}

IdentifiedModel identified(machine::MachineModel machine, measure::Dataset dataset, std::vector<MeasuredFile> measured,
                           const identify::IdentifyOptions& options, const std::vector<std::string>& accepted,
                           const identify::Tracked* tracked = nullptr) {
  std::optional<Diagnostic> other = other_model(dataset, machine);
  Judged looked = judged(machine, std::move(dataset.runs), dataset.instrument, accepted);
  const measure::Thinned thinned = measure::thinned(machine, std::move(looked.runs));
  Identification found = identify::identify(machine, thinned.runs, options, tracked);
  const std::optional<diagnose::OpenGap> open = open_gap(machine, thinned.runs, found, options.plausible.open_share);
  physics::ForceModel forces = found.forces;
  std::vector<double> errors = errors_of(found);
  std::vector<TrackedGap> poses;
  if (tracked != nullptr) poses = tracked_gaps(machine, found, *tracked);
  std::optional<identify::Posterior> posterior = posterior_of(machine, thinned.runs, found);
  const std::optional<identify::LessSure> less =
      identify::less_sure(machine.rotation, thinned.runs, posterior_as_given(machine, thinned.runs, found), *posterior);
  return {std::move(machine),
          std::move(found),
          std::move(measured),
          thinned.thinning,
          open,
          std::move(forces),
          std::move(errors),
          thinned.runs,
          std::move(looked.inspection),
          std::move(poses),
          {},
          false,
          std::move(posterior),
          std::move(other),
          less};
}

}  // namespace

IdentifiedModel identify_model(const Source& model, const std::string& dataset,
                               const identify::IdentifyOptions& options, const std::vector<std::string>& accepted,
                               const std::vector<std::string>& with) {
  machine::MachineModel machine = machine::read_model(model);
  JoinedData data = read_joined(dataset, with);
  measure::check_measured(data.dataset);
  return identified(std::move(machine), std::move(data.dataset), std::move(data.files), options, accepted);
}

IdentifiedModel calibrate_model(CalibrateJob job) {
  machine::MachineModel machine = machine::read_model(job.model);
  measure::Dataset dataset;
  std::optional<identify::Tracked> tracked;
  std::vector<MeasuredFile> files;
  if (!job.dataset.empty()) {
    JoinedData data = read_joined(job.dataset, job.with);
    measure::check_measured(data.dataset);
    dataset = std::move(data.dataset);
    files = std::move(data.files);
  }
  if (!job.poses.empty()) {
    tracked = {measure::read_tracked_poses(job.poses), job.frame_known};
    files.push_back(
        {job.poses.name(), fnv1a(tracked->table.text), tracked->table.poses.size(), MeasuredFile::Kind::poses});
  }
  job.options.stages = identify::Stages::geometry;
  IdentifiedModel model = identified(std::move(machine), std::move(dataset), std::move(files), job.options,
                                     job.accepted, tracked ? &*tracked : nullptr);
  model.calibrated = true;
  if (job.controller) believe_joints(model);
  return model;
}

}  // namespace plumbline::jobs

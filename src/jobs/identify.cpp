#include "jobs/identify.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/text/hash.hpp"
#include "base/version.hpp"
#include "diagnose/doubt.hpp"
#include "identify/model_text.hpp"
#include "machine/model_file.hpp"
#include "measure/thinning.hpp"

namespace plumbline::jobs {
namespace {

using identify::Fit;
using identify::Identification;
using identify::Stage;
using identify::Unknown;

// Of the dataset and the tables that it names.
std::uint64_t hash_of(const measure::Dataset& dataset, const std::string& path) {
  std::uint64_t hash = fnv1a(dataset.document.text);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (const measure::Run& run : dataset.runs) hash = fnv1a(read_text((folder / run.file).string()), hash);
  return hash;
}

// "measurements/dataset.toml (fnv1a ..., 26 runs)"
std::string source_text(const std::string& path, std::uint64_t hash, std::size_t count, std::string_view what) {
  return fmt::format("{} (fnv1a {}, {} {})", path, to_hex(hash), count, what);
}

double value_of(const Fit& fit, std::size_t i) { return fit.values[static_cast<Eigen::Index>(i)]; }

// "K1: 0.01287 -> 0.01209 +- 0.0002 um/N per m"
std::string change_text(const Fit& fit, std::size_t i) {
  const Unknown& u = fit.unknowns[i];
  return fmt::format("{}: {:.6g} -> {:.6g} +- {:.2g} {}", u.label, u.start / u.unit.si, value_of(fit, i) / u.unit.si,
                     fit.standard_error(i) / u.unit.si, u.unit.name);
}

std::vector<std::string> notes_of(const Identification& found, const std::string& verb, const std::string& source) {
  std::vector<std::string> notes{fmt::format("{} by plumbline {} from {}", verb, version(), source),
                                 "What was before, what it is now, and its standard error:"};
  for (const Stage& stage : found.stages) {
    for (std::size_t i = 0; i < stage.fit.unknowns.size(); ++i) notes.push_back("  " + change_text(stage.fit, i));
    for (const std::string& statement : stage.observability.statements) notes.push_back("  " + statement);
  }
  return notes;
}

// The model's text with what was found; with `controller` its joints instead of what the controller has wrong.
std::string refitted(const machine::MachineModel& machine, const Identification& found, const std::string& verb,
                     const std::string& source, bool controller = false) {
  std::vector<double> errors(found.forces.parameters.size(), 0);
  for (const Stage& stage : found.stages) {
    const std::vector<double> of_stage = stage.fit.parameter_errors();
    for (std::size_t i = 0; i < of_stage.size(); ++i) errors[i] = std::max(errors[i], of_stage[i]);
  }
  physics::ForceModel forces = found.forces;
  std::optional<identify::BelievedJoints> joints;
  if (controller) {
    joints = {machine.geometry.base_joints_W, machine.geometry.platform_joints_P};
    for (auto [key, positions] :
         {std::pair("base_um", &joints->base_W), std::pair("platform_um", &joints->platform_P)}) {
      double* const off = forces.parameters.data() + forces.find(physics::JointPosition::name, key);
      *positions += Eigen::Map<machine::StrutVectors<double>>(off);
      std::fill_n(off, positions->size(), 0.0);
    }
  }
  const std::string from = fmt::format("{}, model fnv1a {}", source, to_hex(machine.hash));
  return identify::model_text(
      machine, {forces, std::move(errors), fmt::format("{} by plumbline {} to {}", verb, version(), from),
                notes_of(found, verb == "refitted" ? "Identified" : "Calibrated", from), joints});
}

constexpr double kOpen = 1.0 / 3;  // of what was left before; with more, a gap that is no noise is open

// A gap that is no noise, and that the fit did not close.
std::string open_gap(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                     const Identification& found) {
  if (runs.empty()) return {};
  const auto rms = [](const identify::Misfit& of) {
    return diagnose::Rms{of.radial_readings > 0 ? std::optional(of.radial_rms) : std::nullopt,
                         of.torque_readings > 0 ? std::optional(of.torque_rms) : std::nullopt};
  };
  const auto left = diagnose::residuals(machine, runs, found.forces, found.stages.back().fit.noise);
  return diagnose::open_gap(diagnose::recurring(diagnose::contrasts_of(runs, left), {}),
                            {rms(found.before), {}, rms(found.after)}, kOpen, {})
      .value_or("");
}

std::string objection_to(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                         const Identification& found) {
  const std::string objection = found.objection();
  return objection.empty() && !found.borne_out() ? open_gap(machine, runs, found) : objection;
}

}  // namespace

IdentifiedModel identify_model(const std::string& model, const std::string& dataset,
                               const identify::IdentifyOptions& options) {
  const machine::MachineModel machine = machine::read_model(model);
  const measure::Dataset measured = measure::read_dataset(dataset);
  const measure::Thinned thinned = measure::thinned(measured.runs);
  IdentifiedModel result{identify::identify(machine, thinned.runs, options), {}, thinned.text(), {}};
  result.objection = objection_to(machine, thinned.runs, result.found);
  result.text = refitted(machine, result.found, "refitted",
                         source_text(dataset, hash_of(measured, dataset), measured.runs.size(), "runs"));
  return result;
}

IdentifiedModel calibrate_model(CalibrateJob job) {
  const machine::MachineModel machine = machine::read_model(job.model);
  measure::Dataset measured;
  std::optional<identify::Tracked> tracked;
  std::vector<std::string> sources;
  if (!job.dataset.empty()) {
    measured = measure::read_dataset(job.dataset);
    sources.push_back(source_text(job.dataset, hash_of(measured, job.dataset), measured.runs.size(), "runs"));
  }
  if (!job.poses.empty()) {
    tracked = {measure::read_tracked_poses(job.poses), job.frame_known};
    sources.push_back(source_text(job.poses, fnv1a(tracked->table.text), tracked->table.poses.size(), "poses"));
  }
  job.options.stages = identify::Stages::geometry;
  const measure::Thinned thinned = measure::thinned(measured.runs);
  IdentifiedModel result{
      identify::identify(machine, thinned.runs, job.options, tracked ? &*tracked : nullptr), {}, thinned.text(), {}};
  result.objection = objection_to(machine, thinned.runs, result.found);
  result.text =
      refitted(machine, result.found, "calibrated", fmt::format("{}", fmt::join(sources, " and ")), job.controller);
  return result;
}

}  // namespace plumbline::jobs

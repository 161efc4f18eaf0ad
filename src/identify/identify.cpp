#include "identify/identify.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/mean_square.hpp"
#include "identify/unknowns/named_keys.hpp"

namespace plumbline::identify {
namespace {

// --- which readings a stage looks at ---

enum class Readings { all, torques, bar };

std::vector<measure::Run> only(const std::vector<measure::Run>& runs, Readings which) {
  std::vector<measure::Run> chosen;
  for (measure::Run run : runs) {
    if (which == Readings::torques) run.radial.clear();
    if (which == Readings::bar) std::for_each(run.torque.begin(), run.torque.end(), [](auto& t) { t.clear(); });
    if (run.has_radial() || run.has_torque()) chosen.push_back(std::move(run));
  }
  if (!chosen.empty()) return chosen;
  const std::string_view what = which == Readings::torques ? "torques"
                                : which == Readings::bar   ? "bar readings"
                                                           : "readings";
  refuse("identify-no-readings", fmt::format("no run of this dataset has {}", what),
         which == Readings::all ? "the tables need a column radial_um, or torque1_Nm to torque6_Nm"
         : which == Readings::torques
             ? "the paper's first stage needs torque1_Nm to torque6_Nm; without them use --stages joint"
             : "the paper's second stage needs radial_um; without it use --stages joint");
}

Stage run_stage(std::string name, const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                const Unknowns& unknowns, const IdentifyOptions& options, const Tracked* tracked = nullptr) {
  if (unknowns.size() == 0) {
    refuse("identify-nothing-unknown", "the model's [uncertainty] lists nothing: all of it is exact",
           "list what is not known, as joint_position_um = 8, or name keys by --free", {machine.document.file});
  }
  Fit found = fit(machine.rotation, runs, unknowns, options.fit, tracked);
  Observability known = observability(found, runs, options.observability);
  // poses of a tracker hold a fit as well, so that none of the circles can be left out to first order
  PlausibleOptions believed = options.plausible;
  believed.joints_seen = tracked != nullptr;
  Plausibility plausible = plausibility(machine.rotation, tracked == nullptr ? runs : std::vector<measure::Run>{},
                                        found, options.fit, believed);
  std::optional<Held> held;
  if (tracked == nullptr && options.stages != Stages::paper) {
    held = hold_unsure(machine.rotation, runs, unknowns.forces(), unknowns, found.values, doubt_of(found, plausible),
                       options.hold);
    found.values = held->values;
  }
  const bool sound = held && borne_out(plausible, std::max(held->whole.chance, held->off_the_part.chance), believed);
  const std::optional<Objection> against = objection(plausible, sound, believed);
  return {
      std::move(name), std::move(found), std::move(held), std::move(known), std::move(plausible), sound, against, {}};
}

Misfit misfit_of(const machine::MachineModel& machine, const std::vector<measure::Run>& runs, const Tracked* tracked,
                 const physics::ForceModel& forces, const NoiseModel& noise) {
  Objective objective(machine.rotation, runs, Unknowns(forces), {}, tracked);
  objective.set_noise(noise);
  std::array<MeanSquare, kAllChannels> pools;
  double magnitudes = 0;
  for (const RunEquations& block : objective.equations(Eigen::VectorXd(0))) {
    Eigen::Index first = 0;
    for (const int channel : block.channels) {
      const auto rows = block.residual.segment(first, block.samples);
      first += block.samples;
      const bool torque = channel > kRadial && channel < kChannels;
      pools[torque ? 1 : static_cast<std::size_t>(channel)].add(rows);
      if (torque) magnitudes += rows.cwiseAbs().sum();
    }
  }
  const MeanSquare& torques = pools[1];
  Misfit misfit;
  misfit.radial_rms = pools[kRadial].root();
  misfit.radial_readings = pools[kRadial].count;
  misfit.torque_rms = torques.root();
  misfit.torque_mean_abs = magnitudes / static_cast<double>(std::max<Eigen::Index>(torques.count, 1));
  misfit.torque_readings = torques.count;
  misfit.tracker_rms = pools[kTracker].root();
  misfit.tracker_readings = pools[kTracker].count;
  misfit.tilt_rms = pools[kTrackerTilt].root();
  misfit.tilt_readings = pools[kTrackerTilt].count;
  return misfit;
}

}  // namespace

bool Identification::converged() const {
  return std::all_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.fit.converged; });
}

const Stage* Identification::objected() const {
  const auto stage = std::find_if(stages.begin(), stages.end(), [](const Stage& s) { return s.objection.has_value(); });
  return stage == stages.end() ? nullptr : &*stage;
}

bool Identification::borne_out() const {
  return std::all_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.borne_out; });
}

Unknowns torque_unknowns(const physics::ForceModel& forces) {
  Unknowns unknowns(forces);
  for (const char* key :
       {"strut.motor_mass_kg", "strut.screw_mass_kg", "strut.coulomb_friction_N", "joint.viscous_friction_Nms_rad"}) {
    add_free(unknowns, key);
  }
  return unknowns;
}

Unknowns compliance_unknowns(const physics::ForceModel& forces) {
  Unknowns unknowns(forces);
  for (const char* key : {"strut.compliance_per_length_um_N_m", "strut.compliance_um_N"}) add_free(unknowns, key);
  return unknowns;
}

namespace {

// One fit of everything that is not known.
Stage joint_stage(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                  const physics::ForceModel& forces, const IdentifyOptions& options, const Tracked* tracked) {
  const bool calibration = options.stages == Stages::geometry;
  Unknowns unknowns = calibration ? geometry_unknowns(machine, forces, options.geometry) : nuisances(machine, forces);
  for (const std::string& name : options.free) add_free(unknowns, name);
  Stage stage =
      run_stage(calibration ? "calibration" : "joint", machine,
                tracked != nullptr && runs.empty() ? runs : only(runs, Readings::all), unknowns, options, tracked);
  if (calibration) {
    stage.geometry = shown_geometry(machine.geometry, stage.fit.unknowns, stage.fit.covariance, options.observability);
  }
  return stage;
}

}  // namespace

Identification identify(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                        const IdentifyOptions& options, const Tracked* tracked) {
  Identification result{{}, physics::ForceModel(machine), {}, {}};
  if (options.stages == Stages::paper) {
    Unknowns torques = torque_unknowns(result.forces);
    for (const std::string& name : options.free) add_free(torques, name);
    result.stages.push_back(run_stage("torques", machine, only(runs, Readings::torques), torques, options));
    const Unknowns compliances = compliance_unknowns(result.stages.back().fit.forces());
    result.stages.push_back(run_stage("bar readings", machine, only(runs, Readings::bar), compliances, options));
  } else {
    result.stages.push_back(joint_stage(machine, runs, result.forces, options, tracked));
  }
  result.forces = result.stages.back().fit.forces();
  const NoiseModel& noise = result.stages.back().fit.noise;
  result.before = misfit_of(machine, runs, tracked, physics::ForceModel(machine), noise);
  result.after = misfit_of(machine, runs, tracked, result.forces, noise);
  return result;
}

}  // namespace plumbline::identify

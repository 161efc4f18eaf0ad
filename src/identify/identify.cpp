#include "identify/identify.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "machine/nearest_name.hpp"

namespace plumbline::identify {
namespace {

// --- unknowns that the user names ---

// "table.key" of the model file, or "effect.key" of an effect.
struct NamedKey {
  std::string name;
  std::string_view effect;
  const physics::ParameterSpec* spec = nullptr;
};

std::vector<NamedKey> named_keys() {
  std::vector<NamedKey> keys;
  for (const physics::EffectInfo& info : physics::effect_infos()) {
    for (const physics::ParameterSpec& spec : info.parameters) {
      const std::string_view group = info.base ? spec.table : info.name;
      keys.push_back({fmt::format("{}.{}", group, spec.key), info.name, &spec});
    }
  }
  return keys;
}

// Adds all numbers of a key as free unknowns; a mass or a length of all struts as one.
void add_free(Unknowns& unknowns, const std::string& name) {
  const std::vector<NamedKey> keys = named_keys();
  const auto key = std::find_if(keys.begin(), keys.end(), [&](const NamedKey& k) { return k.name == name; });
  if (key == keys.end()) {
    std::vector<std::string_view> known;
    for (const NamedKey& k : keys) known.push_back(k.name);
    const std::string_view nearest = machine::nearest_name(name, known);
    refuse("identify-unknown-key", fmt::format("{} is nothing that can be fitted", name),
           fmt::format("{}write table.key of the model file or effect.key, as strut.motor_mass_kg or backlash.width_um",
                       nearest.empty() ? "" : fmt::format("did you mean {}? ", nearest)));
  }
  const bool shared = key->effect == "strut-gravity" || key->effect == "axial-elasticity";
  for (int i = 0; i < (shared ? 1 : key->spec->size()); ++i) {
    const int index = shared || key->spec->size() == 1 ? -1 : i;
    int place = unknowns.find(key->effect, key->spec->key, index);
    if (place < 0) {
      place = static_cast<int>(shared ? unknowns.add_shared(key->effect, key->spec->key)
                                      : unknowns.add(key->effect, key->spec->key, i));
    }
    unknowns.set_free(static_cast<std::size_t>(place));
  }
}

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
                const Unknowns& unknowns, const IdentifyOptions& options) {
  if (unknowns.size() == 0) {
    refuse("identify-nothing-unknown", "the model's [uncertainty] lists nothing: all of it is exact",
           "list what is not known, as joint_position_um = 8, or name keys by --free", {machine.document.file});
  }
  Fit found = fit(machine.rotation, runs, unknowns, options.fit);
  Observability known = observability(found, runs, options.observability);
  return {std::move(name), std::move(found), std::move(known)};
}

Misfit misfit_of(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                 const physics::ForceModel& forces, const NoiseModel& noise) {
  Objective objective(machine.rotation, runs, Unknowns(forces));
  objective.set_noise(noise);
  Misfit misfit;
  for (const RunEquations& run : objective.equations(Eigen::VectorXd(0))) {
    const Eigen::Index radial = run.setup_slopes.rows();
    const Eigen::Index torque = run.residual.size() - radial;
    misfit.radial_rms += run.residual.head(radial).squaredNorm();
    misfit.torque_rms += run.residual.tail(torque).squaredNorm();
    misfit.torque_mean_abs += run.residual.tail(torque).cwiseAbs().sum();
    misfit.radial_readings += radial;
    misfit.torque_readings += torque;
  }
  const auto per = [](Eigen::Index readings) { return 1 / static_cast<double>(std::max<Eigen::Index>(readings, 1)); };
  misfit.radial_rms = std::sqrt(misfit.radial_rms * per(misfit.radial_readings));
  misfit.torque_rms = std::sqrt(misfit.torque_rms * per(misfit.torque_readings));
  misfit.torque_mean_abs *= per(misfit.torque_readings);
  return misfit;
}

}  // namespace

bool Identification::converged() const {
  return std::all_of(stages.begin(), stages.end(), [](const Stage& stage) { return stage.fit.converged; });
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

Identification identify(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                        const IdentifyOptions& options) {
  Identification result{{}, physics::ForceModel(machine)};
  if (options.stages == Stages::joint) {
    Unknowns unknowns = nuisances(machine, result.forces);
    for (const std::string& name : options.free) add_free(unknowns, name);
    result.stages.push_back(run_stage("joint", machine, only(runs, Readings::all), unknowns, options));
    result.forces = result.stages.back().fit.forces();
  } else {
    Unknowns torques = torque_unknowns(result.forces);
    for (const std::string& name : options.free) add_free(torques, name);
    result.stages.push_back(run_stage("torques", machine, only(runs, Readings::torques), torques, options));
    const Unknowns compliances = compliance_unknowns(result.stages.back().fit.forces());
    result.stages.push_back(run_stage("bar readings", machine, only(runs, Readings::bar), compliances, options));
    result.forces = result.stages.back().fit.forces();
  }
  const NoiseModel& noise = result.stages.back().fit.noise;
  result.before = misfit_of(machine, runs, physics::ForceModel(machine), noise);
  result.after = misfit_of(machine, runs, result.forces, noise);
  return result;
}

}  // namespace plumbline::identify

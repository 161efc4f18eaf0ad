#include "jobs/diagnose.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "jobs/measured/inspect.hpp"
#include "jobs/measured/joined.hpp"
#include "machine/model_file.hpp"
#include "measure/simulation.hpp"

namespace plumbline::jobs {
namespace {

// The model with the numbers of an effect at nothing.
physics::ForceModel without(const physics::ForceModel& forces, const std::string& effect) {
  physics::ForceModel less = forces;
  const std::size_t index = physics::effect_index(effect);
  const physics::EffectInfo& info = physics::effect_infos().at(index);
  for (const int first : forces.instances_of(index)) {
    int at = first;
    for (const physics::ParameterSpec& spec : info.parameters) {
      for (int k = 0; k < spec.size(); ++k, ++at) less.parameters[static_cast<std::size_t>(at)] = spec.initial;
    }
  }
  return less;
}

AtTip at_tip(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
             const physics::ForceModel& forces, const std::string& effect) {
  AtTip found{effect};
  const physics::ForceModel less = without(forces, effect);
  double squares = 0;
  double count = 0;
  for (const measure::Run& run : runs) {
    const measure::RunSimulation with = measure::simulate_run(machine, forces, run);
    const measure::RunSimulation free = measure::simulate_run(machine, less, run);
    for (std::size_t i = 0; i < run.samples(); ++i) {
      const double off = (with.samples[i].tip_W - free.samples[i].tip_W).norm();
      found.largest = std::max(found.largest, off);
      squares += off * off;
      ++count;
    }
  }
  found.rms = std::sqrt(squares / std::max(count, 1.0));
  return found;
}

// The runs that what is wrong with the data is about; nothing: it is in nobody's way.
std::optional<diagnose::SpoiledData> spoiled(const inspect::Inspection& inspection,
                                             const std::vector<measure::Run>& runs) {
  diagnose::SpoiledData spoiled;
  for (const inspect::Fault& fault : inspection.faults) {
    if (!fault.blocks) continue;
    spoiled.all = spoiled.all || fault.all;
    for (const std::size_t r : fault.runs) {
      if (std::find(spoiled.runs.begin(), spoiled.runs.end(), runs[r].id) == spoiled.runs.end()) {
        spoiled.runs.push_back(runs[r].id);
      }
    }
  }
  return inspection.blocks() ? std::optional(spoiled) : std::nullopt;
}

}  // namespace

DiagnoseResult diagnose(const DiagnoseJob& job, const diagnose::Say& say) {
  machine::MachineModel machine = machine::read_model(job.model);
  JoinedData data = read_joined(job.dataset, job.with);
  measure::Dataset& dataset = data.dataset;
  std::optional<Diagnostic> other = other_model(dataset, machine);
  measure::check_measured(dataset);
  diagnose::DiagnoseOptions options;
  options.candidates.without = job.without;
  options.search.threshold.seed = job.seed;
  say.begin(fmt::format("judging the readings of {} runs", dataset.runs.size()));
  Judged looked = judged(machine, std::move(dataset.runs), dataset.instrument, job.accepted);
  options.spoiled = spoiled(looked.inspection, looked.runs);
  const measure::Thinned thinned = measure::fit_runs(machine, std::move(looked.runs));
  diagnose::Diagnosis diagnosis = diagnose::diagnose(machine, thinned.runs, options, say);
  DiagnoseResult result{
      std::move(machine),    std::move(diagnosis), thinned.thinning, thinned.runs, std::move(looked.inspection), {},
      std::move(data.files), std::move(other)};
  if (result.diagnosis.withheld) return result;
  for (const diagnose::NamedEffect& effect : result.diagnosis.effects) {
    result.at_tip.push_back(at_tip(result.machine, result.runs, result.diagnosis.forces, effect.name));
  }
  return result;
}

}  // namespace plumbline::jobs

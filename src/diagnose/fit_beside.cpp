#include "diagnose/fit_beside.hpp"

#include "base/diagnostic.hpp"
#include "diagnose/held_values.hpp"

namespace plumbline::diagnose {

Fitted plain_fit(const Workbench& bench, const FittedStage& stage, const DiagnoseOptions& options) {
  const physics::ForceModel forces =
      bench.candidates.unknowns.at(held_values(bench, bench.forces, {}, stage.fit, options.hold).values);
  return {forces, parameter_errors(bench.candidates, forces, stage.fit), stage.fit};
}

std::optional<Fitted> fit_beside(const Workbench& bench, const FittedStage& stage, const physics::ForceModel& forces,
                                 const DiagnoseOptions& options) {
  const CandidateSet candidates = make_candidate_set(bench.machine, forces, options.candidates);
  const Workbench beside{bench.machine, forces, bench.runs, candidates};
  try {
    const Refit fit = refit(beside, {}, stage.fit.values, stage.noise, options.search.refit);
    if (!(fit.misfit < stage.fit.misfit)) return std::nullopt;
    const physics::ForceModel fitted =
        candidates.unknowns.at(held_values(beside, bench.forces, {}, fit, options.hold).values);
    return Fitted{fitted, parameter_errors(candidates, fitted, fit), fit};
  } catch (const Refusal&) {  // with the rows as they are, the machine falls through a singularity
    return std::nullopt;
  }
}

}  // namespace plumbline::diagnose

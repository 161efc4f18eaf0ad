#include "diagnose/unexplained.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostic.hpp"
#include "diagnose/held_values.hpp"

namespace plumbline::diagnose {
namespace {

// Adds the terms of a description as instances of the effect `generic`.
void add_terms(physics::ForceModel& forces, const std::vector<Term>& terms) {
  for (const Term& term : terms) {
    const int first = forces.add(physics::Generic::name);
    const std::vector<double> parameters = generic_parameters(term);
    std::copy(parameters.begin(), parameters.end(), forces.parameters.begin() + first);
  }
}

// What comes again was taken for noise.
identify::NoiseModel without_what_recurs(identify::NoiseModel noise, const Recurs& recurs) {
  for (int c = 0; c < identify::kChannels; ++c) {
    const std::optional<Recurring>& of = c == identify::kRadial ? recurs.radial : recurs.torque;
    if (of) noise.channels.at(static_cast<std::size_t>(c)).sigma *= std::sqrt(1 - std::abs(of->correlation));
  }
  return noise;
}

// The base model where what comes again counts as no noise; nothing if nothing does.
std::optional<FittedStage> without_what_recurs(const Workbench& bench, const FittedStage& base, const Recurs& recurs,
                                               const DiagnoseOptions& options) {
  if (!recurs.radial && !recurs.torque) return std::nullopt;
  FittedStage stage;
  stage.noise = without_what_recurs(base.noise, recurs);
  stage.fit = refit(bench, {}, base.fit.values, stage.noise, options.search.refit);
  stage.problem = std::make_shared<const LinearProblem>(linearise(bench.machine.rotation, bench.runs, bench.candidates,
                                                                  stage.fit.values, stage.noise,
                                                                  may_be_marginalised(bench.candidates, {})));
  return stage;
}

// The base model with the terms of a description, its nuisances refitted beside them; without them where that leaves
// more than before: the terms come from a linear problem.
Fitted described(const Workbench& bench, const FittedStage& stage, const std::vector<Term>& terms,
                 const DiagnoseOptions& options) {
  const physics::ForceModel before =
      bench.candidates.unknowns.at(held_values(bench, bench.forces, {}, stage.fit, options.hold).values);
  Fitted base{before, parameter_errors(bench.candidates, before, stage.fit), stage.fit};
  if (terms.empty()) return base;
  physics::ForceModel forces = bench.forces;
  add_terms(forces, terms);
  const CandidateSet candidates = make_candidate_set(bench.machine, forces, options.candidates);
  try {
    const Refit fit =
        refit({bench.machine, forces, bench.runs, candidates}, {}, stage.fit.values, stage.noise, options.search.refit);
    if (fit.misfit < stage.fit.misfit) {
      const Workbench beside{bench.machine, forces, bench.runs, candidates};
      const physics::ForceModel fitted =
          candidates.unknowns.at(held_values(beside, bench.forces, {}, fit, options.hold).values);
      return {fitted, parameter_errors(candidates, fitted, fit), fit};
    }
  } catch (const Refusal&) {  // with the terms as they are, the machine falls through a singularity
  }
  return base;
}

Description describe_base(const Workbench& bench, const FittedStage& stage, const DiagnoseOptions& options) {
  return describe(bench, bench.candidates.unknowns.at(stage.fit.values), *stage.problem,
                  marginalised_by(bench.candidates, {}, stage.fit.values), stage.noise, options.description);
}

}  // namespace

Unexplained unexplained(const Base& base, const std::vector<measure::Run>& runs, const std::vector<bool>& out,
                        const DiagnoseOptions& options) {
  const Workbench& bench = base.bench;
  const FittedStage* stage = &base.stage;
  Description description = base.description != nullptr ? *base.description : describe_base(bench, *stage, options);
  std::optional<FittedStage> quieter;
  if (!is_gap(description, options.verdict)) {
    quieter = without_what_recurs(bench, base.stage, base.recurs, options);
    if (quieter) description = describe_base(bench, *(stage = &*quieter), options);
  }
  if (!is_gap(description, options.verdict)) description.terms.clear();
  Fitted fitted = described(bench, *stage, description.terms, options);
  auto of_fitted = residuals(bench.machine, runs, fitted.forces, base.noise);
  if (held_out_misfit(of_fitted, out, base.noise) > held_out_misfit(base.residuals, out, base.noise)) {
    Fitted plain = described(bench, base.stage, {}, options);
    of_fitted = residuals(bench.machine, runs, plain.forces, base.noise);
    return {std::move(description), std::move(plain), std::move(of_fitted), false};
  }
  return {std::move(description), std::move(fitted), std::move(of_fitted)};
}

}  // namespace plumbline::diagnose

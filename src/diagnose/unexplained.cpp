#include "diagnose/unexplained.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnose/fit_beside.hpp"
#include "diagnose/learnt_residual.hpp"

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
  stage.problem =
      std::make_shared<LinearProblem>(linearise(bench.machine.rotation, bench.runs, bench.candidates, stage.fit.values,
                                                stage.noise, may_be_marginalised(bench.candidates, {})));
  return stage;
}

Fitted described(const Workbench& bench, const FittedStage& stage, const std::vector<Term>& terms,
                 const DiagnoseOptions& options) {
  physics::ForceModel forces = bench.forces;
  add_terms(forces, terms);
  std::optional<Fitted> fitted;
  if (!terms.empty()) fitted = fit_beside(bench, stage, forces, options);
  return fitted ? std::move(*fitted) : plain_fit(bench, stage, options);
}

Description describe_base(const Workbench& bench, const FittedStage& stage, const DiagnoseOptions& options) {
  return describe(bench, bench.candidates.unknowns.at(stage.fit.values), *stage.problem,
                  marginalised_by(bench.candidates, {}, stage.fit.values), stage.noise, options.description);
}

}  // namespace

Unexplained unexplained(const Base& base, const std::vector<measure::Run>& runs, const std::vector<bool>& out,
                        const DiagnoseOptions& options, const Say& say) {
  const Workbench& bench = base.bench;
  const FittedStage* stage = &base.stage;
  Description description = base.description != nullptr ? *base.description : describe_base(bench, *stage, options);
  std::optional<FittedStage> quieter;
  if (!is_gap(description, options.verdict)) {
    quieter = without_what_recurs(bench, base.stage, base.recurs, options);
    if (quieter) description = describe_base(bench, *(stage = &*quieter), options);
  }
  if (!is_gap(description, options.verdict)) description.terms.clear();
  Fitted plain = plain_fit(bench, base.stage, options);
  Fitted fitted = described(bench, *stage, description.terms, options);
  auto of_plain = residuals(bench.machine, runs, plain.forces, base.noise);
  auto of_fitted = residuals(bench.machine, runs, fitted.forces, base.noise);
  const double without = held_out_misfit(base.residuals, out, base.noise);
  Unexplained best{std::move(description), std::move(fitted), std::move(of_fitted), true, {}};
  double least = held_out_misfit(best.residuals, out, base.noise);
  if (least > without) {
    best.fitted = std::move(plain);
    best.residuals = std::move(of_plain);
    best.borne_out = false;
    least = without;
  }
  if (std::find(out.begin(), out.end(), true) == out.end()) return best;  // nothing would confirm it
  std::optional<Learnt> learnt = learn_residual(bench, *stage, options, say);
  if (!learnt) return best;
  auto of_learnt = residuals(bench.machine, runs, learnt->fitted.forces, base.noise);
  const double with = held_out_misfit(of_learnt, out, base.noise);
  if (with >= without || with > options.residual.as_near * least) return best;
  best.fitted = std::move(learnt->fitted);
  best.residuals = std::move(of_learnt);
  best.borne_out = true;
  best.residual = std::move(learnt->residual);
  return best;
}

}  // namespace plumbline::diagnose

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

Fitted plain_fit(const Workbench& bench, const FittedStage& stage, const DiagnoseOptions& options) {
  const physics::ForceModel forces =
      bench.candidates.unknowns.at(held_values(bench, bench.forces, {}, stage.fit, options.hold).values);
  return {forces, parameter_errors(bench.candidates, forces, stage.fit), stage.fit};
}

// The base model with rows added, its nuisances refitted beside them; nothing where that leaves more than before: the
// rows come from a linear problem.
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

struct Learnt {
  LearntResidual residual;
  Fitted fitted;
};

physics::ForceModel with_rows(const physics::ForceModel& forces, const std::vector<Component>& components,
                              std::vector<RowNumber>& numbers) {
  physics::ForceModel with = forces;
  numbers.clear();
  Eigen::Index weights = 0;
  for (const Component& component : components) weights += component.weights.size();
  Eigen::Index first = 0;
  for (const Component& component : components) {
    for (RowNumber& number : add_rows(component, with)) {
      Eigen::RowVectorXd by_all = Eigen::RowVectorXd::Zero(weights);
      by_all.segment(first, component.weights.size()) = number.by_weights;
      number.by_weights = std::move(by_all);
      numbers.push_back(std::move(number));
    }
    first += component.weights.size();
  }
  return with;
}

// Of the nuisances and the numbers of the rows.
Eigen::MatrixXd covariance_of(const Learner& learner, const CandidateSet& candidates,
                              const std::vector<RowNumber>& numbers) {
  const auto nuisances = static_cast<Eigen::Index>(candidates.nuisances);
  const Eigen::MatrixXd of_weights = learner.covariance();
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(nuisances + static_cast<Eigen::Index>(numbers.size()), of_weights.rows());
  for (Eigen::Index i = 0; i < nuisances; ++i) map(i, i) = candidates.unknowns[static_cast<std::size_t>(i)].scale;
  Eigen::VectorXd sigmas(of_weights.rows() - nuisances);
  Eigen::Index first = 0;
  for (const Component& component : learner.components()) {
    sigmas.segment(first, component.sigmas.size()) = component.sigmas;
    first += component.sigmas.size();
  }
  for (std::size_t k = 0; k < numbers.size(); ++k)
    map.row(nuisances + static_cast<Eigen::Index>(k)).tail(sigmas.size()) =
        numbers[k].by_weights.cwiseProduct(sigmas.transpose());
  return map * of_weights * map.transpose();
}

// Each round about the model that the one before found, with the noise that is then left.
std::optional<Learnt> learn_residual(const Workbench& bench, const FittedStage& base, const DiagnoseOptions& options) {
  FittedStage stage = base;
  physics::ForceModel forces = bench.forces;
  Learnt learnt{{}, {bench.forces, {}, {}}};
  try {
    for (int round = 0; round < options.residual.most_rounds; ++round) {
      const CandidateSet candidates = make_candidate_set(bench.machine, forces, options.candidates);
      const Workbench here{bench.machine, forces, bench.runs, candidates};
      if (round > 0) stage = fitted_stage(here, {}, stage.fit.values, stage.noise, options.search, {});
      Learner learner(here, candidates.unknowns.at(stage.fit.values), *stage.problem,
                      marginalised_by(candidates, {}, stage.fit.values), stage.noise, options.description,
                      options.residual);
      for (const Component& component : learnt.residual.components) learner.take(component);
      const bool more = learner.learn();
      learnt.residual.components = learner.components();
      if (learnt.residual.components.empty()) return std::nullopt;
      forces = with_rows(bench.forces, learnt.residual.components, learnt.residual.numbers);
      learnt.residual.covariance = covariance_of(learner, candidates, learnt.residual.numbers);
      if (!more) break;
    }
  } catch (const Refusal&) {
    return std::nullopt;
  }
  std::optional<Fitted> fitted = fit_beside(bench, base, forces, options);
  if (!fitted) return std::nullopt;
  learnt.fitted = std::move(*fitted);
  return learnt;
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
  std::optional<Learnt> learnt = learn_residual(bench, *stage, options);
  if (!learnt) return best;
  auto of_learnt = residuals(bench.machine, runs, learnt->fitted.forces, base.noise);
  if (held_out_misfit(of_learnt, out, base.noise) >= least) return best;
  best.fitted = std::move(learnt->fitted);
  best.residuals = std::move(of_learnt);
  best.borne_out = true;
  best.residual = std::move(learnt->residual);
  return best;
}

}  // namespace plumbline::diagnose

#include "diagnose/learnt_residual.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "diagnose/held_values.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double kLeastSigma = 1e-4;  // of a component's spread: what is narrower stays as exact as it is

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
      number.sigma = number.by_weights.cwiseProduct(component.sigmas.transpose()).norm();
      if (number.sigma < kLeastSigma * component.spread) continue;
      number.by_weights = std::move(by_all);
      numbers.push_back(std::move(number));
    }
    first += component.weights.size();
  }
  return with;
}

// Of the nuisances and the numbers of the rows, and of the weights.
void add_covariance(const Learner& learner, const CandidateSet& candidates, LearntResidual& learnt) {
  const std::vector<RowNumber>& numbers = learnt.numbers;
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
  learnt.covariance = map * of_weights * map.transpose();
  learnt.of_weights =
      sigmas.asDiagonal() * of_weights.bottomRightCorner(sigmas.size(), sigmas.size()) * sigmas.asDiagonal();
}

// The model with these rows, its nuisances and its noise fitted anew. Of effects that may be missing nothing is asked.
FittedStage refitted(const Workbench& bench, const physics::ForceModel& forces, const FittedStage& stage,
                     const SearchOptions& options) {
  const CandidateSet nuisances = make_nuisance_set(bench.machine, forces);
  const auto count = static_cast<Eigen::Index>(nuisances.nuisances);
  Eigen::VectorXd start = nuisances.unknowns.start();
  start.head(count) = stage.fit.values.head(count);
  FittedStage next = fitted_stage({bench.machine, forces, bench.runs, nuisances}, {}, start, stage.noise, options, {});
  Eigen::VectorXd values = stage.fit.values;
  values.head(count) = next.fit.values.head(count);
  next.fit.values = std::move(values);
  return next;
}

// The nuisances refitted beside the rows, without what might make the tip worse.
Fitted fitted_beside(const Workbench& bench, const FittedStage& stage, const physics::ForceModel& forces,
                     const LearntResidual& learnt, const DiagnoseOptions& options, const Say& say) {
  const CandidateSet candidates = make_candidate_set(bench.machine, forces, options.candidates);
  const Refit fit =
      refit({bench.machine, forces, bench.runs, candidates}, {}, stage.fit.values, stage.noise, options.search.refit);
  identify::Unknowns unknowns = candidates.unknowns;
  std::vector<Eigen::Index> places(candidates.nuisances);
  std::iota(places.begin(), places.end(), 0);
  for (const RowNumber& number : learnt.numbers) {
    const std::size_t place = unknowns.add(number.effect, number.key, std::max(number.index, 0), number.row);
    unknowns.set_prior(place, number.sigma);
    places.push_back(static_cast<Eigen::Index>(place));
  }
  Eigen::VectorXd values = unknowns.start();
  values.head(fit.values.size()) = fit.values;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(values.size(), values.size());
  covariance(places, places) = learnt.covariance;
  identify::HoldOptions hold = options.hold;
  hold.may_be_worse = options.residual.may_be_worse;
  hold.steps = 1;  // a part of a shift that is no better known than its size is as likely to be the wrong way
  const identify::Held held =
      identify::hold_unsure(bench.machine.rotation, bench.runs, bench.forces, unknowns, values, covariance, hold);
  say(shift_text(held));
  physics::ForceModel fitted = unknowns.at(held.values);
  std::vector<double> errors = parameter_errors(candidates, fitted, fit);
  return {std::move(fitted), std::move(errors), fit};
}

}  // namespace

std::optional<Learnt> learn_residual(const Workbench& bench, const FittedStage& base, const DiagnoseOptions& options,
                                     const Say& say) {
  FittedStage stage = base;
  physics::ForceModel forces = bench.forces;
  Learnt learnt{{}, {bench.forces, {}, {}}};
  try {
    for (int round = 0; round < options.residual.most_rounds; ++round) {
      const CandidateSet candidates = make_candidate_set(bench.machine, forces, options.candidates);
      const Workbench here{bench.machine, forces, bench.runs, candidates};
      if (round > 0) stage = refitted(bench, forces, stage, options.search);
      Learner learner(here, candidates.unknowns.at(stage.fit.values), *stage.problem,
                      marginalised_by(candidates, {}, stage.fit.values), stage.noise, options.description,
                      options.residual);
      if (round > 0) stage.problem->forget_rows();  // most of the memory, and the learner has its own
      for (const Component& component : learnt.residual.components) learner.take(component);
      const bool more = learner.learn();
      learnt.residual.components = learner.components();
      if (learnt.residual.components.empty()) return std::nullopt;
      forces = with_rows(bench.forces, learnt.residual.components, learnt.residual.numbers);
      add_covariance(learner, candidates, learnt.residual);
      if (!more) break;
    }
    say(fmt::format("learnt beside the base model: {} components, {} numbers", learnt.residual.components.size(),
                    learnt.residual.numbers.size()));
    learnt.fitted = fitted_beside(bench, stage, forces, learnt.residual, options, say);
    return learnt;
  } catch (const Refusal&) {  // with these functions the machine falls through a singularity
    return std::nullopt;
  }
}

}  // namespace plumbline::diagnose

#include "identify/posterior/posterior.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::identify {
namespace {

// Of a stage, in the order of its own unknowns.
PosteriorState state_of(const Stage& stage) {
  PosteriorState state;
  state.mean = stage.held ? stage.held->found : stage.fit.values;
  state.covariance = stage.fit.covariance;
  for (Eigen::Index i = 0; i < state.covariance.rows(); ++i) {
    if (std::isfinite(state.covariance(i, i))) continue;
    state.covariance.row(i).setZero();
    state.covariance.col(i).setZero();
  }
  const Plausibility& plausible = stage.plausible;
  state.widening = plausible.widening();
  state.moved = jackknife(plausible.left_out);
  return state;
}

// What is not fitted is as the owner states it.
void add_not_fitted(const machine::MachineModel& machine, Posterior& posterior) {
  Unknowns& unknowns = posterior.unknowns;
  const auto fitted = static_cast<Eigen::Index>(unknowns.size());
  const Unknowns stated = nuisances(machine, unknowns.forces());
  for (const Unknown& unknown : stated) {
    if (unknowns.find(unknown.effect, unknown.key, unknown.index) < 0) add_like(unknowns, unknown);
  }
  const auto all = static_cast<Eigen::Index>(unknowns.size());
  PosteriorState& state = posterior.states.front();
  state.mean.conservativeResize(all);
  state.covariance.conservativeResizeLike(Eigen::MatrixXd::Zero(all, all));
  state.moved.conservativeResizeLike(Eigen::MatrixXd::Zero(all, state.moved.cols()));
  for (Eigen::Index i = fitted; i < all; ++i) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(i)];
    state.mean[i] = unknown.start;
    state.covariance(i, i) = unknown.sigma * unknown.sigma / state.widening;
  }
}

// Beside those of the stages before: a later one took their values as exact.
void append(const Stage& stage, Posterior& posterior) {
  const PosteriorState more = state_of(stage);
  for (const Unknown& unknown : stage.fit.unknowns) add_like(posterior.unknowns, unknown);
  if (posterior.states.empty()) {
    posterior.states.push_back(more);
    return;
  }
  PosteriorState& state = posterior.states.front();
  const Eigen::Index before = state.mean.size();
  const Eigen::Index all = before + more.mean.size();
  state.mean.conservativeResize(all);
  state.mean.tail(more.mean.size()) = more.mean;
  state.covariance.conservativeResizeLike(Eigen::MatrixXd::Zero(all, all));
  state.covariance.bottomRightCorner(more.mean.size(), more.mean.size()) = more.covariance;
  state.widening = std::max(state.widening, more.widening);
  const Eigen::Index moves = state.moved.cols();
  state.moved.conservativeResizeLike(Eigen::MatrixXd::Zero(all, moves + more.moved.cols()));
  state.moved.bottomRightCorner(more.mean.size(), more.moved.cols()) = more.moved;
}

}  // namespace

Eigen::MatrixXd PosteriorState::doubt() const { return widening * covariance + moved * moved.transpose(); }

std::size_t add_like(Unknowns& unknowns, const Unknown& like) {
  const physics::EffectInfo& info = physics::effect_infos()[physics::effect_index(like.effect)];
  const auto spec = std::find_if(info.parameters.begin(), info.parameters.end(),
                                 [&](const physics::ParameterSpec& s) { return s.key == like.key; });
  const bool shared = like.index < 0 && spec->size() > 1;
  const std::size_t place = shared ? unknowns.add_shared(like.effect, like.key)
                                   : unknowns.add(like.effect, like.key, std::max(like.index, 0), like.row);
  if (!like.free()) unknowns.set_prior(place, like.sigma);
  return place;
}

Posterior about(const Posterior& posterior, const physics::ForceModel& forces) {
  Unknowns unknowns(forces);
  for (const Unknown& unknown : posterior.unknowns) add_like(unknowns, unknown);
  Posterior moved = posterior;
  moved.unknowns = std::move(unknowns);
  return moved;
}

Posterior prior_of(const machine::MachineModel& machine) {
  Posterior prior(nuisances(machine, physics::ForceModel(machine)));
  prior.from_data = false;
  prior.made_by = "[uncertainty] of the model";
  PosteriorState state;
  state.mean = prior.unknowns.start();
  state.covariance = Eigen::MatrixXd::Zero(state.mean.size(), state.mean.size());
  for (Eigen::Index i = 0; i < state.mean.size(); ++i) {
    const double sigma = prior.unknowns[static_cast<std::size_t>(i)].sigma;
    state.covariance(i, i) = sigma * sigma;
  }
  state.moved.resize(state.mean.size(), 0);
  prior.states.push_back(std::move(state));
  return prior;
}

Posterior posterior_of(const machine::MachineModel& machine, const Identification& found) {
  Posterior posterior{Unknowns(physics::ForceModel(machine))};
  for (const Stage& stage : found.stages) append(stage, posterior);
  add_not_fitted(machine, posterior);
  const NoiseModel& noise = found.stages.back().fit.noise;
  if (found.after.radial_readings > 0) posterior.noise.radial = noise.channels[kRadial].sigma;
  if (found.after.torque_readings > 0) {
    for (int channel = kRadial + 1; channel < kChannels; ++channel) {
      posterior.noise.torque = std::max(
          posterior.noise.torque, found.stages.front().fit.noise.channels[static_cast<std::size_t>(channel)].sigma);
    }
  }
  return posterior;
}

}  // namespace plumbline::identify

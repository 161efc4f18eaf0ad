#include "jobs/expected/tip_doubts.hpp"

#include <cmath>
#include <utility>

#include "identify/posterior/normal_length.hpp"
#include "machine/geometry.hpp"

namespace plumbline::jobs {
namespace {

using identify::Posterior;
using identify::PosteriorState;

}  // namespace

TipDoubts::State::State(const Posterior& posterior, const PosteriorState& state, bool own)
    : of(state),
      forces(own ? posterior.unknowns.at(posterior.unknowns.start()) : posterior.unknowns.at(state.mean)),
      sensitivity(forces, posterior.unknowns),
      precision(Eigen::VectorXd::Zero(state.mean.size())) {
  if (own) off = state.mean - posterior.unknowns.start();
  for (std::size_t i = 0; i < posterior.unknowns.size(); ++i) {
    const identify::Unknown& unknown = posterior.unknowns[i];
    if (!unknown.free()) precision[static_cast<Eigen::Index>(i)] = 1 / (unknown.sigma * unknown.sigma);
  }
}

TipDoubts::TipDoubts(const machine::MachineModel& model, const Posterior& posterior,
                     const compensate::Settings& settings)
    : posterior_(posterior),
      model_(model),
      time_s_(settings.time_s.value_or(0)),
      radius_(machine::platform_radius(model.geometry)),
      environment_(compensate::environment_of(posterior.unknowns.forces(), settings)) {
  for (const PosteriorState& state : posterior.states) states_.emplace_back(posterior, state, states_.empty());
  for (const identify::Unknown& unknown : posterior.unknowns) causes_.push_back(cause_of(unknown.effect));
}

void TipDoubts::set_tool(const compensate::ToolInSpindle& tool) {
  for (State& state : states_) state.forces.machine.geometry = machine::with_tool(model_.geometry, tool.length);
  environment_.tool_mass = tool.mass - model_.reference_tool_mass;
  environment_.tool_centre_P = model_.geometry.tool_tip_P - Vector3<double>(0, 0, tool.along);
}

physics::Motion<double> TipDoubts::motion(const compensate::Target& target) const {
  physics::Motion<double> motion = compensate::motion_at(model_.rotation, radius_, target, environment_);
  motion.time = time_s_;
  return motion;
}

std::optional<std::vector<TipDoubts::Played>> TipDoubts::played(const physics::Motion<double>& motion) const {
  std::vector<Played> all;
  Vector3<double> stands = Vector3<double>::Zero();  // with the model
  identify::Slopes slopes(identify::kOutcomes, states_.front().sensitivity.unknowns());
  for (const State& state : states_) {
    const physics::TipError<double> error = physics::tip_error(state.forces, environment_, motion);
    if (!error.converged()) return std::nullopt;
    state.sensitivity.at(environment_, motion, error, slopes);
    Played& here = all.emplace_back();
    here.slopes = slopes.middleRows<3>(identify::kTipRow);
    if (all.size() == 1) {
      stands = error.pose.p_WT;
      here.off = here.slopes * state.off;
    } else {
      here.off = error.pose.p_WT - stands;
    }
  }
  return all;
}

// `places`: how many places the unexplained part counts for. With G = S C and a prior of sigma_i on each number, that
// is the part of S C S^T that the prior leaves, |G_i|^2 / sigma_i^2 summed, and the part that the noise of the readings
// makes: the rest, as C = C (P^-1 + I) C.
TipDoubt TipDoubts::doubt_of(const std::vector<Played>& played, double places) const {
  TipDoubt doubt;
  std::array<double, kCauses> squares{};
  std::vector<identify::WeighedLength> lengths;
  std::array<std::vector<identify::WeighedNumber>, 3> axes;
  const double unexplained = places * posterior_.unexplained * posterior_.unexplained;
  Vector3<double> middle = Vector3<double>::Zero();
  auto state = states_.begin();
  for (const Played& here : played) middle += (state++)->of.weight * here.off;
  state = states_.begin();
  for (const Played& here : played) {
    const double weight = state->of.weight;
    const Eigen::Matrix3Xd& S = here.slopes;
    const Eigen::Matrix3Xd G = S * state->of.covariance;
    const double of_fit = std::max(0.0, (G.array() * S.array()).sum());
    double noise = of_fit;
    for (Eigen::Index i = 0; i < S.cols(); ++i) {
      const double left = G.col(i).squaredNorm() * state->precision[i];
      squares[index(causes_[static_cast<std::size_t>(i)])] += weight * left;
      noise -= left;
    }
    noise = std::max(0.0, noise);
    squares[index(Cause::noise)] += weight * noise;
    // leaving out a pose moves the tip by noise as well: what counts beside it is the excess
    const Eigen::Matrix3Xd moved = S * state->of.moved;
    const double by_poses = moved.squaredNorm();
    const double excess = by_poses > noise ? 1 - noise / by_poses : 0;
    Eigen::Matrix3d all = state->of.widening * G * S.transpose() + excess * moved * moved.transpose();
    all.diagonal().array() += unexplained;
    squares[index(Cause::unexplained)] +=
        weight * ((state->of.widening - 1) * of_fit + excess * by_poses + 3 * unexplained);
    if (played.size() > 1) squares[index(Cause::which_effect)] += weight * (here.off - middle).squaredNorm();
    doubt.axis_mean += weight * here.off;
    lengths.push_back({weight, {here.off, all}});
    doubt.mean += weight * lengths.back().length.mean();
    for (int a = 0; says_axes_ && a < 3; ++a)
      axes[static_cast<std::size_t>(a)].push_back({weight, here.off[a], std::sqrt(std::max(0.0, all(a, a)))});
    ++state;
  }
  // a shift that was held back is one of the joints
  squares[index(Cause::geometry)] += middle.squaredNorm();
  for (std::size_t c = 0; c < kCauses; ++c) doubt.rms[c] = std::sqrt(squares[c]);
  doubt.within = identify::length_within(lengths, kStatedProbability);
  for (int a = 0; says_axes_ && a < 3; ++a) {
    doubt.axis_within[a] = identify::number_within(axes[static_cast<std::size_t>(a)], kStatedProbability);
  }
  return doubt;
}

bool TipDoubts::touch_off(const AxisWords& pose) {
  compensate::Target target;
  target.pose = pose;
  zero_ = played(motion(target));
  return zero_.has_value();
}

std::optional<PoseDoubt> TipDoubts::at(const compensate::Target& target) const {
  std::optional<std::vector<Played>> here = played(motion(target));
  if (!here) return std::nullopt;
  PoseDoubt doubt{doubt_of(*here, 1), {}};
  if (!zero_) return doubt;
  for (std::size_t i = 0; i < here->size(); ++i) {
    (*here)[i].off -= (*zero_)[i].off;
    (*here)[i].slopes -= (*zero_)[i].slopes;
  }
  doubt.touched_off = doubt_of(*here, 2);
  return doubt;
}

}  // namespace plumbline::jobs

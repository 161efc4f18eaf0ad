#include "identify/posterior/expected_tip.hpp"

#include <cmath>

namespace plumbline::identify {

// e = S (p - p_model): E |e|^2 = |S (mean - p_model)|^2 + tr(S C S^T), S the slopes over the root of how many places
double expected_at_tip(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                       const Posterior& posterior) {
  if (runs.empty() || posterior.unknowns.size() == 0) return 0;
  const Eigen::VectorXd start = posterior.unknowns.start();
  const TipField field = tip_field(order, runs, posterior.unknowns.forces(), posterior.unknowns, start, {.middle = 1});
  if (field.places() == 0) return 0;
  double square = 3 * posterior.unexplained * posterior.unexplained;
  for (const PosteriorState& state : posterior.states) {
    const double off = (field.slopes * (state.mean - start)).squaredNorm();
    square += state.weight * (off + ((field.slopes * state.doubt()).array() * field.slopes.array()).sum());
  }
  return std::sqrt(square);
}

std::optional<LessSure> less_sure(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                                  const Posterior& given, const Posterior& learnt) {
  constexpr double kTimes = 2;          // as much: data that add something take something away from it
  constexpr double kNegligible = 5e-6;  // m
  const LessSure both{expected_at_tip(order, runs, given), expected_at_tip(order, runs, learnt)};
  if (both.given == 0 || both.learnt < kNegligible || both.learnt < kTimes * both.given) return std::nullopt;
  // What moves the tip by far more than it is unsure of brings it nearer, whatever was stated before it was found.
  const TipField field =
      tip_field(order, runs, given.unknowns.forces(), learnt.unknowns, learnt.unknowns.start(), {.middle = 1});
  if (field.moved.norm() > kTimes * both.learnt) return std::nullopt;
  return both;
}

}  // namespace plumbline::identify

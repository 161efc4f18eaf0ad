#include "path/subdivide.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/diagnostic.hpp"

namespace plumbline::path {
namespace {

constexpr double kMostPieces = 2e5;  // all of a move are kept at once
constexpr double kSlack = 1e-9;      // 1 mm at a step of 1 mm is one piece, whatever the last bit says

double steps(double amount, double step) { return step > 0 ? std::abs(amount) / step : 0; }

// The rotation vector of the tool turns at most as fast as A, B and C together.
double turn_deg(const AxisWords& delta) {
  return std::abs(delta[Axis::A]) + std::abs(delta[Axis::B]) + std::abs(delta[Axis::C]);
}

}  // namespace

Subdivision subdivide(const Curve& curve, std::optional<double> seconds, const StepSettings& settings,
                      const std::function<Place()>& place) {
  const double wanted =
      std::max({1.0, steps(curve.arc_deg(), settings.angle_deg), steps(turn_deg(curve.delta()), settings.angle_deg),
                steps(curve.linear_mm(), settings.length_mm)});
  double allowed = kMostPieces;
  if (seconds && settings.least_time_s > 0)
    allowed = std::max(1.0, std::floor(*seconds / settings.least_time_s + kSlack));
  if (std::min(wanted, allowed) >= kMostPieces) {
    refuse("path-too-many-pieces", fmt::format("a single move would be cut into {:.3g} pieces", wanted),
           "check its end, or give a larger --step-length or --step-angle", place ? place() : Place{});
  }
  const double pieces = std::ceil(wanted * (1 - kSlack));
  return {static_cast<int>(std::min(pieces, allowed)), pieces > allowed};
}

}  // namespace plumbline::path

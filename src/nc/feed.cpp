#include "nc/feed.hpp"

#include <cmath>

namespace plumbline::nc {
namespace {

// Degrees that a millimetre may bring along where the rule is not known: whether F counts none of them or all as
// millimetres, the time differs by 0.005 %.
constexpr double kTurnsLittle = 0.01;

double norm(double a, double b, double c) { return std::sqrt(a * a + b * b + c * c); }

}  // namespace

std::optional<double> feed_length(double linear_mm, const AxisWords& delta, FeedRule rule) {
  const double rotary_deg = norm(delta[Axis::A], delta[Axis::B], delta[Axis::C]);
  switch (rule) {
    case FeedRule::xyz_first:
    case FeedRule::path_group:
      return linear_mm > 0 ? linear_mm : rotary_deg;
    case FeedRule::all_axes_as_mm:
      return std::hypot(linear_mm, rotary_deg);
    case FeedRule::unknown:
      break;
  }
  if (linear_mm > 0 && rotary_deg > kTurnsLittle * linear_mm) return std::nullopt;
  return linear_mm > 0 ? linear_mm : rotary_deg;
}

std::optional<double> feed_length(const AxisWords& delta, FeedRule rule) {
  return feed_length(norm(delta[Axis::X], delta[Axis::Y], delta[Axis::Z]), delta, rule);
}

bool feed_length_is_angle(double linear_mm, FeedRule rule) {
  return linear_mm == 0 && rule != FeedRule::all_axes_as_mm;
}

}  // namespace plumbline::nc

#include "nc/rewrite/feed.hpp"

#include <cmath>

namespace plumbline::nc {
namespace {

// Degrees that a millimetre may bring along where the rule is not known: whether F counts none of them or all as
// millimetres, the time differs by 0.005 %.
constexpr double kTurnsLittle = 0.01;

double norm(double a, double b, double c) { return std::sqrt(a * a + b * b + c * c); }

}  // namespace

std::optional<double> feed_length(double linear_mm, const AxisWords& delta, FeedRule rule, double mm_per_unit) {
  const double rotary_deg = norm(delta[Axis::A], delta[Axis::B], delta[Axis::C]);
  switch (rule) {
    case FeedRule::xyz_first:
      return linear_mm > 0 ? linear_mm : rotary_deg;
    case FeedRule::all_axes_as_mm:
      // A degree counts as the program's unit, a mm or an inch: alone it is deg/min either way [B-63174EN 4.2].
      return linear_mm > 0 ? std::hypot(linear_mm, rotary_deg * mm_per_unit) : rotary_deg;
    case FeedRule::path_group:
    case FeedRule::tool_tip:
      if (linear_mm == 0 && rotary_deg > 0) return std::nullopt;
      return linear_mm;
    case FeedRule::unknown:
      break;
  }
  if (linear_mm > 0 && rotary_deg > kTurnsLittle * linear_mm) return std::nullopt;
  return linear_mm > 0 ? linear_mm : rotary_deg;
}

bool turns_count_little(const AxisWords& start, std::span<const AxisWords> ends, double mm_per_unit, double share) {
  double linear = 0;
  double all = 0;
  AxisWords at = start;
  for (const AxisWords& end : ends) {
    const AxisWords delta = end - at;
    const double mm = norm(delta[Axis::X], delta[Axis::Y], delta[Axis::Z]);
    at = end;
    if (mm == 0) continue;
    linear += mm;
    all += *feed_length(mm, delta, FeedRule::all_axes_as_mm, mm_per_unit);
  }
  return all - linear <= share * linear;
}

}  // namespace plumbline::nc

#include "machine/limits.hpp"

#include <cmath>

#include <fmt/format.h>

#include "machine/condition.hpp"

namespace plumbline::machine {
namespace {

// Adds what lies beyond the range, in the unit that messages speak.
// `name` is asked only then: poses within the limits, which are many, cost no text.
template <class Name>
void check_range(std::vector<Violation>& broken, Name&& name, double value, const Range& range, double unit,
                 std::string_view unit_name) {
  if (value >= range.lower && value <= range.upper) return;
  const double limit = value < range.lower ? range.lower : range.upper;
  broken.push_back({name(), value / unit, limit / unit, std::abs(value - limit) / unit, std::string(unit_name)});
}

void check_tilt(std::vector<Violation>& broken, const Matrix3<double>& R_WP, double limit) {
  const double angle = tilt(R_WP);
  if (angle <= limit + kTiltTolerance) return;
  check_range(
      broken, [] { return "tilt"; }, angle, {0, limit}, kDeg, "deg");
}

}  // namespace

std::string to_text(const Violation& v) {
  const std::string unit = v.unit.empty() ? "" : " " + v.unit;
  return fmt::format("{} would be {:.7g}{}, {:.4g}{} beyond its limit of {:.7g}{}", v.what, v.value, unit,
                     v.by_how_much, unit, v.limit, unit);
}

double tilt(const Matrix3<double>& R_WP) {
  // Z of P in W is the last column; atan2 keeps its accuracy near zero, where acos of its z has none
  return std::atan2(std::hypot(R_WP(0, 2), R_WP(1, 2)), R_WP(2, 2));
}

std::vector<Violation> check_programmed(const Limits& limits, const Pose<double>& pose) {
  std::vector<Violation> broken;
  check_tilt(broken, pose.R_WP, limits.tilt);
  return broken;
}

std::vector<Violation> check_compensated(const Limits& limits, const Geometry& geometry, const Pose<double>& pose) {
  std::vector<Violation> broken;
  check_tilt(broken, pose.R_WP, limits.tilt + limits.tilt_allowance);
  for (int a = 0; a < 3; ++a) {
    const auto name = [a] { return std::string(1, static_cast<char>('X' + a)); };
    check_range(broken, name, pose.p_WT[a], limits.travel[static_cast<std::size_t>(a)], kMm, "mm");
  }
  const StrutGeometry<double> struts = strut_geometry(geometry, pose);
  for (int j = 0; j < kStruts; ++j) {
    const auto name = [j] { return fmt::format("strut {}", j + 1); };
    check_range(broken, name, struts.length[j], {limits.length_min[j], limits.length_max[j]}, kMm, "mm");
  }
  if (std::isinf(limits.condition_max)) return broken;
  // The bound is cheap and never too small: only where it exceeds the limit is the number itself needed.
  const double radius = platform_radius(geometry);
  if (condition_bound<double>(struts, radius) > limits.condition_max) {
    check_range(
        broken, [] { return "condition"; }, condition_number(struts, radius), {0, limits.condition_max}, 1, "");
  }
  return broken;
}

}  // namespace plumbline::machine

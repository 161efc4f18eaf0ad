#include "nc/control/state/tilt.hpp"

#include <cmath>

#include "base/check.hpp"
#include "base/units.hpp"

namespace plumbline::nc {
namespace {

constexpr double kUpright = 1e-9;  // cosine of a tilt: less than this is a tool that lies

Turn about(int axis, double degrees) {
  const auto i = static_cast<std::size_t>(axis);
  const std::size_t j = (i + 1) % 3;
  const std::size_t k = (i + 2) % 3;
  const double c = std::cos(degrees * kDeg);
  const double s = std::sin(degrees * kDeg);
  Turn turn{};
  turn[3 * i + i] = 1;
  turn[3 * j + j] = turn[3 * k + k] = c;
  turn[3 * j + k] = -s;
  turn[3 * k + j] = s;
  return turn;
}

Turn product(const Turn& a, const Turn& b) {
  Turn c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) c[3 * i + j] += a[3 * i + k] * b[3 * k + j];
    }
  }
  return c;
}

ToolDirection times(const Turn& turn, const ToolDirection& v) {
  ToolDirection out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = turn[3 * i] * v[0] + turn[3 * i + 1] * v[1] + turn[3 * i + 2] * v[2];
  return out;
}

Turn transposed(const Turn& turn) {
  return {turn[0], turn[3], turn[6], turn[1], turn[4], turn[7], turn[2], turn[5], turn[8]};
}

double angle_between(double y, double x, double from_y, double from_x) {
  double degrees = (std::atan2(y, x) - std::atan2(from_y, from_x)) / kDeg;
  if (degrees > 180) degrees -= 360;
  if (degrees <= -180) degrees += 360;
  return degrees;
}

}  // namespace

Turn turned_in_turn(std::string_view axes, const std::array<double, 3>& degrees) {
  Turn turn = kNoTurn;
  for (std::size_t i = 0; i < 3; ++i) turn = product(turn, about(axes[i] - 'X', degrees[i]));
  return turn;
}

AxisWords turned(const Turn& turn, AxisWords words) {
  const ToolDirection v = times(turn, {words[Axis::X], words[Axis::Y], words[Axis::Z]});
  words[Axis::X] = v[0];
  words[Axis::Y] = v[1];
  words[Axis::Z] = v[2];
  return words;
}

AxisWords turned_back(const Turn& turn, AxisWords words) { return turned(transposed(turn), words); }

ToolDirection direction_of(const RotationOrder& order, const AxisWords& words) {
  ToolDirection v{0, 0, 1};
  for (std::size_t i = order.size(); i-- > 0;)
    v = times(about(order[i], words[kAllAxes[3 + static_cast<std::size_t>(order[i])]]), v);
  return v;
}

// The tool is R e_z. Rz(C) on the right of Rx(A) and Ry(B) leaves e_z alone; on their left it is taken off the
// direction; between them it stands with a fixed angle c: with X outside, n = Rx(A) v with
// v = Rz(c) Ry(B) e_z = (cos c sin B, sin c sin B, cos B), so that n_x gives B, and the angle between (v_y, v_z) and
// (n_y, n_z) gives A. With Y outside alike, v = Rz(c) Rx(A) e_z = (sin c sin A, -cos c sin A, cos A).
std::optional<AxisWords> orientation_along(const ToolDirection& along, const RotationOrder& order, double c_deg) {
  const double size = std::hypot(along[0], along[1], along[2]);
  if (!(size > 0) || along[2] / size < kUpright) return std::nullopt;
  ToolDirection n{along[0] / size, along[1] / size, along[2] / size};
  if (order[0] == 2) n = times(about(2, -c_deg), n);
  const double between = order[1] == 2 ? c_deg * kDeg : 0;
  const double c = std::cos(between);
  const double s = std::sin(between);
  if (c < kUpright) return std::nullopt;
  const bool x_outside = order[0] == 0 || (order[0] == 2 && order[1] == 0);
  const double inner_sine = (x_outside ? n[0] : -n[1]) / c;
  if (std::abs(inner_sine) >= 1) return std::nullopt;
  const double inner = std::asin(inner_sine);
  AxisWords words;
  words[Axis::C] = c_deg;
  if (x_outside) {
    const ToolDirection v{c * std::sin(inner), s * std::sin(inner), std::cos(inner)};
    words[Axis::B] = inner / kDeg;
    words[Axis::A] = angle_between(n[2], n[1], v[2], v[1]);
  } else {
    const ToolDirection v{s * std::sin(inner), -c * std::sin(inner), std::cos(inner)};
    words[Axis::A] = inner / kDeg;
    words[Axis::B] = angle_between(n[0], n[2], v[0], v[2]);
  }
  return words;
}

AxisWords shift_after(const Orienting& orienting, AxisWords shift) {
  const double c_shift = orienting.free == FreeRotation::c_stays ? shift[Axis::C] : 0;
  const auto was = orientation_along(orienting.along, orienting.order, orienting.c_deg);
  const auto is = orientation_along(orienting.along, orienting.order, orienting.c_deg + c_shift);
  PLUMBLINE_CHECK(was && is);
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) shift[axis] = (*is)[axis] - (*was)[axis];
  return shift;
}

}  // namespace plumbline::nc

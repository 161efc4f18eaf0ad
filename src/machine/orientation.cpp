#include "machine/orientation.hpp"

#include "base/angle.hpp"

namespace plumbline::machine {
namespace {

constexpr double kLock = 1e-7;  // cosine of the middle angle below which the outer two are not told apart

// The angles of R whose leftmost one is given.
Vector3<double> complete(const RotationOrder& order, const Matrix3<double>& R, double leftmost) {
  const auto [i, j, k] = order.axes;
  const double e = order.parity();
  // Of R_j R_k, the column of axis k is that of R_j alone and the row of axis j is that of R_k alone.
  const Matrix3<double> rest = axis_rotation(i, leftmost).transpose() * R;
  Vector3<double> abc;
  abc[i] = leftmost;
  abc[j] = std::atan2(e * rest(i, k), rest(k, k));
  abc[k] = std::atan2(e * rest(j, i), rest(j, j));
  return abc;
}

// Each angle moved by whole turns to where it is nearest to the reference.
Vector3<double> unwound(const Vector3<double>& abc, const Vector3<double>& reference) {
  Vector3<double> near = abc;
  for (int a = 0; a < 3; ++a) near[a] -= kTurn * std::round((abc[a] - reference[a]) / kTurn);
  return near;
}

}  // namespace

std::optional<RotationOrder> rotation_order(std::string_view text) {
  if (text.size() != 3) return std::nullopt;
  RotationOrder order;
  for (std::size_t n = 0; n < 3; ++n) {
    if (text[n] < 'X' || text[n] > 'Z') return std::nullopt;
    order.axes[n] = text[n] - 'X';
  }
  const bool different =
      order.axes[0] != order.axes[1] && order.axes[1] != order.axes[2] && order.axes[0] != order.axes[2];
  return different ? std::optional(order) : std::nullopt;
}

std::string to_text(const RotationOrder& order) {
  std::string text;
  for (const int axis : order.axes) text += static_cast<char>('X' + axis);
  return text;
}

Angles nearest_angles(const RotationOrder& order, const Matrix3<double>& R_WP, const Vector3<double>& reference) {
  const auto [i, j, k] = order.axes;
  if (std::hypot(R_WP(j, k), R_WP(k, k)) < kLock) {
    return {unwound(complete(order, R_WP, reference[i]), reference), true};
  }
  const double leftmost = std::atan2(-order.parity() * R_WP(j, k), R_WP(k, k));
  const Vector3<double> one = unwound(complete(order, R_WP, leftmost), reference);
  const Vector3<double> other = unwound(complete(order, R_WP, leftmost + std::numbers::pi), reference);
  const bool first = (one - reference).squaredNorm() <= (other - reference).squaredNorm();
  return {first ? one : other, false};
}

}  // namespace plumbline::machine

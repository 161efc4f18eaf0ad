#include "compensate/bound/arc_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace plumbline::compensate {
namespace {

using Vector2 = Eigen::Vector2d;

constexpr double kTurnRad = 2 * std::numbers::pi;
constexpr double kMostSweep = 0.9 * kTurnRad;  // of an arc that is a piece: its end is well behind its begin
constexpr std::size_t kFitLooks = 7;           // between the ends of a piece
constexpr int kRounds = 2;                     // the radius depends a little on where the centre is
constexpr double kApartCosts = 0.02;           // mm that the radius changes by, in mm that the tip is off
constexpr double kShiftCosts = 1e-6;           // and mm that the centre is shifted by
constexpr double kClosed = 1e-9;               // mm
constexpr double kSureWay = 50;                // times what rounding may do to the ends of an arc
constexpr double kSureSweep = 0.2;             // share of its angle by which an arc may differ
constexpr double kSureAngle = 1e-4;            // rad: less than 1e-6 is a full turn to LinuxCNC [_posemath.c]
constexpr double kLongMm = 0.1;

Vector2 in_plane(const AxisWords& words, const nc::PlaneAxes& plane) {
  return {words[plane.first], words[plane.second]};
}

Vector2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

void ArcFit::follow(const Move& move, const std::optional<nc::ArcForm>& form) {
  move_ = &move;
  form_.reset();
  if (move.motion->kind != nc::MotionKind::arc || !form) return;
  original_ = nc::arc_shape(move.motion->from, move.motion->to, move.motion->arc);
  if (std::min(original_.start_radius, original_.end_radius) < form->least_radius_mm) return;
  form_ = form;
}

// The original ends where it begins, after one turn or several.
bool ArcFit::closes() const {
  const nc::PlaneAxes plane = nc::axes_of(move_->motion->arc.plane);
  return (in_plane(move_->motion->to, plane) - in_plane(move_->motion->from, plane)).norm() < kClosed;
}

double ArcFit::most_share(double begin) const {
  const bool whole = begin == 0 && (!closes() || form_->may_close);
  return whole ? 1 : std::min(1.0, kMostSweep / std::abs(original_.sweep));
}

AxisWords ArcFit::end_of(const PieceEnd& begin, double end, const AxisWords& told) const {
  const nc::Frame& frame = move_->path.frame;
  const nc::PlaneAxes plane = nc::axes_of(move_->motion->arc.plane);
  const AxisWords from = frame.from_pose(begin.told);
  AxisWords to = frame.from_pose(told);
  for (const Axis axis : kAllAxes) {
    const bool in_plane = axis == plane.first || axis == plane.second;
    const bool stays = in_plane ? is_whole(begin.fraction, end) && closes() : !form_->beside.contains(axis);
    if (stays) to[axis] = from[axis];
  }
  return frame.to_pose(to);
}

// The radius that the control has on its way is R_a + f (R_b - R_a) about the centre c. Shifting c by d, the ends left
// alone, moves it off by d . g, g = n - (1 - f) n_a - f n_b, outwards, with n the direction from c; and the radii apart
// by d . h, h = n_a - n_b. The least squares of what is left, with a little on h and on d itself, since on a short arc
// neither shows.
std::optional<nc::Arc> ArcFit::between(const PieceEnd& begin, const PieceEnd& end) {
  const double share = end.fraction - begin.fraction;
  const bool whole = is_whole(begin.fraction, end.fraction);
  if (share > most_share(begin.fraction) * (1 + kClosed)) return std::nullopt;
  const nc::Frame& frame = move_->path.frame;
  const nc::PlaneAxes plane = nc::axes_of(move_->motion->arc.plane);
  nc::Arc arc = move_->motion->arc;
  if (!whole) arc.turns = arc.turns > 0 ? 1 : -1;
  const AxisWords from = frame.from_pose(begin.told);
  const AxisWords to = frame.from_pose(end.told);
  std::array<Vector2, kFitLooks> wanted;
  Vector2 shift = Vector2::Zero();
  for (std::size_t i = 0; i < kFitLooks; ++i) {
    const double along = static_cast<double>(i + 1) / (kFitLooks + 1);
    const PathPlace place = curve_.place(begin.fraction + along * share);
    const Corrected corrected = curve_.command(place, begin.sign + along * (end.sign - begin.sign));
    if (!corrected.converged) return std::nullopt;
    wanted[i] = in_plane(frame.from_pose(corrected.pose), plane);
    shift += (wanted[i] - in_plane(place.work, plane)) / kFitLooks;
  }
  Vector2 centre = Vector2(original_.centre[0], original_.centre[1]) + shift;
  const auto shape_about = [&] {
    arc.centre_mm[index(plane.first)] = centre[0];
    arc.centre_mm[index(plane.second)] = centre[1];
    arc.centre_mm[index(plane.third)] = from[plane.third];
    return nc::arc_shape(from, to, arc);
  };
  for (int round = 0; round < kRounds; ++round) {
    const nc::ArcShape shape = shape_about();
    const Vector2 n_a = direction(shape.start_angle);
    const Vector2 n_b = direction(shape.start_angle + shape.sweep);
    const Vector2 h = kApartCosts * (n_a - n_b);
    Eigen::Matrix2d squares = h * h.transpose() + kShiftCosts * kShiftCosts * Eigen::Matrix2d::Identity();
    Vector2 right = -h * kApartCosts * (shape.end_radius - shape.start_radius);
    for (std::size_t i = 0; i < kFitLooks; ++i) {
      const double f = static_cast<double>(i + 1) / (kFitLooks + 1);
      const Vector2 out = wanted[i] - centre;
      const Vector2 g = out.normalized() - (1 - f) * n_a - f * n_b;
      const double radius = shape.start_radius + f * (shape.end_radius - shape.start_radius);
      squares += g * g.transpose();
      right -= g * (radius - out.norm());
    }
    centre += squares.ldlt().solve(right);
  }
  if (!is_sure(shape_about(), share, whole)) return std::nullopt;
  return arc;
}

// What rounding does to the ends and the centre makes it no other arc: a full turn more or less.
bool ArcFit::is_sure(const nc::ArcShape& shape, double share, bool whole) const {
  const double intended = original_.sweep * share;
  const double radius = std::min(shape.start_radius, shape.end_radius);
  if (radius < form_->least_radius_mm) return false;
  if (std::abs(shape.start_radius - shape.end_radius) > form_->radii_apart_mm) return false;
  if (std::abs(shape.sweep - intended) > kSureSweep * std::min(std::abs(intended), 1.0)) return false;
  if (whole && closes()) return true;
  const double over = std::fmod(std::abs(shape.sweep), kTurnRad);
  const double apart = std::min(over, kTurnRad - over);  // its ends
  return apart > kSureAngle && radius * apart > kSureWay * form_->half_centre_mm;
}

bool ArcFit::is_long(double share) const {
  return original_.length_mm() * share > kLongMm && std::abs(original_.sweep) * share > 2 * kSureAngle;
}

// Its ends are where they are: between them the radius is off by |d . g| at most, |g| <= min(2, sweep^2 / 8).
double ArcFit::rounding_mm(double share) const {
  const double sweep = original_.sweep * share;
  return std::numbers::sqrt2 * form_->half_centre_mm * std::min(2.0, sweep * sweep / 8);
}

}  // namespace plumbline::compensate

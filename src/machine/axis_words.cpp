#include "machine/axis_words.hpp"

#include "base/units.hpp"

namespace plumbline::machine {
namespace {

Vector3<double> angles_of(const AxisWords& words) {
  return kDeg * Vector3<double>(words[Axis::A], words[Axis::B], words[Axis::C]);
}

}  // namespace

Pose<double> pose_of(const RotationOrder& order, const AxisWords& words) {
  return {kMm * Vector3<double>(words[Axis::X], words[Axis::Y], words[Axis::Z]), rotation(order, angles_of(words))};
}

AxisWords words_of(const RotationOrder& order, const Pose<double>& pose, const AxisWords& reference) {
  const Vector3<double> position = pose.p_WT / kMm;
  const Vector3<double> angles = nearest_angles(order, pose.R_WP, angles_of(reference)).abc / kDeg;
  return {{position[0], position[1], position[2], angles[0], angles[1], angles[2]}};
}

}  // namespace plumbline::machine

// Poses in the control's words: X, Y, Z in mm, A, B, C in deg. The edge between NC programs and SI.
#pragma once

#include "base/axes.hpp"
#include "base/pose.hpp"
#include "machine/orientation.hpp"

namespace plumbline::machine {

/// The pose that the words name.
Pose<double> pose_of(const RotationOrder& order, const AxisWords& words);

/// The words of a pose, A, B, C nearest to those of `reference` (see nearest_angles).
AxisWords words_of(const RotationOrder& order, const Pose<double>& pose, const AxisWords& reference);

}  // namespace plumbline::machine

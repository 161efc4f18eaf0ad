// Angles that come round.
#pragma once

#include <cmath>
#include <numbers>

namespace plumbline {

inline constexpr double kTurn = 2 * std::numbers::pi;  // rad

/// An angle (rad) within one turn from 0.
inline double within_turn(double angle) { return angle - kTurn * std::floor(angle / kTurn); }

}  // namespace plumbline

// Systems that lie askew in space, and the words of A, B, C with which the tool stands along a direction.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/axes.hpp"

namespace plumbline::nc {

/// A rotation matrix, row by row: the columns are the axes of the turned system in those of the one around it.
using Turn = std::array<double, 9>;
inline constexpr Turn kNoTurn{1, 0, 0, 0, 1, 0, 0, 0, 1};

using ToolDirection = std::array<double, 3>;

/// Rotations one after the other, each about an axis of the system as turned so far: "ZXZ" and three angles.
Turn turned_in_turn(std::string_view axes, const std::array<double, 3>& degrees);
/// X, Y and Z turned; A, B and C as they are.
AxisWords turned(const Turn& turn, AxisWords words);
AxisWords turned_back(const Turn& turn, AxisWords words);

/// The order in which A, B and C compose: {2, 1, 0} is R = Rz(C) Ry(B) Rx(A).
using RotationOrder = std::array<int, 3>;

/// What the control does with C where the direction of the tool leaves the rotation about the tool open.
enum class FreeRotation : std::uint8_t { unknown, c_stays, c_zero };

/// A, B and C (deg) with which the spindle, Z of the platform, stands along `along`; C as given. Nothing where no A
/// and B below 90 deg do that.
std::optional<AxisWords> orientation_along(const ToolDirection& along, const RotationOrder& order, double c_deg);

/// Where the tool points, from its tip to the spindle, at A, B and C (deg).
ToolDirection direction_of(const RotationOrder& order, const AxisWords& words);

/// What turned the tool into a direction: enough to know where A and B went, had C stood elsewhere.
struct Orienting {
  ToolDirection along{};
  RotationOrder order{2, 1, 0};
  FreeRotation free = FreeRotation::unknown;
  double c_deg = 0;  // where C stood, of the machine
};

/// How far A, B and C are off after it where they were off by `shift` before it.
AxisWords shift_after(const Orienting& orienting, AxisWords shift);

}  // namespace plumbline::nc

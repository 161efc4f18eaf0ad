// What several files of this module compute alike.
#pragma once

#include <numbers>

#include "base/median.hpp"

namespace plumbline::inspect {

inline constexpr double kTurn = 2 * std::numbers::pi;

}  // namespace plumbline::inspect

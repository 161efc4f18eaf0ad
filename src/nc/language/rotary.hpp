// Where a word of A, B or C sends an axis that turns without end.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace plumbline::nc {

/// How a control counts the absolute words of an axis that turns. Positions count on, whichever the rule: 370 is
/// after 360.
enum class RotaryRule : std::uint8_t {
  linear,    // a place on a scale without end
  sign,      // 0 to 360; the sign says which way round [LinuxCNC WRAPPED_ROTARY; Fanuc 1008 ROA and RAB]
  shortest,  // any turn of it, the shorter way round [Fanuc 1008 ROA; Siemens MD30455 bit 2; DC]
  one_turn,  // any turn of it, within that in which the axis stands [Siemens MD30310]
};

/// Of A, B and C.
using RotaryRules = std::array<RotaryRule, 3>;

inline constexpr double kFullTurn = 360;

/// Where an axis that stands at `from` goes, deg. `place`: the word as a position of the work system, which is not the
/// word itself in machine coordinates; `negative`: the word has a minus, -0 too. Without `from`, in which turn it
/// stands then is not known: the first one, which begins at -37.5, so that corrections of places such as 0 and 180 stay
/// in it.
double rotary_end(RotaryRule rule, double place, bool negative, std::optional<double> from);

/// The word, a sign included, that sends an axis from `from` to `to`; nothing if none does.
std::optional<double> rotary_word(RotaryRule rule, double to, double from);

/// The turn of `angle` that lies in 0 <= ... < 360.
double within_one_turn(double angle);

}  // namespace plumbline::nc

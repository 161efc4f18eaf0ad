#include "nc/language/rotary.hpp"

#include <cmath>

namespace plumbline::nc {
namespace {

constexpr double kFirstTurn = -37.5;  // deg
constexpr double kSameAngle = 1e-9;   // deg: what adding and taking away offsets may leave

double begin_of_turn(double angle) { return std::floor((angle + kSameAngle) / kFullTurn) * kFullTurn; }

}  // namespace

double within_one_turn(double angle) {
  const double within = std::fmod(angle, kFullTurn);
  return within < 0 ? within + kFullTurn : within;
}

double rotary_end(RotaryRule rule, double place, bool negative, std::optional<double> known_from) {
  if (rule == RotaryRule::linear) return place;
  if (rule == RotaryRule::sign) place = std::abs(place);  // the sign says the way round
  if (!known_from) return kFirstTurn + within_one_turn(place - kFirstTurn);
  const double from = *known_from;
  switch (rule) {
    case RotaryRule::sign: {  // as LinuxCNC's interpreter does it [measured]
      const double end = place + begin_of_turn(from);
      if (std::abs(end - from) < kSameAngle) return end;
      if (negative) return end > from ? end - kFullTurn : end;
      return end < from ? end + kFullTurn : end;
    }
    case RotaryRule::shortest: {  // half a turn goes up [B-63783EN 1.6.3]
      const double up = within_one_turn(place - from);
      return from + (up > kFullTurn / 2 ? up - kFullTurn : up);
    }
    case RotaryRule::one_turn:
      return begin_of_turn(from) + within_one_turn(place);
    case RotaryRule::linear:
      break;
  }
  return place;
}

std::optional<double> rotary_word(RotaryRule rule, double to, double from) {
  if (rule == RotaryRule::linear) return to;
  const double place = within_one_turn(to);
  const bool negative = rule == RotaryRule::sign && to < from;
  if (negative && place == 0) return std::nullopt;  // -0 is not the same to every control
  if (std::abs(rotary_end(rule, place, negative, from) - to) > kSameAngle) return std::nullopt;
  return negative ? -place : place;
}

}  // namespace plumbline::nc

#include "nc/control/state/kept.hpp"

#include <algorithm>
#include <cmath>

#include "base/text/number_text.hpp"

namespace plumbline::nc {
namespace {

constexpr double kWholeTicks = 1e-6;  // of a tick, so that 0.123 is not cut to 0.122, and 1.0005 is a half

constexpr double kLargestKept = 1e9;  // beyond it a word is refused

}  // namespace

Kept kept_of(const ControlBehaviour& behaviour, bool angle, bool inches, double ratio) {
  if (!behaviour.keeps_increment) return {0, kMostDecimals};
  const double quantum = ratio * (angle    ? behaviour.increment_deg
                                  : inches ? behaviour.increment_inch
                                           : behaviour.increment_mm);
  if (quantum <= 0) return {0, kMostDecimals};
  const int decimals = static_cast<int>(std::ceil(-std::log10(quantum) - kWholeTicks));
  return {quantum, std::clamp(decimals, 0, kMostDecimals)};
}

Kept kept_of_axis_word(const ControlBehaviour& behaviour, bool angle, bool inches, double ratio, bool incremental) {
  const bool of_word = incremental || behaviour.increment_word_always;
  if (!of_word || behaviour.increment_word_mm <= 0) return kept_of(behaviour, angle, inches, ratio);
  const double quantum = angle    ? behaviour.increment_word_deg
                         : inches ? behaviour.increment_word_inch
                                  : behaviour.increment_word_mm;
  if (quantum <= 0) return {0, kMostDecimals};
  return {quantum, static_cast<int>(std::lround(-std::log10(quantum)))};
}

double kept_value(double value, const Kept& kept, bool is_literal) {
  if (kept.quantum <= 0 || std::abs(value) > kLargestKept) return value;
  const double ticks = value / kept.quantum;
  const double whole = std::round(is_literal ? ticks : ticks + std::copysign(kWholeTicks, ticks));
  const double cut = std::abs(ticks - whole) < kWholeTicks || !is_literal ? whole : std::trunc(ticks);
  return from_ticks(to_ticks(cut * kept.quantum, kept.decimals), kept.decimals);
}

double WrittenNumber::kept_of_quanta(double quanta) const {
  const double whole = std::abs(quanta) < kLargestExact ? static_cast<double>(nearest_whole(quanta)) : quanta;
  return from_ticks(to_ticks(whole * quantum, digits), digits);
}

WrittenNumber written_number(const Kept& kept, int digits, double increment) {
  const int written = std::clamp(digits, 0, kept.decimals);
  return {written, std::max({increment, from_ticks(1, written), kept.quantum})};
}

}  // namespace plumbline::nc

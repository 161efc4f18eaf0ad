#include "inspect/fault.hpp"

#include <algorithm>
#include <array>

namespace plumbline::inspect {

std::string_view to_text(FaultKind kind) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(FaultKind::stands_out) + 1> kNames{
      "direction",       "angle-zero",   "centre",    "tilt",     "payload",     "radius",
      "bar-length",      "feed",         "exchanged", "bar-sign", "bar-unit",    "motor-sign",
      "motors-swapped",  "torque-unit",  "clock",     "drift",    "bar-step",    "motor-zero",
      "motors-unsigned", "motor-silent", "stuck",     "clipped",  "noisy",       "same-readings",
      "motors-alike",    "start",        "spikes",    "gaps",     "unreachable", "periodic-disturbance",
      "noise",           "stands-out"};
  return kNames.at(static_cast<std::size_t>(kind));
}

bool Inspection::blocks() const {
  return std::any_of(faults.begin(), faults.end(), [](const Fault& fault) { return fault.blocks; });
}

bool is_setting(FaultKind kind) {
  return kind == FaultKind::centre || kind == FaultKind::tilt || kind == FaultKind::payload ||
         kind == FaultKind::radius || kind == FaultKind::bar_length;
}

bool is_by_degrees(FaultKind kind) {
  return is_setting(kind) || kind == FaultKind::drift || kind == FaultKind::bar_step || kind == FaultKind::motor_zero;
}

}  // namespace plumbline::inspect

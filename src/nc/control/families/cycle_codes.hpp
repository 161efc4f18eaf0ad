// Cycles by the `value` of their rows.
#pragma once

namespace plumbline::nc {

enum CycleCode {
  kChipBreaking = 73,
  kLeftTapping = 74,
  kDrill = 81,
  kDrillDwell,
  kPeck,
  kTapping,
  kBore,
  kBoreStop,
  kBackBore,
  kBoreByHand,
  kBoreDwell
};

inline bool is_tap(int code) { return code == kLeftTapping || code == kTapping; }

inline bool works_spindle(int code) {
  return is_tap(code) || code == kBoreStop || code == kBackBore || code == kBoreByHand;
}

}  // namespace plumbline::nc

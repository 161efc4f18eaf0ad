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

inline bool works_spindle(int code) {
  return code == kLeftTapping || code == kTapping || code == kBoreStop || code == kBackBore || code == kBoreByHand;
}

}  // namespace plumbline::nc

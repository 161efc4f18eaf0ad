// Modes that M70 and M73 keep and M72 brings back: those that LinuxCNC names, so not the motion.
#pragma once

#include "nc/execution.hpp"

namespace plumbline::nc {

struct SavedModes {
  bool valid = false;
  bool of_call = false;  // M73: come back at the end of the subprogram
  Modal modal;
  double feed_linear = 0, spindle_speed = 0;
  AxisWords tool;  // length in force
};

SavedModes save_modes(const Control& control, bool of_call);
/// `block` is the one at fault where they cannot come back.
void restore_modes(Execution& run, const SavedModes& saved, const Block& block);

}  // namespace plumbline::nc

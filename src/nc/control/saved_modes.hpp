// Modes that M70 and M73 keep and M72 brings back: those that LinuxCNC names, so not the motion.
#pragma once

#include <optional>

#include "nc/control/execution.hpp"

namespace plumbline::nc {

struct SavedModes {
  Modal modal;
  bool tool_length = false;         // some length was in force: G43, else G49
  std::optional<bool> g92_applied;  // whether an offset of G92 or G52 was; nothing: not known
};

/// What a call has kept. Once M73 was written, whatever M70 keeps after it comes back at the end as well [M].
struct ModesOfCall {
  std::optional<SavedModes> saved;
  bool come_back = false;
  bool sets_call = false;  // of a cycle after each move: MCALL
};

SavedModes save_modes(const Control& control);
/// As the control does it, which executes the codes of those modes that differ: G43 is the length of the tool in the
/// spindle then, F and S come back rounded, G92.2 or G92.3 stands for G92. `block` is the one at fault where they
/// cannot come back.
void restore_modes(Execution& run, const SavedModes& saved, const Block& block);

}  // namespace plumbline::nc

// Which speed an F is.
#pragma once

#include <cstdint>

namespace plumbline::nc {

/// Which length a feed per minute is the speed along.
enum class FeedRule : std::uint8_t {
  xyz_first,       // of X Y Z if any of them moves, else of A B C (deg) [RS274/NGC 2.1.2.5]
  all_axes_as_mm,  // of all six, degrees counted as millimetres
  tool_tip,        // of X Y Z; how long A B C alone turn, no program says (G43.4)
  path_group,      // of X Y Z, the path group; how long A B C alone turn was found in no source (FGROUP)
  unknown,         // blocks that mix linear and rotary words are refused
};

}  // namespace plumbline::nc

// What a tool may measure.
#pragma once

namespace plumbline::nc {

inline constexpr double kLongestTool = 2000;  // mm, kg: beyond it the unit is wrong
inline constexpr double kShortestTool = 1;    // mm, likewise; 0 is no length at all
inline constexpr double kLargestToolNumber = 1e6;

}  // namespace plumbline::nc

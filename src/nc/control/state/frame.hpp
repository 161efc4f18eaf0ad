// Work offsets: from the words of a program to the machine and back.
#pragma once

#include "base/axes.hpp"
#include "nc/control/state/tilt.hpp"

namespace plumbline::nc {

inline constexpr AxisSet kTurningAxes{Axis::X, Axis::Y};  // which a rotation of the work system mixes

/// The offsets in force. Order as in RS274/NGC: work + G92, turned about Z by the rotation, + work offset, + tool.
struct Frame {
  AxisWords origin;         // of the active work system (G54...)
  double rotation_deg = 0;  // of the active work system about Z (G10 L2 R), of X and Y alone
  AxisWords g92;            // G92, G52
  AxisWords tool;           // G43: what the tool adds to the control's display
  bool tilted = false;   // a plane lies askew (G68.2): then rotation_deg and g92 are zero, the origin is the plane's,
  Turn plane = kNoTurn;  // and this its axes; the tool's length counts along its Z

  bool operator==(const Frame&) const = default;
  /// The tool tip in W: every offset but the tool's, whose length is part of the machine's geometry.
  AxisWords to_pose(const AxisWords& work) const { return turned(work + g92) + origin; }
  AxisWords from_pose(const AxisWords& pose) const { return turned_back(pose - origin) - g92; }
  /// The control's display: every offset.
  AxisWords to_machine(const AxisWords& work) const { return to_pose(work) + (tilted ? turned(tool) : tool); }
  AxisWords from_machine(const AxisWords& machine) const;
  /// As G53, G28 and G30 (not G28.1 and G30.1) see it: without the rotary offsets of the tool [LinuxCNC, measured].
  Frame without_rotary_tool() const;
  /// A difference of positions, from the axes of the words to those of W, and back.
  AxisWords turned(const AxisWords& words) const { return turns() ? turned_forth(words) : words; }
  AxisWords turned_back(const AxisWords& words) const { return turns() ? turned_home(words) : words; }
  /// The axes that are made of each other: known together or not at all. None where nothing turns.
  AxisSet mixed() const;

 private:
  bool turns() const { return tilted || rotation_deg != 0; }
  AxisWords turned_forth(const AxisWords& words) const;
  AxisWords turned_home(const AxisWords& words) const;
};

/// X and Y turned into each other; the other words as they are.
AxisWords turned_about_z(AxisWords words, double degrees);

}  // namespace plumbline::nc

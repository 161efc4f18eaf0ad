// What the program being written has told the control so far: where it stands and what is modal in it.
#pragma once

#include "base/axes.hpp"
#include "nc/control/state/frame.hpp"
#include "nc/control/step.hpp"
#include "nc/rewrite/output/emit_codes.hpp"

namespace plumbline::nc {

/// The control's state where it can differ from that of the original program.
struct OutputState {
  AxisWords shift;  // control's position minus the original's, in W: mm and deg
  MotionMode motion = MotionMode::none;
  bool modal_call = false;  // a cycle is called after each move
  FeedMode feed_mode = FeedMode::per_minute;
  double feed = 0;         // in the program's unit; 0: none in force
  double feed_rotary = 0;  // the same as deg/min: it does not follow a change of units

  /// The shift in the words of the active work system, and back.
  AxisWords work_shift(const Frame& frame) const;
  void set_work_shift(const Frame& frame, const AxisWords& work);

  /// A block has changed the feed mode: the control drops its F.
  void drop_feed() { feed = feed_rotary = 0; }
  void set_feed(double value) { feed = feed_rotary = value; }
  /// The length unit becomes that of `after`: F keeps its speed.
  void change_unit(const Modal& before, const Modal& after);

  /// Takes over the modal state of the original.
  void adopt(const Modal& modal);
  /// Follows a block that was passed through as it stands, and has these codes.
  void follow(const Step& step, const BlockCodes& codes);
};

}  // namespace plumbline::nc

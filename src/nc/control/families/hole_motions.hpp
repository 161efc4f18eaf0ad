// What a canned cycle does at one hole.
#pragma once

#include "nc/control/execution.hpp"

namespace plumbline::nc {

/// What its levels count from, along the normal of the plane, mm.
struct CycleLevels {
  double start = 0;   // where the first of these cycles began
  double offset = 0;  // how far the tool comes up into the hole from below
};

/// Adds motions to an execution, from the place and the levels of one hole. All lengths in mm.
class HoleMotions {
 public:
  HoleMotions(Execution& run, const Hole& hole, const CycleLevels& levels)
      : run_(run),
        control_(run.control),
        cycle_(run.control.cycle),
        hole_(hole),
        levels_(levels),
        axes_(axes_of(run.control.modal.plane)),
        code_(run.motion->value),
        as_fanuc_(run.dialect.behaviour.fanuc_cycles),
        unit_(run.control.length_unit()) {}

  /// Above the hole, or along it.
  void along(MotionKind kind, double level) { go(kind, hole_.first, hole_.second, level); }
  /// From R down, what the cycle does there, and up.
  void at_hole();

 private:
  double in_unit(double mm) const;
  void pecks();
  void back_bore();
  void go(MotionKind kind, double first, double second, double level);
  void along_tap(double level);
  void wait();
  bool waits_as_osp() const { return run_.dialect.behaviour.return_levels && cycle_.dwell_s > 0; }

  Execution& run_;
  Control& control_;
  const Cycle& cycle_;
  const Hole& hole_;
  const CycleLevels& levels_;
  PlaneAxes axes_;
  int code_;
  bool as_fanuc_;
  double unit_;      // mm
  double feed_ = 0;  // of the way out; 0: as that of the way in
};

}  // namespace plumbline::nc

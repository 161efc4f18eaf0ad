// How a program is compensated.
#pragma once

#include <optional>

#include "base/axes.hpp"
#include "path/subdivide.hpp"

namespace plumbline::compensate {

enum class Method {
  exact,        // T_c = FK(IK(T) - dL(T)): the deformed machine stands on T  [docs/physics.md, Compensation]
  first_order,  // T_c = T - dT(T)  [Ibaraki et al., 3.3]
};

/// Points are chosen by a bound: the deformed tip stays within it of the programmed path, between the points as well.
struct BoundSettings {
  double tolerance_mm = 0;  // 0: the steps choose them
  /// Over this length a turn of the tool counts: its orientation is within tolerance_mm / turn_length_mm, in rad.
  double turn_length_mm = 100;
  /// Of a piece: the control's time for a block.
  double least_time_s = 1e-3;
  /// Of a piece under G93, whatever yields: the time of the largest F that the control takes.
  double least_inverse_time_s = 0;
  /// What gives way where both cannot be had: the bound, or the time.
  enum class Yields { bound, time } yields = Yields::bound;

  bool is_asked() const { return tolerance_mm > 0; }
};

struct Settings {
  Method method = Method::exact;
  bool friction = true;
  bool dynamic = false;  // inertia and the following error of the drives, as if the control held the feed everywhere
  /// On the clock of the measurements, for effects that drift; not stated: 0.
  std::optional<double> time_s;
  path::StepSettings step;
  /// Where it is asked for the points are chosen by it, and `step` is left alone.
  BoundSettings bound;
  /// The sign of a strut's speed is smoothed over this share of the feed, so that a compensated path has no steps.
  double sign_width_of_feed = 0.01;
  /// What a correction may vary along a hole whose cycle is shifted as a whole (G74, G84, G86 to G88).
  double cycle_tolerance_mm = 0.005;
  /// Where the work offset was probed on the sagging machine: pose in W, mm and deg. Its error is added to the offset.
  std::optional<AxisWords> touch_off;
  /// The output is read again as it is written, and held against what was meant.
  bool read_back = true;
};

/// The steps by which a reader divides cuts: none where a bound chooses their points.
inline path::StepSettings divided_by(const Settings& settings) {
  return settings.bound.is_asked() ? path::StepSettings{0, 0, 0} : settings.step;
}

}  // namespace plumbline::compensate

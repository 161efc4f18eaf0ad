// The commanded motion of a circular test.
#pragma once

#include <cmath>

#include "machine/orientation.hpp"
#include "measure/dataset.hpp"
#include "physics/motion.hpp"

namespace plumbline::measure {

/// The motion at a sample of a run: one full turn in a horizontal plane at constant feed, without a run-in.
/// x = m + r (cos phi, sin phi, 0),  v = w x r,  a = -w^2 r, |w| = feed / r about +Z (ccw) or -Z (cw); the orientation
/// stands  [docs/physics.md, "The circular test"]. The time is the dataset's. Refers to the signs of the run, if any.
inline physics::Motion<double> circular_motion(const machine::RotationOrder& order, const Run& run,
                                               std::size_t sample) {
  const double phi = run.angle[sample];
  const Vector3<double> outward(std::cos(phi), std::sin(phi), 0);
  const double turning = run.feed / run.radius;  // rad/s
  physics::Motion<double> motion;
  motion.pose = {run.centre_W + run.radius * outward, machine::rotation<double>(order, run.tilt)};
  motion.twist.v_WT = run.turn() * run.feed * Vector3<double>(-outward.y(), outward.x(), 0);
  motion.acceleration.v_WT = -turning * turning * run.radius * outward;
  motion.time = run.start + run.time[sample];
  if (!run.signs.empty()) motion.signs = &run.signs[sample];
  return motion;
}

/// The same in another scalar.
template <class T>
physics::Motion<T> motion_as(const physics::Motion<double>& m) {
  return {{m.pose.p_WT.cast<T>(), m.pose.R_WP.cast<T>()},
          {m.twist.v_WT.cast<T>(), m.twist.w_WP.cast<T>()},
          {m.acceleration.v_WT.cast<T>(), m.acceleration.w_WP.cast<T>()},
          T(m.time),
          m.signs};
}

}  // namespace plumbline::measure

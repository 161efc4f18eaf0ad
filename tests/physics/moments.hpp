// Moments of motion for the tests of the physics, as any scalar.
#pragma once

#include <vector>

#include "machine/machines.hpp"
#include "physics/motion.hpp"

namespace plumbline::testing {

/// A pose within the limits, moving at up to 50 mm/s and 5 deg/s and accelerating, some hours into the measurements.
inline physics::Motion<double> moment_within(const machine::Limits& limits, Random& random) {
  physics::Motion<double> motion;
  do motion.pose = pose_within(limits, random);
  while (motion.pose.p_WT.head<2>().norm() > 0.15);  // away from the singularities at the corners
  motion.twist = {uniform(random, 0.001, 0.05) * direction(random), uniform(random, 0, 0.1) * direction(random)};
  motion.acceleration = {uniform(random, 0, 0.5) * direction(random), uniform(random, 0, 0.5) * direction(random)};
  motion.time = uniform(random, 0, 20000);
  return motion;
}

template <class T>
physics::Motion<T> cast(const physics::Motion<double>& m) {
  return {{m.pose.p_WT.cast<T>(), m.pose.R_WP.cast<T>()},
          {m.twist.v_WT.cast<T>(), m.twist.w_WP.cast<T>()},
          {m.acceleration.v_WT.cast<T>(), m.acceleration.w_WP.cast<T>()},
          T(m.time)};
}

/// One moment in each lane.
inline physics::Motion<Pack> packed_motion(const std::vector<physics::Motion<double>>& lanes) {
  physics::Motion<Pack> packed = cast<Pack>(lanes.front());
  for (int lane = 0; lane < Pack::size(); ++lane) {
    const physics::Motion<double>& m = lanes[static_cast<std::size_t>(lane)];
    for (int a = 0; a < 3; ++a) {
      packed.pose.p_WT[a].set(lane, m.pose.p_WT[a]);
      for (int b = 0; b < 3; ++b) packed.pose.R_WP(a, b).set(lane, m.pose.R_WP(a, b));
      packed.twist.v_WT[a].set(lane, m.twist.v_WT[a]);
      packed.twist.w_WP[a].set(lane, m.twist.w_WP[a]);
      packed.acceleration.v_WT[a].set(lane, m.acceleration.v_WT[a]);
      packed.acceleration.w_WP[a].set(lane, m.acceleration.w_WP[a]);
    }
    packed.time.set(lane, m.time);
  }
  return packed;
}

}  // namespace plumbline::testing

// Dry friction near rest: v / |v| has no derivative there.
#pragma once

#include <cmath>

#include "base/pose.hpp"
#include "base/units.hpp"

namespace plumbline::physics {

inline constexpr double kRestSpeed = 0.01 * kMm;  // m/s, below which v / |v| fades

/// What v (m/s) is divided by to give its direction: |v|, and kRestSpeed where it rests.
template <class T>
T speed_from_rest(const Vector3<T>& v) {
  using std::sqrt;
  return sqrt(v.squaredNorm() + T(kRestSpeed * kRestSpeed));
}

}  // namespace plumbline::physics

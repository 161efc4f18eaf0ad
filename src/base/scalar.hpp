// The scalars that the kinematics and the physics are written for: double for one pose, Pack for several at once, and
// any type with the same operators (ceres::Jet, for derivatives). What differs between them stands here.
#pragma once

#include <type_traits>
#include <utility>

#include "base/elementary.hpp"
#include "base/lanes.hpp"

namespace plumbline {

/// Two poses at once, on any processor.
using Pack = Lanes<AnyProcessor, 2>;

/// What a comparison of two T gives: bool, or one bool per lane of a pack.
template <class T>
using MaskOf = decltype(std::declval<const T&>() < std::declval<const T&>());

/// a where the mask holds, else b. Both are evaluated: neither may trap, but one may hold what is not used.
template <class T>
PLUMBLINE_INLINE T select(const MaskOf<T>& mask, const T& a, const T& b) {
  if constexpr (kIsPack<T>) {
    return T::choose(mask, a, b);
  } else {
    return mask ? a : b;
  }
}

/// True if the mask holds in any lane, in all lanes.
template <class Mask>
PLUMBLINE_INLINE bool any(const Mask& mask) {
  if constexpr (std::is_same_v<Mask, bool>) {
    return mask;
  } else {
    return mask.any();
  }
}
template <class Mask>
PLUMBLINE_INLINE bool all(const Mask& mask) {
  if constexpr (std::is_same_v<Mask, bool>) {
    return mask;
  } else {
    return mask.all();
  }
}

/// Exchanges a and b where the mask holds.
template <class T>
PLUMBLINE_INLINE void swap_where(const MaskOf<T>& mask, T& a, T& b) {
  if constexpr (kIsPack<T>) {
    const T kept = a;
    a = select<T>(mask, b, a);
    b = select<T>(mask, kept, b);
  } else if (mask) {
    std::swap(a, b);
  }
}

template <class T>
PLUMBLINE_INLINE T absolute(const T& a) {
  if constexpr (kIsPack<T>) {
    return abs(a);
  } else {
    return select<T>(a < T(0.0), -a, a);
  }
}
/// NaN if either is: a residual that is no number must not pass for a small one.
template <class T>
PLUMBLINE_INLINE T larger(const T& a, const T& b) {
  return select<T>(b <= a, a, select<T>(b > a, b, a + b));
}

}  // namespace plumbline

// The scalars that the kinematics and the physics are written for: double for one pose, Pack for several at once, and
// any type with the same operators (ceres::Jet, for derivatives). What differs between them stands here.
#pragma once

#include <cstddef>
#include <utility>

#include <Eigen/Core>
#include <experimental/simd>

namespace plumbline {

/// As many doubles as one register of the processor holds; every operation acts on all of them.
using Pack = std::experimental::native_simd<double>;

template <class T>
inline constexpr bool kIsPack = std::experimental::is_simd_v<T>;

/// What a comparison of two T gives: bool, or one bool per lane of a pack.
template <class T>
using MaskOf = decltype(std::declval<const T&>() < std::declval<const T&>());

/// a where the mask holds, else b. Both are evaluated: neither may trap, but one may hold what is not used.
template <class T>
T select(const MaskOf<T>& mask, const T& a, const T& b) {
  if constexpr (kIsPack<T>) {
    T chosen = b;
    std::experimental::where(mask, chosen) = a;
    return chosen;
  } else {
    return mask ? a : b;
  }
}

/// True if the mask holds in any lane, in all lanes.
template <class Mask>
bool any(const Mask& mask) {
  if constexpr (std::is_same_v<Mask, bool>) {
    return mask;
  } else {
    return std::experimental::any_of(mask);
  }
}
template <class Mask>
bool all(const Mask& mask) {
  if constexpr (std::is_same_v<Mask, bool>) {
    return mask;
  } else {
    return std::experimental::all_of(mask);
  }
}

/// Exchanges a and b where the mask holds.
template <class T>
void swap_where(const MaskOf<T>& mask, T& a, T& b) {
  if constexpr (kIsPack<T>) {
    const T kept = a;
    std::experimental::where(mask, a) = b;
    std::experimental::where(mask, b) = kept;
  } else if (mask) {
    std::swap(a, b);
  }
}

template <class T>
T absolute(const T& a) {
  return select<T>(a < T(0.0), -a, a);
}
/// NaN if either is: a residual that is no number must not pass for a small one.
template <class T>
T larger(const T& a, const T& b) {
  return select<T>(b <= a, a, select<T>(b > a, b, a + b));
}

}  // namespace plumbline

/// Lets Eigen hold packs.
template <>
struct Eigen::NumTraits<plumbline::Pack> : Eigen::GenericNumTraits<plumbline::Pack> {
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  static plumbline::Pack epsilon() { return Eigen::NumTraits<double>::epsilon(); }
  static plumbline::Pack dummy_precision() { return Eigen::NumTraits<double>::dummy_precision(); }
};

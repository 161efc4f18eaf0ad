// Several doubles that go through the same operations at once: GCC's vectors as a number type. One lane gives the bits
// that any number of them gives: nothing here adds across lanes, contracts or approximates.
#pragma once

#include <cstdint>
#include <cstring>

#include <Eigen/Core>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace plumbline {

/// What a translation unit may use of a processor is part of the type of its lanes: code made for one processor then
/// never stands in for that of another when a program is linked.
struct AnyProcessor {};

/// The registers that N doubles take, and the masks that comparing them gives: all bits of a lane, or none.
template <int N>
struct LaneRegister {
  using Doubles [[gnu::vector_size(8 * N)]] = double;
  using Bits [[gnu::vector_size(8 * N)]] = std::int64_t;
};
template <>
struct LaneRegister<1> {
  using Doubles = double;
  using Bits = std::int64_t;
};

// What passes registers is always inlined: how they would be passed to a function does not matter.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
#define PLUMBLINE_INLINE [[gnu::always_inline]] inline

template <class Processor, int N>
class LaneMask {
 public:
  using Bits = typename LaneRegister<N>::Bits;
  LaneMask() = default;
  PLUMBLINE_INLINE explicit LaneMask(bool all) : bits_(Bits{} - static_cast<std::int64_t>(all)) {}
  PLUMBLINE_INLINE static LaneMask of(const Bits& bits) {
    LaneMask mask;
    mask.bits_ = bits;
    return mask;
  }
  PLUMBLINE_INLINE const Bits& bits() const { return bits_; }

  PLUMBLINE_INLINE friend LaneMask operator&&(const LaneMask& a, const LaneMask& b) { return of(a.bits_ & b.bits_); }
  PLUMBLINE_INLINE friend LaneMask operator||(const LaneMask& a, const LaneMask& b) { return of(a.bits_ | b.bits_); }
  PLUMBLINE_INLINE friend LaneMask operator!(const LaneMask& a) { return of(~a.bits_); }

  PLUMBLINE_INLINE bool operator[](int lane) const {
    if constexpr (N == 1) {
      return bits_ != 0;
    } else {
      return bits_[lane] != 0;
    }
  }
  PLUMBLINE_INLINE bool any() const {
    if constexpr (N == 1) return bits_ != 0;
#if defined(__SSE2__)
    if constexpr (N == 2) return _mm_movemask_pd(reinterpret_cast<__m128d>(bits_)) != 0;
#endif
#if defined(__AVX__)
    if constexpr (N == 4) return _mm256_movemask_pd(reinterpret_cast<__m256d>(bits_)) != 0;
#endif
#if defined(__AVX512DQ__)
    if constexpr (N == 8) return _mm512_movepi64_mask(reinterpret_cast<__m512i>(bits_)) != 0;
#endif
    if constexpr (N > 1) {
      std::int64_t all = 0;
      for (int lane = 0; lane < N; ++lane) all |= bits_[lane];
      return all != 0;
    }
  }
  PLUMBLINE_INLINE bool all() const { return !(!*this).any(); }

 private:
  Bits bits_;
};

template <class Processor, int N>
class Lanes {
 public:
  using Doubles = typename LaneRegister<N>::Doubles;
  using Bits = typename LaneRegister<N>::Bits;
  using Mask = LaneMask<Processor, N>;

  Lanes() = default;
  PLUMBLINE_INLINE Lanes(double every) : doubles_(every - Doubles{}) {}  // the same in all lanes

  static constexpr int size() { return N; }
  PLUMBLINE_INLINE double operator[](int lane) const {
    if constexpr (N == 1) {
      return doubles_;
    } else {
      return doubles_[lane];
    }
  }
  PLUMBLINE_INLINE void set(int lane, double x) {
    if constexpr (N == 1) {
      doubles_ = x;
    } else {
      doubles_[lane] = x;
    }
  }

  /// N doubles that lie one after the other, wherever.
  PLUMBLINE_INLINE static Lanes load(const double* from) {
    Lanes x;
    std::memcpy(&x.doubles_, from, sizeof x.doubles_);
    return x;
  }
  PLUMBLINE_INLINE void store(double* to) const { std::memcpy(to, &doubles_, sizeof doubles_); }

  PLUMBLINE_INLINE Bits bits() const {
    Bits bits;
    std::memcpy(&bits, &doubles_, sizeof bits);
    return bits;
  }
  PLUMBLINE_INLINE static Lanes from_bits(const Bits& bits) {
    Lanes x;
    std::memcpy(&x.doubles_, &bits, sizeof bits);
    return x;
  }

  PLUMBLINE_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return of(a.doubles_ + b.doubles_); }
  PLUMBLINE_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return of(a.doubles_ - b.doubles_); }
  PLUMBLINE_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return of(a.doubles_ * b.doubles_); }
  PLUMBLINE_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) { return of(a.doubles_ / b.doubles_); }
  PLUMBLINE_INLINE friend Lanes operator-(const Lanes& a) { return of(-a.doubles_); }
  PLUMBLINE_INLINE Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  PLUMBLINE_INLINE Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
  PLUMBLINE_INLINE Lanes& operator*=(const Lanes& b) { return *this = *this * b; }
  PLUMBLINE_INLINE Lanes& operator/=(const Lanes& b) { return *this = *this / b; }

  PLUMBLINE_INLINE friend Mask operator<(const Lanes& a, const Lanes& b) { return mask(a.doubles_ < b.doubles_); }
  PLUMBLINE_INLINE friend Mask operator<=(const Lanes& a, const Lanes& b) { return mask(a.doubles_ <= b.doubles_); }
  PLUMBLINE_INLINE friend Mask operator>(const Lanes& a, const Lanes& b) { return mask(a.doubles_ > b.doubles_); }
  PLUMBLINE_INLINE friend Mask operator>=(const Lanes& a, const Lanes& b) { return mask(a.doubles_ >= b.doubles_); }
  PLUMBLINE_INLINE friend Mask operator==(const Lanes& a, const Lanes& b) { return mask(a.doubles_ == b.doubles_); }
  PLUMBLINE_INLINE friend Mask operator!=(const Lanes& a, const Lanes& b) { return mask(a.doubles_ != b.doubles_); }

  /// a where the mask holds, else b.
  PLUMBLINE_INLINE static Lanes choose(const Mask& mask, const Lanes& a, const Lanes& b) {
    if constexpr (N == 1) {
      return mask.bits() != 0 ? a : b;
    } else {
      return of(mask.bits() ? a.doubles_ : b.doubles_);
    }
  }

  PLUMBLINE_INLINE friend Lanes sqrt(const Lanes& a) {
    if constexpr (N == 1) return of(__builtin_sqrt(a.doubles_));
#if defined(__SSE2__)
    if constexpr (N == 2) return of(reinterpret_cast<Doubles>(_mm_sqrt_pd(reinterpret_cast<__m128d>(a.doubles_))));
#endif
#if defined(__AVX__)
    if constexpr (N == 4) return of(reinterpret_cast<Doubles>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(a.doubles_))));
#endif
#if defined(__AVX512F__)
    if constexpr (N == 8) {  // GCC 12 warns of the form without a mask
      return of(reinterpret_cast<Doubles>(_mm512_maskz_sqrt_pd(0xFF, reinterpret_cast<__m512d>(a.doubles_))));
    }
#endif
    if constexpr (N > 1) {
      Lanes root;
      for (int lane = 0; lane < N; ++lane) root.doubles_[lane] = __builtin_sqrt(a.doubles_[lane]);
      return root;
    }
  }
  PLUMBLINE_INLINE friend Lanes abs(const Lanes& a) { return from_bits(a.bits() & ~kSign); }
  /// The size of a with the sign of b.
  PLUMBLINE_INLINE friend Lanes copysign(const Lanes& a, const Lanes& b) {
    return from_bits((a.bits() & ~kSign) | (b.bits() & kSign));
  }

 private:
  static constexpr std::int64_t kSign = INT64_MIN;

  PLUMBLINE_INLINE static Lanes of(const Doubles& doubles) {
    Lanes x;
    x.doubles_ = doubles;
    return x;
  }
  // what a comparison of two registers gives: of one lane a bool
  template <class Compared>
  PLUMBLINE_INLINE static Mask mask(const Compared& compared) {
    if constexpr (N == 1) {
      return Mask(static_cast<bool>(compared));
    } else {
      return Mask::of(compared);
    }
  }

  Doubles doubles_;
};

#pragma GCC diagnostic pop

template <class T>
inline constexpr bool kIsPack = false;
template <class Processor, int N>
inline constexpr bool kIsPack<Lanes<Processor, N>> = true;

}  // namespace plumbline

/// Lets Eigen hold lanes.
template <class Processor, int N>
struct Eigen::NumTraits<plumbline::Lanes<Processor, N>> : Eigen::GenericNumTraits<plumbline::Lanes<Processor, N>> {
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  static plumbline::Lanes<Processor, N> epsilon() { return Eigen::NumTraits<double>::epsilon(); }
  static plumbline::Lanes<Processor, N> dummy_precision() { return Eigen::NumTraits<double>::dummy_precision(); }
};

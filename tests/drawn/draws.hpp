// Chance from a seed, the same wherever it is compiled: no distribution of the standard library is used.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>

namespace plumbline::drawn {

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : random_(seed * 0x9E3779B97F4A7C15U + 1) {}

  std::uint64_t bits() { return random_(); }
  int whole(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(int percent) { return whole(0, 99) < percent; }
  double between(double low, double high) {
    constexpr double kStep = 1.0 / 9007199254740992.0;  // 2^-53
    return low + (high - low) * static_cast<double>(random_() >> 11U) * kStep;
  }
  template <class T, std::size_t N>
  const T& pick(const std::array<T, N>& from) {
    return from[static_cast<std::size_t>(whole(0, static_cast<int>(N) - 1))];
  }
  template <class Container>
  auto& pick_of(Container& from) {
    return from[static_cast<std::size_t>(whole(0, static_cast<int>(from.size()) - 1))];
  }
  template <class Container>
  void shuffle(Container& items) {
    for (std::size_t i = items.size(); i > 1; --i) {
      std::swap(items[i - 1], items[static_cast<std::size_t>(whole(0, static_cast<int>(i) - 1))]);
    }
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace plumbline::drawn

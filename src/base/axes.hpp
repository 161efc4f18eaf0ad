// The six axes of the control, and positions in its words: X, Y, Z in mm, A, B, C in deg.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>

namespace plumbline {

enum class Axis : std::uint8_t { X, Y, Z, A, B, C };

inline constexpr std::size_t kAxes = 6;
inline constexpr std::array<Axis, kAxes> kAllAxes{Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B, Axis::C};
inline constexpr std::array<char, kAxes> kAxisLetters{'X', 'Y', 'Z', 'A', 'B', 'C'};

constexpr std::size_t index(Axis axis) { return static_cast<std::size_t>(axis); }
constexpr char letter(Axis axis) { return kAxisLetters[index(axis)]; }
/// The index of the axis that a letter names, in upper case; kAxes: none.
inline constexpr std::array<std::uint8_t, 256> kAxisOfLetter = [] {
  std::array<std::uint8_t, 256> axes{};
  axes.fill(kAxes);
  for (std::size_t i = 0; i < kAxes; ++i)
    axes[static_cast<unsigned char>(kAxisLetters[i])] = static_cast<std::uint8_t>(i);
  return axes;
}();
constexpr std::optional<Axis> axis_of(char upper_case_letter) {
  const std::uint8_t i = kAxisOfLetter[static_cast<unsigned char>(upper_case_letter)];
  return i < kAxes ? std::optional(static_cast<Axis>(i)) : std::nullopt;
}
constexpr bool is_rotary(Axis axis) { return axis >= Axis::A; }

/// A set of axes.
class AxisSet {
 public:
  constexpr AxisSet() = default;
  constexpr AxisSet(std::initializer_list<Axis> axes) {
    for (Axis axis : axes) insert(axis);
  }
  static constexpr AxisSet all() { return from_bits(0x3F); }
  static constexpr AxisSet linear() { return from_bits(0x07); }
  static constexpr AxisSet rotary() { return from_bits(0x38); }

  constexpr bool contains(Axis axis) const { return ((bits_ >> index(axis)) & 1U) != 0; }
  constexpr bool contains(AxisSet other) const { return (bits_ & other.bits_) == other.bits_; }
  constexpr void insert(Axis axis) { bits_ = static_cast<std::uint8_t>(bits_ | (1U << index(axis))); }
  constexpr void erase(Axis axis) { bits_ = static_cast<std::uint8_t>(bits_ & ~(1U << index(axis))); }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr int size() const { return std::popcount(bits_); }
  constexpr AxisSet operator|(AxisSet o) const { return from_bits(static_cast<std::uint8_t>(bits_ | o.bits_)); }
  constexpr AxisSet operator&(AxisSet o) const { return from_bits(static_cast<std::uint8_t>(bits_ & o.bits_)); }
  constexpr AxisSet operator-(AxisSet o) const { return from_bits(static_cast<std::uint8_t>(bits_ & ~o.bits_)); }
  constexpr bool operator==(const AxisSet&) const = default;

 private:
  static constexpr AxisSet from_bits(std::uint8_t bits) {
    AxisSet set;
    set.bits_ = bits;
    return set;
  }
  std::uint8_t bits_ = 0;
};

/// A position (or a difference of two) in the control's own words: X, Y, Z in mm, A, B, C in deg.
struct AxisWords {
  std::array<double, kAxes> values{};

  constexpr double& operator[](Axis axis) { return values[index(axis)]; }
  constexpr double operator[](Axis axis) const { return values[index(axis)]; }
  constexpr AxisWords& operator+=(const AxisWords& other) {
    for (std::size_t i = 0; i < kAxes; ++i) values[i] += other.values[i];
    return *this;
  }
  constexpr AxisWords& operator-=(const AxisWords& other) {
    for (std::size_t i = 0; i < kAxes; ++i) values[i] -= other.values[i];
    return *this;
  }
  friend constexpr AxisWords operator+(AxisWords a, const AxisWords& b) { return a += b; }
  friend constexpr AxisWords operator-(AxisWords a, const AxisWords& b) { return a -= b; }
  constexpr bool operator==(const AxisWords&) const = default;
};

/// Length of a way in X, Y, Z, mm.
inline double length_mm(const AxisWords& way) {
  return std::sqrt(way[Axis::X] * way[Axis::X] + way[Axis::Y] * way[Axis::Y] + way[Axis::Z] * way[Axis::Z]);
}

/// "X, Y"
inline std::string axis_list(AxisSet axes) {
  std::string list;
  for (const Axis axis : kAllAxes) {
    if (!axes.contains(axis)) continue;
    if (!list.empty()) list += ", ";
    list += letter(axis);
  }
  return list;
}

}  // namespace plumbline

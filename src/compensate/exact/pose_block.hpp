// Poses that are corrected together, as the kernel reads and writes them: number by number, eight poses side by side.
#pragma once

#include <array>
#include <cstddef>

namespace plumbline::compensate::exact {

inline constexpr std::size_t kBlock = 8;  // poses: what the widest registers hold

using Row = std::array<double, kBlock>;
using Rows6 = std::array<Row, 6>;  // of X, Y, Z (mm), A, B, C (deg), or of six struts

/// Eight targets: see compensate/target.hpp.
struct alignas(64) AskedBlock {
  Rows6 pose;
  Rows6 slope;  // derivative of the pose along the path, in any unit of the path
  Rows6 bend;   // second derivative
  Row seconds;  // that one such unit takes; below zero: only the direction counts
};

/// What is surely so of an answer; where it is not, it may be.
enum State : int {
  kFound = 1,   // the exact correction
  kWithin = 2,  // no limit is broken, neither where the program asks for nor where the control is sent
  kSmall = 4,   // so small a correction that the machine surely holds there
};

struct alignas(64) AnsweredBlock {
  Rows6 pose;  // to be commanded
  Rows6 sign;  // of each strut's speed, smoothed
  Row state;   // sum of State
};

/// Where the deformed machine stands.
struct alignas(64) PlayedBlock {
  std::array<Row, 3> tip;     // m in W
  std::array<Row, 9> turned;  // R_WP, row by row
  Rows6 speed;                // of the struts, as commanded, m/s
  Row state;                  // kFound
};

/// What the struts carry where the machine is sent to, its giving way left out.
struct alignas(64) CarriedBlock {
  Rows6 length;       // m
  Rows6 nut_tension;  // N
  Row state;          // kFound
};

/// How fast friction turns where a strut turns around  [docs/physics.md, Friction].
enum class Friction {
  smoothed,  // v0 grows with the feed, so that a correction turns smoothly
  as_modelled
};

}  // namespace plumbline::compensate::exact

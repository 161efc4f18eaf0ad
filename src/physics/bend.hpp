// Effects whose readings do not move in proportion to their numbers: what is tried of them in a linear problem.
#pragma once

#include <span>
#include <string_view>

namespace plumbline::physics {

/// What one strut does at a moment, SI.
struct StrutMoment {
  double length, speed, acceleration;
  double turn;  // of its screw, 2 pi L / lead, rad
};

/// How an effect bends. About sizes that are nil it adds what another effect adds for each strut, times a factor that
/// depends on its shape: one column for each shape that is tried, or two for a phase. An effect says so by `bend`.
struct Bend {
  enum class By {
    setting,  // a number beside the size: a speed at which friction has faded
    size,     // the size itself: what shows grows with its square
    phase,    // an angle: any phase is a sum of a sine and a cosine
  };
  By by;
  std::string_view size;                                          // key of the number, or of six, that say how much
  std::string_view shape;                                         // key of the number that bends; by size: the same
  std::span<const double> tried = {};                             // shapes, in the file's unit; by phase: none
  std::string_view of, of_key;                                    // effect and key whose six columns are multiplied
  double (*factor)(const StrutMoment& strut, double shape);       // SI
  double (*quarter_turn_on)(const StrutMoment& strut) = nullptr;  // by phase: the factor's cosine
};

}  // namespace plumbline::physics

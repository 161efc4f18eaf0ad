// The parts that a residual model is made of: functions of what is known at a moment, added to one channel.
#pragma once

#include <vector>

#include "diagnose/description/term_columns.hpp"

namespace plumbline::diagnose {

/// The coordinates of physics::Residual, from 1; kCoordinateLength is what those of a strut's length count in.
namespace coordinates {
enum { kX = 1, kY, kZ, kAx, kAy, kTime, kLength, kSpeed, kSign, kTension, kSize, kUx, kUy, kUz };
}
inline constexpr double kCoordinateLength = 0.1;  // m

/// What functions add to, and of what: powers x a smooth function of some coordinates, x a wave in the length, or the
/// powers alone.
struct Shape {
  Term::Channel channel = Term::Channel::length;
  std::array<int, 8> strut_powers{};
  std::array<int, 6> shared_powers{};
  std::vector<int> coordinates;  // of physics::Residual, from 1
  double pitch = 0;              // m; 0: no wave

  bool is_smooth() const { return !coordinates.empty(); }
  bool is_wave() const { return pitch > 0; }
  /// How many numbers a function has.
  int functions() const;
  /// How many struts or axes have one.
  int parts() const { return is_per_strut(channel) ? machine::kStruts : 3; }
};

/// Where the functions of a shape stand, in the units of its coordinates, and what each part was measured on.
struct Region {
  std::vector<double> middle, half_width;
  std::vector<std::vector<double>> lower, upper;  // of each part
};
Region region_of(const Shape& shape, const std::vector<ReadyRun>& runs, const physics::MachineConstants& machine);

/// How wide each number of a shape's functions is beforehand, for functions that vary by one (rms, in the middle) over
/// `length_scale` half widths: the root of the spectral density of a squared exponential kernel  [Solin and Sarkka
/// 2020, Eq. 20].
Eigen::VectorXd prior_widths(const Shape& shape, double length_scale);

/// The functions of a smooth shape where its coordinates are `at`.
Eigen::RowVectorXd functions_at(const Shape& shape, const Region& region, const std::vector<double>& at);

/// The functions of each part at the samples of a run, times the powers.
std::vector<identify::SlopeRows> values_of(const Shape& shape, const Region& region, const ReadyRun& run,
                                           const physics::MachineConstants& machine);

/// How the readings of a run move with all numbers of all parts, function after function, part after part: not
/// whitened.
identify::SlopeRows columns_of(const Shape& shape, const Region& region, const ReadyRun& run,
                               const physics::MachineConstants& machine);

/// The shapes that are tried whatever the readings say.
const std::vector<Shape>& smooth_shapes();

}  // namespace plumbline::diagnose

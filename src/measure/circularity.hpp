// The figures of ISO 230-4 for circular tests, from readings of a ballbar.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "measure/dataset.hpp"

namespace plumbline::measure {

/// Readings around a circle: angle (rad) and deviation from the bar's length (m), in any order.
struct Profile {
  Eigen::VectorXd angle;
  Eigen::VectorXd reading;
};
/// `run` has radial readings.
Profile profile_of(const Run& run);
Profile joined(const Profile& a, const Profile& b);

/// r = mean + x cos phi + y sin phi, the circle that comes nearest in the sense of least squares.
struct CircleFit {
  double mean = 0;
  double x = 0;
  double y = 0;
};
CircleFit least_squares_circle(const Profile& profile);

/// Readings minus mean and first harmonic: what the centring of the balls does not make.
Eigen::VectorXd without_setup(const Profile& profile, const CircleFit& circle);

/// Figures of one direction, m.
struct CircularityFigures {
  double least_squares = 0;  // circularity: max - min about the least-squares circle
  double minimum_zone = 0;   // G, circular deviation: width of the narrowest ring
  double radial_max = 0;     // F max and F min, radial deviation: from the nominal radius, the least-squares centre
  double radial_min = 0;     // removed, the mean kept
  CircleFit circle;
};
CircularityFigures circularity_figures(const Profile& profile);

/// Figures of a pair of runs that differ in direction alone, m.
struct BidirectionalFigures {
  double minimum_zone = 0;   // G(b): width of the narrowest ring that holds both profiles
  double least_squares = 0;  // the same about their common least-squares circle
  double mean_radial = 0;    // D: mean radius of both about their common least-squares centre, minus the nominal one
};
BidirectionalFigures bidirectional_figures(const Profile& ccw, const Profile& cw);

/// One wave of a profile: amplitude cos(order phi - phase).
struct Harmonic {
  int order = 0;
  double amplitude = 0;  // m
  double phase = 0;      // rad
};
/// Waves of order 1 to `highest` in the sense of least squares, fewer where the samples do not tell them apart.
std::vector<Harmonic> harmonics(const Profile& profile, int highest);

/// How far the reading jumps at `angle` (rad): a step between two half windows with a common parabola; m, positive if
/// readings beyond the angle (towards greater angles) are larger. Nothing where too few samples lie in the window.
std::optional<double> reversal_step(const Profile& profile, double angle, double half_window);

}  // namespace plumbline::measure

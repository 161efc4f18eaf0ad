// The set-up of a ballbar: where the ball on the table really stood, and how long the bar really was.
#pragma once

#include "measure/simulation.hpp"

namespace plumbline::measure {

struct SetupOptions {
  int most_iterations = 10;
  double tolerance_m = 1e-12;
  double least_observable = 0.02;  // share of a column that the others must leave for its unknown to be fitted
};

struct Setup {
  Vector3<double> ball_W = Vector3<double>::Zero();  // m
  double bar = 0;                                    // m
  bool fits_height = false;  // false: the ball's height is the ideal one; it and the bar's length change readings alike
  int iterations = 0;
  bool converged = false;
};

/// The ball (x, y, and z where the readings tell it from the bar's length) and the bar's length with which `simulation`
/// comes nearest to the measured readings, in the sense of least squares. `run` has radial readings.
Setup fit_setup(const Run& run, const RunSimulation& simulation, const SetupOptions& options = {});

/// What the model leaves of the measured readings with that set-up: measured minus simulated, m.
Eigen::VectorXd radial_residuals(const Run& run, const RunSimulation& simulation, const Setup& setup);

}  // namespace plumbline::measure

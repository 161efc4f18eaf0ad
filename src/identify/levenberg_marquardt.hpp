// A sum of squares made least within bounds, by its normal equations.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <Eigen/Core>

namespace plumbline::identify {

/// A sum of squares about a point z: S(z + p) ~ misfit + 2 gradient^T p + p^T information p.
struct SumOfSquares {
  double misfit = 0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd information;
};

/// Gradient and information may be left out where no derivatives are asked for. Nothing: there is no sum at z, and a
/// shorter step is to be tried.
using SumAt = std::function<std::optional<SumOfSquares>(const Eigen::VectorXd& z, bool derivatives)>;

/// Infinite where there are none.
struct Bounds {
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
};

struct LeastOptions {
  int most_iterations = 40;
  double misfit_tolerance = 1e-8;     // relative change of the sum, predicted or seen, at which iterations end
  double step_tolerance = 1e-10;      // relative to |z|
  double gradient_tolerance = 1e-10;  // of its greatest component within the bounds
  double first_radius = 1e10;         // of the region in which the equations are trusted: Gauss-Newton's step first
  double greatest_radius = 1e16;
  double least_radius = 1e-32;
  double least_gain = 1e-3;          // of a step that is taken, as a share of what was predicted
  int most_failures = 5;             // steps in a row to where there is no sum
  double least_information = 1e-14;  // eigenvalues below this share of the largest count as that
};

struct Least {
  Eigen::VectorXd z;
  int iterations = 0;  // the start is one
  bool converged = false;
  std::string stopped_because;  // in words
};

/// From `z`, which is moved into the bounds, by Levenberg and Marquardt: each step solves the equations, damped by
/// their own diagonal, within the bounds [Nocedal, Wright, Numerical Optimization, 2nd ed., 4.1 and 10.3; the damping
/// follows Nielsen, Damping parameter in Marquardt's method, IMM-REP-1999-05].
Least least_squares(const SumAt& sum_at, const Eigen::VectorXd& z, const Bounds& bounds,
                    const LeastOptions& options = {});

}  // namespace plumbline::identify

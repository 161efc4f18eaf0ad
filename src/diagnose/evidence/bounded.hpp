// Small least-squares problems with bounds.
#pragma once

#include <Eigen/Core>

namespace plumbline::diagnose {

/// The x within the bounds that makes x.A x / 2 - b.x least; A is symmetric and positive definite, zero lies within the
/// bounds. An active-set method  [Stark and Parker 1995, BVLS].
Eigen::VectorXd solve_bounded(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, const Eigen::VectorXd& lower,
                              const Eigen::VectorXd& upper);

}  // namespace plumbline::diagnose

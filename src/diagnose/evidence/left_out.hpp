// Evidence on what was left out: how much better an effect predicts whole poses, and whole runs, that it was not
// fitted to.
#pragma once

#include <vector>

#include "diagnose/evidence/linear_problem.hpp"

namespace plumbline::diagnose {

/// Nats by which readings that were left out are more likely with an effect than without it; about nil or less: the
/// effect helps only where it was fitted.
struct LeftOut {
  double poses = 0;
  double runs = 0;
};

/// Each group of runs (same number) is predicted from all others, for every group in turn; the sum of the differences
/// in log predictive density, with these columns of the problem and without them  [Geisser and Eddy 1979]. What is
/// `taken` is refitted each time within its priors; so are the effect's sizes, normal beforehand with the spread of
/// `sizes`. All of it exactly, from the Gram matrices of the runs.
double left_out_nats(const LinearProblem& problem, const Marginalised& marginalised, const std::vector<int>& columns,
                     const Eigen::VectorXd& sizes, const std::vector<int>& groups);

}  // namespace plumbline::diagnose

// The nonlinear fit of a model with some effects added: nuisances within their priors, effects within their bounds.
#pragma once

#include "diagnose/candidates/workbench.hpp"
#include "diagnose/evidence/linear_problem.hpp"
#include "diagnose/evidence/score.hpp"

namespace plumbline::diagnose {

/// An effect that was picked, and which of its numbers are fitted.
struct Pick {
  const Candidate* candidate = nullptr;
  int mode = 0;
  std::vector<int> column_groups;
  std::vector<int> unknowns;  // of the candidates
};

struct RefitOptions {
  int most_iterations = 8;
  double tolerance = 0.02;  // of the misfit, at which it ends
};

struct Refit {
  Eigen::VectorXd values;      // of the candidates' unknowns, SI
  double misfit = 0;           // of data and priors, in units of the noise
  Eigen::MatrixXd effects;     // Gram matrix of the picks' numbers, nuisances out, in scales of their unknowns
  Eigen::VectorXd sizes;       // of those numbers in these scales, from where they change nothing
  std::vector<double> errors;  // standard errors of the candidates' unknowns that were fitted, SI; others zero
  std::vector<int> places;     // of the candidates' unknowns that were fitted,
  Eigen::MatrixXd covariance;  // and theirs, SI
  std::vector<identify::RunEquations> left;  // residuals, not whitened; no slopes
  bool converged = false;
};

/// Gauss-Newton with halved steps, the set-up of each run projected out at every step.
Refit refit(const Workbench& bench, const std::vector<Pick>& picks, const Eigen::VectorXd& start,
            const identify::NoiseModel& noise, const RefitOptions& options = {});

/// Standard errors of a force model's parameters that the unknowns of the candidates stand for, SI; others zero.
std::vector<double> parameter_errors(const CandidateSet& candidates, const physics::ForceModel& forces,
                                     const Refit& fit);

/// A pick as its score has it; puts the sizes found into `values`.
Pick pick_of(const CandidateSet& candidates, const Candidate& candidate, const Score& score, Eigen::VectorXd& values);

/// The columns of the linear problem that these picks and the nuisances stand for at `values`.
Marginalised taken_by(const CandidateSet& candidates, const std::vector<Pick>& picks, const Eigen::VectorXd& values);

}  // namespace plumbline::diagnose

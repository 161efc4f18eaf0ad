// The nonlinear fit of a model with some effects added: nuisances within their priors, effects within their bounds.
#pragma once

#include "diagnose/candidates/workbench.hpp"
#include "diagnose/search/picks.hpp"

namespace plumbline::diagnose {

struct RefitOptions {
  int most_iterations = 8;
  double tolerance = 0.02;          // of the misfit, at which it ends
  double negligible = 0.002;        // of the misfit: a step that should take no more of it is not made
  int most_halvings = 5;            // of a step that makes the misfit larger
  double zero_sum_precision = 1e6;  // of the sum of numbers that sum to zero, in scales: firm beside any data
};

struct Refit {
  Eigen::VectorXd values;      // of the candidates' unknowns, SI
  double misfit = 0;           // of data and priors, in units of the noise
  Eigen::MatrixXd effects;     // Gram matrix of the picks' numbers, nuisances out, in scales of their unknowns
  Eigen::VectorXd sizes;       // of those numbers in these scales, from where they change nothing
  std::vector<double> errors;  // standard errors of the candidates' unknowns that were fitted, SI; others zero
  std::vector<int> places;     // of the candidates' unknowns that were fitted,
  Eigen::MatrixXd covariance;  // and theirs, SI
  std::vector<identify::RunEquations> residuals;  // residuals, not whitened; no slopes
  bool converged = false;
};

/// The nuisances of the base model and the numbers of picks, free.
struct FreeUnknowns {
  identify::Unknowns unknowns;
  std::vector<int> places;   // of each among the candidates'
  std::vector<int> effects;  // of each number of the picks, in their order, among `unknowns`
};
FreeUnknowns free_unknowns(const Workbench& bench, const std::vector<Pick>& picks);

/// Gauss-Newton with halved steps, the set-up of each run projected out at every step.
Refit refit(const Workbench& bench, const std::vector<Pick>& picks, const Eigen::VectorXd& start,
            const identify::NoiseModel& noise, const RefitOptions& options = {});

/// Standard errors of a force model's parameters that the unknowns of the candidates stand for, SI; others zero.
std::vector<double> parameter_errors(const CandidateSet& candidates, const physics::ForceModel& forces,
                                     const Refit& fit);

}  // namespace plumbline::diagnose

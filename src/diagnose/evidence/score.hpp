// How well one effect explains what is left of the readings: its evidence.
#pragma once

#include <vector>

#include "diagnose/candidates/candidate_set.hpp"

namespace plumbline::diagnose {

struct ScoreOptions {
  double rare = 1.6;             // nats that a rare effect is less likely beforehand
  std::size_t most_subsets = 6;  // groups of columns of which every subset is tried
  // of the linear problem, relative to the mean of its Gram matrix's diagonal
  double ridge = 1e-9;       // keeps matrices of what the plan cannot tell apart regular
  double zero_sum = 1e3;     // how firmly numbers sum to zero
  double least_seen = 1e-9;  // that mean itself, in units of the noise: below that the plan does not see it
  double one_or_all = 0.9;   // how likely it is that one strut carries an effect, or all of them do
};

/// What an effect makes of what is left. Sizes in units of the linear problem.
struct Score {
  double log_odds = 0;             // that it acts, against nothing: evidence and prior together, nats
  double gain = 0;                 // what the misfit drops by
  int mode = 0;                    // of the candidate
  std::vector<int> column_groups;  // of the way: those that act
  std::vector<int> columns;        // of those carriers
  Eigen::VectorXd sizes;           // of those columns
};

/// What some groups of a mode's columns make of a right side: the residual, or a signature.
struct ModeFit {
  std::vector<int> columns;     // of these groups
  Eigen::MatrixXd information;  // of them, kept regular, and their sum at zero if it has to be
  Eigen::VectorXd sizes;        // within their bounds
  double gain = 0;              // what the square of the right side drops by
  int one_sided = 0;            // how many of them cannot be negative
  bool seen = false;            // else neither sizes nor gain
};

/// `left`: the Gram matrix of all columns with what has been taken out, the residual last; `right`: their products with
/// the right side.
ModeFit fit_mode(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, const ActingMode& mode,
                 const std::vector<int>& column_groups, const Eigen::VectorXd& right, const ScoreOptions& options = {});

/// The evidence of columns that add `gain` to the fit and of which the data tell A (Gram, nuisances out): Bayes factor
/// against nothing. Sizes are independent and normal beforehand, with a spread tau of their own that makes the evidence
/// greatest (local empirical Bayes  [Liang et al. 2008, g-priors]); for a size that cannot be negative half of it:
/// log BF = max over tau of [gain' - log det(1 + tau^2 A) + 2 log 2 (one-sided)] / 2
/// `one_sided`: how many of them cannot be negative.
double log_bayes_factor(const Eigen::MatrixXd& A, double gain, const Eigen::VectorXd& sizes, int one_sided);

/// The best that a candidate makes of what is left (Gram matrix with what has been taken out, residual last): over its
/// ways and over the struts that carry it.
Score best_score(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, const Candidate& candidate,
                 const ScoreOptions& options = {});

/// The same for one way and one set of its carriers.
Score score_of(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, const Candidate& candidate, int mode,
               const std::vector<int>& column_groups, const ScoreOptions& options = {});

/// Scores of all candidates, the best first.
struct Ranked {
  const Candidate* candidate;
  Score score;
};
std::vector<Ranked> ranking(const Eigen::MatrixXd& reduced, const CandidateSet& candidates,
                            const ScoreOptions& options = {});

/// What is less likely beforehand: of a rare effect, of each of its ways, of just those carriers among
/// all. Nats, not positive.
double log_prior(const Candidate& candidate, int mode, std::size_t column_groups, const ScoreOptions& options = {});

}  // namespace plumbline::diagnose

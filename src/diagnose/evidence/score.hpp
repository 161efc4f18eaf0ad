// How well one effect explains what is left of the readings: its evidence.
#pragma once

#include <vector>

#include "diagnose/candidates/candidate_set.hpp"

namespace plumbline::diagnose {

struct ScoreOptions {
  double rare = 1.6;        // nats that a rare effect is less likely beforehand
  double one_or_all = 0.9;  // how likely it is that one strut carries an effect, or all of them do
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

/// The evidence of columns that add `gain` to the fit and of which the data tell A (Gram, nuisances out): Bayes factor
/// against nothing. Sizes are independent and normal beforehand, with a spread tau of their own that makes the evidence
/// greatest (local empirical Bayes  [Liang et al. 2008, g-priors]); for a size that cannot be negative half of it:
/// log BF = max over tau of [gain' - log det(1 + tau^2 A) + 2 log 2 (one-sided)] / 2
/// `one_sided`: how many of them cannot be negative.
double log_bayes_factor(const Eigen::MatrixXd& A, double gain, const Eigen::VectorXd& sizes, int one_sided);

/// The best that a candidate makes of what is left (Gram matrix with what has been taken out, residual last): over its
/// ways and over the struts that carry it.
/// `bounds` are those of the columns at the point, in their order.
Score best_score(const Eigen::MatrixXd& left, const CandidateSet& candidates, const Candidate& candidate,
                 const ScoreOptions& options = {});

/// The same for one way and one set of its carriers.
Score score_of(const Eigen::MatrixXd& left, const CandidateSet& candidates, const Candidate& candidate, int mode,
               const std::vector<int>& column_groups, const ScoreOptions& options = {});

/// Scores of all candidates, the best first.
struct Ranked {
  const Candidate* candidate;
  Score score;
};
std::vector<Ranked> ranking(const Eigen::MatrixXd& left, const CandidateSet& candidates,
                            const ScoreOptions& options = {});

/// What is less likely beforehand: of a rare effect, of each of its ways, of just those carriers among
/// all. Nats, not positive.
double log_prior(const Candidate& candidate, int mode, std::size_t column_groups, const ScoreOptions& options = {});

}  // namespace plumbline::diagnose

// Effects that were picked from the candidates, and what they take of the linear problem.
#pragma once

#include "diagnose/evidence/linear_problem.hpp"
#include "diagnose/evidence/score.hpp"

namespace plumbline::diagnose {

/// An effect that was picked, and which of its numbers are fitted.
struct Pick {
  const Candidate* candidate = nullptr;
  int mode = 0;
  std::vector<int> column_groups;
  std::vector<int> unknowns;  // of the candidates

  const ActingMode& acts() const { return candidate->modes[static_cast<std::size_t>(mode)]; }
};

/// Precision of the numbers of effects, in their scales: keeps what the data cannot tell in place.
inline constexpr double kWeakPrecision = 1e-7;

/// These picks with that one in the place of another, or beside them.
std::vector<Pick> with(std::vector<Pick> picks, const Pick& pick, std::size_t place);
/// These picks without the one at a place, if there is one.
std::vector<Pick> without(std::vector<Pick> picks, std::size_t place);

/// A pick as its score has it; puts the sizes found into `values`.
Pick pick_of(const CandidateSet& candidates, const Candidate& candidate, const Score& score, Eigen::VectorXd& values);

/// The columns of the linear problem that these picks and the nuisances stand for at `values`.
Marginalised marginalised_by(const CandidateSet& candidates, const std::vector<Pick>& picks,
                             const Eigen::VectorXd& values);

/// All columns that marginalised_by may name for these picks, be it with other numbers of the same effects; ascending.
std::vector<int> may_be_marginalised(const CandidateSet& candidates, const std::vector<Pick>& picks);

}  // namespace plumbline::diagnose

// The kinds of candidates: how an effect acts on the linear problem, one file each. What bends, and by what, effects
// say themselves (physics/bend.hpp).
#pragma once

#include <utility>
#include <vector>

#include "diagnose/candidates/candidate_set.hpp"
#include "diagnose/candidates/run_columns.hpp"

namespace plumbline::diagnose {

/// A number of an effect and what it is, SI.
struct UnknownValue {
  int unknown = 0;  // of the candidates
  double value = 0;
};

class CandidateKind {
 public:
  CandidateKind() = default;
  CandidateKind(const CandidateKind&) = delete;
  CandidateKind& operator=(const CandidateKind&) = delete;
  virtual ~CandidateKind() = default;

  /// Adds the modes of an effect to the candidate, and to the set the columns that are made from others.
  virtual void add_modes(const physics::EffectInfo& info, CandidateSet& set, Candidate& candidate) const = 0;

  /// Fills the columns that are made from others, of one run.
  virtual void fill(const RunColumns& run, const Candidate& candidate, identify::SlopeRows& all) const;

  /// The effect's numbers where columns of a mode have these sizes (units of the linear problem).
  virtual std::vector<UnknownValue> numbers(const CandidateSet& set, const Candidate& candidate, const ActingMode& mode,
                                            const std::vector<int>& columns, const Eigen::VectorXd& sizes) const = 0;

  /// Columns and sizes that make up what one of its numbers adds, all unknowns being at `values`.
  virtual std::vector<std::pair<int, double>> parts(const CandidateSet& set, const Candidate& candidate, int unknown,
                                                    const Eigen::VectorXd& values) const;
};

/// Of effects that try shapes: a mode for each, with a column of its own.
class TriedShapes : public CandidateKind {
 public:
  void add_modes(const physics::EffectInfo& info, CandidateSet& set, Candidate& candidate) const override;
  void fill(const RunColumns& run, const Candidate& candidate, identify::SlopeRows& all) const override;
};

/// One for each file of this folder.
const CandidateKind& straight();
const CandidateKind& bent_by_setting();
const CandidateKind& bent_by_size();
const CandidateKind& bent_by_phase();

/// The kind that an effect says it is.
const CandidateKind& kind_of(const physics::EffectInfo& info);

// What kinds have in common.

/// Adds a column that is made from others, about that of an unknown; returns its place.
int add_made_column(CandidateSet& set, int unknown);
const physics::EffectInfo& info_of(const Candidate& candidate);

}  // namespace plumbline::diagnose

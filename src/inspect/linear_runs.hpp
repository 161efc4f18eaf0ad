// Runs as rows of a linear problem: what is left of their readings, and how these move with everything that a machine
// may have, the whole catalogue of effects included.
#pragma once

#include <vector>

#include "diagnose/candidates/candidate_set.hpp"
#include "diagnose/evidence/linear_problem.hpp"

namespace plumbline::inspect {

/// What a machine may be beside its model, and what is known of that beforehand: the keys of [uncertainty] with their
/// sigmas, the numbers of every effect of the catalogue with a spread of a share of their bounds.
struct Prior {
  std::vector<int> columns;     // of the candidates' linear problem
  Eigen::VectorXd precision;    // of each, in its units
  std::vector<int> effect;      // of each: number of the candidate; -1: a nuisance alone
  Eigen::VectorXd least, most;  // spreads that are allowed
  std::size_t size() const { return columns.size(); }
};
Prior prior_of(const diagnose::CandidateSet& candidates, double share_of_bounds);

/// One run: rows whitened, its set-up taken out.
struct RunRows {
  identify::SlopeRows slopes;  // by the columns of the prior
  Eigen::VectorXd left;        // measured less what the model as stated says
  identify::RunEquations raw;  // residuals and set-up, SI
  Eigen::VectorXd measured;    // the readings, channel after channel, SI
  Eigen::MatrixXd gram;        // slopes^T slopes
  Eigen::VectorXd pull;        // slopes^T left

  Eigen::Index rows() const { return left.size(); }
};

/// How runs become rows. Kept by reference.
struct Bench {
  const machine::MachineModel& machine;
  const physics::ForceModel& forces;
  const diagnose::CandidateSet& candidates;
  const Prior& prior;
  identify::NoiseModel noise;

  /// Refuses with simulate-unreachable.
  RunRows rows(const measure::Run& run) const;
  /// Readings in the order of `measured` as rows: whitened, what a set-up could do taken out.
  Eigen::MatrixXd white(const RunRows& of, const Eigen::MatrixXd& readings) const;
  /// What the model as stated leaves of a run, as rows; no slopes.
  Eigen::VectorXd left(const measure::Run& run) const;
};

/// The readings of a run in the order of its equations, SI.
Eigen::VectorXd readings_of(const measure::Run& run);

}  // namespace plumbline::inspect

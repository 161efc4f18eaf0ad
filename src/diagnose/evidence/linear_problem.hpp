// The linear problem about a model: what is left of the readings, and how they move with everything that may be wrong,
// whitened, the set-up of each run taken out.
#pragma once

#include <optional>

#include "diagnose/candidates/candidate_set.hpp"
#include "identify/equations/objective.hpp"

namespace plumbline::diagnose {

/// One run: rows are its readings; a column for each Column of the candidates, in its units, and the residual last.
struct Block {
  identify::SlopeRows rows;  // of the columns that LinearProblem::kept names
  Eigen::MatrixXd gram;      // rows^T rows, of all columns
};

/// All runs about one point.
struct LinearProblem {
  Eigen::VectorXd values;     // of the candidates' unknowns, SI: where the slopes were taken
  std::vector<Block> blocks;  // of the runs
  std::vector<int> kept;      // columns whose rows the blocks have, ascending
  Eigen::MatrixXd gram;       // sum of rows^T rows
  // Not whitened, in SI: residuals, and of the slopes those by the length of each strut alone (six columns).
  std::vector<identify::RunEquations> raw;

  Eigen::Index residual() const { return gram.cols() - 1; }
  /// Some columns of one run, which were kept.
  identify::SlopeRows rows_of(std::size_t run, const std::vector<int>& columns) const;
  /// Leaves the Gram matrices and what is not whitened.
  void forget_rows();
};

/// What is left of the Gram matrix when some columns have taken what they can: G - G_T (G_TT + D)^-1 G_T^T, D the
/// precision of what is known of them beforehand.
struct Marginalised {
  std::vector<int> columns;
  Eigen::VectorXd precision;  // per column, in its units
  Eigen::VectorXd departure;  // of the point from what is known beforehand, in its units
};

/// Schur complement of the columns that are taken; rows and columns of those stay in it, with what their prior leaves.
/// The residual's own element is the misfit that is left, of data and priors together.
Eigen::MatrixXd reduced_gram(const LinearProblem& problem, const Marginalised& marginalised);

/// Takes the slopes of all columns of the candidates at `values`. Of the rows, which are most of the memory, those of
/// the columns `kept` (ascending) and of the residual are kept; without `kept` all. Refuses with simulate-unreachable.
LinearProblem linearise(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                        const CandidateSet& candidates, const Eigen::VectorXd& values,
                        const identify::NoiseModel& noise, std::optional<std::vector<int>> kept = {});

/// The squared lengths of all columns of each run, the residual's last.
std::vector<Eigen::VectorXd> column_squares(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                                            const CandidateSet& candidates, const Eigen::VectorXd& values,
                                            const identify::NoiseModel& noise);

/// Whitens rows of one channel of a run, by its place among those measured, and takes the set-up out of them.
void take_setup_out(const identify::RunEquations& equations, std::size_t channel, const identify::NoiseModel& noise,
                    Eigen::Ref<identify::SlopeRows> rows);

/// Whitens the equations of one run (columns of slopes scaled already, residual last) and takes its set-up out.
identify::SlopeRows without_setup(const identify::RunEquations& equations, identify::SlopeRows columns,
                                  const identify::NoiseModel& noise);

}  // namespace plumbline::diagnose

#include "diagnose/evidence/linear_problem.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "base/check.hpp"
#include "base/parallel.hpp"
#include "diagnose/candidates/run_columns.hpp"
#include "identify/equations/whitening.hpp"

namespace plumbline::diagnose {
namespace {

using identify::SlopeRows;

// The rows of all columns of one run. `raw` takes its equations.
SlopeRows rows_of_run(const machine::RotationOrder& order, const measure::Run& run, const CandidateSet& candidates,
                      const Eigen::VectorXd& values, const identify::NoiseModel& noise, identify::RunEquations& raw) {
  const std::vector<measure::Run> alone{run};
  identify::Objective objective(order, alone, candidates.unknowns, {.huber = 0});
  objective.set_noise(noise);
  objective.each_run(values, [&](std::size_t, identify::RunEquations made) { raw = std::move(made); });
  const physics::ForceModel forces = candidates.unknowns.at(values);
  const std::vector<SampleState> states = sample_states(order, forces, run);
  return without_setup(raw, RunColumns{candidates, forces.machine, states, raw}.all(), noise);
}

}  // namespace

void take_setup_out(const identify::RunEquations& equations, std::size_t channel, const identify::NoiseModel& noise,
                    Eigen::Ref<SlopeRows> rows) {
  const identify::ChannelNoise& own = noise.channels[static_cast<std::size_t>(equations.channels[channel])];
  identify::whiten(own, rows);
  if (equations.channels[channel] != identify::kRadial) return;
  Eigen::MatrixXd setup = equations.setup_slopes;
  identify::whiten(own, setup);
  const Eigen::MatrixXd Q =
      setup.householderQr().householderQ() * Eigen::MatrixXd::Identity(setup.rows(), setup.cols());
  rows -= Q * (Q.transpose() * rows).eval();
}

SlopeRows without_setup(const identify::RunEquations& equations, SlopeRows columns, const identify::NoiseModel& noise) {
  const Eigen::Index n = equations.samples;
  for (std::size_t c = 0; c < equations.channels.size(); ++c)
    take_setup_out(equations, c, noise, columns.middleRows(static_cast<Eigen::Index>(c) * n, n));
  return columns;
}

SlopeRows LinearProblem::rows_of(std::size_t run, const std::vector<int>& columns) const {
  std::vector<Eigen::Index> places;
  for (const int column : columns) {
    const auto place = std::lower_bound(kept.begin(), kept.end(), column);
    PLUMBLINE_CHECK(place != kept.end() && *place == column);
    places.push_back(place - kept.begin());
  }
  return blocks[run].rows(Eigen::all, places);
}

void LinearProblem::forget_rows() {
  for (Block& block : blocks) block.rows.resize(0, 0);
}

LinearProblem linearise(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                        const CandidateSet& candidates, const Eigen::VectorXd& values,
                        const identify::NoiseModel& noise, std::optional<std::vector<int>> kept) {
  LinearProblem problem;
  problem.values = values;
  problem.raw.resize(runs.size());
  problem.blocks.resize(runs.size());
  const auto residual = static_cast<int>(candidates.columns.size());
  if (!kept) {
    kept.emplace(candidates.columns.size());
    std::iota(kept->begin(), kept->end(), 0);
  }
  kept->push_back(residual);
  problem.kept = std::move(*kept);
  // run by run: slopes by all unknowns take most of the memory, and few of them are kept
  for_each_index(runs.size(), [&](std::size_t i) {
    identify::RunEquations& raw = problem.raw[i];
    SlopeRows rows = rows_of_run(order, runs[i], candidates, values, noise, raw);
    raw.slopes = SlopeRows(
        raw.slopes.middleCols(candidates.unknowns.find(physics::StrutOffset::name, "length_um", 0), machine::kStruts));
    Eigen::MatrixXd& gram = problem.blocks[i].gram;
    gram.setZero(rows.cols(), rows.cols());
    gram.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
    gram.triangularView<Eigen::StrictlyUpper>() = gram.transpose();
    problem.blocks[i].rows = static_cast<Eigen::Index>(problem.kept.size()) == rows.cols()
                                 ? std::move(rows)
                                 : SlopeRows(rows(Eigen::all, problem.kept));
  });
  problem.gram = problem.blocks[0].gram;
  for (std::size_t i = 1; i < problem.blocks.size(); ++i) problem.gram += problem.blocks[i].gram;
  return problem;
}

std::vector<Eigen::VectorXd> column_squares(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                                            const CandidateSet& candidates, const Eigen::VectorXd& values,
                                            const identify::NoiseModel& noise) {
  std::vector<Eigen::VectorXd> squares(runs.size());
  for_each_index(runs.size(), [&](std::size_t i) {
    identify::RunEquations raw;
    squares[i] = rows_of_run(order, runs[i], candidates, values, noise, raw).colwise().squaredNorm().transpose();
  });
  return squares;
}

Eigen::MatrixXd reduced_gram(const LinearProblem& problem, const Marginalised& marginalised) {
  const auto count = static_cast<Eigen::Index>(marginalised.columns.size());
  const Eigen::Index r = problem.residual();
  Eigen::MatrixXd G = problem.gram(Eigen::all, marginalised.columns);  // what they have in common with all columns
  Eigen::MatrixXd own = G(marginalised.columns, Eigen::all);
  own.diagonal() += marginalised.precision;
  // rows of the priors: slope one, residual minus the departure
  const Eigen::VectorXd pull = marginalised.precision.cwiseProduct(marginalised.departure);
  G.row(r) -= pull.transpose();
  Eigen::MatrixXd reduced = problem.gram;
  reduced(r, r) += pull.dot(marginalised.departure);
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(own);
  PLUMBLINE_CHECK(ldlt.info() == Eigen::Success && count == own.rows());
  reduced -= G * ldlt.solve(G.transpose());
  return reduced;
}

}  // namespace plumbline::diagnose

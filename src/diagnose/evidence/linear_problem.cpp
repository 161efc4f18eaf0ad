#include "diagnose/evidence/linear_problem.hpp"

#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "base/check.hpp"
#include "base/parallel.hpp"
#include "diagnose/candidates/run_columns.hpp"

namespace plumbline::diagnose {
Eigen::MatrixXd without_setup(const identify::RunEquations& equations, Eigen::MatrixXd columns,
                              const identify::NoiseModel& noise) {
  const Eigen::Index n = equations.samples;
  for (std::size_t c = 0; c < equations.channels.size(); ++c) {
    const identify::ChannelNoise& channel = noise.channels[static_cast<std::size_t>(equations.channels[c])];
    identify::whiten(channel, columns.middleRows(static_cast<Eigen::Index>(c) * n, n));
    if (equations.channels[c] != identify::kRadial) continue;
    Eigen::MatrixXd setup = equations.setup_slopes;
    identify::whiten(channel, setup);
    const Eigen::MatrixXd Q = setup.householderQr().householderQ() * Eigen::MatrixXd::Identity(n, setup.cols());
    auto radial = columns.middleRows(static_cast<Eigen::Index>(c) * n, n);
    radial -= Q * (Q.transpose() * radial).eval();
  }
  return columns;
}

LinearProblem linearise(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                        const CandidateSet& candidates, const Eigen::VectorXd& values,
                        const identify::NoiseModel& noise) {
  LinearProblem problem;
  problem.values = values;
  problem.raw.resize(runs.size());
  problem.blocks.resize(runs.size());
  const physics::ForceModel forces = candidates.unknowns.at(values);
  // run by run: slopes by all unknowns take most of the memory, and few of them are kept
  for_each_index(runs.size(), [&](std::size_t i) {
    const std::vector<measure::Run> run{runs[i]};
    identify::Objective objective(order, run, candidates.unknowns, {.huber = 0});
    objective.set_noise(noise);
    identify::RunEquations& raw = problem.raw[i];
    raw = std::move(objective.equations(values, true).front());
    const std::vector<SampleState> states = sample_states(order, forces, run.front());
    problem.blocks[i].rows = without_setup(raw, RunColumns{candidates, forces.machine, states, raw}.all(), noise);
    raw.slopes = Eigen::MatrixXd(
        raw.slopes.middleCols(candidates.unknowns.find(physics::StrutOffset::name, "length_um", 0), machine::kStruts));
    const Eigen::MatrixXd& rows = problem.blocks[i].rows;
    Eigen::MatrixXd& gram = problem.blocks[i].gram;
    gram.setZero(rows.cols(), rows.cols());
    gram.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
    gram.triangularView<Eigen::StrictlyUpper>() = gram.transpose();
  });
  problem.gram = problem.blocks[0].gram;
  for (std::size_t i = 1; i < problem.blocks.size(); ++i) problem.gram += problem.blocks[i].gram;
  return problem;
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

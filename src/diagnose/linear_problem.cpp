#include "diagnose/linear_problem.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "base/check.hpp"
#include "base/parallel.hpp"
#include "diagnose/states.hpp"

namespace plumbline::diagnose {
namespace {

// Row by row factors of all channels of a run: per sample, the same for each channel.
Eigen::VectorXd repeated(const Eigen::VectorXd& per_sample, std::size_t channels) {
  return per_sample.replicate(static_cast<Eigen::Index>(channels), 1);
}

class ColumnMaker {
 public:
  ColumnMaker(const CandidateSet& candidates, const physics::ForceModel& forces, const std::vector<State>& states,
              const identify::RunEquations& equations)
      : candidates_(candidates), forces_(forces), states_(states), equations_(equations) {}

  Eigen::MatrixXd run() const {
    const auto count = static_cast<Eigen::Index>(candidates_.columns.size());
    Eigen::MatrixXd all(equations_.residual.size(), count + 1);
    const Eigen::Index direct = equations_.slopes.cols();
    for (Eigen::Index c = 0; c < direct; ++c) {
      all.col(c) = candidates_.columns[static_cast<std::size_t>(c)].scale * equations_.slopes.col(c);
    }
    for (const Candidate& candidate : candidates_.all) {
      if (candidate.name == "screw-stribeck") {
        for (const ActingMode& way : candidate.ways) all.col(way.column_groups[0][0]) = stribeck(way);
      } else if (candidate.name == "servo-lag") {
        for (const ActingMode& way : candidate.ways) all.col(way.column_groups[0][0]) = lag(way);
      } else if (candidate.name == "cyclic") {
        for (const ColumnGroup& column_group : candidate.ways[0].column_groups) {
          all.col(column_group[0]) = cyclic(column_group[0], [](double x) { return std::sin(x); });
          all.col(column_group[1]) = cyclic(column_group[1], [](double x) { return std::cos(x); });
        }
      }
    }
    all.col(count) = equations_.residual;
    return all;
  }

 private:
  template <class F>
  Eigen::VectorXd factors(F&& of) const {
    Eigen::VectorXd values(static_cast<Eigen::Index>(states_.size()));
    for (std::size_t i = 0; i < states_.size(); ++i) values[static_cast<Eigen::Index>(i)] = of(states_[i]);
    return repeated(values, equations_.channels.size());
  }

  Eigen::VectorXd slope(std::string_view effect, std::string_view key, int index) const {
    return equations_.slopes.col(candidates_.unknowns.find(effect, key, index));
  }

  // the columns of a key's six numbers, each sample times of(state, strut), summed over the struts
  template <class F>
  Eigen::VectorXd over_struts(const ActingMode& way, std::string_view effect, std::string_view key, F&& of) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(equations_.residual.size());
    for (int j = 0; j < machine::kStruts; ++j) {
      sum += slope(effect, key, j).cwiseProduct(factors([&](const State& s) { return of(s, j); }));
    }
    return candidates_.columns[static_cast<std::size_t>(way.column_groups[0][0])].scale * sum;
  }

  // a Coulomb friction that fades with exp(-(Ldot / v)^2)
  Eigen::VectorXd stribeck(const ActingMode& way) const {
    return over_struts(way, "screw-coulomb", "force_N",
                       [&](const State& s, int j) { return std::exp(-std::pow(s.speed[j] / way.setting, 2)); });
  }

  // an offset of -Ldot + tau Lddot: a lag of tau, per unit. Small lags move the tip along its circle, where the bar
  // does not see them.
  Eigen::VectorXd lag(const ActingMode& way) const {
    return over_struts(way, "strut-offset", "length_um",
                       [&](const State& s, int j) { return way.setting * s.acceleration[j] - s.speed[j]; });
  }

  // an offset's column times sin or cos of 2 pi L / lead
  template <class Wave>
  Eigen::VectorXd cyclic(int column, Wave&& wave) const {
    const Column& about = candidates_.columns[static_cast<std::size_t>(column)];
    const double turns = 2 * std::numbers::pi / forces_.machine.lead[about.strut];
    const auto at = [&](const State& s) { return wave(turns * s.struts.length[about.strut]); };
    return about.scale * slope("strut-offset", "length_um", about.strut).cwiseProduct(factors(at));
  }

  const CandidateSet& candidates_;
  const physics::ForceModel& forces_;
  const std::vector<State>& states_;
  const identify::RunEquations& equations_;
};

}  // namespace

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
  identify::Objective objective(order, runs, candidates.unknowns, {.huber = 0});
  objective.set_noise(noise);
  LinearProblem problem;
  problem.values = values;
  problem.raw = objective.equations(values, true);
  problem.blocks.resize(runs.size());
  const physics::ForceModel forces = candidates.unknowns.at(values);
  for_each_index(runs.size(), [&](std::size_t i) {
    const std::vector<State> states = states_of(order, forces, runs[i]);
    identify::RunEquations& raw = problem.raw[i];
    problem.blocks[i].rows = without_setup(raw, ColumnMaker(candidates, forces, states, raw).run(), noise);
    raw.slopes = Eigen::MatrixXd(
        raw.slopes.middleCols(candidates.unknowns.find("strut-offset", "length_um", 0), machine::kStruts));
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

Eigen::MatrixXd left_of(const LinearProblem& problem, const Marginalised& taken) {
  const auto count = static_cast<Eigen::Index>(taken.columns.size());
  const Eigen::Index r = problem.residual();
  Eigen::MatrixXd G = problem.gram(Eigen::all, taken.columns);  // what they have in common with all columns
  Eigen::MatrixXd own = G(taken.columns, Eigen::all);
  own.diagonal() += taken.precision;
  // rows of the priors: slope one, residual minus the departure
  const Eigen::VectorXd pull = taken.precision.cwiseProduct(taken.departure);
  G.row(r) -= pull.transpose();
  Eigen::MatrixXd left = problem.gram;
  left(r, r) += pull.dot(taken.departure);
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(own);
  PLUMBLINE_CHECK(ldlt.info() == Eigen::Success && count == own.rows());
  left -= G * ldlt.solve(G.transpose());
  return left;
}

}  // namespace plumbline::diagnose

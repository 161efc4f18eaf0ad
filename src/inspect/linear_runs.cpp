#include "inspect/linear_runs.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnose/readings/residuals.hpp"

namespace plumbline::inspect {
namespace {

// A spread of the size of a column: a share of how far its bounds let it go.
double spread_of(const diagnose::Column& column, double share) {
  const double furthest = std::max(std::abs(column.lower), std::abs(column.upper));
  return std::isfinite(furthest) ? share * furthest : 100 * share;
}

}  // namespace

Prior prior_of(const diagnose::CandidateSet& candidates, double share_of_bounds) {
  std::map<int, int> effects;  // column -> candidate
  for (std::size_t e = 0; e < candidates.all.size(); ++e) {
    for (const diagnose::ActingMode& mode : candidates.all[e].modes) {
      for (const diagnose::ColumnGroup& group : mode.column_groups) {
        for (const int column : group) effects.emplace(column, static_cast<int>(e));
      }
    }
  }
  for (std::size_t u = 0; u < candidates.nuisances; ++u) effects.emplace(static_cast<int>(u), -1);
  Prior prior;
  const auto count = static_cast<Eigen::Index>(effects.size());
  prior.precision.resize(count);
  prior.least.resize(count);
  prior.most.resize(count);
  for (const auto& [column, effect] : effects) {
    const auto place = static_cast<Eigen::Index>(prior.columns.size());
    const bool nuisance = static_cast<std::size_t>(column) < candidates.nuisances;
    const double spread =
        effect < 0 ? 1 : spread_of(candidates.columns[static_cast<std::size_t>(column)], share_of_bounds);
    prior.least[place] = nuisance ? 1 : 1e-3 * spread;
    prior.most[place] = std::max(spread, prior.least[place]);
    prior.precision[place] = 1 / (prior.most[place] * prior.most[place]);
    prior.columns.push_back(column);
    prior.effect.push_back(effect);
  }
  return prior;
}

Eigen::VectorXd readings_of(const measure::Run& run) {
  std::vector<double> all = run.radial;
  for (const std::vector<double>& torque : run.torque) all.insert(all.end(), torque.begin(), torque.end());
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

RunRows Bench::rows(const measure::Run& run) const {
  diagnose::LinearProblem problem =
      diagnose::linearise(machine.rotation, {run}, candidates, candidates.unknowns.start(), noise, prior.columns);
  RunRows rows;
  const auto count = static_cast<Eigen::Index>(prior.size());
  const identify::SlopeRows& all = problem.blocks[0].rows;
  rows.slopes = all.leftCols(count);
  rows.left = all.col(count);
  rows.raw = std::move(problem.raw[0]);
  rows.measured = readings_of(run);
  rows.gram = problem.blocks[0].gram(prior.columns, prior.columns);
  rows.pull = rows.slopes.transpose() * rows.left;
  return rows;
}

Eigen::MatrixXd Bench::white(const RunRows& of, const Eigen::MatrixXd& readings) const {
  return diagnose::without_setup(of.raw, identify::SlopeRows(readings), noise);
}

Eigen::VectorXd Bench::left(const measure::Run& run) const {
  const std::vector<measure::Run> alone{run};
  const identify::RunEquations equations = diagnose::residuals(machine, alone, forces, noise).front();
  return diagnose::without_setup(equations, identify::SlopeRows(equations.residual), noise);
}

}  // namespace plumbline::inspect

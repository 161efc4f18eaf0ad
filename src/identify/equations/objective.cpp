#include "identify/equations/objective.hpp"

#include <cmath>

#include <Eigen/QR>

#include "base/parallel.hpp"
#include "identify/equations/whitening.hpp"

namespace plumbline::identify {
namespace {

// rho(e) = e^2 up to k, 2 k |e| - k^2 beyond  [Huber 1964]; k = 0: e^2 throughout.
double misfit_of(double e, double k) {
  const double size = std::abs(e);
  return k <= 0 || size <= k ? e * e : k * (2 * size - k);
}

// The root of the weight min(1, k / |e|) that each whitened row has.
Eigen::VectorXd root_weights(const Eigen::VectorXd& whitened, double k) {
  return whitened.unaryExpr([k](double e) { return k <= 0 || std::abs(e) <= k ? 1.0 : std::sqrt(k / std::abs(e)); });
}

}  // namespace

NormalEquations normal_equations(RunEquations equations, const NoiseModel& noise, const Unknowns& unknowns,
                                 double huber) {
  whiten(noise, equations);
  NormalEquations normal;
  normal.rows = equations.residual.size();
  for (const double e : equations.residual) normal.misfit += misfit_of(e, huber);
  if (equations.slopes.size() == 0) return normal;

  const Eigen::VectorXd weights = root_weights(equations.residual, huber);
  equations.residual.array() *= weights.array();
  Eigen::RowVectorXd scales(equations.slopes.cols());
  for (std::size_t u = 0; u < unknowns.size(); ++u) scales[static_cast<Eigen::Index>(u)] = unknowns[u].scale;
  for (Eigen::Index i = 0; i < equations.slopes.rows(); ++i) {
    equations.slopes.row(i).array() *= weights[i] * scales.array();
  }
  const Eigen::Index n = equations.setup_slopes.rows();
  if (n > 0) {
    // what the set-up can take is taken out of readings and slopes alike  [variable projection: Golub, Pereyra 1973]
    const Eigen::MatrixXd weighted = weights.head(n).asDiagonal() * equations.setup_slopes;
    const Eigen::MatrixXd Q = weighted.householderQr().householderQ() * Eigen::MatrixXd::Identity(n, weighted.cols());
    equations.slopes.topRows(n) -= Q * (Q.transpose() * equations.slopes.topRows(n)).eval();
    equations.residual.head(n) -= Q * (Q.transpose() * equations.residual.head(n)).eval();
  }
  normal.information = Eigen::MatrixXd::Zero(equations.slopes.cols(), equations.slopes.cols());
  normal.information.selfadjointView<Eigen::Lower>().rankUpdate(equations.slopes.transpose());
  normal.information.triangularView<Eigen::StrictlyUpper>() = normal.information.transpose();
  normal.gradient = -equations.slopes.transpose() * equations.residual;
  return normal;
}

Objective::Objective(machine::RotationOrder order, const std::vector<measure::Run>& runs, Unknowns unknowns,
                     const ObjectiveOptions& options, const Tracked* tracked)
    : order_(order), runs_(runs), unknowns_(std::move(unknowns)), options_(options), tracked_(tracked) {
  for (const measure::Run& run : runs_) setups_.push_back(ideal_setup(run));
  if (tracked_ != nullptr) frame_ = first_frame(*tracked_);
}

void Objective::simulate(const Eigen::VectorXd& values, bool derivatives) {
  if (simulated_at_ && *simulated_at_ == values && (simulated_slopes_ || !derivatives)) return;
  simulated_at_.reset();
  simulated_runs_ = std::vector<SimulatedRun>(runs_.size());  // the old ones give their memory back first
  const physics::ForceModel forces = unknowns_.at(values);
  const Sensitivity sensitivity(forces, unknowns_);
  const Sensitivity* const asked = derivatives ? &sensitivity : nullptr;
  for_each_index(blocks(), [&](std::size_t i) {
    if (i < runs_.size()) {
      simulated_runs_[i] = simulate_run(order_, forces, runs_[i], asked);
    } else {
      simulated_poses_ = simulate_poses(order_, forces, *tracked_, asked);
    }
  });
  simulated_at_ = values;
  simulated_slopes_ = derivatives;
}

RunEquations Objective::fitted(std::size_t block, bool derivatives) {
  return block < runs_.size() ? fitted_run(block, simulated_runs_[block], derivatives) : fitted_poses(derivatives);
}

// Moves a set-up until the readings that it moves fit best, outliers counting linearly. `equations_at` makes them for
// the set-up as it is, without the slopes of the unknowns; `move` moves it.
bool Objective::fit_setup(const std::function<RunEquations()>& equations_at,
                          const std::function<void(const Eigen::VectorXd&)>& move, int& steps) const {
  for (steps = 1; steps <= options_.most_setup_steps; ++steps) {
    RunEquations equations = equations_at();
    const Eigen::Index n = equations.setup_slopes.rows();
    if (n == 0) return true;
    whiten(noise_, equations);
    const Eigen::VectorXd residual = equations.residual.head(n);
    const Eigen::VectorXd weights = root_weights(residual, options_.huber);
    const Eigen::VectorXd step = (weights.asDiagonal() * equations.setup_slopes)
                                     .colPivHouseholderQr()
                                     .solve((weights.array() * residual.array()).matrix());
    move(step);
    if (step.cwiseAbs().maxCoeff() <= options_.setup_tolerance_m) return true;
  }
  return false;
}

RunEquations Objective::fitted_poses(bool derivatives) {
  int steps = 0;
  fit_setup([&] { return tracker_equations(order_, *tracked_, simulated_poses_, frame_, false); },
            [&](const Eigen::VectorXd& step) { move_frame(frame_, step); }, steps);
  return tracker_equations(order_, *tracked_, simulated_poses_, frame_, derivatives);
}

RunEquations Objective::fitted_run(std::size_t index, const SimulatedRun& simulated, bool derivatives) {
  const measure::Run& run = runs_[index];
  measure::Setup& setup = setups_[index];
  setup.converged = fit_setup([&] { return run_equations(run, simulated, setup, false); },
                              [&](const Eigen::VectorXd& step) { move_setup(setup, step); }, setup.iterations);
  return run_equations(run, simulated, setup, derivatives);
}

std::vector<RunEquations> Objective::equations(const Eigen::VectorXd& values, bool derivatives) {
  simulate(values, derivatives);
  std::vector<RunEquations> all(blocks());
  for_each_index(blocks(), [&](std::size_t i) { all[i] = fitted(i, derivatives); });
  return all;
}

void Objective::each_run(const Eigen::VectorXd& values, const std::function<void(std::size_t, RunEquations)>& take) {
  const physics::ForceModel forces = unknowns_.at(values);
  const Sensitivity sensitivity(forces, unknowns_);
  for_each_index(runs_.size(), [&](std::size_t i) {
    take(i, fitted_run(i, simulate_run(order_, forces, runs_[i], &sensitivity), true));
  });
}

NormalEquations Objective::evaluate(const Eigen::VectorXd& values, bool derivatives) {
  if (known_at_ && *known_at_ == values) return known_;
  simulate(values, derivatives);
  std::vector<NormalEquations> each(blocks());
  for_each_index(blocks(), [&](std::size_t i) {
    each[i] = normal_equations(fitted(i, derivatives), noise_, unknowns_, options_.huber);
  });
  const auto size = static_cast<Eigen::Index>(unknowns_.size());
  NormalEquations sum{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  for (const NormalEquations& run : each) {
    sum.misfit += run.misfit;
    sum.rows += run.rows;
    if (!derivatives) continue;
    sum.information += run.information;
    sum.gradient += run.gradient;
  }
  if (derivatives) {
    known_at_ = values;
    known_ = sum;
  }
  return sum;
}

}  // namespace plumbline::identify

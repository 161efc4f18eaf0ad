#include "identify/plausible.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

#include "base/mean_square.hpp"
#include "identify/unknowns/geometry.hpp"

namespace plumbline::identify {
namespace {

constexpr double kSamePlace = 1e-6;  // m, rad: files write places to a micrometre

void add_chi2(const Fit& fit, const std::vector<Eigen::Index>& places, const PlausibleOptions& options,
              Plausibility& found) {
  std::vector<const Unknown*> known;
  for (const Eigen::Index i : places) known.push_back(&fit.unknowns[static_cast<std::size_t>(i)]);
  const PriorStrain strain =
      prior_strain(known, fit.values(places), fit.covariance(places, places), options.least_share);
  found.chi2 = strain.chi2;
  found.degrees = strain.degrees;
  found.all_sigmas = strain.deviate();
}

void add_strain(const Fit& fit, const PlausibleOptions& options, Plausibility& found) {
  std::vector<Eigen::Index> places;
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    const Unknown& u = fit.unknowns[i];
    if (u.free() || (options.joints_seen && is_geometry(u))) continue;
    places.push_back(static_cast<Eigen::Index>(i));
    const double sigmas = (fit.values[places.back()] - u.start) / u.sigma;
    if (std::abs(sigmas) > options.most_sigmas) found.strained.push_back({i, sigmas});
  }
  add_chi2(fit, places, options, found);
  found.all_strained = found.all_sigmas > options.most_sigmas_all;
  std::sort(found.strained.begin(), found.strained.end(),
            [](const Strain& a, const Strain& b) { return std::abs(a.sigmas) > std::abs(b.sigmas); });
}

// What the readings of a run leave once its set-up is fitted to them, by kind.
void add_residuals(const RunEquations& equations, const Eigen::MatrixXd& residual, MeanSquare& radial,
                   MeanSquare& torque) {
  const Eigen::Index n = equations.samples;
  for (std::size_t c = 0; c < equations.channels.size(); ++c) {
    Eigen::MatrixXd rows = residual.middleRows(static_cast<Eigen::Index>(c) * n, n);
    if (equations.channels[c] != kRadial) {
      torque.add(rows);
      continue;
    }
    rows -= equations.setup_slopes * equations.setup_slopes.colPivHouseholderQr().solve(rows).eval();
    radial.add(rows);
  }
}

// What a model leaves of all readings.
struct KindSums {
  MeanSquare radial, torque;
};

KindSums sums_at_start(Objective& objective, const Fit& fit) {
  KindSums sums;
  for (const RunEquations& run : objective.equations(fit.unknowns.start())) {
    add_residuals(run, run.residual, sums.radial, sums.torque);
  }
  return sums;
}

// Normal equations of the runs at each pose, and of all with the priors.
struct OfPoses {
  std::vector<Eigen::MatrixXd> information;
  std::vector<Eigen::VectorXd> gradient;
  Eigen::MatrixXd all;

  OfPoses(const std::vector<int>& poses, int count, const std::vector<NormalEquations>& runs, const Unknowns& unknowns)
      : all(prior_weights(unknowns).asDiagonal()) {
    const auto size = static_cast<Eigen::Index>(unknowns.size());
    information.resize(static_cast<std::size_t>(count), Eigen::MatrixXd::Zero(size, size));
    gradient.resize(static_cast<std::size_t>(count), Eigen::VectorXd::Zero(size));
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const auto pose = static_cast<std::size_t>(poses[i]);
      information[pose] += runs[i].information;
      gradient[pose] += runs[i].gradient;
      all += runs[i].information;
    }
  }

  /// To first order the fit without some runs is where the others' misfit and the priors have their least:
  /// (A - A_k) d = -g + g_k, g being nil at the fit. A - A_k, and d in scales of the unknowns.
  using Others = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;
  Others without(int pose) const { return Others(all - information[static_cast<std::size_t>(pose)]); }
  Eigen::VectorXd step(const Others& others, int pose) const {
    return others.solve(gradient[static_cast<std::size_t>(pose)]);
  }
};

int count_of(const std::vector<int>& poses) {
  return poses.empty() ? 0 : *std::max_element(poses.begin(), poses.end()) + 1;
}

void predict_left_out(const machine::RotationOrder& order, const std::vector<measure::Run>& runs, const Fit& fit,
                      const FitOptions& fitted_with, const PlausibleOptions& options, Plausibility& found) {
  const std::vector<int> poses = poses_of(runs);
  const int count = count_of(poses);
  if (count < static_cast<int>(options.least_poses)) return;

  Objective objective(order, runs, fit.unknowns, fitted_with.objective);
  objective.set_noise(fit.noise);
  const KindSums before = sums_at_start(objective, fit);
  const std::vector<RunEquations> equations = objective.equations(fit.values, true);
  std::vector<NormalEquations> normal;
  for (const RunEquations& run : equations)
    normal.push_back(normal_equations(run, fit.noise, fit.unknowns, fitted_with.objective.huber));
  const OfPoses of_poses(poses, count, normal, fit.unknowns);
  const auto size = static_cast<Eigen::Index>(fit.unknowns.size());
  const Eigen::VectorXd scales = fit.unknowns.scales();
  found.left_out.resize(size, count);
  KindSums sums;
  KindSums doubt;  // how far off the fit to the others must expect to be, being unsure of its unknowns
  for (int pose = 0; pose < count; ++pose) {
    const OfPoses::Others others = of_poses.without(pose);
    const Eigen::VectorXd step = scales.cwiseProduct(of_poses.step(others, pose));
    const Eigen::MatrixXd spread = scales.asDiagonal() * root_of(others.pseudoInverse());
    found.left_out.col(pose) = step;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (poses[i] != pose) continue;
      add_residuals(equations[i], equations[i].residual - equations[i].slopes * step, sums.radial, sums.torque);
      add_residuals(equations[i], equations[i].slopes * spread, doubt.radial, doubt.torque);
    }
  }
  const auto columns = std::sqrt(static_cast<double>(size));  // doubt is summed over them, not averaged
  found.radial = {before.radial.root(), sums.radial.root(), columns * doubt.radial.root(), sums.radial.count};
  found.torque = {before.torque.root(), sums.torque.root(), columns * doubt.torque.root(), sums.torque.count};
}

}  // namespace

std::vector<int> poses_of(const std::vector<measure::Run>& runs) {
  std::vector<int> poses;
  int count = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    int pose = -1;
    for (std::size_t k = 0; k < i && pose < 0; ++k) {
      const bool same = (runs[i].centre_W - runs[k].centre_W).norm() < kSamePlace &&
                        (runs[i].tilt - runs[k].tilt).norm() < kSamePlace;
      if (same) pose = poses[k];
    }
    poses.push_back(pose < 0 ? count++ : pose);
  }
  return poses;
}

Eigen::MatrixXd doubt_of(const Fit& fit, const Plausibility& plausible) {
  Eigen::MatrixXd covariance = fit.covariance;
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    if (std::isfinite(covariance(i, i))) continue;
    covariance.row(i).setZero();
    covariance.col(i).setZero();
  }
  covariance *= plausible.widening();
  const Eigen::MatrixXd moved = jackknife(plausible.left_out);
  return covariance + moved * moved.transpose();
}

Eigen::MatrixXd moved_by_poses(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                               const Fit& fit, const ObjectiveOptions& fitted_with, std::size_t least_poses) {
  const auto size = static_cast<Eigen::Index>(fit.unknowns.size());
  const std::vector<int> poses = poses_of(runs);
  const int count = count_of(poses);
  const bool enough = count >= static_cast<int>(least_poses);
  Eigen::MatrixXd moved(size, enough ? count : 0);
  if (!enough) return moved;

  Objective objective(order, runs, fit.unknowns, fitted_with);
  objective.set_noise(fit.noise);
  std::vector<NormalEquations> normal(runs.size());
  objective.each_run(fit.values, [&](std::size_t i, RunEquations equations) {
    normal[i] = normal_equations(std::move(equations), fit.noise, fit.unknowns, fitted_with.huber);
  });
  const OfPoses of_poses(poses, count, normal, fit.unknowns);
  for (int pose = 0; pose < count; ++pose)
    moved.col(pose) = fit.unknowns.scales().cwiseProduct(of_poses.step(of_poses.without(pose), pose));
  return moved;
}

Eigen::MatrixXd jackknife(const Eigen::MatrixXd& moved_by_poses) {
  const auto poses = static_cast<double>(moved_by_poses.cols());
  if (poses < 2) return Eigen::MatrixXd::Zero(moved_by_poses.rows(), moved_by_poses.cols());
  return std::sqrt((poses - 1) / poses) * (moved_by_poses.colwise() - moved_by_poses.rowwise().mean().eval());
}

Plausibility plausibility(const machine::RotationOrder& order, const std::vector<measure::Run>& runs, const Fit& fit,
                          const FitOptions& fitted_with, const PlausibleOptions& options) {
  Plausibility found;
  add_strain(fit, options, found);
  predict_left_out(order, runs, fit, fitted_with, options, found);
  return found;
}

bool borne_out(const Plausibility& plausible, double chance, const PlausibleOptions& options) {
  return plausible.radial.predicted() > options.predicted && chance <= options.may_be_worse;
}

std::optional<Objection> objection(const Plausibility& plausible, bool borne_out, const PlausibleOptions& options) {
  if (!plausible.strained.empty()) return Objection::strained;
  if (plausible.all_strained && !borne_out) return Objection::all_strained;
  if (plausible.radial.worse(options, options.least_radial)) return Objection::radial_worse;
  if (plausible.torque.worse(options, options.least_torque)) return Objection::torque_worse;
  return std::nullopt;
}

}  // namespace plumbline::identify

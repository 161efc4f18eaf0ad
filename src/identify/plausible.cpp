#include "identify/plausible.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "base/mean_square.hpp"
#include "base/units.hpp"
#include "identify/prior_strain.hpp"
#include "identify/unknowns/geometry.hpp"

namespace plumbline::identify {
namespace {

constexpr double kSamePlace = 1e-6;  // m, rad
constexpr std::size_t kMostNamed = 5;

void add_chi2(const Fit& fit, const std::vector<Eigen::Index>& places, Plausibility& found) {
  if (places.empty()) return;
  Eigen::VectorXd sigmas(static_cast<Eigen::Index>(places.size()));
  Eigen::VectorXd off(sigmas.size());
  for (Eigen::Index k = 0; k < sigmas.size(); ++k) {
    const Eigen::Index i = places[static_cast<std::size_t>(k)];
    const Unknown& u = fit.unknowns[static_cast<std::size_t>(i)];
    sigmas[k] = u.sigma;
    off[k] = (fit.values[i] - u.start) / u.sigma;
  }
  const Eigen::MatrixXd left =
      sigmas.cwiseInverse().asDiagonal() * fit.covariance(places, places) * sigmas.cwiseInverse().asDiagonal();
  const PriorStrain strain = prior_strain(off, left);
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
  add_chi2(fit, places, found);
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

// To first order the fit without some runs is where the others' misfit and the priors have their least:
// (A - A_k) d = -g + g_k, g being nil at the fit
void predict_left_out(const machine::RotationOrder& order, const std::vector<measure::Run>& runs, const Fit& fit,
                      const FitOptions& fitted_with, const PlausibleOptions& options, Plausibility& found) {
  const std::vector<int> poses = poses_of(runs);
  const int count = runs.empty() ? 0 : *std::max_element(poses.begin(), poses.end()) + 1;
  if (count < static_cast<int>(options.least_poses)) return;

  Objective objective(order, runs, fit.unknowns, fitted_with.objective);
  objective.set_noise(fit.noise);
  const KindSums before = sums_at_start(objective, fit);
  const std::vector<RunEquations> equations = objective.equations(fit.values, true);
  const auto size = static_cast<Eigen::Index>(fit.unknowns.size());
  std::vector<Eigen::MatrixXd> information(static_cast<std::size_t>(count), Eigen::MatrixXd::Zero(size, size));
  std::vector<Eigen::VectorXd> gradient(static_cast<std::size_t>(count), Eigen::VectorXd::Zero(size));
  Eigen::MatrixXd all = prior_weights(fit.unknowns).asDiagonal();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const NormalEquations normal = normal_equations(equations[i], fit.noise, fit.unknowns, fitted_with.objective.huber);
    const auto pose = static_cast<std::size_t>(poses[i]);
    information[pose] += normal.information;
    gradient[pose] += normal.gradient;
    all += normal.information;
  }
  const Eigen::VectorXd scales = fit.unknowns.scales();
  found.left_out.resize(size, count);
  KindSums sums;
  KindSums doubt;  // how far off the fit to the others must expect to be, being unsure of its unknowns
  for (int pose = 0; pose < count; ++pose) {
    const auto k = static_cast<std::size_t>(pose);
    const auto others = (all - information[k]).completeOrthogonalDecomposition();
    const Eigen::VectorXd step = scales.cwiseProduct(others.solve(gradient[k]));
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

std::string strains_text(const Fit& fit, const std::vector<Strain>& strained) {
  std::vector<std::string> each;
  for (std::size_t i = 0; i < std::min(strained.size(), kMostNamed); ++i) {
    each.push_back(strain_text(fit.unknowns[strained[i].unknown], strained[i].sigmas, 1));
  }
  if (strained.size() > kMostNamed) each.push_back(fmt::format("and {} more", strained.size() - kMostNamed));
  return fmt::format("{}", fmt::join(each, "; "));
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
  if (plausible.degrees > 0) covariance *= std::max(1.0, plausible.chi2 / plausible.degrees);
  const auto poses = static_cast<double>(plausible.left_out.cols());
  if (poses > 1) {
    const Eigen::MatrixXd apart = plausible.left_out.colwise() - plausible.left_out.rowwise().mean().eval();
    covariance += (poses - 1) / poses * apart * apart.transpose();
  }
  return covariance;
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

std::string all_strained(const Plausibility& plausible, const PlausibleOptions& options) {
  if (plausible.all_sigmas <= options.most_sigmas_all) return {};
  return fmt::format(
      "all that [uncertainty] lists would be further off together than it says: chi-square is {:.0f} where {:.0f} is "
      "expected, as in less than one of a thousand machines",
      plausible.chi2, plausible.degrees);
}

std::string objection(const Fit& fit, const Plausibility& plausible, bool borne_out, const PlausibleOptions& options) {
  if (!plausible.strained.empty()) return strains_text(fit, plausible.strained);
  if (std::string all = all_strained(plausible, options); !borne_out && !all.empty()) return all;
  const auto worse = [](const Predicted& of, double unit, std::string_view what, std::string_view unit_name) {
    return fmt::format(
        "a fit to the other circles leaves {:.3g} {} of {} on those that it did not see, and the model as given {:.3g}",
        of.after / unit, unit_name, what, of.before / unit);
  };
  if (plausible.radial.worse(options, options.least_radial))
    return worse(plausible.radial, kUm, "the bar's readings", "um");
  if (plausible.torque.worse(options, options.least_torque)) return worse(plausible.torque, 1, "the torques", "N m");
  return {};
}

}  // namespace plumbline::identify

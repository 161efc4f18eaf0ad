#include "identify/plausible.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "base/mean_square.hpp"
#include "base/units.hpp"
#include "identify/geometry.hpp"

namespace plumbline::identify {
namespace {

constexpr double kSamePlace = 1e-6;  // m, rad
constexpr std::size_t kMostNamed = 5;

void add_strain(const Fit& fit, const PlausibleOptions& options, Plausibility& found) {
  double chi2 = 0;
  double count = 0;
  for (std::size_t i = 0; i < fit.unknowns.size(); ++i) {
    const Unknown& u = fit.unknowns[i];
    if (u.free() || (options.joints_seen && of_geometry(u))) continue;
    const double sigmas = (fit.values[static_cast<Eigen::Index>(i)] - u.start) / u.sigma;
    chi2 += sigmas * sigmas;
    ++count;
    if (std::abs(sigmas) > options.most_sigmas) found.strained.push_back({i, sigmas});
  }
  if (count > 0) found.all_sigmas = (chi2 - count) / std::sqrt(2 * count);
  std::sort(found.strained.begin(), found.strained.end(),
            [](const Strain& a, const Strain& b) { return std::abs(a.sigmas) > std::abs(b.sigmas); });
}

// What the readings of a run leave once its set-up is fitted to them, by kind.
void add_left(const RunEquations& equations, const Eigen::MatrixXd& residual, MeanSquare& radial, MeanSquare& torque) {
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

struct Left {
  MeanSquare radial, torque;
};

Left left_at_start(Objective& objective, const Fit& fit) {
  Left left;
  for (const RunEquations& run : objective.equations(fit.unknowns.start())) {
    add_left(run, run.residual, left.radial, left.torque);
  }
  return left;
}

// A square root of a covariance; what rounding makes negative is nil.
Eigen::MatrixXd root_of(const Eigen::MatrixXd& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(covariance);
  return parts.eigenvectors() * parts.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

// To first order the fit without some runs is where the others' misfit and the priors have their least:
// (A - A_k) d = -g + g_k, g being nil at the fit
void foretell(const machine::RotationOrder& order, const std::vector<measure::Run>& runs, const Fit& fit,
              const FitOptions& fitted_with, const PlausibleOptions& options, Plausibility& found) {
  const std::vector<int> poses = poses_of(runs);
  const int count = runs.empty() ? 0 : *std::max_element(poses.begin(), poses.end()) + 1;
  if (count < static_cast<int>(options.least_poses)) return;

  Objective objective(order, runs, fit.unknowns, fitted_with.objective);
  objective.set_noise(fit.noise);
  const Left before = left_at_start(objective, fit);
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
  Eigen::VectorXd scales(size);
  for (Eigen::Index i = 0; i < size; ++i) scales[i] = fit.unknowns[static_cast<std::size_t>(i)].scale;
  Left left;
  Left doubt;  // how far off the fit to the others must expect to be, being unsure of its unknowns
  for (int pose = 0; pose < count; ++pose) {
    const auto k = static_cast<std::size_t>(pose);
    const auto others = (all - information[k]).completeOrthogonalDecomposition();
    const Eigen::VectorXd step = scales.cwiseProduct(others.solve(gradient[k]));
    const Eigen::MatrixXd spread = scales.asDiagonal() * root_of(others.pseudoInverse());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (poses[i] != pose) continue;
      add_left(equations[i], equations[i].residual - equations[i].slopes * step, left.radial, left.torque);
      add_left(equations[i], equations[i].slopes * spread, doubt.radial, doubt.torque);
    }
  }
  const auto columns = std::sqrt(static_cast<double>(size));  // doubt is summed over them, not averaged
  found.radial = {before.radial.root(), left.radial.root(), columns * doubt.radial.root(), left.radial.count};
  found.torque = {before.torque.root(), left.torque.root(), columns * doubt.torque.root(), left.torque.count};
}

std::string strain_text(const Fit& fit, const std::vector<Strain>& strained) {
  std::vector<std::string> each;
  for (std::size_t i = 0; i < std::min(strained.size(), kMostNamed); ++i) {
    const Unknown& u = fit.unknowns[strained[i].unknown];
    each.push_back(fmt::format("{} is {:.4g} {} off, {:.1f} times what [uncertainty] says of it", u.label,
                               strained[i].sigmas * u.sigma / u.unit.si, u.unit.name, std::abs(strained[i].sigmas)));
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

Plausibility plausibility(const machine::RotationOrder& order, const std::vector<measure::Run>& runs, const Fit& fit,
                          const FitOptions& fitted_with, const PlausibleOptions& options) {
  Plausibility found;
  add_strain(fit, options, found);
  foretell(order, runs, fit, fitted_with, options, found);
  return found;
}

std::string objection(const Fit& fit, const Plausibility& plausible, const PlausibleOptions& options) {
  if (!plausible.strained.empty()) return strain_text(fit, plausible.strained);
  if (plausible.all_sigmas > options.most_sigmas_all) {
    return fmt::format(
        "all that [uncertainty] lists would be further off together than it says: none of it by {:.0f} sigma, but the "
        "sum of squares by {:.0f} of its standard deviations",
        options.most_sigmas, plausible.all_sigmas);
  }
  const auto worse = [](const Foretold& of, double unit, std::string_view what, std::string_view unit_name) {
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

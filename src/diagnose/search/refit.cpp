#include "diagnose/search/refit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "diagnose/evidence/bounded.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double kUnbounded = 1e9;  // scales: a phase may go as far as it will

class Fitter {
 public:
  Fitter(const Workbench& bench, const std::vector<Pick>& picks, const identify::NoiseModel& noise,
         const RefitOptions& options)
      : Fitter(bench, free_unknowns(bench, picks), noise, options) {
    for (const Pick& pick : picks) zero_sums_.insert(zero_sums_.end(), pick.unknowns.size(), pick.acts().sums_to_zero);
  }

  Refit run(const Eigen::VectorXd& start) {
    Eigen::VectorXd values = start(places_);
    Point now = tried(values);
    if (!std::isfinite(now.misfit)) {
      for (const int i : effects_) values[i] = unknowns_[static_cast<std::size_t>(i)].start;
      now = at(values);
    }
    Refit result;
    for (int i = 0; i < options_.most_iterations && !result.converged; ++i) {
      auto [step, expected] = step_from(now, values);
      if (expected < options_.negligible) {
        result.converged = true;
        break;
      }
      Point next = tried(values + step);
      for (int half = 0; half < options_.most_halvings && next.misfit > now.misfit + options_.tolerance; ++half) {
        step *= 0.5;
        next = tried(values + step);
      }
      const double drop = now.misfit - next.misfit;
      result.converged = drop < options_.tolerance;
      if (drop < 0) break;
      values += step;
      now = std::move(next);
    }
    result.misfit = now.misfit;
    result.values = start;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      double value = values[static_cast<Eigen::Index>(i)];
      if (unknowns_[i].periodic) value = std::remainder(value, 2 * std::numbers::pi);
      result.values[places_[i]] = value;
    }
    finish(now, values, result);
    result.residuals = std::move(now.residuals);
    return result;
  }

 private:
  Fitter(const Workbench& bench, FreeUnknowns free, const identify::NoiseModel& noise, const RefitOptions& options)
      : bench_(bench),
        unknowns_(std::move(free.unknowns)),
        noise_(noise),
        options_(options),
        places_(std::move(free.places)),
        effects_(std::move(free.effects)) {
    const auto n = static_cast<Eigen::Index>(unknowns_.size());
    scales_.resize(n);
    precision_.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const identify::Unknown& u = unknowns_[static_cast<std::size_t>(i)];
      scales_[i] = u.scale;
      precision_[i] = u.free() ? kWeakPrecision : 1;
    }
    objective_.emplace(bench.machine.rotation, bench.runs, unknowns_, identify::ObjectiveOptions{.huber = 0});
    objective_->set_noise(noise);
  }

  struct Point {
    Eigen::MatrixXd gram;  // of all unknowns in scales, residual last; of data alone
    double misfit = 0;
    std::vector<identify::RunEquations> residuals;
  };

  Eigen::VectorXd departure(const Eigen::VectorXd& values) const {
    return (values - unknowns_.start()).cwiseQuotient(scales_);
  }

  Point at(const Eigen::VectorXd& values) {
    Point point;
    point.residuals.resize(bench_.runs.size());
    std::vector<Eigen::MatrixXd> grams(bench_.runs.size());
    objective_->each_run(values, [&](std::size_t i, identify::RunEquations equations) {
      identify::SlopeRows rows(equations.residual.size(), scales_.size() + 1);
      rows << equations.slopes * scales_.asDiagonal(), equations.residual;
      equations.slopes.resize(0, 0);
      rows = without_setup(equations, std::move(rows), noise_);
      grams[i].setZero(rows.cols(), rows.cols());
      grams[i].selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
      point.residuals[i] = std::move(equations);
    });
    point.gram.setZero(scales_.size() + 1, scales_.size() + 1);
    for (const Eigen::MatrixXd& gram : grams) point.gram += gram;
    point.gram.triangularView<Eigen::StrictlyUpper>() = point.gram.transpose();
    const Eigen::VectorXd z = departure(values);
    point.misfit = point.gram(scales_.size(), scales_.size()) + z.dot(precision_.cwiseProduct(z));
    return point;
  }

  // Of infinite misfit where the machine falls through a singularity: the linear problem may ask for too much.
  Point tried(const Eigen::VectorXd& values) {
    try {
      return at(values);
    } catch (const Refusal&) {
      Point nowhere;
      nowhere.misfit = std::numeric_limits<double>::infinity();
      return nowhere;
    }
  }

  // Normal equations of data and priors.
  void normal(const Point& point, const Eigen::VectorXd& values, Eigen::MatrixXd& A, Eigen::VectorXd& b) const {
    const Eigen::Index n = scales_.size();
    const Eigen::VectorXd z = departure(values);
    A = point.gram.topLeftCorner(n, n);
    A.diagonal() += precision_;
    b = point.gram.col(n).head(n) - precision_.cwiseProduct(z);
    for (std::size_t i = 0; i < effects_.size(); ++i) {
      if (!zero_sums_[i]) continue;
      for (std::size_t k = 0; k < effects_.size(); ++k) {
        if (!zero_sums_[k]) continue;
        A(effects_[i], effects_[k]) += options_.zero_sum_precision;
        b[effects_[i]] -= options_.zero_sum_precision * z[effects_[k]];
      }
    }
  }

  struct Step {
    Eigen::VectorXd step;  // SI
    double expected = 0;   // what the misfit should drop by
  };

  // Effects within their bounds first, the nuisances then follow exactly.
  Step step_from(const Point& point, const Eigen::VectorXd& values) const {
    Eigen::MatrixXd A;
    Eigen::VectorXd b;
    normal(point, values, A, b);
    const std::vector<int> others = not_effects();
    Eigen::VectorXd step(b.size());
    const auto m = static_cast<Eigen::Index>(effects_.size());
    const Eigen::MatrixXd cross = A(others, effects_);
    const Eigen::LDLT<Eigen::MatrixXd> inner(Eigen::MatrixXd(A(others, others)));
    Eigen::MatrixXd inner_cross(cross.rows(), m);
    if (cross.size() > 0) inner_cross = inner.solve(cross);  // Eigen reads an element of an empty one
    const Eigen::VectorXd b_others = b(others);
    Eigen::VectorXd sizes(m);
    if (m > 0) {
      const Eigen::MatrixXd S = A(effects_, effects_) - cross.transpose() * inner_cross;
      const Eigen::VectorXd s = b(effects_) - inner_cross.transpose() * b_others;
      Eigen::VectorXd lower(m);
      Eigen::VectorXd upper(m);
      for (Eigen::Index i = 0; i < m; ++i) {
        const int place = effects_[static_cast<std::size_t>(i)];
        const identify::Unknown& u = unknowns_[static_cast<std::size_t>(place)];
        const bool open = u.periodic;
        lower[i] = open ? -kUnbounded : std::min(0.0, (u.lower - values[place]) / u.scale);
        upper[i] = open ? kUnbounded : std::max(0.0, (u.upper - values[place]) / u.scale);
      }
      sizes = solve_bounded(S, s, lower, upper);
    }
    step(effects_) = sizes;
    if (!others.empty()) step(others) = inner.solve(b_others) - inner_cross * sizes;
    return {step.cwiseProduct(scales_), 2 * b.dot(step) - step.dot(A * step)};
  }

  std::vector<int> not_effects() const {
    std::vector<int> others;
    for (int i = 0; i < scales_.size(); ++i) {
      if (std::find(effects_.begin(), effects_.end(), i) == effects_.end()) others.push_back(i);
    }
    return others;
  }

  void finish(const Point& point, const Eigen::VectorXd& values, Refit& result) const {
    Eigen::MatrixXd A;
    Eigen::VectorXd b;
    normal(point, values, A, b);
    const Eigen::MatrixXd covariance = A.ldlt().solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()));
    result.places = places_;
    result.covariance = scales_.asDiagonal() * covariance * scales_.asDiagonal();
    result.errors.assign(bench_.candidates.unknowns.size(), 0);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      result.errors[static_cast<std::size_t>(places_[i])] = std::sqrt(std::max(covariance(k, k), 0.0)) * scales_[k];
    }
    const std::vector<int> others = not_effects();
    const Eigen::MatrixXd cross = A(others, effects_);
    result.effects = A(effects_, effects_);
    if (!others.empty() && !effects_.empty()) {
      result.effects -= cross.transpose() * Eigen::MatrixXd(A(others, others)).ldlt().solve(cross);
    }
    result.sizes = departure(values)(effects_);
  }

  const Workbench& bench_;
  identify::Unknowns unknowns_;
  identify::NoiseModel noise_;
  const RefitOptions& options_;
  std::vector<int> places_;   // of unknowns_ among the candidates'
  std::vector<int> effects_;  // in unknowns_
  std::vector<bool> zero_sums_;
  Eigen::VectorXd scales_, precision_;
  std::optional<identify::Objective> objective_;
};

}  // namespace

FreeUnknowns free_unknowns(const Workbench& bench, const std::vector<Pick>& picks) {
  FreeUnknowns free{identify::nuisances(bench.machine, bench.forces), {}, {}};
  for (std::size_t i = 0; i < free.unknowns.size(); ++i) free.places.push_back(static_cast<int>(i));
  for (const Pick& pick : picks) {
    for (const int place : pick.unknowns) {
      if (place < static_cast<int>(bench.candidates.nuisances)) {
        free.unknowns.set_free(static_cast<std::size_t>(place));
        free.effects.push_back(place);
      } else {
        const identify::Unknown& u = bench.candidates.unknowns[static_cast<std::size_t>(place)];
        free.effects.push_back(static_cast<int>(free.unknowns.add(u.effect, u.key, std::max(u.index, 0))));
        free.places.push_back(place);
      }
    }
  }
  return free;
}

Refit refit(const Workbench& bench, const std::vector<Pick>& picks, const Eigen::VectorXd& start,
            const identify::NoiseModel& noise, const RefitOptions& options) {
  return Fitter(bench, picks, noise, options).run(start);
}

std::vector<double> parameter_errors(const CandidateSet& candidates, const physics::ForceModel& forces,
                                     const Refit& fit) {
  std::vector<double> errors(forces.parameters.size(), 0);
  for (std::size_t u = 0; u < candidates.unknowns.size(); ++u) {
    for (const identify::Unknown::Term& term : candidates.unknowns[u].terms) {
      double& error = errors[static_cast<std::size_t>(term.parameter)];
      error = std::hypot(error, term.weight * fit.errors[u]);
    }
  }
  return errors;
}

}  // namespace plumbline::diagnose

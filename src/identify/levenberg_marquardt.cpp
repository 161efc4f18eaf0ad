#include "identify/levenberg_marquardt.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace plumbline::identify {
namespace {

// The damping is at least this share of the largest that a column may have.
constexpr double kLeastDamping = 1e-6;

// The sum about a point as |R p + r|^2 + rest, with R^T R the information, its eigenvalues in units of its diagonal
// kept from vanishing: what the unknowns are measured in does not count.
struct Root {
  Eigen::MatrixXd R;
  Eigen::VectorXd r;

  Root(const SumOfSquares& sum, double least_information) {
    const double most = sum.information.diagonal().maxCoeff();
    const Eigen::VectorXd units = sum.information.diagonal().cwiseMax(least_information * most).cwiseSqrt();
    const Eigen::MatrixXd alike =
        units.cwiseInverse().asDiagonal() * sum.information * units.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(alike);
    const Eigen::VectorXd root =
        parts.eigenvalues().cwiseMax(least_information * parts.eigenvalues().maxCoeff()).cwiseSqrt();
    R = root.asDiagonal() * parts.eigenvectors().transpose() * units.asDiagonal();
    r = (parts.eigenvectors().transpose() * sum.gradient.cwiseQuotient(units)).cwiseQuotient(root);
  }

  /// By how much a step lowers the sum.
  double gain(const Eigen::VectorXd& p) const { return r.squaredNorm() - (R * p + r).squaredNorm(); }
};

Eigen::VectorXd within(const Bounds& bounds, const Eigen::VectorXd& z) {
  return z.cwiseMax(bounds.lower).cwiseMin(bounds.upper);
}

// The step of those unknowns that may move, the others' being given in `step`.
void solve(const Root& root, double radius, const std::vector<Eigen::Index>& moving, Eigen::VectorXd& step) {
  const auto count = static_cast<Eigen::Index>(moving.size());
  Eigen::VectorXd fixed = step;
  for (const Eigen::Index i : moving) fixed[i] = 0;
  const Eigen::VectorXd right = root.r + root.R * fixed;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(right.size() + count, count);
  Eigen::VectorXd scales(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    scales[k] = 1 / (1 + root.R.col(moving[static_cast<std::size_t>(k)]).norm());
    A.col(k).head(right.size()) = scales[k] * root.R.col(moving[static_cast<std::size_t>(k)]);
    A(right.size() + k, k) = std::sqrt(std::max(A.col(k).head(right.size()).squaredNorm(), kLeastDamping) / radius);
  }
  Eigen::VectorXd b = Eigen::VectorXd::Zero(A.rows());
  b.head(right.size()) = -right;
  const Eigen::VectorXd moved = scales.cwiseProduct(A.householderQr().solve(b));
  for (Eigen::Index k = 0; k < count; ++k) step[moving[static_cast<std::size_t>(k)]] = moved[k];
}

// The damped step from z; an unknown that it would carry beyond a bound stops there, and the others make up for it.
Eigen::VectorXd step_within(const Root& root, const Eigen::VectorXd& gradient, double radius, const Eigen::VectorXd& z,
                            const Bounds& bounds) {
  Eigen::VectorXd step = Eigen::VectorXd::Zero(z.size());
  std::vector<Eigen::Index> moving;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const bool held = (z[i] <= bounds.lower[i] && gradient[i] > 0) || (z[i] >= bounds.upper[i] && gradient[i] < 0);
    if (!held) moving.push_back(i);
  }
  while (!moving.empty()) {
    solve(root, radius, moving, step);
    const Eigen::VectorXd inside = within(bounds, z + step) - z;
    const std::size_t before = moving.size();
    std::erase_if(moving,
                  [&](Eigen::Index i) { return z[i] + step[i] < bounds.lower[i] || z[i] + step[i] > bounds.upper[i]; });
    step = inside;
    if (moving.size() == before) break;
  }
  return step;
}

class Descent {
 public:
  Descent(const SumAt& sum_at, const Eigen::VectorXd& z, const Bounds& bounds, const LeastOptions& options)
      : sum_at_(sum_at), bounds_(bounds), options_(options), radius_(options.first_radius) {
    least_.z = within(bounds, z);
  }

  Least run() {
    if (!look_around()) return stopped(false, "there is no misfit at the start");
    for (least_.iterations = 1; least_.iterations <= options_.most_iterations; ++least_.iterations) {
      const Eigen::VectorXd step = step_within(*root_, sum_.gradient, radius_, least_.z, bounds_);
      if (const char* const why = why_enough(step)) return stopped(true, why);
      const std::optional<SumOfSquares> there = sum_at_(within(bounds_, least_.z + step), false);
      if (!there && ++failures_ >= options_.most_failures)
        return stopped(false, "steps lead to where there is no misfit");
      if (there) failures_ = 0;
      const double predicted = root_->gain(step);
      const double gain = there && predicted > 0 ? (sum_.misfit - there->misfit) / predicted : -1;
      if (!(gain > options_.least_gain)) {
        radius_ /= shrinks_by_;
        shrinks_by_ *= 2;
        if (radius_ < options_.least_radius) return stopped(true, "no step lowers the misfit");
        continue;
      }
      const double lowered_by = (sum_.misfit - there->misfit) / sum_.misfit;
      take(step, gain);
      if (lowered_by <= options_.misfit_tolerance) return stopped(true, "the misfit hardly changes");
      if (!look_around()) return stopped(false, "there are no derivatives of the misfit");
    }
    return stopped(false, "there were as many steps as are allowed");
  }

 private:
  bool look_around() {
    std::optional<SumOfSquares> sum = sum_at_(least_.z, true);
    if (!sum) return false;
    sum_ = std::move(*sum);
    root_.emplace(sum_, options_.least_information);
    return true;
  }

  const char* why_enough(const Eigen::VectorXd& step) const {
    const Eigen::VectorXd downhill = within(bounds_, least_.z - sum_.gradient) - least_.z;
    if (downhill.lpNorm<Eigen::Infinity>() <= options_.gradient_tolerance) return "the misfit has no slope";
    // one that bounds have cut short may predict a loss: then a shorter one is tried
    if (std::abs(root_->gain(step)) <= options_.misfit_tolerance * sum_.misfit)
      return "a step would hardly lower the misfit";
    const double reach = least_.z.norm() + options_.step_tolerance;
    return step.norm() <= options_.step_tolerance * reach ? "a step hardly leads anywhere" : nullptr;
  }

  void take(const Eigen::VectorXd& step, double gain) {
    least_.z = within(bounds_, least_.z + step);  // rounding
    radius_ = std::min(radius_ / std::max(1.0 / 3, 1 - std::pow(2 * gain - 1, 3)), options_.greatest_radius);
    shrinks_by_ = 2;
  }

  Least stopped(bool converged, const char* why) {
    least_.converged = converged;
    least_.stopped_because = why;
    return least_;
  }

  const SumAt& sum_at_;
  const Bounds& bounds_;
  const LeastOptions& options_;
  double radius_;
  double shrinks_by_ = 2;
  int failures_ = 0;
  Least least_;
  SumOfSquares sum_;
  std::optional<Root> root_;
};

}  // namespace

Least least_squares(const SumAt& sum_at, const Eigen::VectorXd& z, const Bounds& bounds, const LeastOptions& options) {
  return Descent(sum_at, z, bounds, options).run();
}

}  // namespace plumbline::identify

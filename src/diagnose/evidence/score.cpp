#include "diagnose/evidence/score.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "diagnose/evidence/bounded.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double kWidest = 1e7;  // tau^2 in units of what the data tell: wider ones are never better
constexpr double kNever = -1e9;  // nats: what the runs do not see

double log_choose(std::size_t n, std::size_t k) {
  return std::lgamma(static_cast<double>(n) + 1) - std::lgamma(static_cast<double>(k) + 1) -
         std::lgamma(static_cast<double>(n - k) + 1);
}

std::vector<std::vector<int>> subsets_of(const ActingMode& mode, std::size_t most) {
  const std::size_t n = mode.column_groups.size();
  std::vector<int> all(n);
  for (std::size_t i = 0; i < n; ++i) all[i] = static_cast<int>(i);
  if (mode.all_or_none || n == 1) return {all};
  std::vector<std::vector<int>> subsets;
  if (n > most) {
    for (const int i : all) subsets.push_back({i});
    subsets.push_back(all);
    return subsets;
  }
  for (unsigned mask = 1; mask < 1U << n; ++mask) {
    std::vector<int>& subset = subsets.emplace_back();
    for (const int i : all) {
      if ((mask >> i & 1U) != 0) subset.push_back(i);
    }
  }
  return subsets;
}

}  // namespace

ModeFit fit_mode(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, const ActingMode& mode,
                 const std::vector<int>& column_groups, const Eigen::VectorXd& right, const ScoreOptions& options) {
  ModeFit fit;
  for (const int g : column_groups) {
    const ColumnGroup& group = mode.column_groups[static_cast<std::size_t>(g)];
    fit.columns.insert(fit.columns.end(), group.begin(), group.end());
  }
  fit.information = reduced(fit.columns, fit.columns);
  const Eigen::VectorXd b = right(fit.columns);
  const double mean = fit.information.trace() / static_cast<double>(fit.information.rows());
  if (!(mean > options.least_seen)) return fit;
  fit.seen = true;
  if (mode.sums_to_zero) fit.information.array() += options.zero_sum * mean;
  fit.information.diagonal().array() += options.ridge * mean;
  Eigen::VectorXd lower(b.size());
  Eigen::VectorXd upper(b.size());
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    const Column& column = candidates.columns[static_cast<std::size_t>(fit.columns[static_cast<std::size_t>(i)])];
    lower[i] = column.lower;
    upper[i] = column.upper;
    if (column.lower == 0) ++fit.one_sided;
  }
  fit.sizes = solve_bounded(fit.information, b, lower, upper);
  fit.gain = 2 * b.dot(fit.sizes) - fit.sizes.dot(fit.information * fit.sizes);
  return fit;
}

double log_bayes_factor(const Eigen::MatrixXd& A, double gain, const Eigen::VectorXd& sizes, int one_sided) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(A, Eigen::EigenvaluesOnly);
  const double mean = A.trace() / static_cast<double>(A.rows());
  const double squares = sizes.squaredNorm();
  double best = kNever;
  for (double wide = 1; wide < kWidest; wide *= 2) {  // tau^2 of the mean column
    const double tau2 = wide / mean;
    const double determinant = (1 + tau2 * eigen.eigenvalues().array().max(0)).log().sum();
    best = std::max(best, 0.5 * (gain - squares / tau2 - determinant));
  }
  return best + one_sided * std::log(2.0);
}

double log_prior(const Candidate& candidate, int mode, std::size_t column_groups, const ScoreOptions& options) {
  const ActingMode& of = candidate.modes[static_cast<std::size_t>(mode)];
  double prior = candidate.rare ? -options.rare : 0;
  prior -= std::log(static_cast<double>(candidate.modes.size()));
  const std::size_t n = of.column_groups.size();
  if (of.all_or_none || n == 1) return prior;
  // one strut or all of them, mostly; else each number of them alike, and each set of so many alike
  const bool usual = column_groups == 1 || column_groups == n;
  const double share =
      usual ? options.one_or_all / 2 : (1 - options.one_or_all) / std::max(static_cast<double>(n) - 2, 1.0);
  prior += std::log(share) - log_choose(n, column_groups);
  return prior;
}

Score score_of(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, const Candidate& candidate, int mode,
               const std::vector<int>& column_groups, const ScoreOptions& options) {
  const ModeFit fit = fit_mode(reduced, candidates, candidate.modes[static_cast<std::size_t>(mode)], column_groups,
                               reduced.rightCols<1>(), options);
  Score score;
  score.mode = mode;
  score.column_groups = column_groups;
  score.columns = fit.columns;
  score.sizes = fit.sizes;
  score.gain = fit.gain;
  score.log_odds = fit.seen ? log_bayes_factor(fit.information, fit.gain, fit.sizes, fit.one_sided) : kNever;
  score.log_odds += log_prior(candidate, mode, column_groups.size(), options);
  return score;
}

Score best_score(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, const Candidate& candidate,
                 const ScoreOptions& options) {
  Score best{kNever};
  for (std::size_t w = 0; w < candidate.modes.size(); ++w) {
    for (const std::vector<int>& subset : subsets_of(candidate.modes[w], options.most_subsets)) {
      Score score = score_of(reduced, candidates, candidate, static_cast<int>(w), subset, options);
      if (score.log_odds > best.log_odds) best = std::move(score);
    }
  }
  return best;
}

std::vector<Ranked> ranking(const Eigen::MatrixXd& reduced, const CandidateSet& candidates,
                            const ScoreOptions& options) {
  std::vector<Ranked> all;
  for (const Candidate& candidate : candidates.all) {
    all.push_back({&candidate, best_score(reduced, candidates, candidate, options)});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Ranked& a, const Ranked& b) { return a.score.log_odds > b.score.log_odds; });
  return all;
}

}  // namespace plumbline::diagnose

#include "diagnose/evidence/threshold.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <Eigen/Eigenvalues>

#include "base/parallel.hpp"

namespace plumbline::diagnose {
namespace {

// A set of columns that acts together, made ready for many draws: the Gram matrix's own axes.
struct Group {
  std::vector<int> columns;
  Eigen::MatrixXd axes;       // columns: eigenvectors
  Eigen::VectorXd strengths;  // eigenvalues
  double extra = 0;           // prior and what signs add, nats
  std::vector<double> wide;   // tau^2 that are tried
  std::vector<double> price;  // log det(1 + tau^2 A) of each
};

void add_group(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, const Candidate& candidate, int mode,
               const std::vector<int>& column_groups, const ScoreOptions& scoring, const ThresholdOptions& options,
               std::vector<Group>& groups) {
  Group group;
  const ActingMode& of = candidate.modes[static_cast<std::size_t>(mode)];
  for (const int c : column_groups) {
    const ColumnGroup& column_group = of.column_groups[static_cast<std::size_t>(c)];
    group.columns.insert(group.columns.end(), column_group.begin(), column_group.end());
  }
  const Eigen::MatrixXd A = reduced(group.columns, group.columns);
  const double mean = A.trace() / static_cast<double>(A.rows());
  if (!(mean > scoring.least_seen)) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(A);
  group.axes = eigen.eigenvectors();
  group.strengths = eigen.eigenvalues().cwiseMax(0);
  group.extra = log_prior(candidate, mode, column_groups.size(), scoring);
  for (const int c : group.columns) {
    if (candidates.columns[static_cast<std::size_t>(c)].lower == 0) group.extra += std::log(2.0);
  }
  for (double wide = 1; wide < options.widest; wide *= options.wider_times) {
    group.wide.push_back(wide / mean);
    group.price.push_back((1 + group.strengths.array() * wide / mean).log().sum());
  }
  groups.push_back(std::move(group));
}

std::vector<Group> groups_of(const Eigen::MatrixXd& reduced, const CandidateSet& candidates,
                             const ScoreOptions& scoring, const ThresholdOptions& options) {
  std::vector<Group> groups;
  for (const Candidate& candidate : candidates.all) {
    for (std::size_t w = 0; w < candidate.modes.size(); ++w) {
      const ActingMode& mode = candidate.modes[w];
      std::vector<int> all;
      for (std::size_t c = 0; c < mode.column_groups.size(); ++c) all.push_back(static_cast<int>(c));
      add_group(reduced, candidates, candidate, static_cast<int>(w), all, scoring, options, groups);
      if (mode.all_or_none || all.size() == 1) continue;
      for (const int c : all)
        add_group(reduced, candidates, candidate, static_cast<int>(w), {c}, scoring, options, groups);
    }
  }
  return groups;
}

// Each group with all draws of a batch, a column each: raises `most` to
// max over tau of sum [tau^2 b^2 / (1 + tau^2 a) - log(1 + tau^2 a)] / 2
void raise_to_odds(const Group& group, const Eigen::MatrixXd& scores, Eigen::RowVectorXd& most) {
  const Eigen::MatrixXd squares = (group.axes.transpose() * scores(group.columns, Eigen::all)).cwiseAbs2();
  Eigen::RowVectorXd odds(squares.cols());
  for (std::size_t t = 0; t < group.wide.size(); ++t) {
    odds.noalias() = (1 / group.wide[t] + group.strengths.array()).inverse().matrix().transpose() * squares;
    most = most.cwiseMax(((odds.array() - group.price[t]) * 0.5 + group.extra).matrix());
  }
}

// The maxima over all groups of the draws of one batch, which begins with a seed of its own: batches are independent
// of each other, and of who draws them.
Eigen::RowVectorXd maxima_of(const std::vector<Group>& groups, const Eigen::MatrixXd& root, std::size_t batch,
                             Eigen::Index draws, const ThresholdOptions& options) {
  std::seed_seq seeds{static_cast<std::uint32_t>(options.seed), static_cast<std::uint32_t>(options.seed >> 32U),
                      static_cast<std::uint32_t>(batch)};
  std::mt19937_64 random(seeds);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd z(root.cols(), draws);
  for (Eigen::Index k = 0; k < draws; ++k) {
    const double size = std::exp(options.noise_uncertainty * normal(random));
    for (double& element : z.col(k)) element = size * normal(random);
  }
  const Eigen::MatrixXd scores = root * z;
  Eigen::RowVectorXd most = Eigen::RowVectorXd::Constant(draws, -1e9);
  for (const Group& group : groups) raise_to_odds(group, scores, most);
  return most;
}

}  // namespace

Threshold threshold(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, const ScoreOptions& scoring,
                    const ThresholdOptions& options) {
  const std::vector<Group> groups = groups_of(reduced, candidates, scoring, options);
  const Eigen::Index n = reduced.cols() - 1;
  // columns differ in size by orders of magnitude: drawn in units of their own length
  const Eigen::VectorXd lengths = reduced.diagonal().head(n).cwiseMax(1e-300).cwiseSqrt();
  const Eigen::VectorXd inverse = lengths.cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(inverse.asDiagonal() * reduced.topLeftCorner(n, n) *
                                                             inverse.asDiagonal());
  const Eigen::MatrixXd root =
      lengths.asDiagonal() * eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
  constexpr int kBatch = 500;
  const auto batches = static_cast<std::size_t>((options.draws + kBatch - 1) / kBatch);
  std::vector<Eigen::RowVectorXd> each(batches);
  for_each_index(batches, [&](std::size_t i) { each[i] = maxima_of(groups, root, i, kBatch, options); });
  std::vector<double> maxima;
  for (const Eigen::RowVectorXd& batch : each) maxima.insert(maxima.end(), batch.begin(), batch.end());
  const auto place =
      maxima.begin() + static_cast<std::ptrdiff_t>((1 - options.false_alarms) * static_cast<double>(maxima.size()));
  std::nth_element(maxima.begin(), place, maxima.end());
  return {*place, static_cast<int>(maxima.size())};
}

}  // namespace plumbline::diagnose

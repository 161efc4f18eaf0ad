#include "diagnose/evidence/visible.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/effect_info.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double kSurely = 1.6448536;  // a normal deviate lies above minus that with 95 %

// A column, and its size that would pass, in units of its bound.
struct Least {
  int column = -1;
  double size = std::numeric_limits<double>::infinity();  // units of the linear problem
  double share = std::numeric_limits<double>::infinity();

  bool operator<(const Least& other) const { return share < other.share; }
};

bool is_shape(const CandidateSet& candidates, const Column& column) {
  return column.unknown >= 0 && candidates.unknowns[static_cast<std::size_t>(column.unknown)].shape;
}

// What the best fit of `numbers` that share one spread must take of chi-square for a Bayes factor of so many nats: log
// B is [gain - n log(gain / n) - n] / 2 at the best spread. Noise of the numbers that are nil takes one each.
double gain_for(double nats, std::ptrdiff_t numbers) {
  const auto n = static_cast<double>(numbers);
  double gain = 2 * nats;
  for (int round = 0; round < 6; ++round) gain = 2 * nats + n * (std::log(std::max(gain / n, 1.0)) + 1);
  return std::max(gain - (n - 1), 0.0);
}

Least least_of(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, const ColumnGroup& column_group,
               double nats) {
  const auto sizes = std::count_if(column_group.begin(), column_group.end(), [&](int c) {
    return reduced(c, c) > 0 && !is_shape(candidates, candidates.columns[static_cast<std::size_t>(c)]);
  });
  const double gain = gain_for(nats, std::max<std::ptrdiff_t>(sizes, 1));
  Least least;
  for (const int c : column_group) {
    const Column& column = candidates.columns[static_cast<std::size_t>(c)];
    const double bound = std::max(std::abs(column.lower), std::abs(column.upper));
    if (!(reduced(c, c) > 0) || is_shape(candidates, column)) continue;
    const double size = (std::sqrt(gain) + kSurely) / std::sqrt(reduced(c, c));
    least = std::min(least, Least{c, size, size / bound});
  }
  return least;
}

// The way in which it shows best, on the carrier that shows least.
Least least_of(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, const Candidate& candidate,
               double threshold, const ScoreOptions& options) {
  Least best;
  for (std::size_t w = 0; w < candidate.modes.size(); ++w) {
    const ActingMode& mode = candidate.modes[w];
    const double nats = threshold - log_prior(candidate, static_cast<int>(w), 1, options);
    Least worst;
    worst.share = 0;
    for (const ColumnGroup& column_group : mode.column_groups)
      worst = std::max(worst, least_of(reduced, candidates, column_group, nats));
    best = std::min(best, worst);
  }
  return best;
}

}  // namespace

std::vector<Visible> visible_effects(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, double threshold,
                                     const ScoreOptions& options) {
  std::vector<Visible> all;
  for (const Candidate& candidate : candidates.all) {
    Visible visible{candidate.name};
    const Least least = least_of(reduced, candidates, candidate, threshold, options);
    if (least.column >= 0) {
      const Column& column = candidates.columns[static_cast<std::size_t>(least.column)];
      visible.key = column.key;
      for (const physics::ParameterSpec& spec :
           physics::effect_infos()[physics::effect_index(candidate.name)].parameters) {
        if (spec.key != visible.key) continue;
        visible.unit = spec.unit.name;
        visible.smallest = least.size * column.scale / spec.unit.si;
      }
      visible.shows = least.share <= 1;
    }
    all.push_back(std::move(visible));
  }
  return all;
}

}  // namespace plumbline::diagnose

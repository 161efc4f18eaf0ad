#include "measure/even_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumbline::measure {
namespace {

using std::numbers::pi;

constexpr double kAround = 2 * pi;
constexpr double kFlat = 1.0 / 3;     // cycles per step: below, the spectrum is 1
constexpr double kNothing = 2.0 / 3;  // above, it is 0
constexpr int kTableSteps = 512;      // of the table of phi, for each step of the grid
constexpr double kWidest = 0.75;      // steps between samples: with more, their images reach into the band
constexpr double kOpen = 1;           // steps between the last sample and the first of a whole turn

// nu goes from 0 to 1 with three derivatives that vanish at both ends, nu(x) + nu(1 - x) = 1  [Daubechies 1992, 4.3]
double nu(double x) { return x * x * x * x * (35 + x * (-84 + x * (70 - 20 * x))); }

// phi(x) = 2 int cos(2 pi f x) phi^(f) df: 1 up to a third by its integral, cos(pi nu / 2) from there on by Simpson's
// rule
double meyer_integral(double x) {
  constexpr int kParts = 96;
  constexpr double kPart = (kNothing - kFlat) / kParts;
  double sum = x == 0 ? 2 * kFlat : std::sin(2 * pi * kFlat * x) / (pi * x);
  for (int i = 0; i <= kParts; ++i) {
    const double share = static_cast<double>(i) / kParts;
    const double f = kFlat + (kNothing - kFlat) * share;
    const double simpson = (i == 0 || i == kParts) ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += 2 * simpson * kPart / 3 * std::cos(pi / 2 * nu(share)) * std::cos(2 * pi * f * x);
  }
  return sum;
}

std::vector<double> meyer_table() {
  std::vector<double> table;
  for (int i = 0; i <= kMeyerReach * kTableSteps + 1; ++i) {
    table.push_back(meyer_integral(static_cast<double>(i) / kTableSteps));
  }
  return table;
}

}  // namespace

double meyer(double x) {
  static const std::vector<double> table = meyer_table();
  const double place = std::abs(x) * kTableSteps;
  if (place > kMeyerReach * kTableSteps) return 0;
  const auto below = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(below);
  return table[below] + share * (table[below + 1] - table[below]);
}

EvenGrid::EvenGrid(const Run& run, std::size_t points) : turn_(run.turn()), points_(points) {
  const double step = kAround / static_cast<double>(points);
  const std::size_t n = run.samples();
  if (n < kFewest) return;
  at_.reserve(n);
  at_.push_back(std::remainder(turn_ * run.angle[0], kAround) / step);
  for (std::size_t i = 1; i < n; ++i) {
    at_.push_back(at_[i - 1] + std::remainder(turn_ * (run.angle[i] - run.angle[i - 1]), kAround) / step);
  }
  const auto around = static_cast<double>(points);
  while (at_.back() >= at_[0] + around) at_.pop_back();  // a turn and a little
  const double open = at_[0] + around - at_.back();
  whole_turn_ = open <= kOpen;
  stands_.resize(at_.size());
  for (std::size_t i = 0; i < at_.size(); ++i) {
    const bool last = i + 1 == at_.size();
    const double before = i > 0 ? at_[i] - at_[i - 1] : (whole_turn_ ? open : 0);
    const double after = !last ? at_[i + 1] - at_[i] : (whole_turn_ ? open : 0);
    stands_[i] = (before + after) / 2;
    if (before > kWidest && i > 0) return;
  }
  first_ = static_cast<long>(std::ceil(at_.front() + (whole_turn_ ? 0 : kMeyerReach)));
  const long last = static_cast<long>(std::floor(at_.back() - kMeyerReach));
  count_ = whole_turn_ ? points : static_cast<std::size_t>(std::max(last - first_ + 1, 0L));
  possible_ = count_ >= kFewest;
}

std::vector<double> EvenGrid::angles() const {
  std::vector<double> angles;
  const auto around = static_cast<long>(points_);
  for (std::size_t k = 0; k < count_; ++k) {
    const long point = (turn_ > 0 ? 1 : -1) * (first_ + static_cast<long>(k));
    angles.push_back(kAround * static_cast<double>((point % around + around) % around) / static_cast<double>(points_));
  }
  return angles;
}

Eigen::MatrixXd EvenGrid::project(const SampleColumns& samples) const {
  const Eigen::Index rows = samples.rows();
  const auto around = static_cast<long>(points_);
  const auto count = static_cast<long>(count_);
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(rows, count);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
  for (std::size_t i = 0; i < at_.size(); ++i) {
    const long last = static_cast<long>(std::floor(at_[i] + kMeyerReach));
    for (long point = static_cast<long>(std::ceil(at_[i] - kMeyerReach)); point <= last; ++point) {
      long place = point - first_;
      if (whole_turn_) place = (place % around + around) % around;
      if (place < 0 || place >= count) continue;
      const double weight = stands_[i] * meyer(at_[i] - static_cast<double>(point));
      points.col(place) += weight * samples.col(static_cast<Eigen::Index>(i));
      weights[place] += weight;
    }
  }
  return points * weights.cwiseInverse().asDiagonal();
}

}  // namespace plumbline::measure

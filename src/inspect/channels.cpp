// What a channel may hold instead of what it says: another sign, another unit, another motor, another clock, a drift.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>

#include "base/angle.hpp"
#include "base/parallel.hpp"
#include "inspect/channel_rows.hpp"
#include "inspect/hypothesis.hpp"
#include "inspect/records/records.hpp"
#include "inspect/statistics.hpp"

namespace plumbline::inspect {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using identify::kChannels;
using identify::kRadial;
using measure::Run;

constexpr double kUnitLeast = 0.65, kUnitMost = 1.5;  // factors between these may be the machine's own

constexpr double kSmoothed = 1.5;  // times chi-square that readings between samples may hide

constexpr double kUnitLeaves = 0.5;  // of the misfit in the unit that was said, that another unit may leave

Tried made(const Channels& channels, FaultKind kind, std::vector<int> about, double chi2, double penalty,
           std::vector<double> values = {}) {
  Tried one{{kind, channels.suspects().runs}, chi2, penalty};
  one.fault.channels = std::move(about);
  one.fault.values = std::move(values);
  return one;
}

void try_sign(std::vector<Tried>& all, const Channels& channels, FaultKind kind, const std::vector<int>& about,
              double alternatives) {
  const VectorXd readings =
      channels.whitened([&](std::size_t, const RunRows& rows) { return scaled(rows, about, -1); });
  all.push_back(made(channels, kind, about, channels.chi2_of(readings), std::log(alternatives)));
}

void try_unit(std::vector<Tried>& all, const Channels& channels, FaultKind kind, const std::vector<int>& about,
              double alternatives, std::optional<double> known = {}) {
  const double factor = known.value_or(channels.factor(about));
  // the other sign of about the same size is a sign, no unit
  const bool may_be_the_machine = std::abs(factor) > kUnitLeast && std::abs(factor) < kUnitMost;
  if (!std::isfinite(factor) || std::abs(factor) < 1e-6 || may_be_the_machine) return;
  const VectorXd readings =
      channels.whitened([&](std::size_t, const RunRows& rows) { return scaled(rows, about, 1 / factor); });
  // A bar as far off as before in the unit that was said: it is the noise that is larger than assumed, and no other
  // unit. Torques have more that a machine may owe them: of theirs noise is what tells.
  if (about.front() == kRadial &&
      factor * factor * channels.chi2_of(readings, about) > kUnitLeaves * channels.chi2_of(channels.measured(), about))
    return;
  // Smaller readings are nearer to any prediction, and as much less likely: their density has a volume, too. Larger
  // ones gain nothing by theirs: noise may be less than is assumed.
  const double volume = static_cast<double>(channels.rows_of(about)) * std::max(0.0, std::log(std::abs(factor)));
  const double penalty = std::log(alternatives) + 0.5 * std::log(static_cast<double>(channels.rows())) + volume;
  all.push_back(made(channels, kind, about, channels.chi2_of(readings), penalty, {factor}));
}

// The readings of each motor in the columns of each: what an order of all six makes of the misfit is a sum over pairs.
class Orders {
 public:
  explicit Orders(const Channels& channels) : before_(channels.chi2()) {
    MatrixXd columns(channels.rows(), kMotors * kMotors);
    for (int to = 0; to < kMotors; ++to) {
      for (int from = 0; from < kMotors; ++from) {
        columns.col(kMotors * to + from) = channels.whitened([&](std::size_t, const RunRows& rows) {
          VectorXd moved = VectorXd::Zero(rows.measured.size());
          if (rows.raw.first_row(1)) {
            segment(moved, rows, 1 + to) =
                segment(rows.measured, rows, 1 + from) - segment(rows.measured, rows, 1 + to);
          }
          return moved;
        });
      }
    }
    channels.products(columns, squares_, with_off_);
  }
  /// order[i]: the column that holds what motor 1 + i reads.
  double chi2(const std::array<int, 6>& order) const {
    double sum = before_;
    for (int i = 0; i < kMotors; ++i) {
      const Index a = kMotors * i + order[static_cast<std::size_t>(i)];
      sum += 2 * with_off_[a];
      for (int k = 0; k < kMotors; ++k) sum += squares_(a, kMotors * k + order[static_cast<std::size_t>(k)]);
    }
    return sum;
  }

 private:
  static constexpr int kMotors = 6;
  double before_;
  MatrixXd squares_;
  VectorXd with_off_;
};

void try_exchanges(std::vector<Tried>& all, const Channels& channels) {
  const Orders orders(channels);
  std::array<int, 6> order{0, 1, 2, 3, 4, 5};
  while (std::next_permutation(order.begin(), order.end())) {
    std::vector<int> moved;
    std::vector<double> columns;
    for (int i = 0; i < 6; ++i) {
      const int from = order[static_cast<std::size_t>(i)];
      if (from == i) continue;
      moved.push_back(1 + i);
      columns.push_back(1 + from);
    }
    if (moved.size() == 2) columns.clear();
    const double alternatives = moved.size() == 2 ? 15 : 704;
    all.push_back(
        made(channels, FaultKind::motors_swapped, moved, orders.chi2(order), std::log(alternatives), columns));
  }
}

void try_bar(std::vector<Tried>& all, const Channels& channels) {
  try_sign(all, channels, FaultKind::bar_sign, {kRadial}, 1);
  try_unit(all, channels, FaultKind::bar_unit, {kRadial}, 1);
  for (const double unit : {1e-3, 1e3, 25.4, 1 / 25.4, 2.0, 0.5}) {  // mm, nm, thousandths of an inch, a diameter
    try_unit(all, channels, FaultKind::bar_unit, {kRadial}, 6, unit);
  }
}

void try_motors(std::vector<Tried>& all, const Channels& channels, const std::vector<int>& motors) {
  try_sign(all, channels, FaultKind::motor_sign, motors, 7);
  try_unit(all, channels, FaultKind::torque_unit, motors, 7);
}

// How far each sample is along the way from the first one, rad.
std::vector<double> ways_of(const Run& run, double from) {
  std::vector<double> way(run.samples());
  for (std::size_t i = 0; i < way.size(); ++i) {
    const double before = i == 0 ? from : run.angle[i - 1];
    way[i] = (i == 0 ? 0 : way[i - 1]) + std::abs(std::remainder(run.angle[i] - before, kTurn));
  }
  return way;
}

// Readings of the whole run as they would be a little further on the way than the samples of `run` are: between samples
// in proportion, a whole turn going on with its start.
VectorXd further_on(const Run& run, const Run& whole, const std::vector<double>& readings, double angle) {
  const std::vector<double> way = ways_of(whole, whole.angle[0]);
  const std::vector<double> looked = ways_of(run, whole.angle[0]);
  const auto n = static_cast<Index>(way.size());
  const double mean_step = way.back() / static_cast<double>(n - 1);
  const bool turns = way.back() + 2 * mean_step > kTurn;
  VectorXd moved(static_cast<Index>(looked.size()));
  for (Index i = 0; i < moved.size(); ++i) {
    double at = looked[static_cast<std::size_t>(i)] + angle;
    if (turns) at = within_turn(at);
    const auto above = std::upper_bound(way.begin(), way.end(), at) - way.begin();
    const Index b = std::clamp<Index>(above, 0, n);
    const Index lower = b == 0 ? 0 : b - 1;
    const Index upper = b == n ? (turns ? 0 : n - 1) : b;
    const double from = way[static_cast<std::size_t>(lower)];
    const double to = b == n ? kTurn : way[static_cast<std::size_t>(upper)];
    const double share = to > from ? std::clamp((at - from) / (to - from), 0.0, 1.0) : 0;
    const double start = readings[static_cast<std::size_t>(lower)];
    moved[i] = start + share * (readings[static_cast<std::size_t>(upper)] - start);
  }
  return moved;
}

// Clocks that are apart by so many seconds: those channels as they were so much later.
VectorXd readings_of_clock(const Channels& channels, const std::vector<int>& about, double seconds) {
  const Suspects& suspects = channels.suspects();
  return channels.whitened([&](std::size_t i, const RunRows& rows) {
    const Run& run = suspects.all[suspects.runs[i]];
    const Run& whole = suspects.whole[suspects.runs[i]];
    VectorXd readings = rows.measured;
    for (const int channel : about) {
      if (!rows.raw.first_row(channel)) continue;
      segment(readings, rows, channel) =
          further_on(run, whole, readings_of_channel(whole, channel), seconds * run.feed / run.radius);
    }
    return readings;
  });
}

double chi2_of_clock(const Channels& channels, const std::vector<int>& about, double seconds) {
  return channels.chi2_of(readings_of_clock(channels, about, seconds));
}

// Readings between two samples have less noise than either: a clock is weighed by what whole samples leave, unless it
// is this fraction of a sample that matters.
double unsmoothed(const Channels& channels, const std::vector<int>& about, double seconds, double chi2) {
  const Suspects& suspects = channels.suspects();
  const Run& run = suspects.whole[suspects.runs[0]];
  const double sample = (run.time.back() - run.time.front()) / static_cast<double>(run.samples() - 1);
  const double at = seconds / sample;
  const double of_samples = std::min(chi2_of_clock(channels, about, std::floor(at) * sample),
                                     chi2_of_clock(channels, about, std::ceil(at) * sample));
  return std::clamp(of_samples, chi2, kSmoothed * chi2);
}

void try_clock(std::vector<Tried>& all, const Channels& channels, const std::vector<int>& about) {
  const Suspects& suspects = channels.suspects();
  const Run& first = suspects.all[suspects.runs[0]];
  const double whole = kTurn * first.radius / first.feed;  // s
  constexpr std::array kShares{0.005, -0.005, 0.01, -0.01, 0.02, -0.02, 0.04, -0.04, 0.08, -0.08, 0.16, -0.16};
  MatrixXd readings(channels.rows(), static_cast<Index>(kShares.size()));
  for (Index k = 0; k < readings.cols(); ++k) {
    readings.col(k) = readings_of_clock(channels, about, kShares[static_cast<std::size_t>(k)] * whole);
  }
  Index nearest = 0;
  double least = channels.chi2_of_each(readings).minCoeff(&nearest);
  if (least >= channels.chi2()) return;
  double best = kShares[static_cast<std::size_t>(nearest)] * whole;
  double step = std::abs(best) / 2;
  for (int round = 0; round < 14; ++round) {
    bool moved = false;
    for (const double to : {best - step, best + step}) {
      const double chi2 = chi2_of_clock(channels, about, to);
      if (chi2 >= least) continue;
      least = chi2;
      best = to;
      moved = true;
      break;
    }
    if (!moved) step /= 2;
  }
  const double penalty = std::log(12) + 0.5 * std::log(static_cast<double>(channels.rows()));
  all.push_back(made(channels, FaultKind::clock, about, unsmoothed(channels, about, best, least), penalty, {best}));
}

// A drift, a step: columns that a channel of one run may have besides.
void try_added(std::vector<Tried>& all, const Channels& channels) {
  const RunRows& rows = *channels.suspects().rows[0];
  const Index n = rows.raw.samples;
  const double penalty = 0.5 * std::log(static_cast<double>(channels.rows()));
  if (const auto first = rows.raw.first_row(kRadial)) {
    const Index edge = std::max<Index>(4, n / 30);
    MatrixXd columns = MatrixXd::Zero(rows.measured.size(), 1 + std::max<Index>(0, n - 2 * edge));
    columns.col(0).segment(*first, n) = VectorXd::LinSpaced(n, 0, 1);
    for (Index k = 1; k < columns.cols(); ++k) {
      columns.col(k).segment(*first + edge + k, n - edge - k).setOnes();
    }
    const auto added = channels.added(channels.suspects().bench.white(rows, columns));
    all.push_back(
        made(channels, FaultKind::drift, {kRadial}, channels.chi2() - added[0].gain, penalty, {added[0].size}));
    if (added.size() > 1) {
      const auto best = std::max_element(added.begin() + 1, added.end(),
                                         [](const auto& a, const auto& b) { return a.gain < b.gain; });
      const auto sample = static_cast<std::size_t>(edge + (best - added.begin()));
      all.push_back(made(channels, FaultKind::bar_step, {kRadial}, channels.chi2() - best->gain,
                         penalty + std::log(static_cast<double>(n)),
                         {best->size, channels.suspects().all[channels.suspects().runs[0]].angle[sample]}));
    }
  }
}

// A motor that reads too much by as much in all runs.
void try_motor_zeros(std::vector<Tried>& all, const Channels& channels) {
  const double penalty = std::log(6) + 0.5 * std::log(static_cast<double>(channels.rows()));
  for (int motor = 1; motor < kChannels; ++motor) {
    if (!channels.has(motor)) continue;
    const VectorXd column = channels.whitened([&](std::size_t, const RunRows& rows) {
      VectorXd ones = VectorXd::Zero(rows.measured.size());
      if (rows.raw.first_row(motor)) segment(ones, rows, motor).setOnes();
      return ones;
    });
    const auto added = channels.added(column);
    all.push_back(
        made(channels, FaultKind::motor_zero, {motor}, channels.chi2() - added[0].gain, penalty, {added[0].size}));
  }
}

// Something that is tried by itself, beside others.
using Try = std::function<void(std::vector<Tried>&)>;

void add_motors(std::vector<Try>& tries, const Channels& channels) {
  for (int motor = 1; motor < kChannels; ++motor) {
    tries.emplace_back([&channels, motor](auto& all) { try_motors(all, channels, {motor}); });
  }
  tries.emplace_back([&](auto& all) { try_motors(all, channels, {1, 2, 3, 4, 5, 6}); });
  tries.emplace_back([&](auto& all) { try_exchanges(all, channels); });
  tries.emplace_back([&](auto& all) { try_motor_zeros(all, channels); });
}

}  // namespace

std::optional<Drift> drift_of(const Suspects& suspects) {
  const Channels channels(suspects);
  if (!channels.has(kRadial)) return std::nullopt;
  const VectorXd column = channels.whitened([](std::size_t, const RunRows& rows) {
    VectorXd ramp = VectorXd::Zero(rows.measured.size());
    if (rows.raw.first_row(kRadial)) segment(ramp, rows, kRadial) = VectorXd::LinSpaced(rows.raw.samples, 0, 1);
    return ramp;
  });
  const auto added = channels.added(column);
  return Drift{added[0].gain, added[0].size};
}

double chi2_as_stated(const Suspects& suspects) { return Channels(suspects).chi2(); }

std::vector<Tried> tried_channels(const Suspects& suspects) {
  const Channels channels(suspects);
  const bool bar = channels.has(kRadial);
  const bool motors = channels.has(1);
  std::vector<Try> tries;
  if (bar) tries.emplace_back([&](auto& all) { try_bar(all, channels); });
  if (motors) add_motors(tries, channels);
  if (bar && motors) {
    tries.emplace_back([&](auto& all) { try_clock(all, channels, {kRadial}); });
    tries.emplace_back([&](auto& all) { try_clock(all, channels, {1, 2, 3, 4, 5, 6}); });
  }
  if (suspects.runs.size() == 1) tries.emplace_back([&](auto& all) { try_added(all, channels); });
  std::vector<std::vector<Tried>> each(tries.size());
  for_each_index(tries.size(), [&](std::size_t i) { tries[i](each[i]); });
  std::vector<Tried> all;
  for (std::vector<Tried>& some : each) std::move(some.begin(), some.end(), std::back_inserter(all));
  return all;
}

}  // namespace plumbline::inspect

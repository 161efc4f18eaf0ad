#include "inspect/records/records.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include <Eigen/Core>

#include "base/angle.hpp"
#include "identify/equations/run_model.hpp"
#include "inspect/records/alike.hpp"
#include "inspect/statistics.hpp"

namespace plumbline::inspect {
namespace {

using measure::Run;

// The four neighbours of a sample: what a cubic through them is there, which has the slope and the bend of a circle,
// and how far they are off a line and off a parabola.
struct Neighbours {
  double cubic = 0, off_line = 0, off_parabola = 0;

  explicit Neighbours(const std::array<double, 4>& y) {
    const double mean = (y[0] + y[1] + y[2] + y[3]) / 4;
    const double slope = (2 * (y[3] - y[0]) + (y[2] - y[1])) / 10;
    off_line = std::max({std::abs(y[0] - mean + 2 * slope), std::abs(y[1] - mean + slope),
                         std::abs(y[2] - mean - slope), std::abs(y[3] - mean - 2 * slope)});
    cubic = (4 * (y[1] + y[2]) - y[0] - y[3]) / 6;
    off_parabola = std::abs(y[3] - y[0] - 2 * (y[2] - y[1])) / 5;
  }
};

// `closed`: a whole turn, which goes on with its start.
void add_spikes(const std::vector<double>& values, double least_noise, bool closed, const RecordOptions& options,
                std::vector<std::size_t>& found) {
  const std::size_t n = values.size();
  if (n < 16) return;
  std::vector<Neighbours> neighbours;
  std::vector<double> sizes;
  std::vector<double> bends;
  const std::size_t edge = closed ? 0 : 2;
  for (std::size_t i = edge; i + edge < n; ++i) {
    const Neighbours& of = neighbours.emplace_back(
        std::array{values[(i + n - 2) % n], values[(i + n - 1) % n], values[(i + 1) % n], values[(i + 2) % n]});
    sizes.push_back(std::abs(values[i] - of.cubic));
    bends.push_back(of.off_line);
  }
  const double usual_bend = median(bends);
  const double sigma =
      std::max({1.4826 * median(sizes), resolution(values), least_noise, options.of_bend * usual_bend});
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const double returns = options.returns * sizes[k];
    const bool step = neighbours[k].off_parabola > options.step * sizes[k];  // or another spike
    const bool kink = neighbours[k].off_line > returns + 2 * usual_bend;
    if (sizes[k] > options.spike * sigma && !step && !kink) found.push_back(k + edge);
  }
}

double step_of(const Run& run, std::size_t i) {
  return std::abs(std::remainder(run.angle[i] - run.angle[i - 1], kTurn));
}

// The longest way without a sample where there are samples everywhere else, rad; nil: there is none.
double gap_of(const Run& run, const RecordOptions& options) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < run.samples(); ++i) steps.push_back(step_of(run, i));
  const double usual = median(steps);
  const double longest = *std::max_element(steps.begin(), steps.end());
  return longest > options.gap * usual ? longest : 0;
}

// A whole turn whose last sample is a step before its first one.
bool is_closed(const Run& run) {
  double way = 0;
  for (std::size_t i = 1; i < run.samples(); ++i) way += step_of(run, i);
  const double step = way / static_cast<double>(run.samples() - 1);
  return std::abs(kTurn - way - step) < 0.5 * step;
}

struct Standing {
  std::size_t longest = 0;    // samples one after the other that are alike
  std::size_t elsewhere = 0;  // the same of all values between the highest and the lowest
  std::size_t values = 0;     // that are different
  bool at_end = false;        // at the highest or lowest of all values
};

Standing standing_of(const std::vector<double>& values) {
  Standing found;
  std::map<double, std::size_t> longest;  // of each value
  std::size_t length = 1;
  for (std::size_t i = 1; i <= values.size(); ++i) {
    if (i < values.size() && values[i] == values[i - 1]) {
      ++length;
      continue;
    }
    std::size_t& of_value = longest[values[i - 1]];
    of_value = std::max(of_value, length);
    length = 1;
  }
  found.values = longest.size();
  const auto at_end = [&](double value) { return value == longest.begin()->first || value == longest.rbegin()->first; };
  for (const auto& [value, of_value] : longest) {
    if (of_value > found.longest) {
      found.longest = of_value;
      found.at_end = at_end(value) && longest.size() > 1;
    }
    if (!at_end(value)) found.elsewhere = std::max(found.elsewhere, of_value);
  }
  return found;
}

// Readings that repeat because they come in coarse steps: at the top of a wave they stand longest, for as long as the
// top of a parabola is within a step: some five times what they take for the next step, and they stand there, too.
bool is_coarse(const Standing& standing, std::size_t samples) {
  constexpr std::size_t kTopToRest = 6;
  constexpr std::size_t kFewValues = 8;
  if (2 * standing.longest > samples) return false;
  return (standing.values > 1 && standing.values < kFewValues) || kTopToRest * standing.elsewhere >= standing.longest;
}

Fault record_fault(FaultKind kind, std::size_t run, std::vector<double> values, bool blocks) {
  Fault fault{kind, {run}};
  fault.values = std::move(values);
  fault.blocks = blocks;
  return fault;
}

void add_channel_faults(const Run& run, std::size_t number, const RecordOptions& options, std::vector<Fault>& faults) {
  for (int c = 0; c < identify::kChannels; ++c) {
    const std::vector<double>& values = readings_of_channel(run, c);
    if (values.empty()) continue;
    const Standing standing = standing_of(values);
    const bool stands = static_cast<double>(standing.longest) > options.stands * static_cast<double>(values.size());
    const bool clips = standing.at_end && standing.longest >= options.standing;
    if ((!stands && !clips) || is_coarse(standing, values.size())) continue;
    Fault fault = record_fault(standing.at_end ? FaultKind::clipped : FaultKind::stuck, number,
                               {static_cast<double>(standing.longest)}, true);
    fault.channels = {c};
    faults.push_back(std::move(fault));
  }
}

// How much a sample says of the next one: 1 of a slow wave, nil of noise.
double lag_correlation(const std::vector<double>& values) {
  const Eigen::Map<const Eigen::VectorXd> read(values.data(), static_cast<Eigen::Index>(values.size()));
  const Eigen::VectorXd e = read.array() - read.mean();
  return e.head(e.size() - 1).dot(e.tail(e.size() - 1)) / std::max(e.squaredNorm(), 1e-300);
}

std::vector<std::size_t> numbers_of(const std::vector<Run>& runs) {
  std::vector<std::size_t> numbers(runs.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

// Motors that read noise in all runs, where most others follow the way.
void add_silent_motors(const std::vector<Run>& runs, const RecordOptions& options, std::vector<Fault>& faults) {
  std::vector<int> silent;
  int following = 0;
  for (int motor = 1; motor < identify::kChannels; ++motor) {
    std::vector<double> each;
    for (const Run& run : runs) {
      const std::vector<double>& values = readings_of_channel(run, motor);
      if (values.size() > 2) each.push_back(lag_correlation(values));
    }
    if (each.empty()) continue;
    if (*std::max_element(each.begin(), each.end()) < options.silent) silent.push_back(motor);
    if (median(each) > options.follows) ++following;
  }
  if (following < 3) return;
  for (const int motor : silent) {
    faults.push_back({FaultKind::motor_silent, numbers_of(runs), true, {motor}});
  }
}

// On one clock a run begins when the one before it is done. That of another day may begin its clock anew.
void add_starts(const std::vector<Run>& runs, std::vector<Fault>& faults) {
  constexpr std::size_t kLeast = 3;
  std::size_t going_on = 0;
  std::optional<std::size_t> first;
  for (std::size_t r = 1; r < runs.size(); ++r) {
    const double later = runs[r].start - runs[r - 1].start;
    if (later <= 0 || later >= runs[r - 1].time.back()) continue;
    ++going_on;
    if (!first) first = r;
  }
  if (going_on < kLeast || 2 * going_on < runs.size() - 1) return;
  Fault fault = record_fault(FaultKind::start, *first,
                             {runs[*first].start, runs[*first - 1].start, runs[*first - 1].time.back()}, true);
  fault.like = *first - 1;
  fault.all = true;
  fault.runs = numbers_of(runs);
  const auto at = fault.runs.begin() + static_cast<std::ptrdiff_t>(*first);
  std::rotate(fault.runs.begin(), at, at + 1);
  faults.push_back(std::move(fault));
}

}  // namespace

const std::vector<double>& readings_of_channel(const Run& run, int channel) {
  return channel == identify::kRadial ? run.radial : run.torque.at(static_cast<std::size_t>(channel) - 1);
}

double rate_of(const Run& run) {
  double way = 0;
  for (std::size_t i = 1; i < run.samples(); ++i) way += step_of(run, i);
  return way / (run.time.back() - run.time.front());
}

std::vector<std::size_t> spikes_in(const Run& run, const RecordOptions& options) {
  std::vector<std::size_t> found;
  const bool closed = is_closed(run);
  for (int c = 0; c < identify::kChannels; ++c) {
    const double least_noise = c == identify::kRadial ? options.least_radial : options.least_torque;
    add_spikes(readings_of_channel(run, c), least_noise, closed, options, found);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  const double most = std::max(2.0, options.most_spikes * static_cast<double>(run.samples()));
  return static_cast<double>(found.size()) <= most ? found : std::vector<std::size_t>{};
}

std::vector<Fault> record_faults(const std::vector<Run>& runs, const RecordOptions& options) {
  std::vector<Fault> faults = motors_alike(runs, options.same_readings);
  add_silent_motors(runs, options, faults);
  add_starts(runs, faults);
  const AlikeRuns alike(runs);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Run& run = runs[r];
    const std::vector<std::size_t> spikes = spikes_in(run, options);
    if (!spikes.empty()) {
      faults.push_back(record_fault(FaultKind::spikes, r, {static_cast<double>(spikes.size())}, false));
    }
    if (const double gap = gap_of(run, options); gap > 0) {
      faults.push_back(record_fault(FaultKind::gaps, r, {gap, static_cast<double>(run.left_out.size())}, false));
    } else if (!run.left_out.empty()) {
      faults.push_back(record_fault(FaultKind::gaps, r, {0, static_cast<double>(run.left_out.size())}, false));
    }
    add_channel_faults(run, r, options, faults);
    for (const measure::Contradiction contradiction : run.contradictions) {
      const bool direction = contradiction == measure::Contradiction::direction;
      faults.push_back(record_fault(direction ? FaultKind::direction : FaultKind::feed, r,
                                    direction ? std::vector<double>{} : std::vector<double>{run.feed}, true));
    }
    if (const double feed = rate_of(run) * run.radius; std::abs(feed / run.feed - 1) > options.feed) {
      faults.push_back(record_fault(FaultKind::feed, r, {feed}, true));
    }
    for (std::size_t k = 0; k < r; ++k) {
      if (!alike.alike(k, r, options.same_readings)) continue;
      faults.push_back(record_fault(FaultKind::same_readings, r, {}, true));
      faults.back().runs.push_back(k);  // which of them is the wrong one records do not tell
      faults.back().like = k;
    }
  }
  return faults;
}

}  // namespace plumbline::inspect

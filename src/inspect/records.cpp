#include "inspect/records.hpp"

#include <algorithm>
#include <cmath>

#include "identify/equations/run_model.hpp"
#include "inspect/statistics.hpp"

namespace plumbline::inspect {
namespace {

using measure::Run;

// The least step between two different values: what is less than that is no difference.
double resolution(const std::vector<double>& values) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  double least = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const double step = sorted[i] - sorted[i - 1];
    if (step > 1e-12 && (least == 0 || step < least)) least = step;
  }
  return least;
}

void add_spikes(const std::vector<double>& values, const RecordOptions& options, std::vector<std::size_t>& found) {
  if (values.size() < 16) return;
  std::vector<double> off(values.size(), 0);
  std::vector<double> sizes;
  for (std::size_t i = 2; i + 2 < values.size(); ++i) {
    off[i] = values[i] - median({values[i - 2], values[i - 1], values[i + 1], values[i + 2]});
    sizes.push_back(std::abs(off[i]));
  }
  const double sigma = std::max(1.4826 * median(sizes), resolution(values));
  if (sigma <= 0) return;
  for (std::size_t i = 2; i + 2 < values.size(); ++i) {
    const double before = 0.5 * (values[i - 2] + values[i - 1]);
    const double after = 0.5 * (values[i + 1] + values[i + 2]);
    const bool alone = std::abs(after - before) < options.returns * std::abs(off[i]) &&
                       std::abs(values[i - 1] - before) < options.returns * std::abs(off[i]) &&
                       std::abs(values[i + 1] - after) < options.returns * std::abs(off[i]);
    if (alone && std::abs(off[i]) > options.spike * sigma) found.push_back(i);
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

struct Standing {
  std::size_t longest = 0;  // samples one after the other that are alike
  bool at_end = false;      // at the highest or lowest of all values
};

Standing standing_of(const std::vector<double>& values) {
  Standing found;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  std::size_t length = 1;
  for (std::size_t i = 1; i <= values.size(); ++i) {
    if (i < values.size() && values[i] == values[i - 1]) {
      ++length;
      continue;
    }
    if (length > found.longest) {
      found.longest = length;
      found.at_end = (values[i - 1] == *least || values[i - 1] == *most) && *least < *most;
    }
    length = 1;
  }
  return found;
}

bool same_readings(const Run& a, const Run& b, const RecordOptions& options) {
  if (a.samples() != b.samples()) return false;
  std::size_t alike = 0;
  std::size_t compared = 0;
  for (int c = 0; c < identify::kChannels; ++c) {
    const std::vector<double>& one = readings_of_channel(a, c);
    const std::vector<double>& other = readings_of_channel(b, c);
    if (one.size() != other.size()) return false;
    compared += one.size();
    for (std::size_t i = 0; i < one.size(); ++i) {
      if (one[i] == other[i]) ++alike;
    }
  }
  return compared > 0 && static_cast<double>(alike) > options.same_readings * static_cast<double>(compared);
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
    if (!stands && !clips) continue;
    Fault fault = record_fault(standing.at_end ? FaultKind::clipped : FaultKind::stuck, number,
                               {static_cast<double>(standing.longest)}, true);
    fault.channels = {c};
    faults.push_back(std::move(fault));
  }
}

// What the angles and times of its table say of the feed, m/s.
double feed_of(const Run& run) {
  double way = 0;
  for (std::size_t i = 1; i < run.samples(); ++i) way += step_of(run, i);
  return way * run.radius / (run.time.back() - run.time.front());
}

}  // namespace

const std::vector<double>& readings_of_channel(const Run& run, int channel) {
  return channel == identify::kRadial ? run.radial : run.torque.at(static_cast<std::size_t>(channel) - 1);
}

std::vector<std::size_t> spikes_in(const Run& run, const RecordOptions& options) {
  std::vector<std::size_t> found;
  for (int c = 0; c < identify::kChannels; ++c) add_spikes(readings_of_channel(run, c), options, found);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  const double most = std::max(2.0, options.most_spikes * static_cast<double>(run.samples()));
  return static_cast<double>(found.size()) <= most ? found : std::vector<std::size_t>{};
}

std::vector<Fault> record_faults(const std::vector<Run>& runs, const RecordOptions& options) {
  std::vector<Fault> faults;
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
    if (const double feed = feed_of(run); std::abs(feed / run.feed - 1) > options.feed) {
      faults.push_back(record_fault(FaultKind::feed, r, {feed}, true));
    }
    for (std::size_t k = 0; k < r; ++k) {
      if (!same_readings(runs[k], run, options)) continue;
      faults.push_back(record_fault(FaultKind::same_readings, r, {}, true));
      faults.back().runs.push_back(k);  // which of them is the wrong one records do not tell
      faults.back().like = k;
    }
  }
  return faults;
}

}  // namespace plumbline::inspect

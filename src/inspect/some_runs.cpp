#include "inspect/some_runs.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/parallel.hpp"
#include "base/units.hpp"
#include "inspect/statistics.hpp"
#include "inspect/together.hpp"

namespace plumbline::inspect {
namespace {

using identify::kChannels;
using identify::kRadial;
using measure::Run;

constexpr std::size_t kLeastRuns = 4;
constexpr double kLeastFactor = 1.1;  // between the readings of runs

std::vector<Moved> times(const std::vector<int>& channels, double by) {
  std::vector<Moved> all;
  for (const int channel : channels) all.push_back({channel, channel, by});
  return all;
}

Alike signs(const Together& together, FaultKind kind, const std::vector<int>& channels, double alternatives) {
  Alike alike{{kind, {}}, {}, std::log(alternatives), {}};
  alike.fault.channels = channels;
  alike.mended = together.with_channels(times(channels, -1));
  return alike;
}

// The readings of each of these motors are where those of the other one should be.
Alike exchange(const Together& together, const std::vector<int>& motors, const std::vector<int>& others,
               double alternatives) {
  Alike alike{{FaultKind::motors_swapped, {}}, {}, std::log(alternatives), {}};
  alike.fault.channels = motors;
  if (motors.size() > 2) alike.fault.values.assign(others.begin(), others.end());
  std::vector<Moved> moved;
  for (std::size_t i = 0; i < motors.size(); ++i) moved.push_back({motors[i], others[i]});
  alike.mended = together.with_channels(moved);
  return alike;
}

Alike unit(const Together& together, const std::vector<int>& channels, double factor, double alternatives) {
  const FaultKind kind = channels.front() == kRadial ? FaultKind::bar_unit : FaultKind::torque_unit;
  Alike alike{{kind, {}}, {}, std::log(alternatives) + 0.5 * std::log(static_cast<double>(together.rows())), {}};
  alike.fault.channels = channels;
  alike.fault.values = {factor};
  alike.mended = together.with_channels(times(channels, 1 / factor));
  for (const RunRows& rows : together.looked().rows) {
    double count = 0;
    for (const int channel : channels) count += rows.raw.first_row(channel) ? static_cast<double>(rows.raw.samples) : 0;
    alike.volume.push_back(count * std::log(factor));
  }
  return alike;
}

// Scales in two groups, between which the gap is widest.
struct Groups {
  double ratio = 1;  // of the middle of the larger ones to that of the others
  Which large, small;
};
std::optional<Groups> groups_of(const std::vector<double>& scales) {
  std::vector<double> sorted = scales;
  std::erase_if(sorted, [](double scale) { return !(scale > 1e-6); });
  if (sorted.size() < 4) return std::nullopt;
  std::sort(sorted.begin(), sorted.end());
  std::size_t split = 1;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i] / sorted[i - 1] > sorted[split] / sorted[split - 1]) split = i;
  }
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(split);
  Groups groups{
      median(std::vector<double>(at, sorted.end())) / median(std::vector<double>(sorted.begin(), at)), {}, {}};
  for (const double scale : scales) {
    groups.large.push_back(scale >= *at);
    groups.small.push_back(scale < *at);
  }
  return groups;
}

// One pair of motors, or two.
void add_exchanges(std::vector<Alike>& all, const Together& together) {
  for (int a = 1; a < kChannels; ++a) {
    for (int b = a + 1; b < kChannels; ++b) {
      all.push_back(exchange(together, {a, b}, {b, a}, 15));
      for (int c = a + 1; c < kChannels; ++c) {
        for (int d = c + 1; d < kChannels; ++d) {
          if (c != b && d != b) all.push_back(exchange(together, {a, b, c, d}, {b, a, d, c}, 45));
        }
      }
    }
  }
}

std::vector<Alike> of_channels(const Together& together) {
  const auto has = [&](int channel) {
    const auto& rows = together.looked().rows;
    return std::any_of(rows.begin(), rows.end(), [&](const RunRows& run) { return run.raw.first_row(channel); });
  };
  std::vector<Alike> all;
  const auto add_units = [&](const std::vector<int>& channels, double alternatives) {
    const std::optional<Groups> groups = groups_of(together.best_scales(channels));
    if (!groups || groups->ratio < kLeastFactor) return;
    all.push_back(unit(together, channels, groups->ratio, alternatives));
    all.back().first = groups->small;
    all.push_back(unit(together, channels, 1 / groups->ratio, alternatives));
    all.back().first = groups->large;
  };
  if (has(kRadial)) {
    all.push_back(signs(together, FaultKind::bar_sign, {kRadial}, 1));
    add_units({kRadial}, 1);
  }
  if (has(1)) {
    const std::vector<int> motors{1, 2, 3, 4, 5, 6};
    all.push_back(signs(together, FaultKind::motor_sign, motors, 7));
    add_units(motors, 7);
    for (const int one : motors) {
      all.push_back(signs(together, FaultKind::motor_sign, {one}, 7));
      add_units({one}, 7);
    }
    add_exchanges(all, together);
  }
  return all;
}

// One after the other: what runs then say of the machine takes memory.
void consider_labels(const Together& together, const std::function<void(const Alike&)>& consider) {
  const auto add = [&](FaultKind kind, double alternatives, const std::function<void(Run&)>& change,
                       std::vector<double> values = {}) {
    Alike alike{{kind, {}}, {}, std::log(alternatives), {}};
    alike.fault.values = std::move(values);
    alike.change = change;
    alike.mended = together.with_labels(change);
    consider(alike);
  };
  add(FaultKind::direction, 1, [](Run& run) { run = turned_back(run); });
  for (const double angle : {90.0, 180.0, -90.0}) {
    const auto turned = [angle](Run& run) {
      for (double& of_sample : run.angle) of_sample += angle * kDeg;
    };
    add(FaultKind::angle_zero, 3, turned, {angle * kDeg});
  }
  for (const auto& slip : tilt_slips()) add(FaultKind::tilt, 4, slip);
  for (const auto& slip : centre_slips()) add(FaultKind::centre, 4, slip);
}

bool is_unit(FaultKind kind) { return kind == FaultKind::bar_unit || kind == FaultKind::torque_unit; }

// The fault as it stands for these runs, misfits as chi-square of all runs.
Fault made(const Together& together, const Alike& alike, const Chosen& chosen) {
  Fault fault = alike.fault;
  const double scale = std::max(1.0, chosen.chi2 / static_cast<double>(together.rows()));
  const double penalty = alike.penalty + chosen.volume + static_cast<double>(together.runs()) * std::log(2.0);
  fault.nats = (together.chi2() - chosen.chi2) / (2 * scale) - penalty;
  fault.before = together.chi2();
  fault.after = chosen.chi2;
  for (std::size_t r = 0; r < together.runs(); ++r) {
    if (chosen.which[r]) fault.runs.push_back(r);
  }
  if (alike.change && !fault.runs.empty()) {
    Run run = together.looked().runs[fault.runs.front()];
    alike.change(run);
    if (fault.kind == FaultKind::tilt) fault.values = {run.tilt.x(), run.tilt.y(), run.tilt.z()};
    if (fault.kind == FaultKind::centre) fault.values = {run.centre_W.x(), run.centre_W.y(), run.centre_W.z()};
  }
  return fault;
}

std::vector<std::size_t> others(const std::vector<std::size_t>& some, std::size_t count) {
  std::vector<std::size_t> rest;
  for (std::size_t r = 0; r < count; ++r) {
    if (std::find(some.begin(), some.end(), r) == some.end()) rest.push_back(r);
  }
  return rest;
}

}  // namespace

std::optional<Fault> fault_of_some(const Looked& looked, const Bench& bench, const FineNoise& noise, bool labels,
                                   const InspectOptions& options) {
  if (looked.runs.size() < kLeastRuns) return std::nullopt;
  const Together together(looked, bench);
  std::optional<Fault> best;
  double least = together.chi2();
  double least_dense = least;
  const auto chosen_of = [&](const Alike& alike) { return Choice(together, alike).best(options.least_nats); };
  const auto consider = [&](const Alike& alike, const Chosen& choice) {
    const auto count = static_cast<std::size_t>(std::count(choice.which.begin(), choice.which.end(), true));
    const double objective = choice.objective() + 2 * alike.penalty;
    if (count < 2 || count + 2 > together.runs()) return;  // one run, or one that is right, is judged by itself
    // which of two groups has the other unit is a matter of their noise: all of the density counts
    const double dense = choice.chi2 + 2 * (choice.density + alike.penalty);
    const bool same = best && is_unit(best->kind) && best->kind == alike.fault.kind &&
                      best->channels == alike.fault.channels &&
                      choice.chi2 < options.near * std::max(best->after, static_cast<double>(together.rows()));
    if (same ? dense >= least_dense : objective >= least) return;
    // what some do not show, as the sign of a coordinate that is nil, is still of all; a factor of all is none of some
    const Chosen all_runs = Choice(together, alike).at(Which(together.runs(), true));
    const bool of_all = all_runs.objective() < choice.objective() + 2 * options.least_nats;
    if (of_all && is_unit(alike.fault.kind)) return;
    least = objective;
    least_dense = dense;
    best = made(together, alike, of_all ? all_runs : choice);
    best->all = of_all;
  };
  const std::vector<Alike> alikes = of_channels(together);
  std::vector<Chosen> each(alikes.size());
  for_each_index(each.size(), [&](std::size_t i) { each[i] = chosen_of(alikes[i]); });
  for (std::size_t i = 0; i < each.size(); ++i) consider(alikes[i], each[i]);
  if (labels) consider_labels(together, [&](const Alike& alike) { consider(alike, chosen_of(alike)); });
  if (!best) return std::nullopt;
  // as with one run and with all: it takes away most of what is off, and leaves little more than noise
  const double expected = noise.expected({});
  const bool explains = best->before - best->after > options.explained * (best->before - expected);
  if (best->nats < options.all_nats || !explains || best->after > options.near * expected) return std::nullopt;
  // nor is there something wrong with half as many of them alone, or with half as many of the others
  const auto half_explains = [&](const std::vector<std::size_t>& runs) {
    return together.least_without(runs, runs.size() / 2) <= best->after;
  };
  if (!best->all && (half_explains(best->runs) || half_explains(others(best->runs, together.runs()))))
    return std::nullopt;
  const auto rows = static_cast<double>(together.rows());
  best->before = std::sqrt(best->before / rows);
  best->after = std::sqrt(best->after / rows);
  for (std::size_t& run : best->runs) run = looked.numbers[run];
  return best;
}

}  // namespace plumbline::inspect

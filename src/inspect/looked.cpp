#include "inspect/looked.hpp"

#include <optional>

#include "base/diagnostic.hpp"
#include "base/parallel.hpp"
#include "machine/inverse.hpp"
#include "measure/circular_motion.hpp"
#include "measure/friction_turns.hpp"

namespace plumbline::inspect {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using identify::kChannels;
using identify::kRadial;
using measure::Run;

// Every so many of the samples of a run, so that not more than `most` are left.
Run coarse(const Run& run, std::size_t most) {
  const std::size_t each = (run.samples() + most - 1) / most;
  std::vector<std::size_t> left_out;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    if (i % each != 0) left_out.push_back(i);
  }
  return measure::without_samples(run, left_out);
}

// Whether struts would be far from the lengths that they can have: the model's limits may be somewhat off, the run is
// there after all.
bool in_reach(const machine::MachineModel& machine, const Run& run, double beyond) {
  const auto least = machine.limits.length_min.array();
  const auto most = machine.limits.length_max.array();
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const auto pose = measure::circular_motion(machine.rotation, run, i).pose;
    const machine::PerStrut<double> length = machine::strut_lengths<double>(machine.geometry, pose);
    if (((length.array() - most).max(least - length.array()) > beyond * (most - least)).any()) return false;
  }
  return true;
}

}  // namespace

identify::NoiseModel usual_noise(const InspectOptions& options) {
  identify::NoiseModel noise;
  for (int c = 0; c < identify::kAllChannels; ++c) {
    noise.channels[static_cast<std::size_t>(c)].sigma = c == kRadial ? options.usual_radial : options.usual_torque;
  }
  return noise;
}

identify::NoiseModel at_least(identify::NoiseModel noise, const InspectOptions& options) {
  for (int c = 0; c < kChannels; ++c) {
    double& sigma = noise.channels[static_cast<std::size_t>(c)].sigma;
    sigma = std::max(sigma, options.least_noise * (c == kRadial ? options.usual_radial : options.usual_torque));
  }
  return noise;
}

void make_rows(Looked& looked, const Bench& bench) {
  looked.rows.resize(looked.runs.size());
  for_each_index(looked.runs.size(), [&](std::size_t i) { looked.rows[i] = bench.rows(looked.runs[i]); });
}

Looked looked_at(const std::vector<Run>& runs, const Bench& bench, const InspectOptions& options,
                 std::vector<Fault>& faults) {
  Looked looked;
  std::vector<std::optional<Run>> can(runs.size());
  std::vector<Run> whole(runs.size());
  for_each_index(runs.size(), [&](std::size_t r) {
    if (!runs[r].has_radial() && !runs[r].has_torque()) return;
    Run run = measure::without_samples(runs[r], spikes_in(runs[r], options.records));
    whole[r] = coarse(run, options.most_samples);
    run = coarse(measure::without_friction_turns(bench.machine, bench.forces, std::move(run)), options.most_samples);
    if (!in_reach(bench.machine, run, options.beyond_limits)) return;
    try {
      bench.left(run);
      can[r] = run;
    } catch (const Refusal&) {  // it would stand in a singularity, or beyond it
    }
  });
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (can[r]) {
      looked.numbers.push_back(r);
      looked.runs.push_back(std::move(*can[r]));
      looked.whole.push_back(std::move(whole[r]));
    } else if (runs[r].has_radial() || runs[r].has_torque()) {
      faults.push_back({FaultKind::unreachable, {r}});
    }
  }
  return looked;
}

std::vector<identify::RunEquations> remainders(const Looked& looked, const Outliers& outliers,
                                               const identify::NoiseModel& noise) {
  const VectorXd mean = knowledge_of_others(outliers, looked.rows, looked.rows.size()).mean();
  std::vector<identify::RunEquations> all;
  for (const RunRows& rows : looked.rows) {
    identify::RunEquations& equations = all.emplace_back();
    equations.channels = rows.raw.channels;
    equations.samples = rows.raw.samples;
    equations.residual = rows.left - rows.slopes * mean;
    for (std::size_t c = 0; c < equations.channels.size(); ++c) {
      equations.residual.segment(static_cast<Index>(c) * equations.samples, equations.samples) *=
          noise.channels[static_cast<std::size_t>(equations.channels[c])].sigma;
    }
  }
  return all;
}

std::vector<identify::RunEquations> kept(const std::vector<identify::RunEquations>& all, const Outliers& outliers) {
  std::vector<identify::RunEquations> kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!outliers.out[i]) kept.push_back(all[i]);
  }
  return kept;
}

std::vector<Fault> periodic_faults(const Looked& looked, const std::vector<Line>& lines, const LineOptions& options) {
  std::vector<Fault> faults;
  std::vector<bool> told(lines.size(), false);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (told[i]) continue;
    // the same line in runs sampled otherwise, where one frequency is folded to both
    std::vector<Line> same{lines[i]};
    for (std::size_t k = i + 1; k < lines.size(); ++k) {
      const bool other_runs = lines[k].sampling != lines[i].sampling && lines[k].channel == lines[i].channel;
      if (told[k] || !other_runs) continue;
      same.push_back(lines[k]);
      told[k] = common_frequency(same, looked.runs, options.highest).has_value();
      if (!told[k]) same.pop_back();
    }
    Fault fault{FaultKind::periodic, {}};
    for (const Line& line : same) {
      for (const std::size_t r : line.runs) fault.runs.push_back(looked.numbers[r]);
    }
    fault.all = fault.runs.size() == looked.runs.size();
    fault.channels = {lines[i].channel};
    const double frequency = common_frequency(same, looked.runs, options.highest).value_or(lines[i].frequency);
    fault.values = {frequency, lines[i].amplitude, lines[i].sampling};
    if (lines[i].along) fault.values.push_back(lines[i].direction);
    fault.blocks = false;
    faults.push_back(std::move(fault));
  }
  return faults;
}

}  // namespace plumbline::inspect

#include "diagnose/gap/gap_map.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace plumbline::diagnose {

using identify::RunEquations;
using measure::Run;

GapMap gap_map_of(const machine::RotationOrder& order, const std::vector<Run>& runs, const physics::ForceModel& forces,
                  const std::vector<RunEquations>& residuals, const identify::NoiseModel& noise,
                  const GapMapOptions& options) {
  GapMap map;
  for (int channel = 0; channel < identify::kChannels; ++channel) {
    const bool measured = std::any_of(residuals.begin(), residuals.end(),
                                      [&](const RunEquations& run) { return run.first_row(channel).has_value(); });
    if (!measured) continue;
    map.channels.push_back(
        around_the_circle(runs, residuals, channel, noise.channels[static_cast<std::size_t>(channel)]));
  }
  map.contrasts = contrasts_of(runs, residuals);
  map.groups = groups_of(order, runs, residuals, options.groups);
  std::vector<std::vector<SampleState>> states(runs.size());
  for_each_index(runs.size(), [&](std::size_t i) { states[i] = sample_states(order, forces, runs[i]); });
  map.reversals = reversals_of(runs, states, residuals, options.reversals);
  return map;
}

}  // namespace plumbline::diagnose

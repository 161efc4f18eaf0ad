// What a model is good for: the circle that a ballbar would draw if programs were compensated with it.
#pragma once

#include <optional>

#include "measure/circularity.hpp"
#include "physics/force_model.hpp"

namespace plumbline::diagnose {

struct CompensatedOptions {
  double sign_width_of_feed = 0.01;  // v0 of the correction, as `compensate` widens it: a share of the feed
};

/// The readings that a run would have if its program had been compensated with `forces`: what was measured minus what
/// the correction takes away. To first order in the correction; noise and whatever `forces` lack stay in. The
/// correction is that of `compensate`: no inertia, no following error, friction that turns around more slowly than the
/// machine's. The payload is taken for known, what drifts with time for that of the run. `run` has readings of the bar.
measure::Profile compensated_profile(const machine::RotationOrder& order, const measure::Run& run,
                                     const physics::ForceModel& forces, const CompensatedOptions& options = {});

/// Its circularity: max - min about the least-squares circle, m. Nothing if the run has no readings of the bar.
std::optional<double> compensated_circularity(const machine::RotationOrder& order, const measure::Run& run,
                                              const physics::ForceModel& forces,
                                              const CompensatedOptions& options = {});

/// The same without compensation: what was measured.
std::optional<double> measured_circularity(const measure::Run& run);

}  // namespace plumbline::diagnose

// The next circular test: the one that would best separate two models that the data do not tell apart.
#pragma once

#include <optional>
#include <string>

#include "identify/equations/noise.hpp"
#include "machine/model.hpp"
#include "measure/dataset.hpp"
#include "physics/force_model.hpp"

namespace plumbline::diagnose {

struct NextTestOptions {
  double radius = 0.144;    // m, used if no run says otherwise
  double off_centre = 0.1;  // m, how far from the middle of the travel circles are laid
  double tilt_share = 0.8;  // of the limit of tilt
  std::vector<double> feeds_mm_min{1000, 6000};
  std::vector<double> payloads_kg{0, 20};
  double most_off = 1e-3;        // m, that the tip may be off in a test with either model (identify::stands_firm)
  int samples = 24;              // of each test that is tried
  double both_axes = 0.7;        // of that tilt in A and B, where a test is tilted about both
  double clearly_better = 1.02;  // times as far apart must a test show the two that is less simple than another
  double least_separation = 1;   // sigma: a test that shows less separates nothing
};

struct NextTest {
  measure::Run run;       // its design: no readings
  double separation = 0;  // distance of the two models' readings in units of the noise, the set-up fitted, for a run of
                          // as many samples as those measured
};

/// The best of a grid of centres, tilts, directions, feeds and payloads within the machine's limits, as `like` was
/// measured (radius, bar, channels). Nothing if no test can be made, or none separates the two by a sigma.
std::optional<NextTest> next_test(const machine::MachineModel& machine, const physics::ForceModel& one,
                                  const physics::ForceModel& other, const measure::Run& like,
                                  const identify::NoiseModel& noise, const NextTestOptions& options = {});

}  // namespace plumbline::diagnose

// Runs that have something in common.
#pragma once

#include <string_view>

#include "diagnose/gap/channels.hpp"
#include "machine/orientation.hpp"

namespace plumbline::diagnose {

/// What runs have in common. The text says the unit, too: "tilt_deg", "feed_mm_min", "payload_kg", "start_h".
enum class Grouping { tilt, feed, payload, start };
std::string_view to_text(Grouping grouping);

struct RunGroup {
  Grouping by = Grouping::tilt;
  double from = 0;
  double to = 0;
  int runs = 0;
  BarAndTorque rms;
};

struct GroupOptions {
  std::vector<double> tilts_deg{0, 5, 15, 90};  // edges of the groups
  int start_groups = 3;                         // parts of the time from the first run to the last
};

/// By tilt, feed, payload and, if runs were made at several times, by time.
std::vector<RunGroup> groups_of(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                                const std::vector<identify::RunEquations>& residuals, const GroupOptions& options = {});

}  // namespace plumbline::diagnose

// Where the machine at rest stands when it is sent to a pose: the error of the tool tip and what makes it, as a table.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/files/files.hpp"
#include "jobs/pose_table.hpp"
#include "machine/model.hpp"

namespace plumbline::jobs {

struct ErrorTableSummary {
  std::uint64_t poses = 0;
  double largest_um = 0;  // distance of the tip from its pose
};

/// Writes one row per pose: the pose, commanded strut lengths (mm), nut tensions (N), stretches (um), the error of the
/// tip (um) and its rotation vector (urad), in W. No friction, no limits. Refuses with error-unreachable a pose where
/// the machine cannot stand, and what physics::ForceModel refuses.
ErrorTableSummary write_error_table(const machine::MachineModel& model, std::span<const PoseRow> poses,
                                    OutputFile& out);

}  // namespace plumbline::jobs

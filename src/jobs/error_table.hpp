// Where the machine at rest stands when it is sent to a pose: the error of the tool tip and what makes it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "base/diagnostic.hpp"
#include "jobs/expected/expected_error.hpp"
#include "jobs/pose_table.hpp"
#include "machine/model.hpp"

namespace plumbline::jobs {

/// A pose, and how the machine stands there.
struct PoseError {
  AxisWords pose;                         // asked for, mm and deg
  machine::PerStrut<double> lengths;      // commanded, m
  machine::PerStrut<double> nut_tension;  // N
  machine::PerStrut<double> stretch;      // m
  machine::Vector6<double> error;         // of the tip (m) and its rotation vector (rad), in W
  std::optional<PoseDoubt> doubt;         // how far the tip may be from there; the zero is in the middle of the travel
};

struct ErrorTableSummary {
  std::uint64_t poses = 0;
  std::uint64_t beyond_travel = 0;         // of them
  std::optional<Diagnostic> first_beyond;  // a warning of the first
  double largest_um = 0;                   // distance of the tip from its pose
  std::optional<ExpectedError> expected;
};

/// Hands over pose after pose. No friction; poses beyond the limits are counted. `known`: where it is not null, how far
/// the tip may be from where it says comes with each. Refuses with error-unreachable a pose where the machine cannot
/// stand, and what physics::ForceModel refuses.
ErrorTableSummary error_table(const machine::MachineModel& model, std::span<const PoseRow> poses,
                              const std::function<void(const PoseError&)>& take,
                              const identify::Posterior* known = nullptr);

}  // namespace plumbline::jobs

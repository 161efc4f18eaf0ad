// Where a machine is to be trusted: error, stiffness, condition, forces and uncertainty over its workspace.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/axes.hpp"
#include "base/progress.hpp"
#include "jobs/spread.hpp"
#include "machine/model.hpp"

namespace plumbline::jobs {

struct MapOptions {
  std::array<std::optional<machine::Range>, 3> box;  // m; an axis without one: the model's travel
  std::optional<double> step;  // m, the most between two points; none: a twentieth of the longest side
  std::vector<double> planes;  // m, the Z to look at in place of steps; empty: steps
  std::vector<AxisWords> tilts = {AxisWords{}};  // A, B, C in deg; X, Y, Z of them mean nothing
};

/// The points of each axis, m, ascending.
struct WorkspaceGrid {
  std::array<std::vector<double>, 3> axes;
  std::vector<AxisWords> tilts;

  std::uint64_t poses() const { return tilts.size() * axes[0].size() * axes[1].size() * axes[2].size(); }
};

/// The box with both of its ends, its sides divided evenly. Refuses with map-box a box without a width, with map-step a
/// step that is not positive or gives more than 1e9 poses.
WorkspaceGrid workspace_grid(const machine::MachineModel& model, const MapOptions& options);

/// A pose of the grid and how the machine at rest stands there, as the model has it, corrected by nothing.
struct MapCell {
  AxisWords pose;                // mm, deg
  std::vector<std::string> out;  // the limits that keep the machine from it: "strut 3 too long"; empty: in reach
  // of poses in reach alone
  Vector3<double> error = Vector3<double>::Zero();  // of the tip, m in W
  double stiffness = 0;                             // of the tip in its softest direction, N/m
  double condition = 0;                             // of the Jacobian, lengths over the platform radius
  double largest_force = 0;                         // the largest nut tension of a strut without its sign, N
  double uncertainty = 0;                           // of the tip, 1 sigma, the root of X, Y and Z's variances summed, m
  double touched_off = 0;  // that of the distance to the middle of the travel, not tilted: a zero touched off there

  bool reached() const { return out.empty(); }
};

/// What is said of all cells in reach.
struct MapFigure {
  Spread spread;
  AxisWords worst;  // where it is worst: the largest, of the stiffness the least
};

struct MapSummary {
  std::uint64_t poses = 0;
  std::uint64_t reached = 0;
  std::map<std::string, std::uint64_t> out;  // how many poses each limit keeps the machine from
  bool has_uncertainty = false;              // the model has an [uncertainty] that says something
  MapFigure error, stiffness, condition, force, uncertainty, touched_off;  // SI
};

/// Whether the model's [uncertainty] says anything.
bool knows_uncertainty(const machine::MachineModel& model);

/// Hands over cell after cell: tilt by tilt, plane by plane, Y by Y, X fastest. No friction; a pose is out of reach
/// where it breaks a limit, lies on the other side of a singularity than the middle of the travel, or where the machine
/// gives way. Refuses with map-middle a machine that gives way in that middle. Uncertainty is that of [uncertainty] at
/// rest, all its quantities independent. Memory does not grow with the grid. Refuses as workspace_grid and
/// physics::ForceModel do.
MapSummary map_workspace(const machine::MachineModel& model, const MapOptions& options,
                         const std::function<void(const MapCell&)>& take, const Progress& progress = {});

}  // namespace plumbline::jobs

// A map of the workspace: a table as CSV, and words.
#pragma once

#include <string>

#include "base/files/files.hpp"
#include "jobs/workspace_map.hpp"

namespace plumbline::report {

inline constexpr double kNewtonPerMicrometre = 1e6;  // N/m

/// "21.2 um", "2358 um" of metres.
std::string round_um_text(double metres);

/// "X-300 Y300 Z-800 A0 B0 C0"
std::string pose_text(const AxisWords& pose);

/// Writes a row for every pose: the pose (mm, deg), whether it is in reach, the limits that keep the machine from it,
/// and of those in reach the error of the tip (um) with its parts in W, the least stiffness (N/um), the condition
/// number, the largest force of a strut (N) and, if the model says how sure it is, the uncertainty of the tip (um).
class MapTable {
 public:
  /// Writes the names of the columns. `output` is kept by reference.
  MapTable(OutputFile& output, bool has_uncertainty);
  void add(const jobs::MapCell& cell);

 private:
  OutputFile& output_;
  bool has_uncertainty_;
  std::string row_;
};

/// How much is in reach and why not the rest, and each figure's spread and worst place; lines. Of the figure that
/// counts most, the uncertainty, what share of the reach is `within` (m); none: what nineteen twentieths are within.
std::string map_text(const jobs::MapSummary& summary);

}  // namespace plumbline::report

// Poses of the tool tip as a tracker saw them: the machine sent to a pose, standing there, measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/files/source.hpp"
#include "base/pose.hpp"
#include "machine/orientation.hpp"

namespace plumbline::measure {

/// One pose. SI.
struct TrackedPose {
  Vector3<double> position_W = Vector3<double>::Zero();  // that the tip was sent to, m
  Vector3<double> tilt = Vector3<double>::Zero();        // and A, B, C, rad
  double payload_mass = 0;                               // known, suspended from the tool tip, kg
  Vector3<double> measured = Vector3<double>::Zero();    // where the tracker saw the tip, in its own frame, m
  std::optional<Vector3<double>> measured_tilt;          // A, B, C in its frame, rad
  Place place;                                           // its row

  Pose<double> commanded(const machine::RotationOrder& order) const {
    return {position_W, machine::rotation<double>(order, tilt)};
  }
};

struct TrackedPoses {
  std::string file;
  std::string text;  // of the file
  std::vector<TrackedPose> poses;

  bool has_tilt() const { return !poses.empty() && poses.front().measured_tilt.has_value(); }
};

struct TrackerTableOptions {
  std::size_t fewest_poses = 4;  // three lay the tracker's frame
};

/// Reads the columns x_mm,y_mm,z_mm,a_deg,b_deg,c_deg (commanded) and measured_x_mm,measured_y_mm,measured_z_mm; where
/// they are there measured_a_deg,measured_b_deg,measured_c_deg and payload_kg. Refuses with csv-header, csv-columns,
/// csv-number, tracker-tilt-part (some of the measured angles, not all) or tracker-too-few.
TrackedPoses read_tracked_poses(const Source& source, const TrackerTableOptions& options = {});

}  // namespace plumbline::measure

// Poses of the tool tip from a CSV file.
#pragma once

#include <string>
#include <vector>

#include "base/axes.hpp"
#include "base/diagnostic.hpp"
#include "base/files/source.hpp"

namespace plumbline::jobs {

struct PoseRow {
  AxisWords pose;  // tool tip in W, mm and deg
  Place place;     // of the row
};

/// Reads the columns x_mm,y_mm,z_mm,a_deg,b_deg,c_deg, found by the names of the first line; others are left out.
/// Refuses with csv-header, csv-columns, csv-number or csv-no-rows and the place.
std::vector<PoseRow> read_poses(const Source& source);

}  // namespace plumbline::jobs

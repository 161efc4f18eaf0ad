#include "measure/tracker.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/input_name.hpp"
#include "base/text/number_table.hpp"
#include "base/units.hpp"

namespace plumbline::measure {
namespace {

constexpr std::string_view kHeader =
    "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,measured_x_mm,measured_y_mm,measured_z_mm"
    ",measured_a_deg,measured_b_deg,measured_c_deg,payload_kg";
constexpr std::size_t kMeasured = 6;
constexpr std::size_t kMeasuredTilt = 9;
constexpr std::size_t kPayloadColumn = 12;

const std::vector<NumberColumn>& columns() {
  static const std::vector<NumberColumn> all{{"x_mm", "mm"},
                                             {"y_mm", "mm"},
                                             {"z_mm", "mm"},
                                             {"a_deg", "deg"},
                                             {"b_deg", "deg"},
                                             {"c_deg", "deg"},
                                             {"measured_x_mm", "mm"},
                                             {"measured_y_mm", "mm"},
                                             {"measured_z_mm", "mm"},
                                             {"measured_a_deg", "deg", false},
                                             {"measured_b_deg", "deg", false},
                                             {"measured_c_deg", "deg", false},
                                             {"payload_kg", "kg", false}};
  return all;
}

Vector3<double> three(const NumberTable::Row& row, std::size_t first, double unit) {
  return {row.values[first] * unit, row.values[first + 1] * unit, row.values[first + 2] * unit};
}

TrackedPose pose_of(const NumberTable::Row& row, const NumberTable& table) {
  TrackedPose pose;
  pose.position_W = three(row, 0, kMm);
  pose.tilt = three(row, 3, kDeg);
  pose.measured = three(row, kMeasured, kMm);
  if (table.has[kMeasuredTilt]) pose.measured_tilt = three(row, kMeasuredTilt, kDeg);
  if (table.has[kPayloadColumn]) pose.payload_mass = row.values[kPayloadColumn];
  pose.place = row.place;
  return pose;
}

}  // namespace

TrackedPoses read_tracked_poses(const Source& source, const TrackerTableOptions& options) {
  TrackedPoses tracked;
  tracked.file = source.name();
  tracked.text = read_text(source);
  const NumberTable table =
      read_number_table(tracked.file, tracked.text, columns(), kHeader.substr(0, kHeader.find(",measured_a")));
  const auto angles = std::count(table.has.begin() + kMeasuredTilt, table.has.begin() + kPayloadColumn, true);
  if (angles != 0 && angles != 3) {
    refuse("tracker-tilt-part", "the tracker's angles are given in part",
           "name all of measured_a_deg, measured_b_deg and measured_c_deg, or none", table.header);
  }
  for (const NumberTable::Row& row : table.rows) tracked.poses.push_back(pose_of(row, table));
  if (tracked.poses.size() < options.fewest_poses) {
    refuse("tracker-too-few", fmt::format("{} poses are too few", tracked.poses.size()),
           fmt::format("a tracker's table needs at least {} poses, best 50 and more, tilted every way",
                       options.fewest_poses),
           table.header);
  }
  return tracked;
}

}  // namespace plumbline::measure

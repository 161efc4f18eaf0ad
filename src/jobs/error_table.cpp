#include "jobs/error_table.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "jobs/csv_columns.hpp"
#include "machine/axis_words.hpp"
#include "physics/error.hpp"

namespace plumbline::jobs {
namespace {

constexpr int kPoseDecimals = 3;

constexpr std::string_view kErrorColumns =
    "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,"
    "length1_mm,length2_mm,length3_mm,length4_mm,length5_mm,length6_mm,"
    "nut_tension1_N,nut_tension2_N,nut_tension3_N,nut_tension4_N,nut_tension5_N,nut_tension6_N,"
    "stretch1_um,stretch2_um,stretch3_um,stretch4_um,stretch5_um,stretch6_um,"
    "dx_um,dy_um,dz_um,rx_urad,ry_urad,rz_urad\n";

void append_pose(std::string& line, const AxisWords& pose) {
  for (const Axis axis : kAllAxes) {
    if (axis != Axis::X) line += ',';
    append_decimal(line, pose[axis], kMostDecimals, kPoseDecimals);
  }
}

[[noreturn]] void refuse_pose(const PoseRow& row, std::string_view why) {
  refuse("error-unreachable", fmt::format("the machine cannot stand at this pose: {}", why),
         "the pose lies at or beyond a singularity of the machine; leave it out or check its units (mm, deg)",
         row.place);
}

}  // namespace

ErrorTableSummary write_error_table(const machine::MachineModel& model, std::span<const PoseRow> poses,
                                    OutputFile& out) {
  const physics::ForceModel forces(model);
  physics::Environment at_rest = forces.environment();
  at_rest.friction = false;
  ErrorTableSummary summary;
  std::string line(kErrorColumns);
  out.write(line);
  for (const PoseRow& row : poses) {
    physics::Motion<double> motion;
    motion.pose = machine::pose_of(model.rotation, row.pose);
    const physics::TipError<double> error = physics::tip_error(forces, at_rest, motion);
    if (!error.converged()) refuse_pose(row, physics::to_text(error.stopped_because));
    const auto lengths = machine::strut_lengths<double>(model.geometry, motion.pose);
    line.clear();
    append_pose(line, row.pose);
    append_columns(line, lengths, kMm, 9);
    append_columns(line, error.loads.nut_tension, 1, 7);
    append_columns(line, error.loads.stretch, kUm, 8);
    append_columns(line, error.displacement.head<3>(), kUm, 8);
    append_columns(line, error.displacement.tail<3>(), kUrad, 8);
    line += '\n';
    out.write(line);
    ++summary.poses;
    summary.largest_um = std::max(summary.largest_um, error.displacement.head<3>().norm() / kUm);
  }
  return summary;
}

}  // namespace plumbline::jobs

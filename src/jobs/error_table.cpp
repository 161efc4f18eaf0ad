#include "jobs/error_table.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "base/units.hpp"
#include "machine/axis_words.hpp"
#include "physics/error.hpp"

namespace plumbline::jobs {
namespace {

[[noreturn]] void refuse_pose(const PoseRow& row, std::string_view why) {
  refuse("error-unreachable", fmt::format("the machine cannot stand at this pose: {}", why),
         "the pose lies at or beyond a singularity of the machine; leave it out or check its units (mm, deg)",
         row.place);
}

}  // namespace

ErrorTableSummary error_table(const machine::MachineModel& model, std::span<const PoseRow> poses,
                              const std::function<void(const PoseError&)>& take) {
  const physics::ForceModel forces(model);
  physics::Environment at_rest = forces.environment();
  at_rest.friction = false;
  ErrorTableSummary summary;
  for (const PoseRow& row : poses) {
    physics::Motion<double> motion;
    motion.pose = machine::pose_of(model.rotation, row.pose);
    const physics::TipError<double> error = physics::tip_error(forces, at_rest, motion);
    if (!error.converged()) refuse_pose(row, physics::to_text(error.stopped_because));
    take({row.pose, machine::strut_lengths<double>(model.geometry, motion.pose), error.loads.nut_tension,
          error.loads.stretch, error.displacement});
    ++summary.poses;
    summary.largest_um = std::max(summary.largest_um, error.displacement.head<3>().norm() / kUm);
  }
  return summary;
}

}  // namespace plumbline::jobs

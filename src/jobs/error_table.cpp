#include "jobs/error_table.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/parallel.hpp"
#include "base/units.hpp"
#include "machine/axis_words.hpp"
#include "machine/limits.hpp"
#include "physics/error.hpp"

namespace plumbline::jobs {
namespace {

[[noreturn]] void refuse_pose(const PoseRow& row, std::string_view why) {
  refuse("error-unreachable", fmt::format("the machine cannot stand at this pose: {}", why),
         "the pose lies at or beyond a singularity of the machine; leave it out or check its units (mm, deg)",
         row.place);
}

// Warns of poses where the model holds and the machine does not come.
void note_limits(const machine::MachineModel& model, const PoseRow& row, ErrorTableSummary& summary) {
  const Pose<double> pose = machine::pose_of(model.rotation, row.pose);
  const std::vector<machine::Violation> broken = machine::check_compensated(model.limits, model.geometry, pose);
  if (broken.empty()) return;
  ++summary.beyond_travel;
  if (summary.first_beyond) return;
  summary.first_beyond =
      Diagnostic{"error-beyond-travel", fmt::format("{} at this pose", machine::to_text(broken.front())),
                 "the figures hold for a machine that could go there: look at [limits] and [strut] of the model",
                 row.place, Severity::warning};
}

constexpr std::size_t kPosesTogether = 512;  // poses that are looked at on all processors together

// How far the tip may be from where a table says, with a zero in the middle of the travel.
class Doubts {
 public:
  Doubts(const machine::MachineModel& model, const identify::Posterior& known)
      : known_(known), doubts_(model, known, at_rest()) {
    const Pose<double> home = machine::home_pose(model);
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
      zero_[axis] = home.p_WT[static_cast<Eigen::Index>(index(axis))] / kMm;
    doubts_.touch_off(zero_);
  }

  void add_to(std::span<PoseError> batch) const {
    for_each_index(batch.size(), [&](std::size_t i) {
      compensate::Target target;
      target.pose = batch[i].pose;
      batch[i].doubt = doubts_.at(target);
    });
  }
  void note(const PoseError& pose) {
    if (pose.doubt) tally_.add(*pose.doubt, {}, 1);
  }
  std::optional<ExpectedError> take() {
    return tally_.any() ? std::optional(tally_.take(known_, zero_)) : std::nullopt;
  }

 private:
  static compensate::Settings at_rest() {
    compensate::Settings settings;
    settings.friction = false;
    return settings;
  }

  const identify::Posterior& known_;
  TipDoubts doubts_;
  AxisWords zero_;
  ExpectedTally tally_;
};

PoseError pose_error(const machine::MachineModel& model, const physics::ForceModel& forces,
                     const physics::Environment& at_rest, const PoseRow& row) {
  physics::Motion<double> motion;
  motion.pose = machine::pose_of(model.rotation, row.pose);
  const physics::TipError<double> error = physics::tip_error(forces, at_rest, motion);
  if (!error.converged()) refuse_pose(row, physics::to_text(error.stopped_because));
  return {row.pose,
          machine::strut_lengths<double>(model.geometry, motion.pose),
          error.loads.nut_tension,
          error.loads.stretch,
          error.displacement,
          {}};
}

}  // namespace

ErrorTableSummary error_table(const machine::MachineModel& model, std::span<const PoseRow> poses,
                              const std::function<void(const PoseError&)>& take, const identify::Posterior* known) {
  const physics::ForceModel forces(model);
  physics::Environment at_rest = forces.environment();
  at_rest.friction = false;
  std::optional<Doubts> doubts;
  if (known != nullptr) doubts.emplace(model, *known);
  ErrorTableSummary summary;
  std::vector<PoseError> batch;
  for (; !poses.empty(); poses = poses.subspan(batch.size())) {
    batch.clear();
    for (const PoseRow& row : poses.first(std::min(kPosesTogether, poses.size()))) {
      batch.push_back(pose_error(model, forces, at_rest, row));
      note_limits(model, row, summary);
    }
    if (doubts) doubts->add_to(batch);
    for (const PoseError& error : batch) {
      take(error);
      if (doubts) doubts->note(error);
      ++summary.poses;
      summary.largest_um = std::max(summary.largest_um, error.error.head<3>().norm() / kUm);
    }
  }
  if (doubts) summary.expected = doubts->take();
  return summary;
}

}  // namespace plumbline::jobs

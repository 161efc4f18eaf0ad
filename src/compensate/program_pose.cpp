#include "compensate/program_pose.hpp"

#include "base/units.hpp"

namespace plumbline::compensate {

std::optional<ToolInSpindle> SpindleTool::change(const nc::Step& step) {
  const AxisWords& offset = step.frame->tool;
  const int number = (step.moves_old_tool ? step.before : step.after)->tool_in_spindle;
  if (offset_ == offset && number == number_) return std::nullopt;
  offset_ = offset;
  number_ = number;
  const nc::Tool* const row = number >= 0 ? tools_.find(number) : nullptr;
  has_mass_ = number < 0 || (row != nullptr && row->mass_kg);
  ToolInSpindle tool{offset[Axis::Z] * kMm, reference_mass_, 0};
  if (row != nullptr && row->mass_kg) {
    tool.mass = *row->mass_kg;
    tool.along = row->centre_of_mass_mm.value_or(0) * kMm;
  }
  return tool;
}

void ProgramPose::take(const nc::Step& step) {
  if (step.frame->tilted == tilted_) return;
  tilted_ = step.frame->tilted;
  if (on_fixed) on_fixed(fixed());
}

AxisSet ProgramPose::assumed(const nc::Step& step, AxisSet unknown) {
  if ((unknown & AxisSet::rotary()).empty()) return {};
  if (!assumed_) {
    assumed_ = AxisSet::rotary() - nc::named_axes(source_, dialect_);
    if (on_fixed) on_fixed(fixed());
  }
  AxisSet assumed = unknown & *assumed_;
  const AxisWords origin = step.frame->to_pose({});
  for (const Axis axis : kAllAxes) {
    if (origin[axis] != 0) assumed.erase(axis);
  }
  return assumed;
}

Target ProgramPose::target(const nc::Step& step, const path::CurvePoint& point, std::optional<double> seconds) const {
  AxisWords work = point.at;
  for (const Axis axis : kAllAxes) {
    if (assumed().contains(axis)) work[axis] = 0;
  }
  return {step.frame->to_pose(work), step.frame->turned(point.slope), step.frame->turned(point.bend), seconds};
}

}  // namespace plumbline::compensate

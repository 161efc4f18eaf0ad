#include "compensate/recorded/drawn_path.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel.hpp"
#include "machine/displacement.hpp"
#include "machine/inverse.hpp"

namespace plumbline::compensate {
namespace {

constexpr std::size_t kPointsATime = 64;  // points that one thread takes at once

DrawnPoint drawn(const LoadedMachine& machine, RecordedPoint recorded) {
  DrawnPoint point;
  const physics::Motion<double> asked = machine.motion(recorded.asked);
  Target told = recorded.asked;
  told.pose = recorded.commanded;
  const physics::Motion<double> commanded = machine.motion(told);
  const physics::TipError<double> uncorrected = machine.error(asked);
  const physics::TipError<double> played = machine.error(commanded);
  point.uncorrected = uncorrected.displacement;
  point.left = machine::displacement_between<double>(asked.pose, played.pose);
  point.tension = played.loads.nut_tension;
  point.lengths = machine::strut_lengths(machine.geometry(), commanded.pose);
  point.condition = machine.condition(commanded.pose);
  point.stands = commanded.pose;
  point.tip_z = machine.geometry().tool_tip_P.z();
  point.gives_way = !uncorrected.converged() || !played.converged();
  point.recorded = std::move(recorded);
  return point;
}

}  // namespace

DrawnPath drawn_path(PathRecord& record, const machine::MachineModel& model, const Settings& settings,
                     const OutputText& text) {
  DrawnPath path;
  path.of_points = record.count();
  std::vector<RecordedPoint> points = record.take();
  std::vector<LoadedMachine> machines{LoadedMachine(model, settings)};  // one a tool, in their order
  std::vector<std::size_t> machine_of;
  std::optional<ToolInSpindle> tool;
  for (RecordedPoint& recorded : points) {
    if (recorded.in_spindle != tool) machines.emplace_back(model, settings).set_tool(*(tool = recorded.in_spindle));
    machine_of.push_back(machines.size() - 1);
    const std::uint64_t bytes = std::min<std::uint64_t>(recorded.after_end - recorded.after_begin, 4 * kMostText);
    if (text && bytes > 0) recorded.after = text(recorded.after_begin, recorded.after_begin + bytes);
  }
  path.points.resize(points.size());
  for_each_index((points.size() + kPointsATime - 1) / kPointsATime, [&](std::size_t group) {
    const std::size_t end = std::min(points.size(), (group + 1) * kPointsATime);
    for (std::size_t i = group * kPointsATime; i < end; ++i)
      path.points[i] = drawn(machines[machine_of[i]], std::move(points[i]));
  });
  return path;
}

DrawnPath drawn_path(PathRecord& record) {
  DrawnPath path{{}, record.count(), false};
  for (RecordedPoint& recorded : record.take()) path.points.emplace_back().recorded = std::move(recorded);
  return path;
}

}  // namespace plumbline::compensate

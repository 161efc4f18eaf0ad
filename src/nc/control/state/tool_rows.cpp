#include "nc/control/state/tool_rows.hpp"

#include <cstddef>

namespace plumbline::nc {
namespace {

// #5400 is the tool in the spindle, those after it are its row [LinuxCNC, "Numbered Parameters"].
constexpr int kNumber = 5400, kOffset = 5401, kDiameter = 5410, kDetails = 5411;

}  // namespace

std::optional<AxisWords> offset_of_tool(const Control& control, const ProgramSettings& settings, int number) {
  AxisWords offset;
  if (number == 0) return offset;
  if (const auto written = control.tools.find(number); written != control.tools.end()) return written->second.offset;
  const Tool* const tool = settings.tools.find(number);
  if (tool == nullptr && !settings.as_with_empty_tables) return std::nullopt;
  if (tool != nullptr) offset[Axis::Z] = tool->length_mm;
  return offset;
}

std::optional<double> tool_parameter(const Control& control, const ProgramSettings& settings, int number) {
  const bool empty_tables = settings.as_with_empty_tables;
  const int in_spindle = control.modal.tool_in_spindle;
  if (in_spindle < 0) return empty_tables ? std::optional(0.0) : std::nullopt;
  if (number == kNumber) return in_spindle;
  if (number < kDiameter) {
    const std::optional<AxisWords> offset = offset_of_tool(control, settings, in_spindle);
    const auto at = static_cast<std::size_t>(number - kOffset);
    if (!offset) return std::nullopt;
    return at < kAxes ? offset->values[at] : 0;
  }
  std::optional<double> value;
  const auto written = control.tools.find(in_spindle);
  const Tool* const tool = settings.tools.find(in_spindle);
  if (written != control.tools.end()) {
    const ToolRow& row = written->second;
    value = number == kDiameter ? row.diameter_mm : row.details.at(static_cast<std::size_t>(number - kDetails));
  } else if (tool != nullptr && number == kDiameter) {
    value = tool->diameter_mm;
  }
  return value || (!empty_tables && in_spindle != 0) ? value : 0;
}

}  // namespace plumbline::nc

// Jobs with a tool whose weight bends the machine.
#pragma once

#include <string>

#include "compensate/play.hpp"

namespace plumbline {

inline constexpr compensate::ToolInSpindle kHeavyTool{0.1, 2, 0};

/// With that tool in the spindle, and `free` for what a direction of the tool leaves open.
inline Job heavy_tool_job(const std::string& dialect, nc::FreeRotation free) {
  Job job;
  job.dialect = dialect;
  job.settings.friction = false;
  job.settings.step.length_mm = 5;
  job.settings.step.angle_deg = 5;
  job.program.tool_in_spindle = 1;
  job.program.free_rotation = free;
  job.program.tools = one_tool(2);
  return job;
}

}  // namespace plumbline

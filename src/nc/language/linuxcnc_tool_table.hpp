// LinuxCNC's own tool table, tool.tbl.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nc/language/tool_table.hpp"

namespace plumbline::nc {

/// Whether the first line that is no comment begins with a word of a tool, as T and a digit, or is the head of the old
/// form of such a table (POC FMS LEN DIAM), which is refused.
bool is_linuxcnc_tool_table(std::string_view text);

/// A line a tool: words between blanks, T its number, P its pocket, Z its length and D its diameter in mm; I, J and Q
/// are for lathes; `;` begins a comment. T0 is no tool. (LinuxCNC's src/emc/tooldata/tooldata_common.cc.) What it would
/// skip, or read in part, is refused with tools-value or tools-twice, and so are offsets beside that of Z.
std::vector<Tool> read_linuxcnc_tool_table(std::string_view text, const std::string& file);

}  // namespace plumbline::nc

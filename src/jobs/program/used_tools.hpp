// Which tools of the table a program may use.
#pragma once

#include <vector>

#include "base/files/files.hpp"
#include "nc/language/tool_table.hpp"

namespace plumbline::jobs {

/// The tools whose number or name follows a T, H or Q anywhere in the program's text, comments left out, or in
/// that of a file beside it whose name it holds, and the one in the spindle; all of the table where one of these
/// letters takes an expression. More rather than fewer: the program is not executed.
std::vector<nc::Tool> used_tools(const InputFile& program, const nc::ToolTable& tools,
                                 std::optional<int> tool_in_spindle);

/// True if G92.3 stands in these texts, or a G code that is an expression.
bool may_restore_g92(const InputFile& program);

}  // namespace plumbline::jobs

// Lines at the start of a compensated program that stop the control when it is not set as the program was made for.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "nc/program.hpp"

namespace plumbline::jobs {

/// What the lines compare: G54 active, no G92 and no tool offset in force; origin and rotation of each work system that
/// `program` gives; the length of each of `tools` in the control's tool table; the position of the rotary axes in
/// `assumed`, which the program never names. A difference of more than 0.001 mm or 0.001 deg shows a message and ends
/// the program (M2). They move nothing and leave G54 and G49 in force, as at the start of a program. Refuses with
/// guard-dialect where the control's language cannot say this, and guard-g92 where a G92 offset was given.
std::vector<std::string> guard_block(const nc::ProgramSettings& program, std::span<const nc::Tool> tools,
                                     AxisSet assumed, const nc::Dialect& dialect);

}  // namespace plumbline::jobs

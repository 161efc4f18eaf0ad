// Lines at the start of a compensated program that stop the control when it is not set as the program was made for.
#pragma once

#include <string>
#include <vector>

#include "base/files/files.hpp"
#include "compensate/program_survey.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::jobs {

/// The language of the control decides what the lines compare (guards.hpp). LinuxCNC: G54 active, no G92 and no tool
/// offset in force; origin and rotation of each work system that `program` gives; the length of each tool that it may
/// use in the control's tool table; the position of the rotary axes that it never names. A difference of more than
/// 0.001 mm or 0.001 deg shows a message and ends the program (M2). They move nothing and leave G54 and G49 in force,
/// as at the start of a program. Refuses with guard-dialect and guard-system where no source says how to ask the
/// control, and guard-g92 where a G92 offset was given.
std::vector<std::string> guard_block(const nc::ProgramSettings& program, const compensate::ProgramSurvey& survey);

/// Refuses with guard-definitions where the program begins with what nothing may stand before: DEF and PROC of Siemens.
void refuse_guard_before_definitions(const InputFile& source, const nc::Dialect& dialect);

}  // namespace plumbline::jobs

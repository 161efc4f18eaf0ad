// Lines at the start of a compensated program that stop the control when it is not set as the program was made for.
#pragma once

#include <string>
#include <vector>

#include "base/files/files.hpp"
#include "compensate/program_survey.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::jobs {

/// The language of the control decides what the lines compare (guards.hpp). LinuxCNC: the work system in force and G92,
/// as they were given; no tool offset in force; the unit, distance mode and feed mode that the program does not state
/// before its first move; the tool in the spindle if it was given; the position of the rotary axes that the program
/// never names, and of those whose start was given and that its first move does not reach by itself; origin and
/// rotation of each work system; the offset of each tool that it may use in the control's tool table. A difference of
/// more than 0.001 mm or 0.001 deg shows a message and ends the program (M2). They move nothing and leave work system,
/// G92 and G49 as the program was made for. Refuses with guard-dialect and guard-system where no source says how to ask
/// the control, guard-g92 where a G92 offset is in force of which not all values were given, and guard-unit where a
/// Fanuc control begins in inches.
std::vector<std::string> guard_block(const nc::ProgramSettings& program, const compensate::ProgramSurvey& survey);

/// Refuses with guard-definitions where the program begins with what nothing may stand before: DEF and PROC of Siemens.
void refuse_guard_before_definitions(const InputFile& source, const nc::Dialect& dialect);

}  // namespace plumbline::jobs

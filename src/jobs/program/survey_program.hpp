// What is found out about a program before it is executed, once for all who ask.
#pragma once

#include "compensate/program_survey.hpp"
#include "jobs/program/open_program.hpp"

namespace plumbline::jobs {

/// The axes that its words name, the tools of the settings' table that it may use (used_tools), and what it says of
/// itself before its first move (beginning_of).
compensate::ProgramSurvey survey_program(const OpenedProgram& program);

}  // namespace plumbline::jobs

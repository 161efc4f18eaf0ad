// What a program states before its first move, for a guard: the control brings the rest.
#pragma once

#include "compensate/program_survey.hpp"
#include "jobs/program/open_program.hpp"

namespace plumbline::jobs {

/// Of a program for LinuxCNC; of others nothing is found out. Read without executing it, up to its first block with a
/// feed or an axis; subprograms that stand before it are passed over. Rather less than more is taken as stated: nothing
/// behind a call, a branch, `/`, a parameter of the control that is read, or a code that is an expression.
compensate::Beginning beginning_of(const OpenedProgram& program);

}  // namespace plumbline::jobs

#include "jobs/program/survey_program.hpp"

#include "jobs/program/beginning.hpp"
#include "jobs/program/used_tools.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::jobs {

compensate::ProgramSurvey survey_program(const OpenedProgram& program) {
  return {program.dialect, nc::named_axes(program.file, program.dialect),
          used_tools(program.file, program.settings.tools, program.settings.tool_in_spindle), beginning_of(program)};
}

}  // namespace plumbline::jobs

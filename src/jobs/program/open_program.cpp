#include "jobs/program/open_program.hpp"

#include <utility>

#include "jobs/program/program_dialect.hpp"
#include "machine/model_file.hpp"
#include "settings/program_settings.hpp"

namespace plumbline::jobs {

OpenedProgram open_program(const settings::Options& options, const Source& source, nc::ProgramSettings settings) {
  InputFile file(source);
  const nc::Dialect& dialect = dialect_of(options, file);
  return {std::move(file), dialect, std::move(settings)};
}

OpenedProgram open_program(const settings::Options& options, const Source& source) {
  nc::ProgramSettings settings = settings::program_settings(options);
  if (!options.paths.model.empty()) settings.rotation_order = machine::read_model(options.paths.model).rotation.axes;
  settings.as_with_empty_tables = true;
  return open_program(options, source, std::move(settings));
}

OpenedProgram open_program(const settings::Options& options, const Source& source, const machine::MachineModel& model) {
  return open_program(options, source, settings::program_settings(options, model));
}

}  // namespace plumbline::jobs

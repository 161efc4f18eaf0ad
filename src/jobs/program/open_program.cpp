#include "jobs/program/open_program.hpp"

#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "jobs/program/program_dialect.hpp"
#include "machine/model_file.hpp"
#include "settings/program_settings.hpp"

namespace plumbline::jobs {
namespace {

// The control adds it to the offset of each work system.
void refuse_external_shift(const nc::Dialect& dialect, const settings::Options& options,
                           const nc::ProgramSettings& settings) {
  if (dialect.syntax.system_variables != nc::SystemVariables::macro_b) return;
  constexpr int kExternal = 5201;
  for (const auto& [number, value] : settings.variables) {
    if (number < kExternal || number >= kExternal + static_cast<int>(kAxes) || value == 0) continue;
    refuse("variables-offset", fmt::format("#{} shifts all work systems by {}, which is not added", number, value),
           "add it to the offsets of the work systems, and leave it out of the variables",
           Place{.file = options.paths.variables.name()});
  }
}

}  // namespace

OpenedProgram open_program(const settings::Options& options, const Source& source, nc::ProgramSettings settings) {
  InputFile file(source);
  const nc::Dialect& dialect = dialect_of(options, file);
  refuse_external_shift(dialect, options, settings);
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

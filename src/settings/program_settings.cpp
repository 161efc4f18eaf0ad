#include "settings/program_settings.hpp"

#include "settings/variables_file.hpp"

namespace plumbline::settings {

nc::ProgramSettings program_settings(const Options& options) {
  nc::ProgramSettings settings = options.program;
  if (!options.paths.variables.empty()) {
    settings.variables = read_variables(options.paths.variables);
    settings.work_offsets = work_offsets_of(settings.variables);
    for (std::size_t i = 0; i < settings.work_offsets.size(); ++i) {
      if (options.program.work_offsets[i]) settings.work_offsets[i] = options.program.work_offsets[i];
    }
  }
  if (!options.paths.tools.empty()) settings.tools = nc::read_tool_table(options.paths.tools);
  return settings;
}

nc::ProgramSettings program_settings(const Options& options, const machine::MachineModel& model) {
  nc::ProgramSettings settings = program_settings(options);
  settings.rotation_order = model.rotation.axes;
  return settings;
}

}  // namespace plumbline::settings

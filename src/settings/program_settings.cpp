#include "settings/program_settings.hpp"

#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "settings/variables_file.hpp"

namespace plumbline::settings {
namespace {

constexpr double kSameOffset = 1e-6;  // mm and deg: a variables file has six decimals

// A program that reads #5221 and up would take the file's, and its moves the offset that was given.
void refuse_other_offsets(const Options& options, const std::map<int, double>& variables) {
  for (const NamedSystem& system : options.offset_systems) {
    const auto& given = options.program.work_offsets[static_cast<std::size_t>(system.number - 1)];
    for (const OffsetVariable& held : offset_variables(system.number, variables)) {
      const double stated = held.axis ? given->origin[*held.axis] : given->rotation_deg;
      if (std::abs(held.value - stated) <= kSameOffset) continue;
      const std::string what = held.axis ? std::string(1, letter(*held.axis)) : "rotation";
      refuse("variables-offset",
             fmt::format("#{} says that {} of {} is {}, and --work-offset says {}", held.number, what, system.name,
                         held.value, stated),
             "leave --work-offset out, or correct the variables: the control has one of them",
             Place{.file = options.paths.variables.name()});
    }
  }
}

}  // namespace

nc::ProgramSettings program_settings(const Options& options) {
  nc::ProgramSettings settings = options.program;
  if (!options.paths.variables.empty()) {
    settings.variables = read_variables(options.paths.variables);
    refuse_other_offsets(options, settings.variables);
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

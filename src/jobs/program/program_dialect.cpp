#include "jobs/program/program_dialect.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "jobs/program/program_text.hpp"
#include "nc/language/recognise.hpp"
#include "settings/settings_file.hpp"

namespace plumbline::jobs {
namespace {

[[noreturn]] void refuse_system(const settings::NamedSystem& system, const nc::Dialect& dialect,
                                const std::string& program) {
  Place place = system.stated;
  if (place.file.empty()) place.file = program;
  refuse(
      "settings-work-system",
      fmt::format("a work offset is given for {}, which {} does not have, the control of {}", system.name, dialect.name,
                  program),
      fmt::format("its first work system is called {}; --dialect names another control; programs of several controls "
                  "need a folder and a plumbline.toml each",
                  dialect.name_of_system(1)),
      std::move(place));
}

}  // namespace

const nc::Dialect& dialect_of(const settings::Options& options, const InputFile& program) {
  refuse_unless_program_text(program);
  const nc::Dialect& dialect = options.dialect.empty() ? *nc::recognise(program).dialect : nc::dialect(options.dialect);
  for (const settings::NamedSystem& system : options.offset_systems) {
    if (dialect.system_of_name(system.name) != system.number) refuse_system(system, dialect, program.name());
  }
  const auto refuse_setting = [&](std::string_view code, std::string_view name, const std::string& why) {
    refuse(code, why,
           fmt::format("leave --{} ({} of the settings) out; --dialect names another control", name,
                       settings::key_of(name)),
           {program.name(), 0});
  };
  const nc::ControlBehaviour& behaviour = dialect.behaviour;
  const std::string counts_mm = fmt::format("numbers without a point count mm and deg for {}", dialect.name);
  const bool counts_units = behaviour.increment_mm == 0 || behaviour.increment_mm == 1;
  if (options.program.input_increment && behaviour.increment_mm == 0) {
    refuse_setting("settings-input-increment", "input-increment", counts_mm);
  }
  if (options.program.calculator_type && counts_units) {
    refuse_setting("settings-calculator-type", "calculator-type", counts_mm);
  }
  if (options.program.inches && !behaviour.unit_set_at_start) {
    refuse_setting("settings-unit", "unit", fmt::format("programs for {} that state no unit are in mm", dialect.name));
  }
  return dialect;
}

}  // namespace plumbline::jobs

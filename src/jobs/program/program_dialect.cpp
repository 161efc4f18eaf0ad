#include "jobs/program/program_dialect.hpp"

#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "jobs/program/program_text.hpp"
#include "nc/language/recognise.hpp"

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
  if (options.program.input_increment && dialect.behaviour.increment_mm == 0) {
    refuse("settings-input-increment", fmt::format("numbers without a point count mm and deg for {}", dialect.name),
           "leave --input-increment (input_increment of the settings) out; --dialect names another control",
           {program.name(), 0});
  }
  const bool counts_units = dialect.behaviour.increment_mm == 0 || dialect.behaviour.increment_mm == 1;
  if (options.program.calculator_type && counts_units) {
    refuse("settings-calculator-type", fmt::format("numbers without a point count mm and deg for {}", dialect.name),
           "leave --calculator-type (calculator_type of the settings) out; --dialect names another control",
           {program.name(), 0});
  }
  return dialect;
}

}  // namespace plumbline::jobs

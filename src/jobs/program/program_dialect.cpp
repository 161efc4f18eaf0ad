#include "jobs/program/program_dialect.hpp"

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "jobs/program/program_text.hpp"
#include "nc/language/recognise.hpp"

namespace plumbline::jobs {

const nc::Dialect& dialect_of(const settings::Options& options, const InputFile& program) {
  refuse_unless_program_text(program);
  const nc::Dialect& dialect = options.dialect.empty() ? *nc::recognise(program).dialect : nc::dialect(options.dialect);
  for (const auto& [name, system] : options.work_offset_names) {
    if (dialect.system_of_name(name) == system) continue;
    refuse(
        "settings-work-system",
        fmt::format("a work offset was given for {}, which {} does not have", name, dialect.name),
        fmt::format("its first work system is called {}; --dialect names another control", dialect.name_of_system(1)));
  }
  if (options.program.input_increment && dialect.behaviour.increment_mm == 0) {
    refuse("settings-input-increment", fmt::format("numbers without a point count mm and deg for {}", dialect.name),
           "leave --input-increment out; --dialect names another control");
  }
  return dialect;
}

}  // namespace plumbline::jobs

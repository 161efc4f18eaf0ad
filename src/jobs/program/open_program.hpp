// A program file opened as a command's options say.
#pragma once

#include <string>

#include "base/files/files.hpp"
#include "machine/model.hpp"
#include "nc/language/dialect.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {

struct OpenedProgram {
  InputFile file;
  const nc::Dialect& dialect;
  nc::ProgramSettings settings;
};

/// Opens `source` ("-": standard input), reads the tables that the options name, and takes the dialect that they say or
/// that the text shows. What nobody gave (offsets, tools, start) is zero; A, B and C turn in the order of the model
/// that the options name, else as ZYX. Refuses as InputFile, the readers of tables and models, and dialect_of do.
OpenedProgram open_program(const settings::Options& options, const Source& source);
/// The same for the machine of a model; what nobody gave stays open, so that the interpreter asks for it.
OpenedProgram open_program(const settings::Options& options, const Source& source, const machine::MachineModel& model);
/// The same with what was made of the options and the model before: once for many programs.
OpenedProgram open_program(const settings::Options& options, const Source& source, nc::ProgramSettings settings);

}  // namespace plumbline::jobs

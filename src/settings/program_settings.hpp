// What the interpreter is told.
#pragma once

#include "machine/model.hpp"
#include "nc/control/state/program_settings.hpp"
#include "settings/options.hpp"

namespace plumbline::settings {

/// The settings of the interpreter: tool table and variables file are read here. Refuses as their readers do.
nc::ProgramSettings program_settings(const Options& options);
/// The same for the machine of a model.
nc::ProgramSettings program_settings(const Options& options, const machine::MachineModel& model);

}  // namespace plumbline::settings

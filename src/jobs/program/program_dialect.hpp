// The dialect of a program: the one that was named, else the one that its text shows.
#pragma once

#include "base/files/files.hpp"
#include "nc/language/dialect.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {

/// Refuses with file-empty and file-not-text what is no program at all, with nc-unknown-dialect or
/// nc-dialect-ambiguous, and with settings-work-system where a work offset was given for a system that the dialect does
/// not have, settings-input-increment and settings-calculator-type where its numbers need no point, settings-unit where
/// its programs that state no unit are in mm.
const nc::Dialect& dialect_of(const settings::Options& options, const InputFile& program);

}  // namespace plumbline::jobs

// Where a compensated program goes if nobody says.
#pragma once

#include <string>

#include "settings/options.hpp"

namespace plumbline::jobs {

/// The output of a program by the pattern of the options; "-" for standard input. Only a compensated program is written
/// over there: refuses with file-exists where another file stands. Throws OptionError as settings::output_name does.
std::string output_of(const std::string& program, const settings::Options& options);

}  // namespace plumbline::jobs

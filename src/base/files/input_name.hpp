// How files that are read are named in what is said about them.
#pragma once

#include <string>

#include "base/files/files.hpp"

namespace plumbline {

/// The path; "<stdin>" of standard input.
inline std::string input_name(const std::string& path) { return path == kStandardStream ? "<stdin>" : path; }

}  // namespace plumbline

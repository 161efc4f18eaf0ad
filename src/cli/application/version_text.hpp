// What --version says.
#pragma once

#include <string>

namespace plumbline::cli {

/// "plumbline 0.1.0", and lines of how it was built: compiler, kind of build, system, instruction sets, libraries.
std::string version_text();

}  // namespace plumbline::cli

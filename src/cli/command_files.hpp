// The files that a command names.
#pragma once

#include <initializer_list>
#include <string>

namespace plumbline::cli {

/// No output may be a file that is read, or another output: links followed, before anything is opened. Empty names are
/// left out, "-" is standard input or output. Refuses with file-overwrites-input or file-written-twice.
void check_outputs(std::initializer_list<std::string> inputs, std::initializer_list<std::string> outputs);

}  // namespace plumbline::cli

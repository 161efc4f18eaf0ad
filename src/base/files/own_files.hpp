// Each output is a file of its own.
#pragma once

#include <string>
#include <vector>

namespace plumbline {

/// No output may be a file that is read, or another output: links followed, before anything is opened. Empty names are
/// left out, "-" is standard input or output. Refuses with file-overwrites-input or file-written-twice.
void refuse_shared_files(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

}  // namespace plumbline

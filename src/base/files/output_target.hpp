// Where the name of an output leads: to a file that takes its place, or to something that is written to.
#pragma once

#include <optional>
#include <string>

#include "base/platform/platform.hpp"

namespace plumbline {

struct OutputTarget {
  enum class Kind {
    file,        // a new file appears at `path`
    descriptor,  // an open file of this process: standard output, /dev/stdout, /dev/fd/3
    device,      // a pipe or a device at `path`
    taker,       // somebody who is handed the bytes; `path` is what messages call him
  };
  Kind kind = Kind::file;
  std::string path;                              // links followed, even one that leads to nothing yet
  int descriptor = -1;                           // of Kind::descriptor
  std::optional<platform::FileStatus> replaced;  // the file that stands there now

  std::string folder() const;
};

/// Refuses with file-is-folder, and with file-unwritable a file that is read-only or that the user may not write to,
/// and a number that is no open file, or one open for reading.
OutputTarget output_target(const std::string& name);

/// Whether what is written there comes out where standard output does: "-", /dev/stdout, /dev/fd/1, or an open file of
/// this process that is the same pipe. Refuses nothing.
bool is_standard_output(const std::string& name);

}  // namespace plumbline

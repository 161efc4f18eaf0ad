// Where the name of an output leads: to a file that takes its place, or to something that is written to.
#pragma once

#include <optional>
#include <string>

namespace plumbline {

struct OutputTarget {
  enum class Kind {
    file,        // a new file appears at `path`
    descriptor,  // an open file of this process: standard output, /dev/stdout, /dev/fd/3
    device,      // a pipe or a device at `path`
    taker,       // somebody who is handed the bytes; `path` is what messages call him
  };
  struct Replaced {
    unsigned mode = 0;
    unsigned owner = 0;
    unsigned group = 0;
  };

  Kind kind = Kind::file;
  std::string path;                  // links followed, even one that leads to nothing yet
  int descriptor = -1;               // of Kind::descriptor
  std::optional<Replaced> replaced;  // the file that stands there now

  std::string folder() const;
};

/// Refuses with file-is-folder, and with file-unwritable a file that is read-only or that the user may not write to,
/// and a number that is no open file, or one open for reading.
OutputTarget output_target(const std::string& name);

/// Gives a file the permissions and the owner of the one that it replaces, as far as the user may. Where the group
/// cannot be kept, it is allowed no more than others are.
void adopt(int descriptor, const OutputTarget::Replaced& replaced);

}  // namespace plumbline

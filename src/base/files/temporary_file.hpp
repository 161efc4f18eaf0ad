// Files under a passing name, in the folder where they will appear under their own.
#pragma once

#include <optional>
#include <string>

#include "base/files/descriptor.hpp"
#include "base/files/ending_signals.hpp"

namespace plumbline {

/// ".plumbline-" with sixteen hexadecimal digits and ".tmp".
std::string passing_name_in(const std::string& folder);

/// A file open for reading and writing, locked for as long as it is open: that is how others tell that it is in use.
struct TemporaryFile {
  PassingName name;
  Descriptor descriptor;
};

/// Makes one, its permissions those of `mode` that the user's umask lets through. Nothing, with errno, if that fails.
std::optional<TemporaryFile> make_temporary_file(const std::string& folder, unsigned mode);

/// Removes what processes that were killed left in a folder. Never fails.
void sweep_temporary_files(const std::string& folder);

/// A file without a name, for the environment variable TMPDIR to place. Refuses with file-unwritable.
Descriptor open_unnamed_temporary();

}  // namespace plumbline

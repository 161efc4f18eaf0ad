// Whether an output is still what its program makes.
#pragma once

#include <string>

#include "batch/record.hpp"
#include "batch/settings_by_folder.hpp"

namespace plumbline::batch {

struct Freshness {
  bool is_fresh = false;
  bool looks_new = false;  // files look changed and are not: the entry was brought up to date
};

/// Compares what an entry says with what there is: the settings, the program, the files that it calls, where it would
/// look for them today, and the output. A file is read only if its size, time or number differ.
Freshness freshness(Entry& entry, const std::string& program, const std::string& output,
                    const FolderSettings& settings);

/// What is known of a file that was read when its state was `state`, at `read_ns`: one that had just been written to
/// may be written to again at the same time on the clock of its file system, and is read next time.
KnownFile known_file(const FileState& state, std::uint64_t hash, std::int64_t read_ns);

/// When the folder of a program was last changed; 0: just now, or it is not known.
std::int64_t folder_change(const std::string& program);

}  // namespace plumbline::batch

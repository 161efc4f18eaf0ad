// What earlier runs have done, in a small file beside the outputs.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/files/file_state.hpp"
#include "batch/sqlite.hpp"

namespace plumbline::batch {

/// A file as it was read or written.
struct KnownFile {
  FileState state;
  std::uint64_t hash = 0;
};

/// A subprogram's file, or where one was looked for.
struct CalledFile {
  std::string name;  // by which the program calls it; empty: it is read because the program may
  std::string path;  // in the folder of the program; empty: there was none
  KnownFile file;
};

/// One output, and all that it was made from.
struct Entry {
  std::string place;   // of the output in its folder, and what the entry goes by
  std::string source;  // the program's path, absolute
  KnownFile program;
  std::uint64_t settings = 0;  // FolderSettings::hash
  std::string dialect;
  std::vector<CalledFile> called;
  std::int64_t folder_changed_ns = 0;  // the folder of the program, where it calls any
  KnownFile output;
  bool has_undo = false;
  std::string summary;  // JSON
};

/// One SQLite file. Entries are written before outputs appear: an output that is there as its entry says is whole, and
/// an entry whose output is not is of no use. So a run may be killed at any moment. Thread-safe, and for several
/// processes at a time.
class Record {
 public:
  /// Refuses with batch-record what is no such file, or one of a later version.
  explicit Record(const std::string& path);

  std::optional<Entry> find(const std::string& place);
  /// All of them or none.
  void put(const std::vector<const Entry*>& entries);
  void remove(const std::vector<std::string>& places);
  /// Each in turn, without its summary; `take` may not use the record.
  void each(const std::function<void(const Entry&)>& take);

 private:
  Database prepared(const std::string& path);

  std::mutex guard_;
  Database database_;
  Statement find_, put_, remove_;
};

}  // namespace plumbline::batch

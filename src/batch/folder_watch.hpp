// Waits for programs that come into a folder, and tells which are still being written.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "base/files/file_state.hpp"
#include "base/files/folder_events.hpp"
#include "batch/program_list.hpp"

namespace plumbline::batch {

/// A file is taken when the system tells that it was closed, or moved there; else, and where the folder is looked
/// through now and then, when it has rested: neither its size nor its time has changed for a while.
class FolderWatch {
 public:
  using Milliseconds = std::chrono::milliseconds;
  struct Settings {
    std::optional<Milliseconds> every{};  // looks through the folder that often; nothing: the system tells
    Milliseconds rest{2000};
  };

  /// `programs` must outlive it. Refuses as list_programs does.
  FolderWatch(const ProgramRequest& programs, const Settings& settings);

  /// Waits that long at most. True: a program can be taken, or one has gone.
  bool wait(Milliseconds most);
  /// Programs that are being written.
  std::set<std::string> busy() const;
  /// The system tells of files.
  bool is_told() const { return events_.has_value(); }

 private:
  using Clock = std::chrono::steady_clock;
  struct Seen {
    FileState state;
    Clock::time_point since;
  };
  void add_folder(const std::string& folder);
  void note(const FolderEvent& event);
  void note_busy(const std::string& program);
  void look_through();
  void release_rested();

  const ProgramRequest& programs_;
  Settings settings_;
  std::optional<FolderEvents> events_;
  Clock::time_point looked_;
  std::map<std::string, FileState> known_;  // where the folder is looked through
  std::map<std::string, Seen> busy_;
  bool changed_ = false;
};

}  // namespace plumbline::batch

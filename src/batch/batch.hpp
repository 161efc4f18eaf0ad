// All programs of a folder, each compensated unless its output is what it makes already.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/files/file_state.hpp"
#include "base/progress.hpp"
#include "batch/program_list.hpp"
#include "jobs/batch_item.hpp"
#include "settings/resolved.hpp"

namespace plumbline::batch {

struct Request {
  ProgramRequest programs;
  settings::SettingsRequest settings;  // of the command line
  std::string record;                  // file; empty: kRecordName in the folder of the outputs
  unsigned jobs = 0;                   // programs at a time; 0: as many as there are processors
};

inline constexpr const char* kRecordName = ".plumbline-batch.sqlite";

/// Where the record of a request lies.
std::string record_path(const Request& request);

struct Observer {
  /// Each program, when its output is there or it is known that there will be none: those that can be done in the order
  /// of the list, then those that cannot. By one thread at a time.
  std::function<void(const jobs::BatchItem&)> item;
  Progress progress;  // programs
};

struct Result {
  jobs::BatchSummary summary;
  std::vector<std::string> files_read;  // programs, what they call, and the next; folders looked into
  std::map<std::string, std::optional<FileState>> tables_read;  // models, tables, settings, as they were
};

/// What is refused of one program is in its item, and the others are done. Refuses, before anything is done, as
/// list_programs and Record do, and with file-overwrites-input and file-written-twice; while it goes on, with
/// batch-record if what is done cannot be recorded.
Result run(const Request& request, const Observer& observer);

}  // namespace plumbline::batch

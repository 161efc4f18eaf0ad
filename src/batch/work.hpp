// One program of a batch.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/files/output_group.hpp"
#include "batch/record.hpp"
#include "batch/settings_by_folder.hpp"
#include "jobs/batch_item.hpp"

namespace plumbline::batch {

struct Task {
  std::size_t number = 0;  // of the program in the list
  std::string program;
  std::string place;   // of the output in its folder
  std::string output;  // its path
};

/// A program that is compensated; its output waits under a passing name.
struct Work {
  jobs::BatchItem item;
  Task task;
  Entry entry;
  std::vector<std::string> called;        // files; an empty one was not there
  bool is_known_anew = false;             // the output stays, and its entry is brought up to date
  std::unique_ptr<WaitingOutput> undo;    // appears before the output; none: not asked for, or refused
  std::unique_ptr<WaitingOutput> output;  // none: refused
};

/// `known`: the entry of an earlier run. Whatever goes wrong is in the item.
Work compensate_one(const Task& task, const FolderSettings& settings, const std::optional<Entry>& known);

/// The item of a program that could not be compensated. `stays`: its output of an earlier run is there still.
Work failed(const Task& task, const Diagnostic& why, bool stays);

/// What an exception that is being handled means for the program that it came from.
Diagnostic current_problem(const std::string& program);

}  // namespace plumbline::batch

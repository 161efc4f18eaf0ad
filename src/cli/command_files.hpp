// The files that a command names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "measure/dataset.hpp"

namespace plumbline::cli {

/// No output may be a file that is read, or another output: links followed, before anything is opened. Empty names are
/// left out, "-" is standard input or output. Refuses with file-overwrites-input or file-written-twice; throws
/// UsageError if two inputs are standard input.
void check_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

/// What was read of a dataset: `path`, its dataset.toml, and the tables of its runs.
std::vector<std::string> files_of(const measure::Dataset& dataset, const std::string& path);

/// A result in words on standard output, and as JSON in the file that --json names.
class JsonResult {
 public:
  /// Opens the file, so that one that cannot be written shows before the work; empty: no JSON is wanted.
  explicit JsonResult(const std::string& path);

  /// Words are left out where standard output takes the JSON.
  void give(const std::string& words, const std::string& json);

 private:
  std::optional<OutputFile> file_;
};

}  // namespace plumbline::cli

// The files that a command names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/files/files.hpp"
#include "cli/messages.hpp"

namespace plumbline::cli {

/// No output may be a file that is read, or another output: links followed, before anything is opened. Empty names are
/// left out, "-" is standard input or output. Refuses with file-overwrites-input or file-written-twice; throws
/// UsageError if two inputs are standard input.
void check_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

/// What a command reads that reads a dataset (may be empty) and those joined with it: their files, and others, those of
/// them that are models with the posteriors that they name. Refuses as measure::files_of_dataset does.
std::vector<std::string> inputs_of(const std::string& dataset, std::vector<std::string> others,
                                   const std::vector<std::string>& with = {});

/// A result in words on standard output, and as JSON in the file that --json names.
class JsonResult {
 public:
  /// Opens the file, so that one that cannot be written shows before the work; empty: no JSON is wanted.
  explicit JsonResult(const std::string& path);

  /// Words are left out where standard output takes the JSON.
  void give(const std::string& words, const std::string& json, const Judgement& judgement = {});
  /// The JSON alone, to appear with other files.
  void add_to(OutputSet& set, const std::string& json);
  bool takes_standard_output() const { return file_ && file_->name() == kStandardStream; }

 private:
  std::optional<OutputFile> file_;
};

}  // namespace plumbline::cli

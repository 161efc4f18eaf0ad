#include "cli/command_files.hpp"

#include <algorithm>

#include "base/files/own_files.hpp"
#include "base/text/printable.hpp"
#include "cli/command.hpp"
#include "cli/messages.hpp"
#include "identify/posterior/posterior_file.hpp"
#include "measure/dataset.hpp"

namespace plumbline::cli {

void check_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  if (std::count(inputs.begin(), inputs.end(), kStandardStream) > 1) {
    throw UsageError("only one of the files that are read can be standard input");
  }
  refuse_shared_files(inputs, outputs);
}

std::vector<std::string> inputs_of(const std::string& dataset, std::vector<std::string> others,
                                   const std::vector<std::string>& with) {
  for (std::size_t i = others.size(); i-- > 0;) {
    if (const std::string posterior = identify::posterior_named_in(others[i]); !posterior.empty())
      others.push_back(posterior);
  }
  if (dataset.empty() && !with.empty()) throw UsageError("--with joins datasets with that of -d, and there is no -d");
  if (dataset.empty()) return others;
  std::vector<std::string> datasets{dataset};
  datasets.insert(datasets.end(), with.begin(), with.end());
  for (const std::string& each : datasets) {
    const std::vector<std::string> files = measure::files_of_dataset(each);
    others.insert(others.end(), files.begin(), files.end());
  }
  return others;
}

JsonResult::JsonResult(const std::string& path) {
  if (!path.empty()) file_.emplace(path);
}

void JsonResult::give(const std::string& words, const std::string& json, const Judgement& judgement) {
  OutputSet alone;
  add_to(alone, json);
  if (!takes_standard_output()) print_result(words, judgement);
  alone.commit();
}

void JsonResult::add_to(OutputSet& set, const std::string& json) {
  if (!file_) return;
  file_->write(takes_standard_output() ? printable_lines(json) : json);
  set.add(*file_);
}

}  // namespace plumbline::cli

#include "batch/outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "compensate/stamp_mark.hpp"

namespace plumbline::batch {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::vector<std::string> vanished_outputs(const std::string& folder, const OutputPlaces& places, Record& record) {
  std::vector<std::string> outputs;
  std::vector<std::string> forgotten;
  record.each([&](const Entry& entry) {
    std::error_code none;
    if (places.contains(entry.place) || fs::exists(path_of(entry.source), none)) return;
    const fs::path output = path_of(folder) / path_of(entry.place);
    if (fs::exists(output, none)) {
      outputs.push_back(output.generic_string());
    } else {
      forgotten.push_back(entry.place);
    }
  });
  record.remove(forgotten);
  return outputs;
}

std::vector<std::string> programs_among_outputs(const ProgramRequest& programs, const OutputPlaces& places,
                                                Record& record) {
  std::set<std::string> outputs;
  for (const auto& [place, program] : places) outputs.insert(place);
  record.each([&](const Entry& entry) { outputs.insert(entry.place); });
  std::vector<std::string> found;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(path_of(programs.output), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string path = entry->path().generic_string();
    std::error_code none;
    if (!entry->is_regular_file(none) || !is_program_name(path, programs.endings)) continue;
    if (outputs.contains(place_in_folder(programs.output, path))) continue;
    if (!compensate::is_compensated(InputFile(path))) found.push_back(path);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace plumbline::batch

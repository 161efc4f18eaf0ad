#include "settings/resolved.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/files/file_state.hpp"
#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "base/platform/platform.hpp"
#include "base/text/nearest_name.hpp"
#include "settings/contradiction.hpp"

namespace plumbline::settings {
namespace {

namespace fs = std::filesystem;

// Whether a settings file stands there. What has its name and is none would leave the settings of the shop out without
// a word.
bool is_settings_file(const fs::path& path) {
  std::error_code error;
  const fs::file_type itself = fs::symlink_status(path, error).type();
  if (itself == fs::file_type::not_found || itself == fs::file_type::none) return false;
  if (fs::is_regular_file(path, error)) return true;
  refuse("settings-no-file", fmt::format("this is {}, and no settings file", what_stands(path)),
         "put the settings file there, take this away, or have no settings read with --no-settings",
         {path.generic_string(), 0});
}

// In the folder of the program, which is named as the program is, and in those above it.
std::vector<std::string> files_from_folder_up(const std::string& program) {
  std::vector<std::string> files;
  if (program == kStandardStream) return files;
  const auto add = [&](const fs::path& folder) {
    if (is_settings_file(folder / kSettingsFileName)) files.push_back((folder / kSettingsFileName).generic_string());
  };
  add(path_of(program).parent_path());
  std::error_code error;
  fs::path folder = fs::absolute(path_of(program), error).lexically_normal().parent_path();
  while (folder.has_relative_path()) {
    folder = folder.parent_path();
    add(folder);
  }
  return files;
}

// Where it is not set, it is not there, which is no error.
std::string users_own() {
  const std::string folder = platform::settings_folder();
  if (folder.empty()) return {};
  const fs::path path = path_of(folder) / "plumbline" / kSettingsFileName;
  return is_settings_file(path) ? path.generic_string() : std::string();
}

void add_once(std::vector<std::string>& files, const std::string& path) {
  std::error_code error;
  const bool known = std::any_of(files.begin(), files.end(), [&](const std::string& file) {
    return file == path || fs::equivalent(path_of(file), path_of(path), error);
  });
  if (!path.empty() && !known) files.push_back(path);
}

// Which machine is meant, and where that is said.
std::pair<std::string, Place> machine_of(const SettingsRequest& request, const std::vector<SettingsFile>& files) {
  if (!request.machine.empty()) return {request.machine, {}};
  for (const SettingsFile& file : files) {
    if (file.machine) return {*file.machine, file.machine_place};
  }
  return {};
}

std::vector<std::string> machines_in(const std::vector<SettingsFile>& files) {
  std::set<std::string> names;
  for (const SettingsFile& file : files) {
    for (const auto& [name, options] : file.machines) names.insert(name);
  }
  return {names.begin(), names.end()};
}

void require_machine(const std::string& name, const Place& place, const std::vector<std::string>& machines) {
  if (name.empty() || std::binary_search(machines.begin(), machines.end(), name)) return;
  std::string help = did_you_mean(name, {machines.begin(), machines.end()});
  help += machines.empty() ? fmt::format("describe it in a settings file under [machines.{}]", name)
                           : fmt::format("machines are {}", fmt::join(machines, ", "));
  refuse("settings-no-machine", fmt::format("no settings file describes a machine {}", name), std::move(help), place);
}

// The work system that a text of --work-offset names.
int system_in(const StatedOption& stated) {
  Options scratch;
  set_option(scratch, *stated.row, stated.text);
  return scratch.offset_systems.empty() ? 0 : scratch.offset_systems.front().number;
}

// Whether one statement leaves nothing of another that is weaker.
bool takes_place_of(const StatedOption& stronger, const StatedOption& weaker) {
  if (excludes(*stronger.row, *weaker.row)) return true;
  if (stronger.row != weaker.row) return false;
  return stronger.row->name != "work-offset" || system_in(stronger) == system_in(weaker);
}

// Adds what a weaker layer states, where no stronger one has stated it.
void add_layer(std::vector<StatedOption>& stated, const std::vector<StatedOption>& layer) {
  const std::size_t stronger = stated.size();
  for (const StatedOption& one : layer) {
    const auto end = stated.begin() + static_cast<std::ptrdiff_t>(stronger);
    if (std::none_of(stated.begin(), end, [&](const StatedOption& other) { return takes_place_of(other, one); }))
      stated.push_back(one);
  }
}

}  // namespace

std::vector<std::string> settings_files(const std::string& program, const std::string& file) {
  std::vector<std::string> files;
  add_once(files, file);
  if (file.empty()) {
    for (const std::string& path : files_from_folder_up(program)) add_once(files, path);
  }
  add_once(files, platform::environment(kSettingsVariable).value_or(""));
  add_once(files, users_own());
  return files;
}

std::string choice_of_machine(const Options& options) {
  if (!options.machine.empty() || options.machines.empty()) return {};
  return fmt::format("--machine NAME takes one of {}", fmt::join(options.machines, ", "));
}

ResolvedSettings resolve_settings(const SettingsRequest& request) {
  return resolve_settings(
      request, request.without_files ? std::vector<std::string>() : settings_files(request.program, request.file));
}

ResolvedSettings resolve_settings(const SettingsRequest& request, const std::vector<std::string>& paths) {
  std::vector<SettingsFile> files;
  for (const std::string& path : paths) files.push_back(read_settings_file(path));
  ResolvedSettings resolved;
  std::vector<std::string>& machines = resolved.options.machines;
  machines = machines_in(files);
  const auto [machine, place] = machine_of(request, files);
  require_machine(machine, place, machines);
  add_layer(resolved.stated, request.given);
  for (const SettingsFile& file : files) {
    if (const auto found = file.machines.find(machine); found != file.machines.end())
      add_layer(resolved.stated, found->second);
    add_layer(resolved.stated, file.options);
    resolved.options.paths.settings_files.push_back(file.path);
  }
  resolved.options.machine = machine;
  resolved.machine_place = place;
  std::stable_sort(resolved.stated.begin(), resolved.stated.end(),
                   [](const StatedOption& a, const StatedOption& b) { return a.row < b.row; });
  std::vector<NamedSystem>& systems = resolved.options.offset_systems;
  for (const StatedOption& one : resolved.stated) {
    const std::size_t known = systems.size();
    set_option(resolved.options, *one.row, one.text);
    if (systems.size() > known) systems.back().stated = one.place;
  }
  return resolved;
}

}  // namespace plumbline::settings

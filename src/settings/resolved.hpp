// What holds of all that is said about a program: on the command line, in settings files, of the machine that is named.
#pragma once

#include <string>
#include <vector>

#include "settings/options.hpp"
#include "settings/settings_file.hpp"

namespace plumbline::settings {

/// The environment variable that names a settings file.
inline constexpr const char* kSettingsVariable = "PLUMBLINE_SETTINGS";

/// What the command line says.
struct SettingsRequest {
  std::string program;              // "-": standard input, which has no folder
  std::string file;                 // --settings: in place of the files in the folders; empty: not given
  std::string machine;              // --machine; empty: the one that the files name, if any
  bool without_files = false;       // --no-settings
  std::vector<StatedOption> given;  // options
};

struct ResolvedSettings {
  Options options;
  std::vector<StatedOption> stated;  // what holds, in the order of option_rows(); the rest is as by default
  Place machine_place;               // where the machine is named; no file: on the command line, or nowhere
};

/// The settings files of a program, the one that counts most first: `file`, or else each plumbline.toml in the folder
/// of the program and the folders above it; the one that PLUMBLINE_SETTINGS names; the user's own,
/// $XDG_CONFIG_HOME/plumbline/plumbline.toml or ~/.config/plumbline/plumbline.toml. None twice. Refuses with
/// settings-no-file what stands in one of these folders under that name and is no file.
std::vector<std::string> settings_files(const std::string& program, const std::string& file);

/// "--machine NAME takes one of hex-3, hex-4"; empty where one is named, or none described.
std::string choice_of_machine(const Options& options);

/// Of each option the strongest statement holds: the command line's, then those of the files in their order, in each
/// file the machine's before what it states for every machine. One that contradicts a stronger one is left out. Work
/// offsets count one by one. Refuses as read_settings_file does, with settings-no-machine if no file describes the
/// machine, and with settings-value if an option of the command line is none (never: they were read before).
ResolvedSettings resolve_settings(const SettingsRequest& request);
/// The same with these files and no others, the one that counts most first.
ResolvedSettings resolve_settings(const SettingsRequest& request, const std::vector<std::string>& paths);

}  // namespace plumbline::settings

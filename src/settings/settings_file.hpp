// A settings file, plumbline.toml: what the command line need not say every time, for all machines or for one by name.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "settings/options.hpp"

namespace plumbline::settings {

inline constexpr std::string_view kSettingsFileName = "plumbline.toml";

/// An option with its text, as the command line would spell it.
struct StatedOption {
  const OptionRow* row;
  std::string text;
  Place place;  // in a settings file; no file: the command line states it
};

struct SettingsFile {
  std::string path;
  std::optional<std::string> machine;  // that holds unless another one is named
  Place machine_place;
  std::vector<StatedOption> options;                          // of every machine
  std::map<std::string, std::vector<StatedOption>> machines;  // what each states besides, or instead
};

/// How a settings file names this option: step-angle is step_angle there.
std::string key_of(std::string_view option);

/// Reads the file; paths in it count from its own folder. Refuses with toml-syntax, settings-kind, settings-key,
/// settings-type or settings-value and the place, so too where it contradicts itself.
SettingsFile read_settings_file(const std::string& path);

}  // namespace plumbline::settings

// The settings file beside a program: what the command line need not say every time.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "settings/options.hpp"

namespace plumbline::settings {

inline constexpr std::string_view kSettingsFileName = "plumbline.toml";

/// The settings file in the folder of `program`; empty if there is none, or the program is standard input.
std::string settings_file_beside(const std::string& program);

/// Sets what the file states, but the options that `is_given` holds to be said already (never asked for work offsets:
/// what is said later takes their place one by one). Paths in it count from its own folder. Refuses with toml-syntax,
/// settings-kind, settings-key, settings-type or settings-value and the place, so too where it contradicts itself.
void read_settings_file(const std::string& path, Options& options,
                        const std::function<bool(const OptionRow&)>& is_given = {});

}  // namespace plumbline::settings

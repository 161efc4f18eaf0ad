// The options that several commands take, as settings/options.hpp lists them.
#pragma once

#include <initializer_list>
#include <list>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.hpp"
#include "settings/options.hpp"
#include "settings/resolved.hpp"

namespace plumbline::cli {

class SharedOptions {
 public:
  /// Adds the options of these groups to a command; must live as long as the command line is read.
  void add_to(CLI::App& command, std::initializer_list<settings::OptionGroup> groups);

  /// Adds these options alone, by their names; no settings file.
  void add_named(CLI::App& command, std::initializer_list<std::string_view> names);

  /// What the command line says. Throws UsageError for values that are none.
  settings::Options given() const;
  /// Whether the command line says this option, by its name without dashes.
  bool is_given(std::string_view name) const;

  /// What the command line says, and where it is silent the settings files of `program`, unless --no-settings asks for
  /// none. Throws UsageError for values that are none, and refuses as resolve_settings does.
  settings::Options read(const std::string& program) const;
  /// What is asked for, of a program that is left open. Throws UsageError for values that are none.
  settings::SettingsRequest request() const;
  /// The same as read() with where each of them is stated.
  settings::ResolvedSettings resolve(const std::string& program) const;

  /// Throws UsageError if the command line gives any of them but the model: `why` they would do nothing.
  void allow_model_alone(std::string_view why) const;

 private:
  struct Given {
    const settings::OptionRow* row;
    std::vector<std::string> texts;
  };
  void add(CLI::App& command, const settings::OptionRow& row);
  void apply(settings::Options& options) const;

  std::list<Given> given_;
  std::string machine_, settings_file_;
  bool no_settings_ = false;
};

/// What is read for a program: itself, and what the options name.
std::vector<std::string> files_read(const std::string& program, const settings::Options& options);

/// The model that the options name. Throws UsageError if they name none.
void require_model(const settings::Options& options);

}  // namespace plumbline::cli

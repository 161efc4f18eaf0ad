// Options that were given by name, as a function takes them.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "api/inside.hpp"
#include "settings/settings_file.hpp"

namespace plumbline::api {

class GivenOptions {
 public:
  /// `own`: names beside those of the groups. Throws wrong_usage at any other, and at one that is given in a form that
  /// it cannot take. `options` is kept by reference.
  GivenOptions(const Options& options, std::initializer_list<settings::OptionGroup> groups,
               std::initializer_list<std::string_view> own = {});

  /// Those of the groups, and what the settings file says besides, for a machine, else for the one that the settings
  /// file names, if any. Throws wrong_usage at what is no value and where options contradict each other; refuses as
  /// settings::resolve_settings does.
  settings::Options program_options(const Model& model) const;
  /// The same; throws wrong_usage if no model is named.
  settings::Options machine_options(const Model& model) const;

  /// Options of its own: what was given last. Throw wrong_usage at what is no value.
  std::optional<std::string> text(std::string_view name) const;
  /// Empty: not given.
  Source source(std::string_view name) const;
  bool is_on(std::string_view name) const;
  std::optional<double> number(std::string_view name) const;
  std::optional<double> positive(std::string_view name) const;
  /// The texts between commas, of all that were given.
  std::vector<std::string> list(std::string_view name) const;
  /// All that were given, each as it stands: names of files may have commas.
  std::vector<std::string> each(std::string_view name) const;

 private:
  std::vector<settings::StatedOption> stated() const;
  const std::vector<Options::Given>& given_;
};

}  // namespace plumbline::api

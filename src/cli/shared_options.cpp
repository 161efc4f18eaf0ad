#include "cli/shared_options.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/check.hpp"
#include "cli/messages.hpp"
#include "settings/contradiction.hpp"
#include "settings/settings_file.hpp"

namespace plumbline::cli {

void SharedOptions::add_to(CLI::App& command, std::initializer_list<settings::OptionGroup> groups) {
  for (const settings::OptionRow& row : settings::option_rows()) {
    if (std::find(groups.begin(), groups.end(), row.group) != groups.end()) add(command, row);
  }
  command.add_flag("--no-settings", no_settings_,
                   fmt::format("read no {} beside the program", settings::kSettingsFileName));
}

void SharedOptions::add_named(CLI::App& command, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    const settings::OptionRow* const row = settings::find_option(name);
    PLUMBLINE_CHECK(row != nullptr);
    add(command, *row);
  }
}

void SharedOptions::add(CLI::App& command, const settings::OptionRow& row) {
  Given& given = given_.emplace_back(Given{&row, {}});
  const std::string name = row.name == "model" ? "-m,--model" : fmt::format("--{}", row.name);
  if (row.value.empty()) {
    command.add_flag_callback(
        name, [&given] { given.texts.assign(1, "on"); }, settings::help_of(row));
    return;
  }
  CLI::Option* const option = command.add_option(name, given.texts, settings::help_of(row));
  option->type_name(std::string(row.value))->type_size(1)->allow_extra_args(false);
  option->multi_option_policy(row.is_repeatable ? CLI::MultiOptionPolicy::TakeAll : CLI::MultiOptionPolicy::Throw);
  if (!row.is_repeatable) option->expected(1);
}

void SharedOptions::apply(settings::Options& options) const {
  for (const Given& given : given_) {
    for (const std::string& text : given.texts) {
      try {
        settings::set_option(options, *given.row, text);
      } catch (const settings::OptionError& error) {
        throw UsageError(fmt::format("--{} {}: {}", given.row->name, text, error.what()));
      }
    }
  }
}

bool SharedOptions::takes_place_of(const settings::OptionRow& row) const {
  return std::any_of(given_.begin(), given_.end(), [&](const Given& given) {
    return !given.texts.empty() && (given.row == &row || settings::excludes(*given.row, row));
  });
}

settings::Options SharedOptions::given() const {
  settings::Options options;
  apply(options);
  return options;
}

settings::Options SharedOptions::read(const std::string& program) const {
  settings::Options options = given();  // first of all: wrong usage shows before any file is read
  if (const std::optional<std::string> why = settings::contradiction(options)) throw UsageError(*why);
  const std::string settings = no_settings_ ? std::string() : settings::settings_file_beside(program);
  if (settings.empty()) return options;
  say_step(fmt::format("settings: {}, and what the command line says instead", settings));
  options = {};
  settings::read_settings_file(settings, options, [&](const settings::OptionRow& row) { return takes_place_of(row); });
  apply(options);
  return options;
}

void SharedOptions::allow_model_alone(std::string_view why) const {
  for (const Given& given : given_) {
    if (given.row->name != "model" && !given.texts.empty()) {
      throw UsageError(fmt::format("--{} does nothing here: {}", given.row->name, why));
    }
  }
}

std::vector<std::string> files_read(const std::string& program, const settings::Options& options) {
  return {program, options.paths.model, options.paths.tools, options.paths.variables, options.paths.settings_file};
}

void require_model(const settings::Options& options) {
  if (options.paths.model.empty()) throw UsageError("--model MODEL is required: the machine's model file");
}

}  // namespace plumbline::cli

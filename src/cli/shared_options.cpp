#include "cli/shared_options.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/check.hpp"
#include "cli/messages.hpp"
#include "identify/posterior/posterior_file.hpp"
#include "settings/contradiction.hpp"

namespace plumbline::cli {

void SharedOptions::add_to(CLI::App& command, std::initializer_list<settings::OptionGroup> groups) {
  for (const settings::OptionRow& row : settings::option_rows()) {
    if (std::find(groups.begin(), groups.end(), row.group) != groups.end()) add(command, row);
  }
  command.add_option("--machine", machine_, "the machine, as a settings file names it under [machines.NAME]")
      ->type_name("NAME");
  CLI::Option* const file =
      command.add_option("--settings", settings_file_,
                         fmt::format("settings file (default: each {} in the program's folder and those above it)",
                                     settings::kSettingsFileName));
  file->type_name("FILE");
  command.add_flag("--no-settings", no_settings_, "read no settings file")->excludes(file);
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

bool SharedOptions::is_given(std::string_view name) const {
  return std::any_of(given_.begin(), given_.end(),
                     [&](const Given& given) { return given.row->name == name && !given.texts.empty(); });
}

settings::Options SharedOptions::given() const {
  settings::Options options;
  apply(options);
  return options;
}

settings::SettingsRequest SharedOptions::request() const {
  const settings::Options options = given();  // first of all: wrong usage shows before any file is read
  if (const std::optional<std::string> why = settings::contradiction(options)) throw UsageError(*why);
  settings::SettingsRequest request{{}, settings_file_, machine_, no_settings_, {}};
  for (const Given& given : given_) {
    for (const std::string& text : given.texts) request.given.push_back({given.row, text, {}});
  }
  return request;
}

settings::ResolvedSettings SharedOptions::resolve(const std::string& program) const {
  settings::SettingsRequest request = this->request();
  request.program = program;
  return settings::resolve_settings(request);
}

settings::Options SharedOptions::read(const std::string& program) const {
  settings::Options options = resolve(program).options;
  if (is_given("yields") && !options.compensation.bound.is_asked())
    throw UsageError("--yields says what yields to --tolerance, and there is none");
  if (!options.paths.settings_files.empty()) {
    say_step(fmt::format("settings: {}, and what the command line says instead",
                         fmt::join(options.paths.settings_files, ", ")));
  }
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
  const settings::Paths& paths = options.paths;
  std::vector<std::string> files{program, paths.model.path(), paths.tools.path(), paths.variables.path()};
  if (std::string posterior = identify::posterior_named_in(paths.model.path()); !posterior.empty())
    files.push_back(std::move(posterior));
  files.insert(files.end(), paths.settings_files.begin(), paths.settings_files.end());
  return files;
}

void require_model(const settings::Options& options) {
  if (!options.paths.model.empty()) return;
  if (const std::string choice = settings::choice_of_machine(options); !choice.empty())
    throw UsageError(fmt::format("which machine is meant? {}; or --model MODEL names a file", choice));
  throw UsageError(fmt::format("--model MODEL is required: the machine's model file; or name it in {}",
                               settings::kSettingsFileName));
}

}  // namespace plumbline::cli

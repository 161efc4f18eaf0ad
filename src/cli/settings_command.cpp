#include <memory>

#include <fmt/format.h>

#include "cli/command.hpp"
#include "cli/command_files.hpp"
#include "cli/shared_options.hpp"
#include "report/program/settings_text.hpp"

namespace plumbline::cli {
namespace {

struct SettingsArguments {
  std::string program, json;
  SharedOptions shared;
};

// Any name in the current folder has its settings.
constexpr const char* kHere = ".";

int settings(const SettingsArguments& arguments) {
  const settings::ResolvedSettings resolved =
      arguments.shared.resolve(arguments.program.empty() ? kHere : arguments.program);
  check_outputs(files_read(arguments.program, resolved.options), {arguments.json});
  JsonResult json(arguments.json);
  try {
    json.give(report::settings_text(resolved, arguments.program), report::settings_json(resolved, arguments.program));
  } catch (const settings::OptionError& error) {
    throw UsageError(fmt::format("--output-name {}: {}", resolved.options.output_pattern, error.what()));
  }
  return kDone;
}

}  // namespace

void add_settings(CLI::App& app, Run& run) {
  CLI::App* const command =
      app.add_subcommand("settings", "Say which settings hold for a program, and where each of them is stated");
  const auto arguments = std::make_shared<SettingsArguments>();
  command
      ->add_option("PROGRAM", arguments->program, "the NC program, which is not read (default: none, in this folder)")
      ->type_name("FILE");
  command->add_option("--json", arguments->json, "write the result as JSON, too")->type_name("FILE");
  using Group = settings::OptionGroup;
  arguments->shared.add_to(*command, {Group::model, Group::program, Group::step, Group::bound, Group::compensation});
  command->callback([arguments, &run] { run = [arguments] { return settings(*arguments); }; });
}

}  // namespace plumbline::cli

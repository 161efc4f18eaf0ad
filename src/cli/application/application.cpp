#include "cli/application/application.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/output_target.hpp"
#include "cli/application/command_examples.hpp"
#include "cli/application/version_text.hpp"
#include "cli/messages.hpp"

namespace plumbline::cli {
namespace {

struct Command {
  std::string_view name;  // in the code: new_model is new-model
  void (*add)(CLI::App& app, Run& run);
};
constexpr Command kCommands[] = {
#define PLUMBLINE_ENTRY(NAME) {#NAME, add_##NAME},
    PLUMBLINE_COMMANDS(PLUMBLINE_ENTRY)
#undef PLUMBLINE_ENTRY
};

bool is_called(const Command& command, std::string_view name) {
  return std::equal(command.name.begin(), command.name.end(), name.begin(), name.end(),
                    [](char in_code, char c) { return (in_code == '_' ? '-' : in_code) == c; });
}

// Before the command and after it.
void add_diagnostics(CLI::App& app) {
  static std::string form;
  std::vector<CLI::App*> all = app.get_subcommands([](const CLI::App*) { return true; });
  all.push_back(&app);
  for (CLI::App* const one : all) {
    one->add_option("--diagnostics", form, "form of the messages on standard error: text, or json, an object a line")
        ->type_name("FORM")
        ->check(CLI::IsMember({"text", "json"}));
  }
}

// Before the command and after it.
void add_loudness(CLI::App& app) {
  const auto add = [](CLI::App& to, const char* names, Loudness loudness, const char* what) {
    return to
        .add_flag_callback(
            names, [loudness] { say_as_much_as(loudness); }, what)
        ->trigger_on_parse();
  };
  std::vector<CLI::App*> all = app.get_subcommands([](const CLI::App*) { return true; });
  all.push_back(&app);
  for (CLI::App* const one : all) {
    CLI::Option* const quiet =
        add(*one, "-q,--quiet", Loudness::quiet, "say errors, warnings and results, and nothing else");
    add(*one, "-v,--verbose", Loudness::verbose, "say the steps of the work, too")->excludes(quiet);
  }
}

// /dev/stdout is standard output by another name.
std::string one_name_of_standard_output(std::string& value) {
  if (is_standard_output(value)) value = kStandardStream;
  return {};
}

void add_names_of_standard_output(CLI::App& command) {
  for (const char* const name : {"--output", "--json", "--report", "--depfile"}) {
    CLI::Option* const option = command.get_option_no_throw(name);
    if (option != nullptr && option->get_items_expected_max() > 0)
      option->transform(CLI::Validator(one_name_of_standard_output, ""));
  }
}

void describe(CLI::App& app) {
  app.description(
      "plumbline straightens NC programs for hexapod machine tools: it moves the tool tip to where the "
      "program meant it to go, against gravity, friction and elasticity of the machine.");
  app.name("plumbline");
  app.set_version_flag("--version", version_text());
  app.allow_windows_style_options(false);  // paths begin with / there, too
  app.require_subcommand(1);
  app.get_formatter()->column_width(36);
  app.footer(
      "Lengths are in mm, angles in deg, masses in kg; - stands for standard input or output.\n"
      "Exit codes: 0 done, 1 the work failed, 2 wrong usage, 3 done and something was found (check, inspect, "
      "diff --expect-equal,\n"
      "compare --max-radial-um).");
}

void add_example(CLI::App& command) {
  const auto known = std::find_if(kCommandExamples.begin(), kCommandExamples.end(),
                                  [&](const CommandExample& one) { return one.command == command.get_name(); });
  if (known == kCommandExamples.end()) return;
  command.group(std::string(known->group));
  command.footer(fmt::format("Example:\n  plumbline {}\n\n{}", known->example, command.get_footer()));
}

void finish(CLI::App& app) {
  for (CLI::App* const command : app.get_subcommands([](const CLI::App*) { return true; })) {
    add_example(*command);
    add_names_of_standard_output(*command);
  }
  app.footer(fmt::format("Example:\n  plumbline {}\nplumbline COMMAND --help says more, with an example of it.\n\n{}",
                         kCommandExamples.front().example, app.get_footer()));
  add_diagnostics(app);
  add_loudness(app);
}

}  // namespace

Application::Application() {
  describe(app);
  for (const Command& command : kCommands) command.add(app, run);
  finish(app);
}

Application::Application(const std::string& command) {
  describe(app);
  for (const Command& one : kCommands) {
    if (is_called(one, command)) one.add(app, run);
  }
  finish(app);
}

std::optional<std::string> command_named(std::span<const char* const> arguments) {
  if (arguments.size() < 2) return std::nullopt;
  const std::string_view first = arguments[1];
  if (first == "--version") return "";
  const bool known = std::any_of(std::begin(kCommands), std::end(kCommands),
                                 [&](const Command& one) { return is_called(one, first); });
  return known ? std::optional<std::string>(first) : std::nullopt;
}

}  // namespace plumbline::cli

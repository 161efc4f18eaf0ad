#include "cli/suggest.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "machine/nearest_name.hpp"

namespace plumbline::cli {
namespace {

std::string unknown(std::string_view kind, std::string_view name, const std::vector<std::string>& known) {
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  const std::string_view nearest = machine::nearest_name(name, candidates);
  return fmt::format("no {} {}{}", kind, name, nearest.empty() ? "" : fmt::format(": did you mean {}?", nearest));
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* const command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

bool holds(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// "-m" of "-mFILE", "--model" of "--model=FILE".
std::string_view option_of(std::string_view argument) {
  return argument.starts_with("--") ? argument.substr(0, argument.find('=')) : argument.substr(0, 2);
}

bool is_option(std::string_view argument) {
  if (argument.size() < 2 || argument[0] != '-') return false;
  return argument[1] == '-' || CLI::detail::valid_first_char(argument[1]);
}

}  // namespace

std::optional<std::string> what_is_unknown(const CLI::App& app, std::span<const char* const> arguments) {
  const std::vector<CLI::App*> asked = const_cast<CLI::App&>(app).get_subcommands();
  const std::vector<std::string> commands = command_names(app);
  std::vector<std::string> options = option_names(app);
  if (!asked.empty()) {
    const std::vector<std::string> own = option_names(*asked.front());
    options.insert(options.end(), own.begin(), own.end());
  }
  for (const std::string_view argument : arguments.subspan(std::min<std::size_t>(1, arguments.size()))) {
    if (argument == "--") break;
    if (is_option(argument)) {
      const std::string_view name = option_of(argument);
      if (!holds(options, name)) return unknown("option", name, options);
    } else if (asked.empty()) {
      return holds(commands, argument) ? std::nullopt : std::optional(unknown("command", argument, commands));
    }
  }
  return std::nullopt;
}

}  // namespace plumbline::cli

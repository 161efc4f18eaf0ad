#include "cli/application/suggest.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/files/path_of.hpp"
#include "base/text/nearest_name.hpp"

namespace plumbline::cli {
namespace {

std::string unknown(std::string_view kind, std::string_view name, const std::vector<std::string>& known) {
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  const std::string_view nearest = nearest_name(name, candidates);
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
  if (argument[1] == '.' || (argument[1] >= '0' && argument[1] <= '9')) return false;  // a number below zero
  return argument[1] == '-' || CLI::detail::valid_first_char(argument[1]);
}

// "-lead.ngc"
bool is_file_name(std::string_view argument) {
  std::error_code none;
  const bool has_ending = !argument.starts_with("--") && argument.find('.') != std::string_view::npos;
  return has_ending || std::filesystem::exists(path_of(std::string(argument)), none);
}

std::string list_of(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

// A misspelt name, or one that other commands have.
std::string unknown_option(const CLI::App& app, std::string_view name, const std::vector<std::string>& options) {
  std::vector<std::string> others;
  for (const CLI::App* const command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (holds(option_names(*command), name)) others.push_back(command->get_name());
  }
  if (!others.empty() && !app.get_subcommands().empty())
    return fmt::format("no option {} here: it belongs to {}", name, list_of(others));
  if (!name.starts_with("--")) return fmt::format("no option {}", name);
  std::vector<std::string> candidates;
  std::copy_if(options.begin(), options.end(), std::back_inserter(candidates),
               [](const std::string& option) { return option.starts_with("--"); });
  return unknown("option", name, candidates);
}

// "-o FILE", "PROGRAM", "--work-offset G54=X,Y,Z,A,B,C"
std::string usage_of(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name(true);
  const std::string name =
      option.get_snames().empty() ? "--" + option.get_lnames().front() : "-" + option.get_snames().front();
  return fmt::format("{} {}", name, option.get_type_name());
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

const CLI::Option* find(const CLI::App& app, const CLI::App& command, std::string_view name) {
  const CLI::Option* const own = command.get_option_no_throw(std::string(name));
  return own != nullptr ? own : app.get_option_no_throw(std::string(name));
}

// Goes through what follows the command, as it is read: each option with its value, and the rest in order.
class Walk {
 public:
  Walk(const CLI::App& app, const CLI::App& command) : app_(app), command_(command) {
    for (const CLI::Option* const option : command.get_options()) {
      if (option->get_positional()) places_.push_back(option);
    }
  }

  // What is wrong there, if something is.
  std::optional<std::string> take(std::span<const char* const> arguments) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const std::string_view argument = arguments[i];
      if (argument == "--") return std::nullopt;
      if (!is_option(argument)) {
        if (++placed_ > places_.size()) return one_too_many(argument);
        before_ = nullptr;
        continue;
      }
      const CLI::Option* const option = find(app_, command_, option_of(argument));
      if (option == nullptr) return std::nullopt;
      before_ = option;
      if (!takes_value(*option)) continue;
      if (is_single(*option) && !seen_.insert(option).second)
        return fmt::format("{} stands twice: give it once", option_of(argument));
      if (option_of(argument) != argument) continue;  // --model=FILE, -mFILE
      if (++i == arguments.size() || names_option(arguments[i]))
        return fmt::format("{} needs its value: {}", argument, usage_of(*option));
    }
    return std::nullopt;
  }

 private:
  static bool is_single(const CLI::Option& option) { return option.get_expected_max() == 1; }
  bool names_option(std::string_view argument) const {
    return is_option(argument) && find(app_, command_, option_of(argument)) != nullptr;
  }

  std::string one_too_many(std::string_view argument) const {
    if (before_ != nullptr && !takes_value(*before_)) {
      return fmt::format("{} is one too many: {} is a switch and takes no value", argument, before_->get_name());
    }
    if (before_ != nullptr)
      return fmt::format("{} is one too many: the value of {} is one word, without blanks", argument,
                         before_->get_name());
    std::vector<std::string> wanted;
    for (const CLI::Option* const place : places_) wanted.push_back(place->get_name(true));
    if (wanted.empty())
      return fmt::format("{} is one too many: plumbline {} takes options alone", argument, command_.get_name());
    return fmt::format("{} is one too many: plumbline {} takes {}", argument, command_.get_name(), list_of(wanted));
  }

  const CLI::App& app_;
  const CLI::App& command_;
  std::vector<const CLI::Option*> places_;
  std::size_t placed_ = 0;
  const CLI::Option* before_ = nullptr;  // the option that stands before this argument
  std::set<const CLI::Option*> seen_;
};

// What is required and was not given.
std::optional<std::string> missing_in(const CLI::App& command) {
  std::vector<std::string> missing;
  for (const CLI::Option* const option : command.get_options()) {
    if (option->get_required() && option->count() == 0) missing.push_back(usage_of(*option));
  }
  if (missing.empty()) return std::nullopt;
  return fmt::format("{} {} required", fmt::join(missing, " and "), missing.size() == 1 ? "is" : "are");
}

// "-model.ngc" is read as "-m odel.ngc". Empty: no file has the name of an option with its value behind it.
std::string hint_of_file(const CLI::App& app, const CLI::App& command, std::span<const char* const> arguments) {
  for (const std::string_view argument : arguments) {
    if (argument == "--") break;
    const std::string_view name = option_of(argument);
    std::error_code none;
    if (!is_option(argument) || argument.starts_with("--") || name == argument) continue;
    if (!std::filesystem::exists(path_of(std::string(argument)), none)) continue;
    const CLI::Option* const option = find(app, command, name);
    if (option == nullptr || !takes_value(*option)) continue;
    return fmt::format("; {} is read as {} {}: if it is the file of that name, write ./{}", argument, name,
                       argument.substr(name.size()), argument);
  }
  return {};
}

}  // namespace

std::optional<std::string> what_is_wrong(const CLI::App& app, std::span<const char* const> arguments) {
  if (auto unknown = what_is_unknown(app, arguments)) return unknown;
  const std::vector<CLI::App*> asked = const_cast<CLI::App&>(app).get_subcommands();
  if (asked.empty()) return fmt::format("name a command: {}", list_of(command_names(app)));
  const auto command = std::find(arguments.begin(), arguments.end(), asked.front()->get_name());
  if (command == arguments.end()) return std::nullopt;
  const auto after = static_cast<std::size_t>(command - arguments.begin()) + 1;
  auto wrong = Walk(app, *asked.front()).take(arguments.subspan(after));
  if (!wrong) wrong = missing_in(*asked.front());
  if (wrong) *wrong += hint_of_file(app, *asked.front(), arguments.subspan(after));
  return wrong;
}

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
    if (!is_option(argument)) {
      if (!asked.empty()) continue;
      return holds(commands, argument) ? std::nullopt : std::optional(unknown("command", argument, commands));
    }
    const std::string_view name = option_of(argument);
    if (holds(options, name)) continue;
    if (is_file_name(argument))
      return fmt::format("{} is taken for an option: name the file as ./{}", argument, argument);
    return unknown_option(app, name, options);
  }
  return std::nullopt;
}

}  // namespace plumbline::cli

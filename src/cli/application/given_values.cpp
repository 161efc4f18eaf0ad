#include "cli/application/given_values.hpp"

#include <filesystem>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "cli/command.hpp"

namespace plumbline::cli {
namespace {

struct Result {
  const char* option;
  const char* is;  // what such a file is
  bool (*may_begin)(std::string_view text);
};

bool begins_with(std::string_view text, char first) {
  const std::size_t at = text.find_first_not_of(" \t\r\n");
  return at == std::string_view::npos || text[at] == first;
}

// The first line may be as long as all the text that is looked at.
bool is_rule(std::string_view text) {
  return text.empty() || text.substr(0, text.find('\n')).find(':') != std::string_view::npos;
}

constexpr Result kResults[] = {
    {"--json", "JSON", [](std::string_view text) { return begins_with(text, '{'); }},
    {"--report", "a page", [](std::string_view text) { return begins_with(text, '<'); }},
    {"--depfile", "a rule for make", is_rule},
};

std::string beginning(const std::string& path) {
  constexpr std::size_t kLookedAt = 4096;
  std::string text(kLookedAt, '\0');
  text.resize(InputFile(path).read(0, text.data(), text.size()));
  return text;
}

// Of another option: that is said in other words.
bool is_named_again(const CLI::App& command, const CLI::Option& option, const std::string& path) {
  std::error_code none;
  for (const CLI::Option* const other : command.get_options()) {
    if (other == &option) continue;
    for (const std::string& value : other->results()) {
      if (std::filesystem::equivalent(path_of(value), path_of(path), none)) return true;
    }
  }
  return false;
}

void refuse_strange_result(const CLI::App& command, const CLI::Option& option, const Result& result) {
  const std::string& path = option.results().front();
  std::error_code none;
  if (path == kStandardStream || !std::filesystem::is_regular_file(path_of(path), none)) return;
  if (is_named_again(command, option, path)) return;
  if (result.may_begin(beginning(path))) return;
  refuse("file-exists", fmt::format("{} stands there already, and is not {}", path, result.is),
         fmt::format("{} writes into the file behind it: name another one, or move this away", result.option),
         {path, 0});
}

}  // namespace

void refuse_odd_values(const CLI::App& app) {
  for (const CLI::App* const command : app.get_subcommands()) {
    for (const CLI::Option* const option : command->get_options()) {
      for (const std::string& value : option->results()) {
        if (value.empty())
          throw UsageError(fmt::format("{}: expected {}", option->get_name(), option->get_type_name()));
        if (value.front() != '=' || option->get_snames().empty()) continue;
        throw UsageError(fmt::format("-{0}{1}: between -{0} and its value stands no =; write -{0} {2}",
                                     option->get_snames().front(), value, value.substr(1)));
      }
    }
  }
}

void refuse_strange_results(const CLI::App& app) {
  for (const CLI::App* const command : app.get_subcommands()) {
    for (const Result& result : kResults) {
      const CLI::Option* const option = command->get_option_no_throw(result.option);
      if (option != nullptr && option->count() > 0) refuse_strange_result(*command, *option, result);
    }
  }
}

}  // namespace plumbline::cli

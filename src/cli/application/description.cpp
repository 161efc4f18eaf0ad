#include "cli/application/description.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/version.hpp"

namespace plumbline::cli {
namespace {

using Json = nlohmann::ordered_json;

// "on|off" of a type name, "{text,json}" of a check: the values that there are. Empty: any.
std::vector<std::string> choices_of(std::string_view type) {
  const std::size_t open = type.find(":{");
  const bool checked = open != std::string_view::npos && type.ends_with('}');
  const char between = checked ? ',' : '|';
  if (checked) type = type.substr(open + 2, type.size() - open - 3);
  std::vector<std::string> choices;
  if (!checked && type.find(between) == std::string_view::npos) return choices;
  while (true) {
    const std::size_t end = std::min(type.find(between), type.size());
    const std::string_view one = type.substr(0, end);
    if (one.empty() || one.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") != std::string_view::npos)
      return {};
    choices.emplace_back(one);
    if (end == type.size()) return choices;
    type.remove_prefix(end + 1);
  }
}

Json described(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  Json one{{"name", option.get_name(true)}, {"for", option.get_description()}};
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  one["names"] = names;
  one["takes_value"] = option.get_items_expected_min() > 0;
  one["value"] = type.substr(0, type.find(":{"));
  one["choices"] = choices_of(type);
  one["required"] = option.get_required();
  one["repeatable"] = option.get_expected_max() > 1;
  one["default"] = option.get_default_str();
  return one;
}

Json described(const CLI::App& app) {
  Json command{{"name", app.get_name()}, {"for", app.get_description()}, {"footer", app.get_footer()}};
  command["group"] = app.get_group();
  command["positionals"] = Json::array();
  command["options"] = Json::array();
  for (const CLI::Option* const option : app.get_options()) {
    if (option->get_group().empty()) continue;  // not shown
    command[option->nonpositional() ? "options" : "positionals"].push_back(described(*option));
  }
  return command;
}

}  // namespace

std::string description_json(const CLI::App& app) {
  Json program = described(app);
  program["version"] = version();
  program["commands"] = Json::array();
  for (const CLI::App* const command : app.get_subcommands([](const CLI::App*) { return true; }))
    program["commands"].push_back(described(*command));
  return program.dump(1) + "\n";
}

}  // namespace plumbline::cli

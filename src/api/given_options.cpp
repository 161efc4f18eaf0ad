#include "api/given_options.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/text/nearest_name.hpp"
#include "base/text/number_text.hpp"
#include "settings/contradiction.hpp"
#include "settings/resolved.hpp"

namespace plumbline::api {
namespace {

constexpr std::string_view kSettings = "settings";
constexpr std::string_view kMachine = "machine";
constexpr std::string_view kTools = "tools";

bool may_be_held(std::string_view name) { return name == kTools || name == "variables" || name == "poses"; }

}  // namespace

GivenOptions::GivenOptions(const Options& options, std::initializer_list<settings::OptionGroup> groups,
                           std::initializer_list<std::string_view> own)
    : given_(options.given()) {
  std::vector<std::string_view> known(own);
  for (const settings::OptionRow& row : settings::option_rows()) {
    if (std::find(groups.begin(), groups.end(), row.group) != groups.end()) known.push_back(row.name);
  }
  if (groups.size() > 0) known.insert(known.end(), {kSettings, kMachine});
  for (const Options::Given& given : given_) {
    if (std::find(known.begin(), known.end(), given.name) == known.end()) {
      const std::string help = known.empty() ? "there are no options here" : suggestion(given.name, known);
      wrong_usage(fmt::format("there is no option {}", given.name), help);
    }
    if (given.input && !may_be_held(given.name)) {
      wrong_usage(fmt::format("{} is given as an Input", given.name), "give the text that stands on the command line");
    }
  }
}

std::vector<settings::StatedOption> GivenOptions::stated() const {
  std::vector<settings::StatedOption> stated;
  settings::Options scratch;
  for (const Options::Given& given : given_) {
    const settings::OptionRow* const row = settings::find_option(given.name);
    if (row == nullptr || given.input) continue;
    try {
      settings::set_option(scratch, *row, given.value);
    } catch (const settings::OptionError& error) {
      wrong_usage(fmt::format("{} {}: {}", row->name, given.value, error.what()));
    }
    stated.push_back({row, given.value, {}});
  }
  if (const std::optional<std::string> why = settings::contradiction(scratch)) wrong_usage(*why);
  return stated;
}

settings::Options GivenOptions::program_options(const Model& model) const {
  settings::SettingsRequest request;
  request.given = stated();
  request.machine = text(kMachine).value_or("");
  std::vector<std::string> files;
  if (const std::optional<std::string> file = text(kSettings)) files.push_back(*file);
  settings::Options options = settings::resolve_settings(request, files).options;
  for (const Options::Given& given : given_) {
    if (!given.input || settings::find_option(given.name) == nullptr) continue;
    (given.name == kTools ? options.paths.tools : options.paths.variables) = Inside::source(*given.input);
  }
  if (model.is_given()) options.paths.model = Inside::source(model);
  return options;
}

settings::Options GivenOptions::machine_options(const Model& model) const {
  settings::Options options = program_options(model);
  if (options.paths.model.empty()) no_model();
  return options;
}

std::optional<std::string> GivenOptions::text(std::string_view name) const {
  const auto last = std::find_if(given_.rbegin(), given_.rend(), [&](const auto& given) { return given.name == name; });
  return last == given_.rend() ? std::nullopt : std::optional(last->value);
}

Source GivenOptions::source(std::string_view name) const {
  Source source;
  for (const Options::Given& given : given_) {
    if (given.name == name) source = given.input ? Inside::source(*given.input) : Source(given.value);
  }
  return source;
}

bool GivenOptions::is_on(std::string_view name) const {
  const std::optional<std::string> value = text(name);
  if (value && *value != "on" && *value != "off") wrong_usage(fmt::format("{} {}: expected on or off", name, *value));
  return value == "on";
}

std::optional<double> GivenOptions::number(std::string_view name) const {
  const std::optional<std::string> value = text(name);
  if (!value) return std::nullopt;
  const std::optional<double> number = parse_number(*value);
  if (!number) wrong_usage(fmt::format("{} {}: expected a number", name, *value));
  return number;
}

std::optional<double> GivenOptions::positive(std::string_view name) const {
  const std::optional<double> value = number(name);
  if (value && !(*value > 0)) wrong_usage(fmt::format("{} {}: expected a positive number", name, *text(name)));
  return value;
}

std::vector<std::string> GivenOptions::list(std::string_view name) const {
  std::vector<std::string> texts;
  for (const std::string& given : each(name)) {
    for (std::size_t at = 0; at <= given.size();) {
      const std::size_t end = std::min(given.find(',', at), given.size());
      texts.push_back(given.substr(at, end - at));
      at = end + 1;
    }
  }
  return texts;
}

std::vector<std::string> GivenOptions::each(std::string_view name) const {
  std::vector<std::string> texts;
  for (const Options::Given& given : given_) {
    if (given.name == name) texts.push_back(given.value);
  }
  return texts;
}

}  // namespace plumbline::api

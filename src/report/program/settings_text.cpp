#include "report/program/settings_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/files/files.hpp"
#include "settings/output_name.hpp"

namespace plumbline::report {
namespace {

using settings::ResolvedSettings;
using settings::StatedOption;
using Json = nlohmann::ordered_json;

std::string from(const Place& place) {
  return place.file.empty() ? "the command line" : fmt::format("{}:{}", place.file, place.line);
}

std::string machine_text(const ResolvedSettings& resolved) {
  if (!resolved.options.machine.empty())
    return fmt::format("machine {}, as {} says\n", resolved.options.machine, from(resolved.machine_place));
  const std::string choice = settings::choice_of_machine(resolved.options);
  return choice.empty() ? "" : fmt::format("no machine named; {}\n", choice);
}

// Empty: the program is not named, or comes from standard input.
std::string output_text(const ResolvedSettings& resolved, const std::string& program) {
  if (program.empty() || program == kStandardStream) return {};
  return settings::output_name(program, resolved.options);
}

}  // namespace

std::string settings_text(const ResolvedSettings& resolved, const std::string& program) {
  std::size_t names = 0;
  std::size_t values = 0;
  for (const StatedOption& one : resolved.stated) {
    names = std::max(names, one.row->name.size());
    values = std::max(values, one.text.size());
  }
  std::string text = machine_text(resolved);
  for (const StatedOption& one : resolved.stated)
    text += fmt::format("  {:<{}}  {:<{}}  {}\n", one.row->name, names, one.text, values, from(one.place));
  if (resolved.stated.empty()) text += "nothing is stated: every option is as by default\n";
  const std::vector<std::string>& files = resolved.options.paths.settings_files;
  if (!files.empty()) text += fmt::format("read, the one that counts most first: {}\n", fmt::join(files, ", "));
  if (const std::string output = output_text(resolved, program); !output.empty())
    text += fmt::format("output where -o does not say: {}\n", output);
  return text + "all other options are as by default: plumbline compensate --help\n";
}

std::string settings_json(const ResolvedSettings& resolved, const std::string& program) {
  Json options = Json::array();
  for (const StatedOption& one : resolved.stated) {
    const bool has_file = !one.place.file.empty();
    options.push_back({{"name", one.row->name},
                       {"value", one.text},
                       {"file", has_file ? Json(one.place.file) : Json()},
                       {"line", has_file ? Json(one.place.line) : Json()}});
  }
  const std::string output = output_text(resolved, program);
  const std::string& machine = resolved.options.machine;
  const Json json{{"plumbline", "resolved settings 1"},
                  {"program", program.empty() ? Json() : Json(program)},
                  {"machine", machine.empty() ? Json() : Json(machine)},
                  {"machines", resolved.options.machines},
                  {"files", resolved.options.paths.settings_files},
                  {"output", output.empty() ? Json() : Json(output)},
                  {"options", options}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace plumbline::report

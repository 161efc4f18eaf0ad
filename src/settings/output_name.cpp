#include "settings/output_name.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "base/files/path_of.hpp"
#include "settings/options.hpp"

namespace plumbline::settings {
namespace {

constexpr std::array<std::string_view, 4> kNames{"folder", "name", "ext", "machine"};

// Calls `take` with each text between the braces, and `copy` with what stands around them.
template <class Copy, class Take>
void each_part(std::string_view pattern, const Copy& copy, const Take& take) {
  while (!pattern.empty()) {
    const std::size_t open = pattern.find('{');
    copy(pattern.substr(0, open));
    if (open == std::string_view::npos) return;
    const std::size_t close = pattern.find('}', open);
    if (close == std::string_view::npos) throw OptionError("a { in it has no }");
    take(pattern.substr(open + 1, close - open - 1));
    pattern.remove_prefix(close + 1);
  }
}

}  // namespace

void check_output_pattern(std::string_view pattern) {
  bool has_name = false;
  each_part(
      pattern,
      [](std::string_view text) {
        if (text.find('}') != std::string_view::npos) throw OptionError("a } in it has no {");
      },
      [&](std::string_view name) {
        if (std::find(kNames.begin(), kNames.end(), name) == kNames.end())
          throw OptionError("expected no braces but {folder}, {name}, {ext} and {machine}");
        has_name = has_name || name == "name";
      });
  if (!has_name) throw OptionError("expected {name} in it: else all programs have the same output");
}

std::string output_name(std::string_view pattern, const std::string& program, const std::string& machine) {
  const std::filesystem::path path = path_of(program);
  std::string name;
  each_part(
      pattern, [&](std::string_view text) { name += text; },
      [&](std::string_view part) {
        if (part == "folder") {
          const std::string folder = path.parent_path().generic_string();
          name += folder.empty() ? "." : folder;
        } else if (part == "name") {
          name += path.stem().generic_string();
        } else if (part == "ext") {
          name += path.extension().generic_string();
        } else if (machine.empty()) {
          throw OptionError("it holds {machine}, and no machine is named: --machine NAME");
        } else {
          name += machine;
        }
      });
  return path_of(name).lexically_normal().generic_string();
}

std::string output_name(const std::string& program, const Options& options) {
  const std::string_view pattern = options.output_pattern.empty() ? kOutputPattern : options.output_pattern;
  return output_name(pattern, program, options.machine);
}

}  // namespace plumbline::settings

#include "nc/language/tool_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/files/input_name.hpp"
#include "base/text/characters.hpp"
#include "base/text/toml.hpp"
#include "nc/language/linuxcnc_tool_table.hpp"
#include "nc/language/tool_limits.hpp"

namespace plumbline::nc {
namespace {

constexpr std::string_view kVersion = "tools 1";
constexpr std::array<std::string_view, 6> kKeys{"number",      "name",    "length_mm",
                                                "diameter_mm", "mass_kg", "centre_of_mass_mm"};
constexpr std::size_t kDigitsOfNumber = 8;

bool is_key(std::string_view key) { return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end(); }

class ToolReader {
 public:
  explicit ToolReader(const TomlDocument& document) : document_(document) {}

  std::vector<Tool> read() {
    check_version();
    std::vector<Tool> tools;
    for (const TomlEntry& entry : document_.root.entries) {
      if (entry.key == "plumbline") continue;
      if (entry.key != "tool" || entry.value.kind != TomlValue::Kind::array) {
        refuse_key("tools-unknown-key", entry, fmt::format("a tool table has no key '{}'", entry.key),
                   "write each tool as [[tool]]");
      }
      for (const TomlValue& row : entry.value.items) tools.push_back(read_row(row));
    }
    return tools;
  }

 private:
  [[noreturn]] void refuse_key(std::string_view code, const TomlEntry& entry, std::string message, std::string help) {
    refuse(code, std::move(message), std::move(help), document_.place(entry.key_span));
  }

  void check_version() {
    const TomlEntry* const entry = document_.root.find("plumbline");
    if (entry == nullptr || entry->value.kind != TomlValue::Kind::text || entry->value.text != kVersion) {
      Place place;
      place.file = document_.file;
      refuse("tools-version", "this is no tool table", fmt::format("begin it with plumbline = \"{}\"", kVersion),
             entry == nullptr ? place : document_.place(entry->value.span));
    }
  }

  Tool read_row(const TomlValue& row) {
    if (row.kind != TomlValue::Kind::table) {
      refuse("tools-value", "a tool is a table", "write each tool as [[tool]]", document_.place(row.span));
    }
    Tool tool;
    bool has_number = false;
    bool has_length = false;
    for (const TomlEntry& entry : row.entries) {
      if (!is_key(entry.key)) {
        refuse_key("tools-unknown-key", entry, fmt::format("a tool has no key '{}'", entry.key),
                   fmt::format("its keys are {}", fmt::join(kKeys, ", ")));
      }
      if (entry.key == "name") {
        tool.name = name(entry);
        continue;
      }
      const double value = number(entry);
      if (entry.key == "number") {
        tool.number = tool_number(entry, value);
        has_number = true;
      } else if (entry.key == "length_mm") {
        tool.length_mm = length(entry, value);
        has_length = true;
      } else if (entry.key == "diameter_mm") {
        tool.diameter_mm = in_range(entry, value, 0);
      } else if (entry.key == "mass_kg") {
        tool.mass_kg = in_range(entry, value, 0);
      } else {
        tool.centre_of_mass_mm = in_range(entry, value, -kLongestTool);
      }
    }
    if (!has_number || !has_length) {
      refuse("tools-missing-key", fmt::format("a tool without {}", has_number ? "length_mm" : "number"),
             "each [[tool]] needs number and length_mm", document_.place(row.span));
    }
    return tool;
  }

  std::string name(const TomlEntry& entry) {
    const std::string& text = entry.value.text;
    const Place place = document_.place(entry.value.span);
    if (entry.value.kind != TomlValue::Kind::text || text.empty() || std::any_of(text.begin(), text.end(), [](char c) {
          return static_cast<unsigned char>(c) < ' ' || c == '"' || c == '\'';
        })) {
      refuse("tools-value", "'name' is no name of a tool", "write what stands after T=, as in name = \"MILL10\"",
             place);
    }
    if (is_tool_number(text)) {
      refuse("tools-value", fmt::format("T=\"{}\" calls a tool by its number", text), "write number alone", place);
    }
    if (!names_.insert(text).second) {
      refuse("tools-twice", fmt::format("the name '{}' stands here twice", text), "leave one of them", place);
    }
    return text;
  }

  double number(const TomlEntry& entry) {
    if (entry.value.kind == TomlValue::Kind::number && std::isfinite(entry.value.number)) return entry.value.number;
    refuse("tools-value", fmt::format("'{}' is no number", entry.key),
           entry.value.kind == TomlValue::Kind::text     ? "write a number without quotes"
           : entry.value.kind == TomlValue::Kind::number ? "write the number itself: nan and inf are none"
                                                         : "write one number, without brackets",
           document_.place(entry.value.span));
  }

  double in_range(const TomlEntry& entry, double value, double least) {
    if (value >= least && value <= kLongestTool) return value;
    refuse("tools-value", fmt::format("'{}' is out of range", entry.key),
           fmt::format("write {} to {}, in the unit that the key names", least, kLongestTool),
           document_.place(entry.value.span));
  }

  double length(const TomlEntry& entry, double value) {
    if (value == 0 || std::abs(value) >= kShortestTool) return in_range(entry, value, -kLongestTool);
    refuse("tools-value", fmt::format("a tool of {} mm is shorter than any", value),
           fmt::format("write millimetres: {:g} if these are metres; lengths count from the gauge point of the spindle",
                       value * 1000),
           document_.place(entry.value.span));
  }

  int tool_number(const TomlEntry& entry, double value) {
    if (value < 1 || value > kLargestToolNumber || value != std::floor(value)) {
      refuse("tools-value", "the number of a tool is a whole number from 1", "write the T word's number",
             document_.place(entry.value.span));
    }
    const int number = static_cast<int>(value);
    if (!seen_.insert(number).second) {
      refuse("tools-twice", fmt::format("tool {} stands here twice", number), "leave one of them",
             document_.place(entry.value.span));
    }
    return number;
  }

  const TomlDocument& document_;
  std::set<int> seen_;
  std::set<std::string> names_;
};

}  // namespace

const Tool* ToolTable::find(int number) const {
  const auto at = std::find_if(tools_.begin(), tools_.end(), [&](const Tool& tool) { return tool.number == number; });
  return at == tools_.end() ? nullptr : &*at;
}

const Tool* ToolTable::find(std::string_view name) const {
  const auto at = std::find_if(tools_.begin(), tools_.end(), [&](const Tool& tool) { return tool.name == name; });
  return name.empty() || at == tools_.end() ? nullptr : &*at;
}

bool is_tool_number(std::string_view name) {
  const bool as_written = name == "0" || !name.starts_with('0');
  return as_written && !name.empty() && name.size() <= kDigitsOfNumber &&
         std::all_of(name.begin(), name.end(), is_digit);
}

ToolTable read_tool_table(const Source& source) {
  std::string text = read_text(source);
  // LinuxCNC's table of no tools is an empty file.
  const bool is_blank = text.find_first_not_of(" \t\r\n") == std::string::npos;
  if (is_blank && source.path().ends_with(".tbl")) return {};
  if (is_linuxcnc_tool_table(text)) return ToolTable(read_linuxcnc_tool_table(text, source.name()));
  const TomlDocument document = parse_toml(std::move(text), source.name());
  return ToolTable(ToolReader(document).read());
}

}  // namespace plumbline::nc

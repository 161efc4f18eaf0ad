#include "jobs/program/used_tools.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "base/files/files_beside.hpp"
#include "base/files/path_of.hpp"
#include "base/text/characters.hpp"
#include "nc/syntax/line_source.hpp"

namespace plumbline::jobs {
namespace {

namespace fs = std::filesystem;

constexpr int kLargestNumber = 99999999;
constexpr std::string_view kG92Restored = "92.3";

bool is_name_letter(char c) { return is_letter(c) || c == '_'; }

// What programs and files are compared by: lower case; of O0100, P100 and 0100.nc the number alone.
std::string plain_name(std::string_view text) {
  if (text.size() > 1 && is_name_letter(text[0]) && is_digit(text[1])) text.remove_prefix(1);
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_digit)) {
    text.remove_prefix(std::min(text.find_first_not_of('0'), text.size() - 1));
  }
  std::string name(text);
  for (char& c : name) c = lower(c);
  return name;
}

class Scan {
 public:
  void take(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const char c = line[i];
      if (c == ';') return;
      if (c == '(') i = std::min(line.find(')', i), line.size());
      if (is_name_letter(c) && (i == 0 || !is_name_letter(line[i - 1]))) note_name(line, i);
      if (lower(c) == 'g') note_g_code(line, i + 1);
      if (std::string_view("TtHhQq").find(c) == std::string_view::npos) continue;
      std::size_t at = i + 1;
      while (at < line.size() && (is_blank(line[at]) || line[at] == '+')) ++at;
      if (at < line.size() && line[at] == '=') {
        const std::size_t quote = line.find_first_not_of(" \t", at + 1);
        if (quote < line.size() && (line[quote] == '"' || line[quote] == '\'')) {
          i = take_quoted(line, quote);
          continue;
        }
      }
      if (at < line.size() && (line[at] == '#' || line[at] == '[' || line[at] == '=')) has_expression_ = true;
      if (at < line.size() && is_digit(line[at])) take_number(line, at);
    }
  }

  /// True if the text may call a program of this name.
  bool may_call(const std::string& name) const { return names_.contains(name); }
  bool may_call_any() const { return !names_.empty(); }
  bool may_restore_g92() const { return restores_g92_; }
  bool may_use(const nc::Tool& tool) const {
    return has_expression_ || numbers_.contains(tool.number) || tool_names_.contains(tool.name);
  }

 private:
  void note_g_code(std::string_view line, std::size_t at) {
    std::string code;
    for (; at < line.size() && code.size() < kG92Restored.size(); ++at) {
      if (!is_blank(line[at]) && !(code.empty() && line[at] == '0')) code += line[at];
    }
    restores_g92_ = restores_g92_ || code == kG92Restored || code.starts_with('#') || code.starts_with('[');
  }

  // Names of two letters or more, and numbers after letters that programs are called with: few in any program.
  void note_name(std::string_view line, std::size_t at) {
    std::size_t end = at;
    while (end < line.size() && (is_name_letter(line[end]) || is_digit(line[end]))) ++end;
    const std::string_view text = line.substr(at, end - at);
    const bool short_name = text.size() > 1 && !is_name_letter(text[1]);
    if (text.size() < 2 || (short_name && std::string_view("OoPpLl").find(text[0]) == std::string_view::npos)) return;
    names_.insert(plain_name(text));
  }

  // T="12", T="MILL10"; gives where it ends.
  std::size_t take_quoted(std::string_view line, std::size_t quote) {
    const std::size_t end = std::min(line.find(line[quote], quote + 1), line.size());
    const std::string_view name = line.substr(quote + 1, end - quote - 1);
    if (nc::is_tool_number(name)) {
      take_number(name, 0);
    } else if (!name.empty()) {
      tool_names_.emplace(name);
    }
    return end;
  }

  void take_number(std::string_view line, std::size_t at) {
    int number = 0;
    for (; at < line.size() && (is_digit(line[at]) || is_blank(line[at])); ++at) {
      if (is_digit(line[at])) number = std::min(number * 10 + (line[at] - '0'), kLargestNumber / 10);
    }
    numbers_.insert(number);
  }

  bool has_expression_ = false;
  bool restores_g92_ = false;
  std::set<int> numbers_;
  std::set<std::string> names_;
  std::set<std::string> tool_names_;
};

void take_file(Scan& scan, const InputFile& file) {
  nc::LineSource lines(file);
  for (nc::Line line; lines.next(line);) scan.take(line.text);
}

// Files of subprograms stand beside the program, and are named after what calls them.
void take_called_files(Scan& scan, const InputFile& program) {
  if (!scan.may_call_any()) return;
  const fs::path folder = path_of(program.name()).parent_path();
  std::set<fs::path> waiting;
  std::error_code ignored;
  const auto add_folder = [&](const fs::path& path) {
    for (const auto& entry : fs::directory_iterator(path, ignored)) waiting.insert(entry.path());
  };
  add_folder(folder.empty() ? fs::path(".") : folder);
  for (bool found = true; found;) {
    found = false;
    for (auto path = waiting.begin(); path != waiting.end() && !found; ++path) {
      std::string stem = plain_name(path->stem().generic_string());
      if (stem.starts_with("_n_")) stem = stem.substr(3, stem.rfind('_') - 3);
      if (!scan.may_call(stem)) continue;
      found = true;  // it may name others
      const std::string file = path->generic_string();
      waiting.erase(path);
      if (fs::is_directory(path_of(file), ignored)) add_folder(path_of(file));  // o<subs/deep> CALL
      if (!fs::is_regular_file(path_of(file), ignored) || program.is_same_as(file)) break;
      FilesBeside::note(program.name(), "", file);
      take_file(scan, InputFile(file));
      break;
    }
  }
}

}  // namespace

std::vector<nc::Tool> used_tools(const InputFile& program, const nc::ToolTable& tools,
                                 std::optional<int> tool_in_spindle) {
  if (tools.empty()) return {};
  Scan scan;
  take_file(scan, program);
  take_called_files(scan, program);
  std::vector<nc::Tool> used;
  for (const nc::Tool& tool : tools.all()) {
    if (scan.may_use(tool) || tool.number == tool_in_spindle) used.push_back(tool);
  }
  return used;
}

bool may_restore_g92(const InputFile& program) {
  Scan scan;
  take_file(scan, program);
  take_called_files(scan, program);
  return scan.may_restore_g92();
}

}  // namespace plumbline::jobs

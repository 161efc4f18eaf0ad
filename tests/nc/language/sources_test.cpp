// Each row of a table of grammar/ names the source that says so, or says that it is a setting.
#include <set>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/text/toml.hpp"

using namespace plumbline;

namespace {

// The tables gone through so far; LinuxCNC's own program is at hand, and the tests run it.
const std::vector<std::string> kSourced = {
    "fanuc",
    "siemens",
    "okuma",
};

std::set<std::string> sources_of(const TomlValue& root) {
  const TomlEntry* const entry = root.find("sources");
  std::set<std::string> names;
  if (entry == nullptr) return names;
  for (const TomlEntry& source : entry->value.entries) names.insert(source.key);
  return names;
}

bool names_source(const std::string& text, const std::set<std::string>& sources) {
  return text.starts_with("setting") || sources.contains(text.substr(0, text.find(' ')));
}

// "[P 4.2]" or "(setting)" after the #.
bool comment_names_source(const std::string& line, const std::set<std::string>& sources) {
  const std::size_t comment = line.find('#');
  if (comment == std::string::npos) return false;
  if (line.find("(setting", comment) != std::string::npos) return true;
  for (std::size_t at = line.find('[', comment); at != std::string::npos; at = line.find('[', at + 1)) {
    if (names_source(line.substr(at + 1, line.find_first_of(" ],", at) - at - 1), sources)) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("every code that is read has a source, or is called a setting") {
  for (const std::string& name : kSourced) {
    const std::string path = fmt::format("{}/grammar/{}.toml", PLUMBLINE_SOURCE_DIR, name);
    const TomlDocument document = parse_toml(read_text(path), path);
    const std::set<std::string> sources = sources_of(document.root);
    CHECK_FALSE(sources.empty());
    for (const char* const key : {"g", "m", "names"}) {
      const TomlEntry* const rows = document.root.find(key);
      if (rows == nullptr) continue;
      for (const TomlValue& row : rows->value.items) {
        if (row.find("does")->value.text == "refused") continue;
        INFO(name << ": " << key << " " << row.find("code")->value.text);
        const TomlEntry* const source = row.find("source");
        CHECK((source != nullptr && names_source(source->value.text, sources)));
      }
    }
  }
}

TEST_CASE("every habit of a control has a source, or is called a setting") {
  for (const std::string& name : kSourced) {
    const std::string path = fmt::format("{}/grammar/{}.toml", PLUMBLINE_SOURCE_DIR, name);
    const std::string text = read_text(path);
    const std::set<std::string> sources = sources_of(parse_toml(std::string(text), path).root);
    std::istringstream lines(text);
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with('[')) inside = line == "[syntax]" || line == "[habits]";
      if (!inside || line.find(" = ") == std::string::npos || line.starts_with('#')) continue;
      INFO(name << ": " << line);
      CHECK(comment_names_source(line, sources));
    }
  }
}

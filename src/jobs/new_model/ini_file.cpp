#include "jobs/new_model/ini_file.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "base/text/number_text.hpp"

namespace plumbline::jobs {
namespace {

constexpr std::string_view kIniBlanks = " \t\r";
constexpr std::string_view kInclude = "#INCLUDE";
constexpr int kDeepestInclude = 16;

// What of a text lies between blanks, as offset and length.
std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kIniBlanks);
  if (first == std::string_view::npos) return text.substr(text.size());
  return text.substr(first, text.find_last_not_of(kIniBlanks) - first + 1);
}

class IniReader {
 public:
  explicit IniReader(IniFile& ini) : ini_(ini) {}

  void read(const std::string& path, int depth) {
    const std::string text = read_text(path);
    const std::string_view all = text;
    for (std::size_t at = 0; at < all.size();) {
      const std::size_t end = std::min(all.find('\n', at), all.size());
      const std::string_view line = trimmed(all.substr(at, end - at));
      const auto place = [&](std::string_view part) {
        const auto offset = static_cast<std::size_t>(part.data() - all.data());
        return place_in(path, all, offset, std::max<std::size_t>(part.size(), 1));
      };
      at = end + 1;
      if (line.starts_with(kInclude)) {
        include(trimmed(line.substr(kInclude.size())), path, depth, place(line));
      } else if (!line.empty() && line.front() != '#' && line.front() != ';') {
        add(line, place);
      }
    }
  }

 private:
  void include(std::string_view name, const std::string& from, int depth, const Place& place) {
    const std::filesystem::path path = path_of(from).parent_path() / path_of(name);
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
      refuse("draft-file", fmt::format("there is no file {}", path.generic_string()),
             "paths count from the file that includes it", place);
    }
    if (depth >= kDeepestInclude) {
      refuse("draft-file", "files include each other without end", "leave one of the inclusions out", place);
    }
    read(path.generic_string(), depth + 1);
  }

  template <class PlaceOf>
  void add(std::string_view line, const PlaceOf& place) {
    if (line.front() == '[') {
      const std::size_t close = line.find(']');
      if (close == std::string_view::npos)
        refuse("draft-syntax", "the name of a section does not end", "write it as [SECTION]", place(line));
      section_ = trimmed(line.substr(1, close - 1));
      return;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
      refuse("draft-syntax", "this line is no section, no KEY = VALUE and no comment",
             "write KEY = VALUE, or begin it with #", place(line));
    }
    const std::string_view value = trimmed(line.substr(equals + 1));
    ini_.entries.push_back({section_, std::string(trimmed(line.substr(0, equals))), std::string(value), place(value)});
  }

  IniFile& ini_;
  std::string section_;
};

}  // namespace

const IniEntry* IniFile::find(std::string_view section, std::string_view key) const {
  for (const IniEntry& entry : entries) {
    if (entry.section == section && entry.key == key) return &entry;
  }
  return nullptr;
}

IniFile read_ini(const std::string& path) {
  IniFile ini{path, {}};
  IniReader(ini).read(path, 0);
  return ini;
}

std::vector<double> numbers_of(const IniEntry& entry) {
  const std::string_view all = std::string_view(entry.value).substr(0, entry.value.find_first_of("#;"));
  std::vector<double> numbers;
  for (std::size_t at = all.find_first_not_of(kIniBlanks); at < all.size();
       at = all.find_first_not_of(kIniBlanks, at)) {
    const std::size_t end = std::min(all.find_first_of(kIniBlanks, at), all.size());
    const std::string_view word = all.substr(at, end - at);
    const std::optional<double> number = parse_number(word);
    if (!number) {
      Place place = entry.place;
      place.column += at;
      place.length = word.size();
      refuse("draft-number", fmt::format("{} of [{}]: this is no number", entry.key, entry.section),
             "write it with a decimal point and no unit, as 29.7466", place);
    }
    numbers.push_back(*number);
    at = end;
  }
  if (numbers.empty()) {
    refuse("draft-number", fmt::format("{} of [{}] has no value", entry.key, entry.section),
           "write a number behind the =", entry.place);
  }
  return numbers;
}

}  // namespace plumbline::jobs

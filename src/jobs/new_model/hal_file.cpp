#include "jobs/new_model/hal_file.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/path_of.hpp"
#include "base/text/number_text.hpp"

namespace plumbline::jobs {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestSource = 16;
constexpr std::string_view kHalBlanks = " \t\r=";

struct Word {
  std::string_view text;
  Place place;
};

class HalReader {
 public:
  HalReader(HalPins& pins, const IniFile& ini, std::string_view prefix) : pins_(pins), ini_(ini), prefix_(prefix) {}

  // `from` is where the file is named.
  void read(const std::string& name, const Place& from, int depth) {
    const fs::path path = path_of(ini_.file).parent_path() / path_of(name);
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
      refuse("draft-file", fmt::format("there is no file {}", path.generic_string()),
             "paths count from the folder of the INI file; name HAL files yourself with --hal", from);
    }
    if (depth >= kDeepestSource)
      refuse("draft-file", "files source each other without end", "leave one of the lines out", from);
    read_lines(path.generic_string(), read_text(path.generic_string()), depth);
  }

  void read_lines(const std::string& file, std::string text, int depth) {
    if (std::find(pins_.files.begin(), pins_.files.end(), file) == pins_.files.end()) pins_.files.push_back(file);
    const std::string original = text;
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {  // a line goes on behind a backslash
      const std::size_t end = text[i + 1] == '\r' ? i + 2 : i + 1;
      if (text[i] == '\\' && end < text.size() && text[end] == '\n') std::fill(&text[i], &text[end] + 1, ' ');
    }
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      const std::string_view line = std::string_view(text).substr(at, end - at);
      std::vector<Word> words;
      const std::string_view command = line.substr(0, line.find('#'));
      for (std::size_t w = command.find_first_not_of(kHalBlanks); w < command.size();
           w = command.find_first_not_of(kHalBlanks, w)) {
        const std::size_t stop = std::min(command.find_first_of(kHalBlanks, w), command.size());
        words.push_back({command.substr(w, stop - w), place_in(file, original, at + w, stop - w)});
        w = stop;
      }
      at = end + 1;
      if (!words.empty()) obey(words, depth);
    }
  }

  // A HALCMD line of the INI.
  void obey_entry(const IniEntry& entry) {
    std::vector<Word> words;
    const std::string_view command = entry.value;
    for (std::size_t w = command.find_first_not_of(kHalBlanks); w < command.size();
         w = command.find_first_not_of(kHalBlanks, w)) {
      const std::size_t stop = std::min(command.find_first_of(kHalBlanks, w), command.size());
      Place place = entry.place;
      place.column += w;
      place.length = stop - w;
      words.push_back({command.substr(w, stop - w), place});
      w = stop;
    }
    if (!words.empty()) obey(words, 0);
  }

 private:
  void obey(const std::vector<Word>& words, int depth) {
    const std::string_view verb = words.front().text;
    if (verb == "source" && words.size() > 1) {
      read(std::string(words[1].text), words[1].place, depth + 1);
    } else if (verb == "setp" && words.size() > 2) {
      set(words[1], words[2]);
    } else if (verb == "net") {
      refuse_signals(words);
    } else if (words.size() == 2) {  // PIN = VALUE
      set(words[0], words[1]);
    }
  }

  void set(const Word& pin, const Word& value) {
    if (!pin.text.starts_with(prefix_)) return;
    const HalPin set{std::string(pin.text), number(pin, value), value.place};
    const HalPin* const before = pins_.find(pin.text);
    if (before == nullptr) {
      pins_.pins.push_back(set);
    } else if (before->value != set.value) {
      refuse("draft-contradiction",
             fmt::format("{} is {} here and {} in {}:{}", pin.text, set.value, before->value, before->place.file,
                         before->place.line),
             "LinuxCNC takes the later one; leave the wrong one out", value.place);
    }
  }

  double number(const Word& pin, const Word& value) const {
    if (value.text.starts_with('[')) return number_of_ini(pin, value);
    const std::optional<double> number = parse_number(value.text);
    if (!number)
      refuse("draft-number", fmt::format("the value of {} is no number", pin.text),
             "write it with a decimal point and no unit, as -22.95, or as [SECTION]KEY of the INI file", value.place);
    return *number;
  }

  // [SECTION]KEY or [SECTION](KEY)
  double number_of_ini(const Word& pin, const Word& value) const {
    const std::size_t close = value.text.find(']');
    std::string_view key = close == std::string_view::npos ? "" : value.text.substr(close + 1);
    if (key.starts_with('(') && key.ends_with(')')) key = key.substr(1, key.size() - 2);
    const IniEntry* const entry =
        close == std::string_view::npos ? nullptr : ini_.find(value.text.substr(1, close - 1), key);
    if (entry == nullptr) {
      refuse("draft-missing",
             fmt::format("{} takes its value from {}, which {} does not have", pin.text, value.text, ini_.file),
             "add it to the INI file, or write the number here", value.place);
    }
    return numbers_of(*entry).front();
  }

  // Where joints lie does not change: a pin of the geometry on a signal is set by something that nobody can read here.
  void refuse_signals(const std::vector<Word>& words) const {
    for (const Word& word : words) {
      if (!word.text.starts_with(prefix_)) continue;
      const std::string_view pin = word.text.substr(prefix_.size());
      if (!pin.starts_with("base.") && !pin.starts_with("platform.") && pin != "spindle-offset") continue;
      refuse("draft-signal", fmt::format("{} is set by a signal: its value is not in this file", word.text),
             "write setp and its number instead, at least for plumbline", word.place);
    }
  }

  HalPins& pins_;
  const IniFile& ini_;
  std::string_view prefix_;
};

bool is_hal(std::string_view name) { return name.ends_with(".hal"); }

}  // namespace

const HalPin* HalPins::find(std::string_view name) const {
  for (const HalPin& pin : pins) {
    if (pin.name == name) return &pin;
  }
  return nullptr;
}

HalPins read_hal(const std::vector<std::string>& files, const IniFile& ini, std::string_view prefix) {
  HalPins pins;
  HalReader reader(pins, ini, prefix);
  for (const std::string& file : files) reader.read_lines(file, read_text(file), 0);
  if (!files.empty()) return pins;
  for (const char* const key : {"HALFILE", "HALCMD", "POSTGUI_HALFILE"}) {
    for (const IniEntry& entry : ini.entries) {
      if (entry.section != "HAL" || entry.key != key) continue;
      const std::string name = entry.value.substr(0, entry.value.find_first_of(" \t"));
      if (entry.key == "HALCMD") {
        reader.obey_entry(entry);
      } else if (is_hal(name) && !name.starts_with("LIB:")) {
        reader.read(name, entry.place, 0);
      } else {
        pins.other_files.push_back(name);
      }
    }
  }
  return pins;
}

}  // namespace plumbline::jobs

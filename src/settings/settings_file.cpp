#include "settings/settings_file.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "base/files/input_name.hpp"
#include "base/files/path_of.hpp"
#include "base/text/nearest_name.hpp"
#include "base/text/toml.hpp"
#include "settings/contradiction.hpp"
#include "settings/output_name.hpp"

namespace plumbline::settings {

std::string key_of(std::string_view option) {
  std::string key(option);
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

namespace {

namespace fs = std::filesystem;
using Kind = TomlValue::Kind;

std::string list_of_keys() {
  std::string list;
  for (const OptionRow& row : option_rows()) list += fmt::format("{}{}", list.empty() ? "" : ", ", key_of(row.name));
  return list;
}

// "did you mean step_angle? "; empty where none is near.
std::string nearest_key(std::string_view written) {
  const std::string key = key_of(written);
  std::vector<std::string> keys{"machine", "machines"};
  for (const OptionRow& row : option_rows()) keys.push_back(key_of(row.name));
  return did_you_mean(key, {keys.begin(), keys.end()});
}

const OptionRow* row_of_key(std::string_view key) {
  const auto rows = option_rows();
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const OptionRow& row) { return key_of(row.name) == key; });
  return found == rows.end() ? nullptr : &*found;
}

class SettingsReader {
 public:
  explicit SettingsReader(const TomlDocument& document) : document_(document) {}

  SettingsFile read() {
    check_kind();
    SettingsFile file;
    for (const TomlEntry& entry : document_.root.entries) {
      if (entry.key == "plumbline") continue;
      if (entry.key == "machine") {
        file.machine = text_of(entry, entry.value);
        file.machine_place = document_.place(entry.value.span);
      } else if (entry.key == "machines") {
        take_machines(entry, file);
      } else {
        take(entry, file.options);
      }
    }
    check_together(file.options, document_.root);
    return file;
  }

 private:
  void check_kind() const {
    const TomlEntry* const kind = document_.root.find("plumbline");
    if (kind != nullptr && kind->value.kind == Kind::text && kind->value.text == "settings 1") return;
    refuse("settings-kind", "this is no settings file: it does not begin with plumbline = \"settings 1\"",
           "add that line, or leave the file out with --no-settings",
           kind != nullptr ? document_.place(kind->value.span) : document_.place({0, 1}));
  }

  void take_machines(const TomlEntry& entry, SettingsFile& file) const {
    if (entry.value.kind != Kind::table) refuse_type(entry, entry.value);
    for (const TomlEntry& machine : entry.value.entries) {
      if (machine.value.kind != Kind::table) refuse_type(machine, machine.value);
      std::vector<StatedOption>& options = file.machines[machine.key];
      for (const TomlEntry& item : machine.value.entries) take(item, options);
      check_together(options, machine.value);
    }
  }

  // Each value is tried on options that nobody uses, so that what is wrong shows with its place.
  void take(const TomlEntry& entry, std::vector<StatedOption>& options) const {
    const OptionRow* const row = row_of_key(entry.key);
    if (row == nullptr) {
      refuse("settings-key", fmt::format("there is no setting {}", entry.key),
             fmt::format("{}settings are {}, and machine, [machines.NAME]", nearest_key(entry.key), list_of_keys()),
             document_.place(entry.key_span));
    }
    for (Stated& stated : stated_by(*row, entry)) {
      if (row->is_path) stated.text = beside_file(stated.text);
      Place place = document_.place(stated.span);
      try {
        Options scratch;
        set_option(scratch, *row, stated.text);
      } catch (const OptionError& error) {
        refuse("settings-value", fmt::format("{}: {}", entry.key, error.what()),
               fmt::format("write it as --{} takes it; plumbline compensate --help", row->name), std::move(place));
      }
      options.push_back({row, std::move(stated.text), std::move(place)});
    }
  }

  void check_together(const std::vector<StatedOption>& stated, const TomlValue& table) const {
    Options options;
    for (const StatedOption& one : stated) {
      try {
        set_option(options, *one.row, one.text);
      } catch (const OptionError& error) {  // each alone was tried before
        refuse("settings-value", fmt::format("{}: {}", key_of(one.row->name), error.what()),
               "leave one of them out of the file", one.place);
      }
    }
    if (const std::optional<std::string> why = contradiction(options)) {
      const TomlEntry* const entry = table.find("tolerance");
      refuse("settings-value", *why, "leave one of them out of the file",
             document_.place(entry != nullptr ? entry->key_span : TextSpan{0, 1}));
    }
  }

  // A value as the command line would spell it, and where it stands.
  struct Stated {
    std::string text;
    TextSpan span;
  };

  std::string beside_file(const std::string& path) const {
    const bool is_from_program = path.starts_with(kProgramFolder);
    return path.empty() || is_from_program ? path
                                           : (path_of(document_.file).parent_path() / path_of(path)).generic_string();
  }

  [[noreturn]] void refuse_type(const TomlEntry& entry, const TomlValue& value) const {
    refuse("settings-type", fmt::format("{} cannot be {}", entry.key, name_of(value.kind)),
           "write it as the option of that name takes it, in quotes; plumbline compensate --help",
           document_.place(value.span));
  }

  // A single value as the command line would spell it.
  std::string text_of(const TomlEntry& entry, const TomlValue& value) const {
    switch (value.kind) {
      case Kind::text:
        return value.text;
      case Kind::number:
        return fmt::format("{}", value.number);
      case Kind::boolean:
        return value.flag ? "on" : "off";
      default:
        refuse_type(entry, value);
    }
  }

  std::string joined(const TomlEntry& entry, const TomlValue& array) const {
    std::string text;
    for (const TomlValue& item : array.items) {
      if (!text.empty()) text += ',';
      text += text_of(entry, item);
    }
    return text;
  }

  std::string text_or_list(const TomlEntry& entry, const TomlValue& value) const {
    return value.kind == Kind::array ? joined(entry, value) : text_of(entry, value);
  }

  // What stands for one key: of a table NAME=VALUE for each entry, of an array of texts each of them.
  std::vector<Stated> stated_by(const OptionRow& row, const TomlEntry& entry) const {
    const TomlValue& value = entry.value;
    const bool takes_names = row.name == "work-offset" || row.name == "start";
    std::vector<Stated> all;
    if (value.kind == Kind::table && takes_names) {
      for (const TomlEntry& item : value.entries) {
        all.push_back({item.key + "=" + text_or_list(item, item.value), item.key_span});
      }
      return all;
    }
    if (value.kind == Kind::array && row.is_repeatable) {
      for (const TomlValue& item : value.items) all.push_back({text_of(entry, item), item.span});
      return all;
    }
    return {{text_or_list(entry, value), value.span}};
  }

  const TomlDocument& document_;
};

}  // namespace

SettingsFile read_settings_file(const std::string& path) {
  const TomlDocument document = parse_toml(read_text(path), input_name(path));
  SettingsFile file = SettingsReader(document).read();
  file.path = path;
  return file;
}

}  // namespace plumbline::settings

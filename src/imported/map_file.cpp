#include "imported/map_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/input_name.hpp"
#include "base/text/nearest_name.hpp"
#include "base/units.hpp"

namespace plumbline::imported {

std::string_view to_text(Quantity quantity) {
  constexpr std::array<std::string_view, kQuantities> kNames{
      "time", "angle", "radial", "torque1", "torque2", "torque3", "torque4", "torque5", "torque6", "x", "y"};
  return kNames.at(static_cast<std::size_t>(quantity));
}

const ColumnSource* Source::find(Quantity quantity) const {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const ColumnSource& one) { return one.quantity == quantity; });
  return found == columns.end() ? nullptr : &*found;
}

namespace {

using Kind = TomlValue::Kind;

struct UnitName {
  std::string_view name;
  double si;
};
const std::vector<UnitName> kTimeUnits{{"s", 1}, {"ms", 1e-3}, {"min", 60}, {"us", 1e-6}};
const std::vector<UnitName> kAngleUnits{{"deg", kDeg}, {"rad", 1}};
const std::vector<UnitName> kLengthUnits{{"um", kUm}, {"mm", kMm}, {"m", 1}, {"inch", kInch}, {"nm", 1e-9}};
const std::vector<UnitName> kTorqueUnits{{"Nm", 1}, {"Nmm", 1e-3}, {"Ncm", 1e-2}};

[[noreturn]] void refuse_value(const TomlDocument& document, const TomlValue& value, const std::string& message,
                               const std::string& help) {
  refuse("import-value", message, help, document.place(value.span));
}

void require(const TomlDocument& document, const TomlValue& value, Kind kind, std::string_view key) {
  if (value.kind == kind) return;
  refuse_value(document, value, fmt::format("{} holds {} where {} belongs", key, name_of(value.kind), name_of(kind)),
               "plumbline import --example-map general shows every key");
}

// A text, or several of them.
std::vector<std::string> texts(const TomlDocument& document, const TomlEntry& entry) {
  if (entry.value.kind == Kind::text) return {entry.value.text};
  require(document, entry.value, Kind::array, entry.key);
  std::vector<std::string> all;
  for (const TomlValue& item : entry.value.items) {
    require(document, item, Kind::text, entry.key);
    all.push_back(item.text);
  }
  return all;
}

class MapReader {
 public:
  explicit MapReader(const TomlDocument& document) : document_(document) {}

  Map read() const {
    const TomlValue& root = document_.root;
    const TomlEntry* const marker = root.find("plumbline");
    if (marker == nullptr || marker->value.kind != Kind::text || marker->value.text != "map 1") {
      refuse("import-map", "this file does not say that it is a map of columns",
             "a map begins with plumbline = \"map 1\"; plumbline import --example-map prints one to start from",
             document_.place(marker == nullptr ? TextSpan{0, 1} : marker->value.span));
    }
    check_keys(root, {"plumbline", "machine", "preset", "table", "columns", "motors", "clock", "circle", "run"});
    Map map;
    map.machine = text(root, "machine").value_or("");
    const std::string preset = text(root, "preset").value_or("");
    map.source = source(root, preset, root.find("preset"));
    if (const TomlEntry* const motors = root.find("motors")) {
      require(document_, motors->value, Kind::table, "motors");
      check_keys(motors->value, {"preset", "table", "columns"});
      map.motors = source(motors->value, text(motors->value, "preset").value_or(""), motors->value.find("preset"));
    }
    if (const TomlValue* const clock = table(root, "clock", {"motors_later_s"})) {
      map.motors_later = number(*clock, "motors_later_s", -3600, 3600).value_or(0);
    }
    if (const TomlValue* const circle = table(root, "circle", {"samples"})) {
      map.samples = count(*circle, "samples", 8, 100000).value_or(0);
    }
    read_runs(root, map);
    check_readings(map, root);
    return map;
  }

 private:
  // What no dataset can hold, or what would be passed over.
  void check_readings(const Map& map, const TomlValue& root) const {
    const TomlValue& columns = root.find("columns")->value;
    const bool x = map.source.find(Quantity::x) != nullptr;
    if (x != (map.source.find(Quantity::y) != nullptr)) {
      refuse_value(document_, columns.find(x ? "x" : "y")->value,
                   fmt::format("{} says nothing without {}", x ? "x" : "y", x ? "y" : "x"),
                   "places of the tip need both: name the other column, or leave this one out");
    }
    const TomlValue& of_motors = map.motors ? root.find("motors")->value.find("columns")->value : columns;
    std::size_t torques = 0;
    const TomlEntry* last = nullptr;
    for (const TomlEntry& entry : of_motors.entries) {
      if (!entry.key.starts_with("torque")) continue;
      ++torques;
      last = &entry;
    }
    if (torques != 0 && torques != 6) {
      refuse_value(document_, last->value, fmt::format("the map names the torques of {} of six motors", torques),
                   "a run has those of all motors or none: name torque1 to torque6");
    }
    if (torques == 0 && map.source.find(Quantity::radial) == nullptr) {
      refuse_value(document_, columns, "the map names nothing that was measured",
                   "name the column of the bar, radial, or those of the motors, torque1 to torque6");
    }
  }

  void check_keys(const TomlValue& table, const std::vector<std::string_view>& known) const {
    for (const TomlEntry& entry : table.entries) {
      if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
      refuse("import-key", fmt::format("{} is no key of this part of a map", entry.key), suggestion(entry.key, known),
             document_.place(entry.key_span));
    }
  }

  const TomlValue* table(const TomlValue& in, std::string_view key, const std::vector<std::string_view>& known) const {
    const TomlEntry* const entry = in.find(key);
    if (entry == nullptr) return nullptr;
    require(document_, entry->value, Kind::table, key);
    check_keys(entry->value, known);
    return &entry->value;
  }

  std::optional<std::string> text(const TomlValue& in, std::string_view key) const {
    const TomlEntry* const entry = in.find(key);
    if (entry == nullptr) return std::nullopt;
    require(document_, entry->value, Kind::text, key);
    return entry->value.text;
  }

  std::optional<double> number(const TomlValue& in, std::string_view key, double least, double most) const {
    const TomlEntry* const entry = in.find(key);
    if (entry == nullptr) return std::nullopt;
    require(document_, entry->value, Kind::number, key);
    const double value = entry->value.number;
    if (!(value >= least && value <= most)) {
      refuse_value(document_, entry->value, fmt::format("{} is {:.12g}", key, value),
                   fmt::format("it lies between {:.12g} and {:.12g}", least, most));
    }
    return value;
  }

  std::optional<std::size_t> count(const TomlValue& in, std::string_view key, double least, double most) const {
    const std::optional<double> value = number(in, key, least, most);
    if (!value) return std::nullopt;
    if (*value != std::floor(*value))
      refuse_value(document_, in.find(key)->value, fmt::format("{} is no whole number", key),
                   "write it without a decimal point");
    return static_cast<std::size_t>(*value);
  }

  Source source(const TomlValue& in, const std::string& preset, const TomlEntry* entry) const {
    Source source;
    if (preset == "linuxcnc-halsampler") {
      // halsampler(1): one line a sample, blanks between the values, no header; "overrun" alone where samples are lost
      source.form.delimiter = ' ';
      source.form.header = false;
      source.form.lost = "overrun";
    } else if (!preset.empty()) {
      refuse_value(document_, entry->value, fmt::format("there is no preset {}", preset),
                   "the one preset is linuxcnc-halsampler; for other files describe the table under [table]");
    }
    if (const TomlValue* const table_of = table(
            in, "table",
            {"encoding", "delimiter", "decimal", "comment", "skip_lines", "header", "unit_lines", "missing", "lost"})) {
      read_form(*table_of, source.form);
    }
    const TomlEntry* const columns = in.find("columns");
    if (columns == nullptr) {
      refuse("import-key", "the map does not say which columns there are",
             R"(add [columns], as in radial = {name = "Deviation", unit = "um"})", document_.place(in.span));
    }
    require(document_, columns->value, Kind::table, "columns");
    for (const TomlEntry& column : columns->value.entries) {
      source.columns.push_back(column_of(column, source.form));
      check_once(source, column);
    }
    return source;
  }

  // Two quantities of one column: a line that was copied.
  void check_once(const Source& source, const TomlEntry& entry) const {
    const ColumnSource& last = source.columns.back();
    for (const ColumnSource& other : source.columns) {
      const bool same = last.name.empty() ? other.number == last.number : other.name == last.name;
      if (&other == &last || !same) continue;
      const std::string column = last.name.empty() ? fmt::format("column {}", last.number) : last.name;
      refuse_value(document_, entry.value,
                   fmt::format("{} is read from {}, and so is {}", entry.key, column, to_text(other.quantity)),
                   "each quantity has a column of its own: name the other one, or leave this line out");
    }
  }

  void read_form(const TomlValue& in, TableForm& form) const {
    const std::string encoding = text(in, "encoding").value_or(form.encoding);
    const std::vector<std::string_view> encodings{"auto", "utf-8", "utf-16le", "utf-16be", "latin-1"};
    if (std::find(encodings.begin(), encodings.end(), encoding) == encodings.end()) {
      refuse_value(document_, in.find("encoding")->value, fmt::format("no encoding is called {}", encoding),
                   suggestion(encoding, encodings));
    }
    form.encoding = encoding;
    if (const auto delimiter = text(in, "delimiter")) {
      const std::string& d = *delimiter;
      if (d != "tab" && d != "blanks" && d.size() != 1) {
        refuse_value(document_, in.find("delimiter")->value, fmt::format("the delimiter is \"{}\"", d),
                     R"(one character, "tab", or "blanks" for any number of them)");
      }
      form.delimiter = d == "tab" ? '\t' : d == "blanks" ? ' ' : d[0];
    }
    if (const auto decimal = text(in, "decimal")) {
      if (*decimal != "." && *decimal != ",") {
        refuse_value(document_, in.find("decimal")->value, fmt::format("the decimal mark is \"{}\"", *decimal),
                     R"("." or ",")");
      }
      form.decimal = (*decimal)[0];
    }
    if (form.decimal == form.delimiter) {
      refuse("import-value", "the decimal mark stands between columns, too",
             R"(say delimiter = ";", "tab" or what else stands between the columns)", document_.place(in.span));
    }
    if (const TomlEntry* const comment = in.find("comment")) form.comments = texts(document_, *comment);
    form.skip_lines = count(in, "skip_lines", 0, 1e6).value_or(form.skip_lines);
    form.unit_lines = count(in, "unit_lines", 0, 100).value_or(form.unit_lines);
    if (const TomlEntry* const missing = in.find("missing")) form.missing = texts(document_, *missing);
    form.lost = text(in, "lost").value_or(form.lost);
    if (const TomlEntry* const header = in.find("header")) {
      require(document_, header->value, Kind::boolean, "header");
      form.header = header->value.flag;
    }
  }

  ColumnSource column_of(const TomlEntry& entry, const TableForm& form) const {
    std::vector<std::string_view> names;
    for (std::size_t q = 0; q < kQuantities; ++q) names.push_back(to_text(static_cast<Quantity>(q)));
    const auto known = std::find(names.begin(), names.end(), entry.key);
    if (known == names.end()) {
      refuse("import-key", fmt::format("{} is nothing that a run has", entry.key), suggestion(entry.key, names),
             document_.place(entry.key_span));
    }
    require(document_, entry.value, Kind::table, entry.key);
    check_keys(entry.value, {"name", "column", "unit", "sign", "minus", "Nm_per_A", "rated_Nm", "period_s"});
    ColumnSource column;
    column.quantity = static_cast<Quantity>(known - names.begin());
    column.place = document_.place(entry.key_span);
    column.name = text(entry.value, "name").value_or("");
    column.number = count(entry.value, "column", 1, 10000).value_or(0);
    if (!column.name.empty() && column.number != 0) {
      refuse_value(document_, entry.value, fmt::format("{}: the column is named and counted, too", entry.key),
                   "say one of the two, name or column");
    }
    if (column.name.empty() && column.number == 0) {
      refuse_value(document_, entry.value, fmt::format("{}: which column is it?", entry.key),
                   "name = \"...\" as the header has it, or column = 3, counted from 1");
    }
    if (!column.name.empty() && !form.header) {
      refuse_value(document_, entry.value, fmt::format("{}: without a header columns have no names", entry.key),
                   "say column = 3, counted from 1");
    }
    read_unit(entry, column);
    column.minus = number(entry.value, "minus", -1e9, 1e9).value_or(0);
    if (const auto sign = number(entry.value, "sign", -1, 1)) {
      if (std::abs(*sign) != 1)
        refuse_value(document_, entry.value.find("sign")->value, "a sign is 1 or -1", "write -1 to turn it");
      column.factor *= *sign;
    }
    return column;
  }

  void read_unit(const TomlEntry& entry, ColumnSource& column) const {
    const TomlValue& value = entry.value;
    const bool torque = column.quantity >= Quantity::torque1 && column.quantity <= Quantity::torque6;
    const std::vector<UnitName>& units = column.quantity == Quantity::time    ? kTimeUnits
                                         : column.quantity == Quantity::angle ? kAngleUnits
                                         : torque                             ? kTorqueUnits
                                                                              : kLengthUnits;
    std::vector<std::string_view> names;
    for (const UnitName& unit : units) names.push_back(unit.name);
    if (torque) names.insert(names.end(), {"A", "percent"});
    if (column.quantity == Quantity::time) names.emplace_back("samples");
    const auto unit = text(value, "unit");
    if (!unit) {
      refuse_value(document_, value, fmt::format("{}: in which unit is it?", entry.key),
                   fmt::format("unit = \"{}\"", fmt::join(names, "\", \"")));
    }
    column.unit = *unit;
    const std::string_view used = torque && *unit == "A"                                    ? "Nm_per_A"
                                  : torque && *unit == "percent"                            ? "rated_Nm"
                                  : column.quantity == Quantity::time && *unit == "samples" ? "period_s"
                                                                                            : "";
    for (const std::string_view factor : {"Nm_per_A", "rated_Nm", "period_s"}) {
      const TomlEntry* const given = value.find(factor);
      if (given == nullptr || factor == used) continue;
      refuse("import-key", fmt::format("{}: {} says nothing of readings in {}", entry.key, factor, *unit),
             "correct the unit, or leave this factor out", document_.place(given->key_span));
    }
    const auto needs = [&](std::string_view key, std::string_view why) {
      const auto factor = number(value, key, 1e-9, 1e6);
      if (!factor)
        refuse_value(document_, value, fmt::format("{}: {}", entry.key, why), fmt::format("add {} = ...", key));
      return *factor;
    };
    if (torque && *unit == "A") {
      column.factor = needs("Nm_per_A", "a current becomes a torque by the motor's torque constant");
    } else if (torque && *unit == "percent") {
      column.factor = needs("rated_Nm", "per cent of which torque?") / 100;
    } else if (*unit == "samples" && column.quantity == Quantity::time) {
      column.factor = needs("period_s", "how long is a sample?");
    } else {
      const auto known = std::find_if(units.begin(), units.end(), [&](const UnitName& u) { return u.name == *unit; });
      if (known == units.end()) {
        refuse_value(document_, value.find("unit")->value, fmt::format("{}: {} is no unit of it", entry.key, *unit),
                     suggestion(*unit, names));
      }
      column.factor = known->si;
    }
  }

  void read_runs(const TomlValue& root, Map& map) const {
    const TomlEntry* const runs = root.find("run");
    const bool tables = runs != nullptr && runs->value.kind == Kind::array && !runs->value.items.empty() &&
                        std::all_of(runs->value.items.begin(), runs->value.items.end(),
                                    [](const TomlValue& item) { return item.kind == Kind::table; });
    if (!tables) {
      refuse("import-key", "the map lists no circles", "add a [[run]] for each, as a dataset has it",
             document_.place(runs == nullptr ? TextSpan{0, 1} : runs->key_span));
    }
    for (const TomlValue& table_of : runs->value.items) {
      MapRun run;
      run.run = measure::read_run(document_, table_of, {"motors_file", "circle", "start_angle_deg", "run_in_deg"});
      run.run.place = document_.place(table_of.find("file")->value.span);
      for (const MapRun& other : map.runs) {
        if (other.run.id != run.run.id) continue;
        refuse("dataset-same-id", fmt::format("two runs have the id \"{}\"", run.run.id),
               "give each run an id of its own", document_.place(table_of.find("id")->value.span));
      }
      run.motors_file = text(table_of, "motors_file").value_or("");
      run.circle = count(table_of, "circle", 1, 10000).value_or(0);
      if (const auto angle = number(table_of, "start_angle_deg", -720, 720)) {
        if (map.source.find(Quantity::angle) != nullptr) {
          refuse_value(document_, table_of.find("start_angle_deg")->value,
                       "start_angle_deg says where time alone begins, and there is a column of angles",
                       "leave one of them out; `minus` of the column angle moves its zero");
        }
        run.start_angle = *angle * kDeg;
      }
      if (const auto angle = number(table_of, "run_in_deg", 0, 3600)) run.run_in = *angle * kDeg;
      map.runs.push_back(std::move(run));
    }
  }

  const TomlDocument& document_;
};

}  // namespace

Map parse_map(std::string text, const std::string& file) {
  const TomlDocument document = parse_toml(std::move(text), file);
  return MapReader(document).read();
}

Map read_map(const std::string& path) { return parse_map(read_text(path), input_name(path)); }

}  // namespace plumbline::imported

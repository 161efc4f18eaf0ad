#include "measure/dataset.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <list>
#include <set>

#include <fmt/format.h>

#include "base/files/file_state.hpp"
#include "base/files/files.hpp"
#include "base/files/input_name.hpp"
#include "base/files/path_of.hpp"
#include "base/text/hash.hpp"
#include "base/text/nearest_name.hpp"
#include "base/units.hpp"
#include "machine/model_values.hpp"
#include "machine/unit.hpp"
#include "measure/run_table.hpp"

namespace plumbline::measure {

void check_run_count(std::size_t runs, const Place& place) {
  if (runs <= kMostRuns) return;
  refuse("dataset-too-many-runs", fmt::format("these are {} runs", runs),
         fmt::format("at most {} are read together, as each is judged by all others: make several datasets", kMostRuns),
         place);
}

std::string_view to_text(Direction direction) { return direction == Direction::ccw ? "ccw" : "cw"; }

namespace {

namespace fs = std::filesystem;
namespace units = machine::units;
using Kind = TomlValue::Kind;

constexpr machine::Unit kFeedUnit{"mm/min", kMmPerMin, {{{"m/min", 1000}, {"mm/s", 60}}}};
constexpr machine::Unit kSecond{"s", 1, {}};
constexpr std::string_view kDatasetName = "dataset.toml";

const std::vector<std::string_view> kTopKeys{"plumbline", "machine", "protocol", "instrument", "run"};
const std::vector<std::string_view> kRunKeys{"id",      "file",       "centre_mm", "radius_mm",
                                             "bar_mm",  "tilt_deg",   "direction", "feed_mm_min",
                                             "start_s", "payload_kg", "planned"};

// A number of a [[run]], in the file's unit.
struct NumberSpec {
  std::string_view key;
  machine::Unit unit;
  double lower = 0;
  double upper = 0;
  std::string_view meaning;
};
constexpr NumberSpec kCentre{"centre_mm", units::mm, -1e4, 1e4, "centre of the tool tip's circle in W, [x, y, z]"};
constexpr NumberSpec kRadius{"radius_mm", units::mm, 1, 2000, "radius of the tool tip's circle"};
constexpr NumberSpec kBar{"bar_mm", units::mm, 1, 3000, "length of the bar"};
constexpr NumberSpec kTilt{"tilt_deg", units::deg, -180, 180, "orientation of the platform, [A, B, C]"};
constexpr NumberSpec kFeed{"feed_mm_min", kFeedUnit, 1, 2e5, "speed of the tip along the circle"};
constexpr NumberSpec kStart{"start_s", kSecond, 0, 1e8, "when the run began, on the clock of the dataset"};
constexpr NumberSpec kPayload{"payload_kg", units::kg, 0, 1000, "known mass suspended from the tool tip"};

class RunReader {
 public:
  RunReader(const TomlDocument& document, const TomlValue& table) : document_(document), table_(table) {}

  Run read(const std::vector<std::string_view>& others) const {
    std::vector<std::string_view> keys = kRunKeys;
    keys.insert(keys.end(), others.begin(), others.end());
    for (const TomlEntry& entry : table_.entries) {
      if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
      refuse("dataset-unknown-key", fmt::format("{} is no key of a [[run]]", entry.key), suggestion(entry.key, keys),
             document_.place(entry.key_span));
    }
    Run run;
    run.id = text("id", "a name of the run, in quotes");
    run.file = text("file", "the run's table, beside the dataset");
    run.centre_W = three(kCentre);
    run.place = place_of(kCentre.key);
    run.radius = *number(kRadius, true);
    run.bar = number(kBar, false);
    run.tilt = three(kTilt);
    run.direction = direction();
    run.feed = *number(kFeed, true);
    run.start = number(kStart, false).value_or(0);
    run.payload_mass = number(kPayload, false).value_or(0);
    if (table_.find("planned") != nullptr) run.planned = text("planned", "written by plumbline plan, of the table");
    if (run.bar_length() < run.radius) refuse_bar(run);
    return run;
  }

  Place place_of(std::string_view key) const { return document_.place(table_.find(key)->value.span); }

 private:
  const TomlValue& required(std::string_view key, std::string_view meaning) const {
    const TomlEntry* const entry = table_.find(key);
    if (entry == nullptr) {
      refuse("dataset-missing-key", fmt::format("this [[run]] has no {}", key), fmt::format("add it: {}", meaning),
             document_.place(table_.span));
    }
    return entry->value;
  }

  void require(const TomlValue& value, Kind kind, std::string_view key, std::string_view meaning) const {
    if (value.kind == kind) return;
    refuse("dataset-wrong-type", fmt::format("{} holds {} where {} belongs", key, name_of(value.kind), name_of(kind)),
           fmt::format("{}: {}", key, meaning), document_.place(value.span));
  }

  std::string text(std::string_view key, std::string_view meaning) const {
    const TomlValue& value = required(key, meaning);
    require(value, Kind::text, key, meaning);
    if (value.text.empty()) {
      refuse("dataset-out-of-range", fmt::format("{} is empty", key), fmt::format("{}: {}", key, meaning),
             document_.place(value.span));
    }
    return value.text;
  }

  double in_range(const TomlValue& value, const NumberSpec& spec) const {
    require(value, Kind::number, spec.key, spec.meaning);
    const double x = value.number;
    if (!(x >= spec.lower && x <= spec.upper)) {
      refuse("dataset-out-of-range", fmt::format("{} is {:.12g} {}", spec.key, x, spec.unit.name),
             fmt::format("{}: {:.12g} to {:.12g} {}{}", spec.meaning, spec.lower, spec.upper, spec.unit.name,
                         machine::slip_hint(spec.unit, x, spec.lower, spec.upper)),
             document_.place(value.span));
    }
    return x * spec.unit.si;
  }

  std::optional<double> number(const NumberSpec& spec, bool is_required) const {
    if (!is_required && table_.find(spec.key) == nullptr) return std::nullopt;
    return in_range(required(spec.key, spec.meaning), spec);
  }

  Vector3<double> three(const NumberSpec& spec) const {
    const TomlValue& value = required(spec.key, spec.meaning);
    require(value, Kind::array, spec.key, spec.meaning);
    if (value.items.size() != 3) {
      refuse("dataset-wrong-size", fmt::format("{} holds {} numbers where 3 belong", spec.key, value.items.size()),
             std::string(spec.meaning), document_.place(value.span));
    }
    return {in_range(value.items[0], spec), in_range(value.items[1], spec), in_range(value.items[2], spec)};
  }

  Direction direction() const {
    constexpr std::string_view kMeaning = R"("ccw" or "cw", seen from +Z)";
    const TomlValue& value = required("direction", kMeaning);
    require(value, Kind::text, "direction", kMeaning);
    for (const Direction direction : {Direction::ccw, Direction::cw}) {
      if (value.text == to_text(direction)) return direction;
    }
    refuse("dataset-direction", fmt::format("direction is \"{}\"", value.text), std::string(kMeaning),
           document_.place(value.span));
  }

  [[noreturn]] void refuse_bar(const Run& run) const {
    refuse("dataset-bar",
           fmt::format("a bar of {:.12g} mm does not reach a circle of radius {:.12g} mm", *run.bar / kMm,
                       run.radius / kMm),
           "bar_mm is the distance of the two balls; leave it out for a bar in the plane of the circle",
           place_of("bar_mm"));
  }

  const TomlDocument& document_;
  const TomlValue& table_;
};

void check_top(const TomlDocument& document) {
  constexpr std::string_view kMarker = "dataset 1";
  const TomlEntry* const marker = document.root.find("plumbline");
  if (marker == nullptr || marker->value.kind != Kind::text || marker->value.text != kMarker) {
    refuse("dataset-marker", "this file does not say that it is a dataset",
           "a dataset begins with plumbline = \"dataset 1\"; a machine model is given with -m",
           document.place(marker == nullptr ? TextSpan{0, 1} : marker->value.span));
  }
  for (const TomlEntry& entry : document.root.entries) {
    if (std::find(kTopKeys.begin(), kTopKeys.end(), entry.key) != kTopKeys.end()) continue;
    refuse("dataset-unknown-key", fmt::format("{} is no key of a dataset", entry.key), suggestion(entry.key, kTopKeys),
           document.place(entry.key_span));
  }
}

std::string machine_name(const TomlDocument& document) {
  const TomlEntry* const name = document.root.find("machine");
  if (name == nullptr) return "";
  if (name->value.kind != Kind::text) {
    refuse("dataset-wrong-type", fmt::format("machine holds {} where text belongs", name_of(name->value.kind)),
           "machine: the name of the machine's model, in quotes", document.place(name->value.span));
  }
  return name->value.text;
}

const TomlValue& run_list(const TomlDocument& document) {
  const TomlEntry* const runs = document.root.find("run");
  if (runs == nullptr) {
    refuse("dataset-no-runs", "the dataset has no runs", "add a [[run]] for each circular test",
           document.place({0, 1}));
  }
  const bool tables = runs->value.kind == Kind::array && !runs->value.items.empty() &&
                      std::all_of(runs->value.items.begin(), runs->value.items.end(),
                                  [](const TomlValue& item) { return item.kind == Kind::table; });
  if (!tables) {
    refuse("dataset-wrong-type", "run is no list of tables", "write [[run]], in double brackets, above each run",
           document.place(runs->key_span));
  }
  check_run_count(runs->value.items.size(), document.place(runs->key_span));
  return runs->value;
}

// A dataset may come from anywhere: it does not say which other files are opened and shown in messages.
bool stays_inside(const fs::path& file) {
  const fs::path path = file.lexically_normal();
  return path.is_relative() && *path.begin() != "..";
}

void read_table(const RunReader& reader, const std::string& folder, Believe believe, Run& run) {
  if (!stays_inside(path_of(run.file))) {
    refuse("dataset-file-outside", fmt::format("the table {} lies outside of the dataset's folder", run.file),
           "put it into that folder, and name it relative to it", reader.place_of("file"));
  }
  const fs::path path = path_of(folder) / path_of(run.file);
  const std::string name = path.generic_string();
  std::error_code none;  // a name too long for a file is none
  if (!fs::is_regular_file(path, none)) {
    refuse("dataset-file-missing",
           fs::exists(path, none) ? fmt::format("{} is {}", name, what_stands(path)) : "there is no file " + name,
           "file names the run's table, relative to the folder of the dataset", reader.place_of("file"));
  }
  read_run_table(name, run, {.believe = believe});
  run.as_planned = !run.planned.empty() && run.planned == table_hash(read_text(name));
}

}  // namespace

std::string table_hash(std::string_view table) { return to_hex(fnv1a(table)); }

void check_measured(const Dataset& dataset) {
  std::vector<std::string_view> planned;
  const Place* first = nullptr;
  for (const Run& run : dataset.runs) {
    if (!run.as_planned) continue;
    planned.push_back(run.id);
    if (first == nullptr) first = &run.place;
  }
  if (first == nullptr) return;
  refuse("dataset-not-measured",
         planned.size() == dataset.runs.size()
             ? std::string("these readings are the plan's own: nothing was measured")
             : fmt::format("the readings of {} {} are the plan's own: nothing was measured",
                           planned.size() == 1 ? "run" : "runs", fmt::join(planned, ", ")),
         "a plan's tables hold what the model predicts: put in what was measured, in its columns, or leave the run out",
         *first);
}

Run read_run(const TomlDocument& document, const TomlValue& table, const std::vector<std::string_view>& others) {
  return RunReader(document, table).read(others);
}

Dataset parse_dataset(std::string text, const std::string& file, const std::string& folder, Believe believe) {
  Dataset dataset;
  dataset.document = parse_toml(std::move(text), file);
  check_top(dataset.document);
  dataset.machine = machine_name(dataset.document);
  dataset.protocol = read_protocol(dataset.document);
  dataset.instrument = read_instrument(dataset.document);
  for (const TomlValue& table : run_list(dataset.document).items) {
    const RunReader reader(dataset.document, table);
    Run run = reader.read({});
    for (const Run& other : dataset.runs) {
      if (other.id != run.id) continue;
      refuse("dataset-same-id", fmt::format("two runs have the id \"{}\"", run.id), "give each run an id of its own",
             reader.place_of("id"));
    }
    read_table(reader, folder, believe, run);
    dataset.runs.push_back(std::move(run));
  }
  return dataset;
}

Dataset read_dataset(const std::string& path, Believe believe) {
  return parse_dataset(read_text(path), input_name(path), path_of(path).parent_path().generic_string(), believe);
}

std::vector<std::string> files_of_dataset(const std::string& path) {
  std::vector<std::string> files{path};
  std::error_code missing;
  if (!fs::is_regular_file(path_of(path), missing)) return files;
  const TomlDocument document = parse_toml(read_text(path), input_name(path));
  check_top(document);
  for (const TomlValue& run : run_list(document).items) {
    const TomlEntry* const table = run.find("file");
    if (table == nullptr || table->value.kind != Kind::text) continue;  // read_dataset refuses it
    files.push_back((path_of(path).parent_path() / path_of(table->value.text)).generic_string());
  }
  return files;
}

namespace {

// Where the tables of a dataset will stand, in the order of its runs; each in a place of its own, which none read has.
std::vector<fs::path> table_targets(const Dataset& dataset, const fs::path& folder) {
  std::error_code ignored;
  const fs::path source = path_of(dataset.document.file).parent_path();
  std::set<fs::path> read;
  for (const Run& run : dataset.runs) read.insert(fs::weakly_canonical(source / path_of(run.file), ignored));
  std::set<fs::path> written{fs::weakly_canonical(folder / kDatasetName, ignored)};
  std::vector<fs::path> targets;
  for (const Run& run : dataset.runs) {
    const fs::path relative = path_of(run.file).lexically_normal();
    if (!stays_inside(relative)) {
      refuse("dataset-file-outside",
             fmt::format("the table {} would be written outside of {}", run.file, folder.generic_string()),
             "name the tables of a dataset relative to its folder, inside it", {folder.generic_string()});
    }
    const fs::path target = fs::weakly_canonical(folder / relative, ignored);
    if (read.contains(target)) {
      refuse("file-overwrites-input", fmt::format("the table of run {} would overwrite one that is read", run.id),
             "name another folder for the output", {folder.generic_string()});
    }
    if (!written.insert(target).second) {
      refuse("dataset-same-file", fmt::format("the table of run {} would be written over another file", run.id),
             "give each run a table of its own", {dataset.document.file});
    }
    targets.push_back(folder / relative);
  }
  return targets;
}

// Readings are not made again by running the command again. What stands there already, byte for byte, loses nothing.
template <class MakeText>
void refuse_taken(const fs::path& path, const fs::path& folder, const MakeText& make_text) {
  std::error_code none;
  const bool is_file = fs::is_regular_file(path, none);
  if (is_file ? read_text(path.generic_string()) == make_text() : !fs::exists(fs::symlink_status(path, none))) return;
  refuse("dataset-folder-taken",
         fmt::format("there is another {} in {} already", path.filename().generic_string(), folder.generic_string()),
         "it may have been measured: name another folder with -o", {path.generic_string()});
}

}  // namespace

// dataset.toml last: it names the tables.
void write_dataset(const Dataset& dataset, const std::string& folder, Readings readings) {
  const fs::path into = path_of(folder);
  const fs::path source = path_of(dataset.document.file).parent_path();
  std::error_code error;
  if (!dataset.document.file.empty() && fs::equivalent(into, source.empty() ? fs::path(".") : source, error)) {
    refuse("file-overwrites-input", "the dataset would overwrite the one that is read",
           "name another folder for the output", {folder});
  }
  const std::vector<fs::path> targets = table_targets(dataset, into);
  if (readings == Readings::measured) refuse_taken(into / kDatasetName, into, [&] { return dataset.document.text; });
  for (std::size_t i = 0; i < targets.size() && readings == Readings::measured; ++i) {
    refuse_taken(targets[i], into, [&] { return run_table_text(dataset.runs[i]); });
  }
  std::list<NewFolder> folders;
  std::list<OutputFile> outputs;
  OutputSet files;
  folders.emplace_front(into.generic_string());
  const auto write = [&](const fs::path& path, const std::string& text) {
    outputs.emplace_back(path.generic_string()).write(text);
    files.add(outputs.back());
  };
  for (std::size_t i = 0; i < targets.size(); ++i) {
    folders.emplace_front(targets[i].parent_path().generic_string());
    write(targets[i], run_table_text(dataset.runs[i]));
  }
  write(into / kDatasetName, dataset.document.text);
  files.clear_last_first();
  files.commit();
  for (NewFolder& made : folders) made.keep();
}

Run without_samples(Run run, const std::vector<std::size_t>& samples) {
  const auto drop = [&](auto& values) {
    if (values.empty()) return;
    std::size_t next = 0;
    std::size_t to = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (next < samples.size() && samples[next] == i) {
        ++next;
      } else {
        values[to++] = values[i];
      }
    }
    values.resize(to);
  };
  drop(run.time);
  drop(run.angle);
  drop(run.radial);
  for (std::vector<double>& torque : run.torque) drop(torque);
  drop(run.signs);
  return run;
}

}  // namespace plumbline::measure

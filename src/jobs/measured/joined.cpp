#include "jobs/measured/joined.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/units.hpp"
#include "jobs/measured/paper.hpp"

namespace plumbline::jobs {
namespace {

using measure::Dataset;
using measure::Instrument;
using measure::Run;

constexpr std::string_view kOneMachine =
    "runs are joined where they were measured on one machine, as it was: diagnose the others on their own; where it is "
    "the same machine, write the same in both";
constexpr std::string_view kOneInstrument =
    "the noise of all runs is estimated as that of one instrument: diagnose the others on their own; where it is the "
    "same instrument, write the same in both, or leave it out of one";

// Where a key stands in the text of a dataset: at its top, or in a table there.
Place place_of(const Dataset& dataset, std::string_view table, std::string_view key) {
  const TomlValue* value = &dataset.document.root;
  for (const std::string_view step : {table, key}) {
    if (step.empty()) continue;
    const TomlEntry* const entry = value->find(step);
    if (entry == nullptr) return {dataset.document.file};
    value = &entry->value;
  }
  return dataset.document.place(value->span);
}

// A key that two datasets have, in the words of each.
struct Stated {
  std::string_view table, key;
  std::string before, now;
};

void check_same(const Dataset& before, const Dataset& now, const Stated& stated, std::string_view code,
                std::string_view help) {
  if (stated.before.empty() || stated.now.empty() || stated.before == stated.now) return;
  const Place there = place_of(before, stated.table, stated.key);
  refuse(code,
         fmt::format("{} is {} here, and {} in {}, line {}", stated.key, stated.now, stated.before, there.file,
                     there.line),
         std::string(help), place_of(now, stated.table, stated.key));
}

std::string quoted(const std::string& text) { return text.empty() ? text : fmt::format("\"{}\"", text); }

std::string sigma_text(const std::optional<double>& sigma, double unit) {
  return sigma ? fmt::format("{:.9g}", *sigma / unit) : std::string();
}

void check_agree(const Dataset& before, const Dataset& now) {
  const measure::Protocol& a = before.protocol;
  const measure::Protocol& b = now.protocol;
  const auto machine = [&](const Stated& stated) {
    check_same(before, now, stated, "dataset-other-machine", kOneMachine);
  };
  const auto instrument = [&](const Stated& stated) {
    check_same(before, now, stated, "dataset-other-instrument", kOneInstrument);
  };
  machine({"", "machine", quoted(before.machine), quoted(now.machine)});
  machine({"protocol", "serial", quoted(a.serial), quoted(b.serial)});
  instrument({"protocol", "instrument", quoted(a.instrument), quoted(b.instrument)});
  instrument({"instrument", "bar_sigma_um", sigma_text(before.instrument.bar_sigma, kUm),
              sigma_text(now.instrument.bar_sigma, kUm)});
  instrument({"instrument", "torque_sigma_Nm", sigma_text(before.instrument.torque_sigma, 1),
              sigma_text(now.instrument.torque_sigma, 1)});
}

bool has(const std::vector<Run>& runs, const std::string& id) {
  return std::any_of(runs.begin(), runs.end(), [&](const Run& run) { return run.id == id; });
}

// Runs get the names that they have beside those of the datasets before.
void rename(const std::vector<Run>& before, std::size_t number, std::vector<Run>& runs, MeasuredFile& file) {
  for (Run& run : runs) {
    if (!has(before, run.id)) continue;
    std::string id = run.id;
    do {
      id += fmt::format("@{}", number);
    } while (has(before, id) || has(runs, id));
    file.renamed.emplace_back(run.id, id);
    run.id = id;
  }
}

}  // namespace

JoinedData read_joined(const std::string& first, const std::vector<std::string>& with, measure::Believe believe) {
  std::vector<std::string> paths{first};
  paths.insert(paths.end(), with.begin(), with.end());
  JoinedData joined;
  std::vector<Dataset> read;
  for (const std::string& path : paths) {
    Dataset& now = read.emplace_back(measure::read_dataset(path, believe));
    MeasuredFile file{path, dataset_hash(now, path), now.runs.size()};
    for (std::size_t i = 0; i + 1 < read.size(); ++i) {
      if (joined.files[i].hash == file.hash) {
        refuse("dataset-twice", fmt::format("this dataset and its tables are those of {}", joined.files[i].path),
               "name each dataset once: runs that count twice make everything look surer than it is",
               {now.document.file});
      }
      check_agree(read[i], now);
    }
    measure::check_run_count(joined.dataset.runs.size() + now.runs.size(), {now.document.file});
    rename(joined.dataset.runs, read.size(), now.runs, file);
    joined.files.push_back(std::move(file));
    joined.protocols.push_back(now.protocol);
    if (read.size() == 1) {
      joined.dataset = now;
      continue;
    }
    Instrument& instrument = joined.dataset.instrument;
    if (!instrument.bar_sigma) instrument.bar_sigma = now.instrument.bar_sigma;
    if (!instrument.torque_sigma) instrument.torque_sigma = now.instrument.torque_sigma;
    std::move(now.runs.begin(), now.runs.end(), std::back_inserter(joined.dataset.runs));
    now.runs.clear();
  }
  return joined;
}

std::optional<Diagnostic> other_model(const measure::Dataset& dataset, const machine::MachineModel& model) {
  if (dataset.machine.empty() || dataset.machine == model.name) return std::nullopt;
  const TomlEntry* const entry = dataset.document.root.find("machine");
  return Diagnostic{
      "dataset-other-model",
      fmt::format("the dataset is of the machine \"{}\", and the model is that of \"{}\"", dataset.machine, model.name),
      "look whether they belong together; if they do, write the model's name into the dataset",
      entry != nullptr ? dataset.document.place(entry->value.span) : Place{.file = dataset.document.file},
      Severity::warning};
}

}  // namespace plumbline::jobs

#include "jobs/measured/inspect.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/nearest_name.hpp"
#include "jobs/measured/joined.hpp"
#include "machine/model_file.hpp"

namespace plumbline::jobs {
namespace {

constexpr std::string_view kAll = "all";

void check_accepted(const std::vector<measure::Run>& runs, const std::vector<std::string>& accepted) {
  std::vector<std::string_view> ids{kAll};
  for (const measure::Run& run : runs) ids.push_back(run.id);
  for (const std::string& id : accepted) {
    if (std::find(ids.begin(), ids.end(), id) != ids.end()) continue;
    refuse("inspect-unknown-run", fmt::format("--accept: no run of the dataset has the id {}", id),
           suggestion(id, ids));
  }
}

}  // namespace

InspectResult inspect(const InspectJob& job) {
  InspectResult result;
  JoinedData data = read_joined(job.dataset, job.with, measure::Believe::the_table);
  measure::Dataset& dataset = data.dataset;
  measure::check_measured(dataset);
  result.measured = std::move(data.files);
  result.runs = std::move(dataset.runs);
  inspect::InspectOptions options;
  options.instrument = dataset.instrument;
  result.with_model = !job.model.empty();
  if (result.with_model) {
    const machine::MachineModel machine = machine::read_model(job.model);
    result.other_model = other_model(dataset, machine);
    result.inspection = inspect::inspect(machine, result.runs, options);
  } else {
    result.inspection.faults = inspect::record_faults(result.runs);
  }
  return result;
}

Judged judged(const machine::MachineModel& machine, std::vector<measure::Run> runs,
              const measure::Instrument& instrument, const std::vector<std::string>& accepted) {
  check_accepted(runs, accepted);
  const auto is_accepted = [&](const std::string& id) {
    return std::find(accepted.begin(), accepted.end(), id) != accepted.end();
  };
  Judged judged;
  inspect::InspectOptions options;
  options.instrument = instrument;
  judged.inspection = inspect::inspect(machine, runs, options);
  for (inspect::Fault& fault : judged.inspection.faults) {
    const bool all_named =
        std::all_of(fault.runs.begin(), fault.runs.end(), [&](std::size_t r) { return is_accepted(runs[r].id); });
    if (all_named || (fault.all && is_accepted(std::string(kAll)))) fault.blocks = false;
  }
  judged.runs = inspect::cleaned(std::move(runs), judged.inspection, options);
  return judged;
}

}  // namespace plumbline::jobs

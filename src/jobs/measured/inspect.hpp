// What the command `inspect` does: a dataset, and a model if there is one, in; what may be wrong with the data out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/files/source.hpp"
#include "inspect/inspect.hpp"
#include "jobs/measured/measured_file.hpp"

namespace plumbline::jobs {

struct InspectJob {
  std::string model;  // empty: records alone are looked at
  std::string dataset;
  std::vector<std::string> with = {};  // further ones of the same machine: jobs/measured/joined.hpp
};

struct InspectResult {
  std::vector<measure::Run> runs;  // as they were read
  inspect::Inspection inspection;
  bool with_model = false;
  std::vector<MeasuredFile> measured;
  std::optional<Diagnostic> other_model;  // a warning: the data are of another machine
};

/// Refuses as read_model and read_joined do; where a table contradicts the dataset the table is believed, and said so.
InspectResult inspect(const InspectJob& job);

/// What was judged before something is learnt.
struct Judged {
  std::vector<measure::Run> runs;  // without single spikes and what is periodic in time; none is mended
  inspect::Inspection inspection;
};

/// Runs of a dataset, judged. What is wrong with runs that `accepted` names (ids, or "all" for what is wrong with all
/// of them) does not block.
Judged judged(const machine::MachineModel& machine, std::vector<measure::Run> runs,
              const measure::Instrument& instrument, const std::vector<std::string>& accepted);

}  // namespace plumbline::jobs

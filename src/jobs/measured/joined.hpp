// Several datasets of one machine, as one: a plan and the test that it left to be made, or the circles of two days.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "jobs/measured/measured_file.hpp"
#include "machine/model.hpp"
#include "measure/dataset.hpp"

namespace plumbline::jobs {

struct JoinedData {
  measure::Dataset dataset;                  // the runs of all, one dataset after the other; else what the first says
  std::vector<MeasuredFile> files;           // in their order
  std::vector<measure::Protocol> protocols;  // of each
};

/// Reads `first` and the datasets `with`. A run whose id an earlier dataset has is called ID@N, N the number of its
/// dataset. What [instrument] says in one of them holds for all. All times are taken as on one clock. Refuses as
/// read_dataset does, at its place what contradicts an earlier dataset (dataset-other-machine: `machine` or the serial
/// number; dataset-other-instrument: the instrument or its sigmas), and what was read already (dataset-twice).
JoinedData read_joined(const std::string& first, const std::vector<std::string>& with,
                       measure::Believe believe = measure::Believe::nothing);

/// A warning where a dataset says by name that it is of another machine than the model's: dataset-other-model.
std::optional<Diagnostic> other_model(const measure::Dataset& dataset, const machine::MachineModel& model);

}  // namespace plumbline::jobs

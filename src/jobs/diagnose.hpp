// What the command `diagnose` does: a model and a dataset in, the diagnosis out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "diagnose/diagnose.hpp"
#include "measure/thinning.hpp"

namespace plumbline::jobs {

struct DiagnoseJob {
  std::string model, dataset;
  std::vector<std::string> without;  // effects to be left out of the catalogue
  std::uint64_t seed = 1;
};

struct DiagnoseResult {
  machine::MachineModel machine;  // as given
  diagnose::Diagnosis diagnosis;
  measure::Thinning thinning;  // how long records were made short
};

/// Refuses as read_model, read_dataset and diagnose::diagnose do.
DiagnoseResult diagnose(const DiagnoseJob& job, const diagnose::Say& say = {});

}  // namespace plumbline::jobs

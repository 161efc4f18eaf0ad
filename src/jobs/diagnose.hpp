// What the command `diagnose` does: a model and a dataset in, the diagnosis out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/files/source.hpp"
#include "diagnose/diagnose.hpp"
#include "inspect/fault.hpp"
#include "jobs/measured/measured_file.hpp"
#include "measure/thinning.hpp"

namespace plumbline::jobs {

struct DiagnoseJob {
  Source model;
  std::string dataset;
  std::vector<std::string> without;  // effects to be left out of the catalogue
  std::uint64_t seed = 1;
  std::vector<std::string> accepted = {};  // runs that are taken as they are
  std::vector<std::string> with = {};      // further datasets of the same machine: jobs/measured/joined.hpp
};

/// What an effect that was found does at the tool tip, m: how far the tip is from where it would be without it, over
/// all samples of all runs.
struct AtTip {
  std::string effect;
  double rms = 0;
  double largest = 0;
};

struct DiagnoseResult {
  machine::MachineModel machine;  // as given
  diagnose::Diagnosis diagnosis;
  measure::Thinning thinning;      // how long records were made short
  std::vector<measure::Run> runs;  // as they were looked at: long records made short
  inspect::Inspection inspection;  // what may be wrong with the data; where that blocks, nothing is learnt from them
  std::vector<AtTip> at_tip;       // of the effects named, in their order; none where the model stays as it was given
  std::vector<MeasuredFile> measured;
  std::optional<Diagnostic> other_model = {};  // a warning: the data are of another machine
};

/// Refuses as read_model, read_joined and diagnose::diagnose do.
DiagnoseResult diagnose(const DiagnoseJob& job, const diagnose::Say& say = {});

}  // namespace plumbline::jobs

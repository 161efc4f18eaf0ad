// What the command `diagnose` does: a model and a dataset in, the diagnosis and a model file out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "diagnose/diagnose.hpp"

namespace plumbline::jobs {

struct DiagnoseJob {
  std::string model, dataset;
  std::vector<std::string> without;  // effects to be left out of the catalogue
  std::uint64_t seed = 1;
};

struct DiagnoseResult {
  diagnose::Diagnosis diagnosis;
  std::string machine;     // its name
  std::string model_toml;  // the model with what was found
  std::string thinning;    // how long records were made short; empty: none was
};

/// Refuses as read_model, read_dataset and diagnose::diagnose do.
DiagnoseResult diagnose(const DiagnoseJob& job, const diagnose::Say& say = {});

/// The verdict in a few words, the whole confidence set where it has several names: "named: one of backlash, cyclic".
std::string headline(const diagnose::Diagnosis& diagnosis);

}  // namespace plumbline::jobs

// Identification from files: a model and a dataset in, a model with what was learnt out.
#pragma once

#include <string>

#include "identify/identify.hpp"
#include "measure/dataset.hpp"

namespace plumbline::jobs {

struct IdentifiedModel {
  identify::Identification found;
  std::string text;  // of the new model file
};

/// Reads both, identifies, and writes the new model's text; nothing is written to files. Refuses what the readers of
/// models and datasets, physics::ForceModel and identify::identify refuse.
IdentifiedModel identify_model(const std::string& model, const std::string& dataset,
                               const identify::IdentifyOptions& options);

/// What was found, for people: values before and after, what the data cannot tell, the gap before and after.
std::string identification_text(const identify::Identification& found);
/// As docs/formats.md says.
std::string identification_json(const identify::Identification& found);

}  // namespace plumbline::jobs

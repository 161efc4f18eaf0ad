// Identification and calibration from files: a model and measurements in, a model with what was learnt out.
#pragma once

#include <string>

#include "identify/identify.hpp"
#include "measure/dataset.hpp"

namespace plumbline::jobs {

struct IdentifiedModel {
  identify::Identification found;
  std::string text;       // of the new model file
  std::string thinning;   // how long records were made short; empty: none was
  std::string objection;  // why the model is not to be believed; empty: nothing speaks against it
};

/// Reads both, identifies, and writes the new model's text; nothing is written to files. Refuses what the readers of
/// models and datasets, physics::ForceModel and identify::identify refuse.
IdentifiedModel identify_model(const std::string& model, const std::string& dataset,
                               const identify::IdentifyOptions& options);

/// What a calibration is made from.
struct CalibrateJob {
  std::string model;
  std::string dataset;  // circular tests; empty: none
  std::string poses;    // a tracker's table; empty: none
  identify::IdentifyOptions options;
  bool frame_known = false;  // the tracker measures in the machine's frame W
  bool controller = false;   // new joints for the controller, not what it has wrong
};

/// The same with Stages::geometry. With `controller` the joints that were found become those of [base] and [platform],
/// and joint-position adds nothing to them. Refuses what read_tracked_poses refuses, too.
IdentifiedModel calibrate_model(CalibrateJob job);

}  // namespace plumbline::jobs

// Identification and calibration from files: a model and measurements in, what was learnt out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/files/source.hpp"
#include "diagnose/objection.hpp"
#include "identify/identify.hpp"
#include "identify/model_text.hpp"
#include "identify/posterior/expected_tip.hpp"
#include "identify/posterior/posterior.hpp"
#include "inspect/fault.hpp"
#include "jobs/measured/measured_file.hpp"
#include "measure/dataset.hpp"
#include "measure/thinning.hpp"

namespace plumbline::jobs {

/// What a tracker measured of a pose less what a model says of it, in the tracker's axes, its frame fitted.
struct TrackedResidual {
  Vector3<double> shift = Vector3<double>::Zero();  // m
  std::optional<Vector3<double>> turn;              // about each axis, rad, where angles were measured
};
struct TrackedGap {
  TrackedResidual before;  // with the model as given
  TrackedResidual after;   // with what was found
};

struct IdentifiedModel {
  machine::MachineModel machine;  // as given
  identify::Identification found;
  std::vector<MeasuredFile> measured;
  measure::Thinning thinning;                      // how long records were made short
  std::optional<diagnose::OpenGap> open_gap;       // that the fit left, where no stage of it has an objection
  physics::ForceModel forces;                      // as a model file is to have them
  std::vector<double> errors;                      // of its parameters, SI
  std::vector<measure::Run> runs;                  // as they were fitted: long records made short
  inspect::Inspection inspection;                  // what may be wrong with the data
  std::vector<TrackedGap> poses;                   // of the tracker, in the order of its table
  std::optional<identify::BelievedJoints> joints;  // for the controller
  bool calibrated = false;
  std::optional<identify::Posterior> posterior;  // of the numbers of `forces`
  std::optional<Diagnostic> other_model = {};    // a warning: the data are of another machine
  std::optional<identify::LessSure> less_sure;   // what it leaves open is more than what the model as given does

  /// Whether something speaks against the model.
  bool objected() const {
    return found.objected() != nullptr || open_gap.has_value() || less_sure.has_value() || inspection.blocks();
  }
};

/// Reads both, and the datasets `with` (jobs/measured/joined.hpp), and identifies; what is wrong with runs that
/// `accepted` names (jobs/measured/inspect.hpp) is no objection. Refuses what the readers of models and datasets,
/// physics::ForceModel and identify::identify refuse.
IdentifiedModel identify_model(const Source& model, const std::string& dataset,
                               const identify::IdentifyOptions& options, const std::vector<std::string>& accepted = {},
                               const std::vector<std::string>& with = {});

/// What a calibration is made from.
struct CalibrateJob {
  Source model;
  std::string dataset;                 // circular tests; empty: none
  std::vector<std::string> with = {};  // further ones of the same machine
  Source poses;                        // a tracker's table; empty: none
  identify::IdentifyOptions options;
  bool frame_known = false;           // the tracker measures in the machine's frame W
  std::vector<std::string> accepted;  // runs that are taken as they are
  bool controller = false;            // new joints for the controller, not what it has wrong
};

/// The same with Stages::geometry. With `controller` the joints that were found become those of [base] and [platform],
/// and joint-position adds nothing to them. Refuses what read_tracked_poses refuses, too.
IdentifiedModel calibrate_model(CalibrateJob job);

}  // namespace plumbline::jobs

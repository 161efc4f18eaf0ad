// A new machine's model file, from what its owner states or from the files of its control; what nobody stated is
// assumed, marked so, and the result is checked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jobs/new_model/linuxcnc_control_files.hpp"
#include "jobs/new_model/model_draft.hpp"
#include "machine/model.hpp"

namespace plumbline::jobs {

/// Six joints: their coordinates, or a circle about Z.
struct JointRing {
  std::optional<double> radius_mm;
  std::vector<double> angles_deg;  // six, strut by strut, from +X towards +Y
  double height_mm = 0;            // z of all six
  std::vector<double> joints_mm;   // 18: x y z, strut by strut; in place of the circle
};

struct NewModelJob {
  std::string file = "model.toml";  // where it will stand, for messages
  std::string name;
  std::string provenance;               // of what is stated
  std::optional<ControlFiles> control;  // what is stated otherwise takes precedence over these
  JointRing base;                       // in W
  JointRing platform;                   // in P
  std::vector<double> home_mm;          // the tip at home, x y z in W
  std::vector<DraftValue> stated;       // other keys, in the units of the file
};

/// The box of the travel, not tilted.
struct CornerCheck {
  int reached = 0;               // of its eight corners, within the struts' lengths
  int other_side = 0;            // of those reached: beyond a singularity
  std::string first_limit;       // what keeps the machine from the first one that is not reached
  double largest_condition = 0;  // at those reached and at home
};

struct NewModel {
  std::string text;
  machine::MachineModel model;      // read from it
  std::vector<DraftValue> assumed;  // in the order of the file
  std::vector<std::string> notes;   // on what was read
  double home_condition = 0;
  double home_error = 0;  // of the tip in the middle of the travel, m
  CornerCheck corners;
};

/// Makes the model and checks it: it is read as every model is, its forces are made, and it stands in the middle of its
/// travel, and as far as it can in the corners. Refuses as take_linuxcnc and assume_the_rest do, with draft-joints
/// rings that are stated in two ways or in part, with draft-home a middle of the travel where the machine cannot
/// stand, and as the reader of models does, at the place where the value was stated.
NewModel make_new_model(const NewModelJob& job);

}  // namespace plumbline::jobs

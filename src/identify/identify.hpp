// Identification: the parameters of a machine's model from circular tests, and from poses that a tracker measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identify/held.hpp"
#include "identify/observability.hpp"
#include "identify/plausible.hpp"
#include "identify/unknowns/geometry.hpp"
#include "measure/dataset.hpp"

namespace plumbline::identify {

enum class Stages {
  joint,     // one fit of all nuisances, their priors from [uncertainty], to bar readings and torques together
  paper,     // two fits of what the paper identifies, without priors: masses and friction from torques, then K1 and K2
             // from bar readings  [Ibaraki et al., 3.2]
  geometry,  // calibration: one fit of the joints' coordinates and the struts' offsets, listed or not, beside all other
             // nuisances
};

struct IdentifyOptions {
  Stages stages = Stages::joint;
  std::vector<std::string> free;  // "strut.motor_mass_kg", "backlash.width_um": fitted without a prior, too
  GeometryOptions geometry;
  FitOptions fit;
  ObservabilityOptions observability;
  PlausibleOptions plausible;
  HoldOptions hold;
};

/// How far a model is from the measurements: rms and means over all samples of all runs.
struct Misfit {
  double radial_rms = 0;       // m, the set-up of each run fitted
  double torque_rms = 0;       // N m, of all six struts
  double torque_mean_abs = 0;  // N m
  double tracker_rms = 0;      // m, of each coordinate, the tracker's frame fitted
  double tilt_rms = 0;         // rad
  Eigen::Index radial_readings = 0;
  Eigen::Index torque_readings = 0;
  Eigen::Index tracker_readings = 0;
  Eigen::Index tilt_readings = 0;
};

/// One fit, and what it is worth.
struct Stage {
  std::string name;          // "joint", "torques", "bar readings"
  Fit fit;                   // its values without what was held
  std::optional<Held> held;  // nothing: there were no circles, or no priors that could have taken anything back
  Observability observability;
  Plausibility plausible;
  bool borne_out = false;                 // by circles that a fit to the others did not see, and at the tip
  std::optional<Objection> objection;     // why it is not to be believed
  std::optional<ShownGeometry> geometry;  // of a calibration
};

struct Identification {
  std::vector<Stage> stages;
  physics::ForceModel forces;  // with all that was found
  Misfit before, after;

  /// Whether all fits converged.
  bool converged() const;
  /// The first stage that something speaks against; null: nothing does.
  const Stage* objected() const;
  /// Whether all stages are borne out.
  bool borne_out() const;
};

/// `tracked`: poses that a tracker measured, for all stages but the paper's; `runs` may then be empty.
/// Refuses with simulate-unreachable and tracker-far; with identify-nothing-unknown if there is nothing to fit;
/// identify-no-readings if the runs hold none of the readings that a stage needs; identify-unknown-key a key of `free`
/// that does not exist.
Identification identify(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                        const IdentifyOptions& options = {}, const Tracked* tracked = nullptr);

/// The unknowns of the paper's first stage (shared masses of motors and screws, friction of each screw, viscous
/// friction of the base joints) and second (K1, K2), free.
Unknowns torque_unknowns(const physics::ForceModel& forces);
Unknowns compliance_unknowns(const physics::ForceModel& forces);

}  // namespace plumbline::identify

// The machine of a model under the loads of a motion, as simulation and pictures show it.
#pragma once

#include "compensate/corrector.hpp"
#include "compensate/exact/pose_batch.hpp"
#include "compensate/settings.hpp"
#include "compensate/target.hpp"
#include "machine/model.hpp"
#include "physics/error.hpp"

namespace plumbline::compensate {

class LoadedMachine {
 public:
  /// The model must outlive it.
  LoadedMachine(const machine::MachineModel& model, const Settings& settings);

  void set_tool(const ToolInSpindle& tool);
  /// With the tool in the spindle, m.
  const machine::Geometry& geometry() const { return forces_.machine.geometry; }
  physics::Motion<double> motion(const Target& target) const;
  physics::TipError<double> error(const physics::Motion<double>& motion,
                                  const physics::ErrorOptions& options = {}) const {
    return physics::tip_error(forces_, environment_, motion, options);
  }
  struct Carried {
    machine::PerStrut<double> lengths;      // m
    machine::PerStrut<double> nut_tension;  // N; means nothing where it is singular
    bool singular = false;
  };
  /// The loads where the machine is sent to, and the struts as they are told there; its giving way left out.
  Carried carried(const physics::Motion<double>& motion) const;
  /// The same of many poses together: `batch` then has them.
  void carry(exact::PoseBatch& batch) const;
  /// Condition number of the Jacobian there.
  double condition(const Pose<double>& pose) const;

 private:
  const machine::MachineModel& model_;
  double time_s_;
  physics::ForceModel forces_;
  physics::Environment environment_;
  double radius_;  // of the platform, m
};

}  // namespace plumbline::compensate

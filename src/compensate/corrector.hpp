// The correction at one pose: what to tell the control so that the deformed machine stands where the program says.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/axes.hpp"
#include "compensate/exact/pose_batch.hpp"
#include "compensate/settings.hpp"
#include "compensate/target.hpp"
#include "machine/model.hpp"
#include "physics/error.hpp"

namespace plumbline::compensate {

/// The tool in the spindle as far as the model needs it.
struct ToolInSpindle {
  double length = 0;  // m, from the gauge point along -Z of P
  double mass = 0;    // kg
  double along = 0;   // m, of the centre of mass from the gauge point along -Z of P

  bool operator==(const ToolInSpindle&) const = default;
};

struct Corrected {
  AxisWords pose;  // to be commanded
  bool converged = false;
  bool within_limits = false;  // surely, neither the target nor the pose to be commanded breaks one
  machine::PerStrut<double> sign = machine::PerStrut<double>::Zero();  // of each strut's speed, smoothed
};

/// Targets that are corrected together, and what is kept from one such call to the next.
class Corrections {
 public:
  /// Of the target in the same place.
  const Corrected& operator[](std::size_t i) const { return corrected_[i]; }

 private:
  friend class Corrector;
  std::vector<Corrected> corrected_;
  // Where some axis is fixed, where each is corrected: its fixed axes turned until they end where they were.
  std::vector<Target> standing_;
  std::vector<std::size_t> open_;
  std::vector<std::size_t> still_open_;
  exact::PoseBatch batch_;
};

/// A machine that was told to go somewhere, as the model has it: its friction turns as fast as the model says, not as
/// slowly as the correction lets it.
struct PlayedTip {
  Pose<double> stands;
  machine::PerStrut<double> speed;  // of the struts, as commanded, m/s
};

/// Machines that were told to go somewhere, played together.
class Plays {
 public:
  /// Of the told target in the same place; nothing where the machine gives way.
  std::span<const std::optional<PlayedTip>> all() const { return played_; }

 private:
  friend class Corrector;
  std::vector<std::optional<PlayedTip>> played_;
  exact::PoseBatch batch_;
};

class Corrector {
 public:
  /// Both must outlive it.
  Corrector(const machine::MachineModel& model, const Settings& settings);
  Corrector(const Corrector&) = delete;  // its set-up points into it
  Corrector& operator=(const Corrector&) = delete;

  void set_tool(const ToolInSpindle& tool);

  /// What to command for a target. Not converged: no command within reach puts the tool there.
  Corrected correct(const Target& target) const;
  /// The same for many, in packs: what each gets does not depend on the others. Several threads may do so at once, each
  /// with corrections of its own.
  void correct(std::span<const Target> targets, Corrections& corrections) const;

  /// dT: where the deformed machine stands when told to go to the target, minus the target; mm and deg.
  /// Nothing where that does not converge.
  std::optional<AxisWords> error(const Target& target) const;

  /// Distance (mm) of the deformed tool tip from the target when `commanded` is what the control was told, friction as
  /// the correction has it.
  std::optional<double> tip_distance_mm(const Target& target, const AxisWords& commanded) const;

  /// Where the deformed machine stands when the control is told `told`, and moves as it says. Nothing where that does
  /// not converge: it gives way.
  std::optional<PlayedTip> play(const Target& told) const;
  /// The same for many, in packs.
  void play(std::span<const Target> told, Plays& plays) const;

  /// How far the tip moves and turns, and how much longer or shorter the strut gets, where the friction of a strut
  /// turns from one sign to the other.
  struct FrictionTurns {
    machine::PerStrut<double> strut_mm = machine::PerStrut<double>::Zero();
    machine::PerStrut<double> tip_mm = machine::PerStrut<double>::Zero();
    machine::PerStrut<double> turned_deg = machine::PerStrut<double>::Zero();
  };
  FrictionTurns friction_turns(const Target& target) const;

  bool has_friction() const { return environment_.friction; }
  /// v0 of the model, m/s: how slowly a strut moves where its friction turns.
  double turning_speed() const { return environment_.sign_speed; }

  /// The shortest way of a strut over which an effect of the model may come and go, m: a turn of its screw, or a pitch
  /// that an effect states.
  double shortest_wave() const;

  /// Condition number of the Jacobian where the machine stands on the target.
  double condition(const Target& target) const;
  /// True only where that is below `most`, and cheaper: machine::condition_surely_below.
  bool condition_surely_below(const Target& target, double most) const;

  /// How far each kg hung at the tool tip moves it, mm.
  std::optional<double> error_per_kg_mm(const Target& target) const;

  /// How far the deformed tip drifts in an hour, mm.
  std::optional<double> drift_per_hour_mm(const Target& target) const;

  const machine::Geometry& geometry() const { return physics_.machine.geometry; }
  Pose<double> pose_of(const AxisWords& words) const;
  /// How fast the struts of a machine that is told `told` move, as it is told, m/s; with the sign that its friction
  /// has.
  physics::StrutRates<double> rates_as_told(const Target& told) const;
  /// Angular velocity of P at A, B, C of `words` that turn by `change`, deg: in rad.
  double turn_rad(const AxisWords& words, const AxisWords& change) const;

 private:
  struct Load {  // of a machine that stands on a pose
    Pose<double> pose;
    machine::PerStrut<double> sign;
    physics::StrutStretch<double> stretch;
  };
  Load load_at(const Target& target) const;
  bool move_struts(const Load& load, Pose<double>& pose) const;
  void take_geometry();
  Corrected correct_once(const Target& target, Method method) const;
  void correct_standing(std::span<const Target> standing, Corrections& corrections, int round) const;
  static bool settle_fixed_axes(const Target& target, Corrected& corrected, Target& standing);
  void confirm(std::span<const Target> targets, Corrections& corrections) const;
  bool holds(const Target& target, std::optional<double> off_mm) const;
  bool can_stand_on(const Target& target) const;
  physics::Motion<double> motion_of(const Target& target, physics::Environment& environment) const;

  const machine::MachineModel& model_;
  const Settings& settings_;
  physics::ForceModel physics_;
  physics::Environment environment_;
  exact::Setup setup_;
  double radius_ = 0;  // of the platform, m: turns a rotation into the speed of the joints
};

/// The rest of a touch-off on the sagging machine, which every pose gets; zero where none is set. Refuses with
/// compensate-touch-off a pose where the machine cannot stand, or does not come within `limits`.
AxisWords touch_off_error(const Corrector& corrector, const machine::Limits& limits, const Settings& settings);

}  // namespace plumbline::compensate

#include "compensate/corrector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/units.hpp"
#include "machine/axis_words.hpp"
#include "machine/condition.hpp"
#include "machine/forward.hpp"
#include "machine/limits.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {
namespace {

constexpr int kMostRounds = 8;          // of putting the fixed axes back where they stay
constexpr double kFixedAxisDeg = 1e-8;  // to which they get there
constexpr double kHour = 3600;          // s
constexpr double kSureMm = 0.2;         // a correction below both is that of a machine that holds
constexpr double kSureDeg = 0.1;
constexpr double kHoldsMm = 0.01;  // of the target, where a large correction leads

double tip_distance(const Pose<double>& a, const Pose<double>& b) { return (a.p_WT - b.p_WT).norm(); }

// Between the tips of a machine deformed in two ways, mm.
std::optional<double> tips_apart_mm(const physics::TipError<double>& a, const physics::TipError<double>& b) {
  if (!a.converged() || !b.converged()) return std::nullopt;
  return tip_distance(a.pose, b.pose) / kMm;
}

}  // namespace

Corrector::Corrector(const machine::MachineModel& model, const Settings& settings)
    : model_(model),
      settings_(settings),
      physics_(model),
      environment_(environment_of(physics_, settings)),
      radius_(machine::platform_radius(model.geometry)) {
  setup_.rotation = model.rotation;
  setup_.bounds = exact::sure_bounds(model.limits);
  setup_.radius = radius_;
  setup_.sign_width_of_feed = settings.sign_width_of_feed;
  setup_.time = settings.time_s.value_or(0);
  setup_.small_mm = kSureMm;
  setup_.small_deg = kSureDeg;
  take_geometry();
}

void Corrector::set_tool(const ToolInSpindle& tool) {
  physics_.machine.geometry = machine::with_tool(model_.geometry, tool.length);
  environment_.tool_mass = tool.mass - model_.reference_tool_mass;
  environment_.tool_centre_P = model_.geometry.tool_tip_P - Vector3<double>(0, 0, tool.along);
  take_geometry();
}

void Corrector::take_geometry() {
  setup_.environment = environment_;
  setup_.take_geometry(physics_, machine::home_pose(model_));
}

Pose<double> Corrector::pose_of(const AxisWords& words) const { return machine::pose_of(model_.rotation, words); }

// The commanded motion; v0 grows with the feed, so that the correction turns smoothly where a strut turns around
// [docs/physics.md, Friction].
physics::Motion<double> Corrector::motion_of(const Target& target, physics::Environment& environment) const {
  physics::Motion<double> motion;
  if (environment.friction) {
    motion = motion_at(model_.rotation, radius_, target, environment);
    const double speed = std::hypot(motion.twist.v_WT.norm(), radius_ * motion.twist.w_WP.norm());
    if (speed == 0) environment.friction = false;
    environment.sign_speed = std::max(environment.sign_speed, settings_.sign_width_of_feed * speed);
  } else {
    motion.pose = pose_of(target.pose);
  }
  motion.time = settings_.time_s.value_or(0);
  return motion;
}

Corrector::Load Corrector::load_at(const Target& target) const {
  physics::Environment environment = environment_;
  const physics::Motion<double> motion = motion_of(target, environment);
  const auto struts = machine::strut_geometry(geometry(), motion.pose);
  auto rates = physics::strut_rates(struts, motion, environment);
  if (target.sign && environment.friction) rates.sign = *target.sign;
  return {
      motion.pose, rates.sign,
      physics::strut_stretch_at(physics_, physics_.parameters.data(), environment, motion, rates, motion.pose, struts)};
}

// From a pose to the one whose struts are shorter by their stretch: by the factorisation at hand where that converges,
// else by the full iteration.
bool Corrector::move_struts(const Load& load, Pose<double>& pose) const {
  const machine::NearResult<double> near = machine::forward_near<double>(geometry(), pose, load.stretch.struts,
                                                                         load.stretch.jacobian, -load.stretch.stretch);
  if (near.converged) {
    pose = near.pose;
    return true;
  }
  const machine::PerStrut<double> lengths = load.stretch.struts.length - load.stretch.stretch;
  const machine::ForwardResult found = machine::forward(geometry(), lengths, pose);
  pose = found.pose;
  return found.converged();
}

// Exact: T_c = FK(IK(T) - dL(T)).  First order: T_c = T - J^-1 dL(T).  [docs/physics.md, Compensation]
Corrected Corrector::correct_once(const Target& target, Method method) const {
  const Load load = load_at(target);
  Corrected corrected;
  corrected.sign = load.sign;
  if (load.stretch.jacobian.singular()) return corrected;
  Pose<double> commanded = load.pose;
  if (method == Method::first_order) {
    commanded = machine::displaced<double>(commanded, -load.stretch.jacobian.solve(load.stretch.stretch));
    corrected.converged = true;
  } else {
    corrected.converged = move_struts(load, commanded);
  }
  commanded = machine::displaced<double>(commanded, -load.stretch.tip);
  corrected.pose = machine::words_of(model_.rotation, commanded, target.pose);
  return corrected;
}

// The axes that may not be written stay where they are, so the machine does not stand quite upright on the target: its
// orientation is sought with which the tip is on it. False: not found yet.
bool Corrector::settle_fixed_axes(const Target& target, Corrected& corrected, Target& standing) {
  double off = 0;
  for (const Axis axis : kAllAxes) {
    if (!target.fixed.contains(axis)) continue;
    const double rest = corrected.pose[axis] - target.pose[axis];
    standing.pose[axis] -= rest;
    off = std::max(off, std::abs(rest));
  }
  for (const Axis axis : kAllAxes) {
    if (target.fixed.contains(axis)) corrected.pose[axis] = target.pose[axis];
  }
  return off <= kFixedAxisDeg;
}

// A large correction is one near a singularity, where the machine may give way under its load wherever it is sent.
void Corrector::confirm(std::span<const Target> targets, Corrections& corrections) const {
  std::vector<std::size_t>& large = corrections.open_;
  exact::PoseBatch& batch = corrections.batch_;
  large.clear();
  batch.clear();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Corrected& corrected = corrections.corrected_[i];
    const AxisWords shift = corrected.pose - targets[i].pose;
    const bool small = length_mm(shift) <= kSureMm && path::largest_turn_deg(shift) <= kSureDeg;
    if (!corrected.converged || small) continue;
    if (targets[i].sign) {  // it moves as it moves: what is stated of its friction is not looked at
      Target moving = targets[i];
      moving.sign.reset();
      corrections.corrected_[i].converged = correct(moving).converged;
      continue;
    }
    large.push_back(i);
    batch.add(corrected.pose, targets[i].slope, targets[i].bend, targets[i].seconds.value_or(-1));
  }
  batch.play(setup_, exact::Friction::smoothed);
  for (std::size_t k = 0; k < large.size(); ++k) {
    const Target& target = targets[large[k]];
    Corrected& corrected = corrections.corrected_[large[k]];
    const std::optional<double> off = batch.stands(k) ? tip_distance(batch.stands_at(k), pose_of(target.pose)) / kMm
                                                      : tip_distance_mm(target, corrected.pose);
    corrected.converged = holds(target, off);
  }
}

bool Corrector::holds(const Target& target, std::optional<double> off_mm) const {
  if (!off_mm || *off_mm <= kHoldsMm) return off_mm.has_value();
  return settings_.method == Method::first_order && can_stand_on(target);
}

// The first order leaves more near a singularity. It counts where the exact method finds a command.
bool Corrector::can_stand_on(const Target& target) const {
  const Corrected exact = correct_once(target, Method::exact);
  if (!exact.converged) return false;
  const std::optional<double> off = tip_distance_mm(target, exact.pose);
  return off && *off <= kHoldsMm;
}

Corrected Corrector::correct(const Target& target) const {
  Corrections alone;
  correct({&target, 1}, alone);
  return alone[0];
}

// The open targets where they stand now: in packs, and what these are not sure of one by one.
void Corrector::correct_standing(std::span<const Target> standing, Corrections& corrections, int round) const {
  const std::vector<std::size_t>& open = corrections.open_;
  exact::PoseBatch& batch = corrections.batch_;
  batch.clear();
  const bool signs_stated = open.size() == 1 && standing[open.front()].sign;  // packs know of none
  if (settings_.method == Method::exact && !signs_stated) {
    for (const std::size_t i : open) {
      const Target& at = standing[i];
      batch.add(at.pose, at.slope, at.bend, at.seconds.value_or(-1));
    }
    batch.correct(setup_);
  }
  for (std::size_t k = 0; k < open.size(); ++k) {
    Corrected& corrected = corrections.corrected_[open[k]];
    const int state = batch.size() > 0 ? batch.state(k) : 0;
    if ((state & exact::kFound) == 0 || standing[open[k]].sign) {
      corrected = correct_once(standing[open[k]], settings_.method);
      continue;
    }
    corrected = {batch.commanded(k), true, round == 0 && (state & exact::kWithin) != 0, batch.sign(k)};
  }
}

void Corrector::correct(std::span<const Target> targets, Corrections& corrections) const {
  corrections.corrected_.resize(targets.size());
  const bool fixes = std::any_of(targets.begin(), targets.end(), [](const Target& at) { return !at.fixed.empty(); });
  if (fixes) corrections.standing_.assign(targets.begin(), targets.end());
  const std::span<const Target> standing = fixes ? std::span<const Target>(corrections.standing_) : targets;
  corrections.open_.resize(targets.size());
  std::iota(corrections.open_.begin(), corrections.open_.end(), std::size_t{0});
  for (int round = 0; round < kMostRounds && !corrections.open_.empty(); ++round) {
    correct_standing(standing, corrections, round);
    corrections.still_open_.clear();
    for (const std::size_t i : corrections.open_) {
      const Target& target = targets[i];
      Corrected& corrected = corrections.corrected_[i];
      if (corrected.converged && !target.fixed.empty()) {
        corrected.within_limits = false;  // it was asked of another pose
        if (settle_fixed_axes(target, corrected, corrections.standing_[i])) continue;
        corrected.converged = round + 1 < kMostRounds;
        if (corrected.converged) corrections.still_open_.push_back(i);
      }
    }
    corrections.open_.swap(corrections.still_open_);
  }
  confirm(targets, corrections);
}

std::optional<AxisWords> Corrector::error(const Target& target) const {
  physics::Environment environment = environment_;
  const physics::Motion<double> motion = motion_of(target, environment);
  const physics::TipError<double> error = physics::tip_error(physics_, environment, motion);
  if (!error.converged()) return std::nullopt;
  return machine::words_of(model_.rotation, error.pose, target.pose) - target.pose;
}

void Corrector::play(std::span<const Target> told, Plays& plays) const {
  exact::PoseBatch& batch = plays.batch_;
  batch.clear();
  for (const Target& at : told) batch.add(at.pose, at.slope, at.bend, at.seconds.value_or(-1));
  batch.play(setup_, exact::Friction::as_modelled);
  plays.played_.clear();
  for (std::size_t i = 0; i < told.size(); ++i) {
    if (batch.stands(i)) {
      plays.played_.emplace_back(PlayedTip{batch.stands_at(i), batch.speed(i)});
    } else {
      plays.played_.push_back(play(told[i]));
    }
  }
}

std::optional<PlayedTip> Corrector::play(const Target& told) const {
  physics::Motion<double> motion = motion_at(model_.rotation, radius_, told, environment_);
  motion.time = settings_.time_s.value_or(0);
  const physics::TipError<double> error = physics::tip_error(physics_, environment_, motion);
  if (!error.converged()) return std::nullopt;
  const auto struts = machine::strut_geometry(geometry(), motion.pose);
  return PlayedTip{error.pose, physics::strut_rates(struts, motion, environment_).speed};
}

physics::StrutRates<double> Corrector::rates_as_told(const Target& told) const {
  const physics::Motion<double> motion = motion_at(model_.rotation, radius_, told, environment_);
  return physics::strut_rates(machine::strut_geometry(geometry(), motion.pose), motion, environment_);
}

double Corrector::turn_rad(const AxisWords& words, const AxisWords& change) const {
  const auto rotary = [](const AxisWords& of) -> Vector3<double> {
    return Vector3<double>(of[Axis::A], of[Axis::B], of[Axis::C]) * kDeg;
  };
  return machine::angular_velocity<double>(model_.rotation, rotary(words), rotary(change)).norm();
}

// dx = J^-1 (dL(+) - dL(-)), strut by strut.
Corrector::FrictionTurns Corrector::friction_turns(const Target& target) const {
  FrictionTurns turns;
  if (!environment_.friction) return turns;
  const physics::Motion<double> motion = motion_at(model_.rotation, radius_, target, environment_);
  const auto struts = machine::strut_geometry(geometry(), motion.pose);
  const auto rates = physics::strut_rates(struts, motion, environment_);
  const auto stretch_with = [&](int strut, double sign) {
    auto turned = rates;
    turned.sign[strut] = sign;
    turned.speed[strut] = std::copysign(rates.speed[strut], sign);
    return physics::strut_stretch_at(physics_, physics_.parameters.data(), environment_, motion, turned, motion.pose,
                                     struts);
  };
  for (int j = 0; j < machine::kStruts; ++j) {
    const auto forth = stretch_with(j, 1);
    if (forth.jacobian.singular()) return turns;
    const auto back = stretch_with(j, -1);
    const machine::Vector6<double> moved = forth.jacobian.solve(forth.stretch - back.stretch);
    turns.strut_mm[j] = std::abs(forth.stretch[j] - back.stretch[j]) / kMm;
    turns.tip_mm[j] = moved.head<3>().norm() / kMm;
    turns.turned_deg[j] = moved.tail<3>().norm() / kDeg;
  }
  return turns;
}

std::optional<double> Corrector::tip_distance_mm(const Target& target, const AxisWords& commanded) const {
  Target told = target;
  told.pose = commanded;
  physics::Environment environment = environment_;
  const physics::Motion<double> motion = motion_of(told, environment);
  const physics::TipError<double> error = physics::tip_error(physics_, environment, motion);
  if (!error.converged()) return std::nullopt;
  return tip_distance(error.pose, pose_of(target.pose)) / kMm;
}

double Corrector::shortest_wave() const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const double lead : physics_.machine.lead) {
    if (lead > 0) shortest = std::min(shortest, lead);
  }
  for (const machine::EffectRow& row : model_.effects) {
    for (const machine::EffectValue& value : row.values) {
      if (value.key != "pitch_mm") continue;
      for (const double pitch : value.values) {
        if (pitch > 0) shortest = std::min(shortest, pitch * kMm);
      }
    }
  }
  return shortest;
}

double Corrector::condition(const Target& target) const {
  return machine::condition_number(machine::strut_geometry(geometry(), pose_of(target.pose)), radius_);
}

bool Corrector::condition_surely_below(const Target& target, double most) const {
  return machine::condition_surely_below(machine::strut_geometry(geometry(), pose_of(target.pose)), radius_, most);
}

std::optional<double> Corrector::error_per_kg_mm(const Target& target) const {
  physics::Environment environment = environment_;
  const physics::Motion<double> motion = motion_of(target, environment);
  const physics::TipError<double> without = physics::tip_error(physics_, environment, motion);
  environment.payload_mass += 1;
  return tips_apart_mm(without, physics::tip_error(physics_, environment, motion));
}

std::optional<double> Corrector::drift_per_hour_mm(const Target& target) const {
  physics::Environment environment = environment_;
  physics::Motion<double> motion = motion_of(target, environment);
  const physics::TipError<double> now = physics::tip_error(physics_, environment, motion);
  motion.time += kHour;
  return tips_apart_mm(now, physics::tip_error(physics_, environment, motion));
}

AxisWords touch_off_error(const Corrector& corrector, const machine::Limits& limits, const Settings& settings) {
  if (!settings.touch_off) return {};
  const auto refuse_pose = [](std::string message) {
    refuse("compensate-touch-off", std::move(message),
           "give the pose in W at which the work offset was probed: --touch-off X,Y,Z,A,B,C in mm and deg");
  };
  const std::optional<AxisWords> error = corrector.error({*settings.touch_off, {}, {}, std::nullopt});
  if (!error) refuse_pose("the machine cannot stand at the touch-off pose");
  const std::vector<machine::Violation> broken =
      machine::check_compensated(limits, corrector.geometry(), corrector.pose_of(*settings.touch_off));
  if (!broken.empty()) {
    refuse_pose(fmt::format("the machine does not come to the touch-off pose: {}", machine::to_text(broken.front())));
  }
  return *error;
}

}  // namespace plumbline::compensate

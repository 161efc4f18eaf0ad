// Where the deformed machine stands when it is sent to a pose, for as many poses as T has lanes: dT = FK(IK(T) + dL(T +
// dT)) - T, as physics::tip_error has it. Every lane goes its own way, as in kernel_correct.hpp.
#pragma once

#include "compensate/exact/kernel_loads.hpp"

namespace plumbline::compensate::exact {

constexpr double kStepTolerance = 1e-12;  // m, rotations times a metre
constexpr double kLongestTurn = 0.03;     // rad that a step may turn: the series of turned() is exact to there
constexpr int kMostRounds = 12;

template <class T>
PLUMBLINE_INLINE void write_played(const Pose<T>& stands, const machine::PerStrut<T>& speed, const MaskOf<T>& found,
                                   PlayedBlock& played, std::size_t lane) {
  for (int a = 0; a < 3; ++a) {
    const auto x = static_cast<std::size_t>(a);
    stands.p_WT[a].store(&played.tip[x][lane]);
    for (int b = 0; b < 3; ++b) stands.R_WP(a, b).store(&played.turned[3 * x + static_cast<std::size_t>(b)][lane]);
  }
  for (int j = 0; j < machine::kStruts; ++j) speed[j].store(&played.speed[static_cast<std::size_t>(j)][lane]);
  select<T>(found, T(double(kFound)), T(0.0)).store(&played.state[lane]);
}

/// The lanes of a block from `lane` on.
template <class T>
void play_lanes(const Setup& setup, Friction friction, const AskedBlock& block, PlayedBlock& played, std::size_t lane) {
  const machine::Geometry& geometry = setup.forces->machine.geometry;
  const Asked<T> asked = read<T>(block, lane);
  const machine::AxisTurns<T> turns = machine::axis_turns<T>(setup.rotation, asked.rotary * T(kDeg));
  T per_sign_speed;
  const physics::Motion<T> motion = motion_of(setup, friction, asked, turns, per_sign_speed);
  const machine::StrutGeometry<T> commanded = machine::strut_geometry(geometry, setup.arms_P, motion.pose);
  const physics::StrutRates<T> rates = physics::strut_rates(commanded, motion, setup.environment, per_sign_speed);

  Pose<T> pose = motion.pose;
  machine::StrutGeometry<T> struts = commanded;
  Loads<T> loads = loads_at(setup, motion, rates, pose, struts);
  const T side = loads.lu.determinant();
  MaskOf<T> sound = loads.lu.sound();
  MaskOf<T> settled(false);
  machine::Vector6<T> tip = loads.tip;
  for (int round = 0;; ++round) {
    const MaskOf<T> frozen = settled;
    const machine::Vector6<T> step = loads.lu.solve(commanded.length + loads.stretch - struts.length);
    const Vector3<T> turn(step[3], step[4], step[5]);
    sound = sound && (frozen || squared(turn) < T(kLongestTurn * kLongestTurn));
    const Matrix3<T> next = turned<T>(turn, pose.R_WP);
    MaskOf<T> last(true);
    for (int a = 0; a < 6; ++a) {
      last = last && absolute<T>(step[a]) <= T(kStepTolerance);
      tip[a] = select<T>(frozen, tip[a], loads.tip[a]);
    }
    for (int a = 0; a < 3; ++a) {
      pose.p_WT[a] = select<T>(frozen, pose.p_WT[a], pose.p_WT[a] + step[a]);
      for (int q = 0; q < 3; ++q) pose.R_WP(a, q) = select<T>(frozen, pose.R_WP(a, q), next(a, q));
    }
    settled = frozen || last;
    if (all(settled || !sound) || round == kMostRounds) break;
    struts = machine::strut_geometry(geometry, setup.arms_P, pose);
    loads = loads_at(setup, motion, rates, pose, struts);
    sound = sound && (settled || (loads.lu.sound() && loads.lu.determinant() * side > T(0.0)));
  }
  if (setup.has_tip) pose = machine::displaced<T>(pose, tip);
  write_played<T>(pose, rates.speed, settled && sound, played, lane);
}

template <class T>
void play_blocks(const Setup& setup, Friction friction, const AskedBlock* asked, PlayedBlock* played,
                 std::size_t count) {
  for (std::size_t i = 0; i < count; i += static_cast<std::size_t>(T::size())) {
    play_lanes<T>(setup, friction, asked[i / kBlock], played[i / kBlock], i % kBlock);
  }
}

}  // namespace plumbline::compensate::exact

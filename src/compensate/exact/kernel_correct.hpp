// The exact correction of as many poses as T has lanes: T_c = FK(IK(T) - dL(T))  [docs/physics.md, Compensation]. Every
// lane goes its own way: one that has converged is frozen, one that cannot be sure of its answer says so.
#pragma once

#include "compensate/exact/kernel_loads.hpp"

namespace plumbline::compensate::exact {

constexpr double kLengthTolerance = 1e-12;  // m
constexpr int kMostSteps = 16;

/// What Newton's chord method looks for and how far off it is. Squares take the place of lengths: (w^2 - l^2) / 2 w is
/// w - l but for its square, and needs no root.
template <class T>
struct Search {
  machine::PerStrut<T> squares;     // of the lengths that are wanted, m^2
  machine::PerStrut<T> per_length;  // 1 / 2 w
  machine::PerStrut<T> misfit;      // wanted minus had, m
  MaskOf<T> fits;                   // all of them within the tolerance
};

template <class T>
PLUMBLINE_INLINE void measure(const Setup& setup, const Pose<T>& pose, Search<T>& search) {
  const auto& base = setup.forces->machine.geometry.base_joints_W;
#pragma GCC unroll 6
  for (int j = 0; j < machine::kStruts; ++j) {
    T squares(0.0);
#pragma GCC unroll 3
    for (int a = 0; a < 3; ++a) {
      const T d = (pose.p_WT[a] - T(base(a, j))) +
                  (pose.R_WP(a, 0) * T(setup.arms_P(0, j)) + pose.R_WP(a, 1) * T(setup.arms_P(1, j)) +
                   pose.R_WP(a, 2) * T(setup.arms_P(2, j)));
      squares += d * d;
    }
    search.misfit[j] = (search.squares[j] - squares) * search.per_length[j];
    const auto fits = absolute<T>(search.misfit[j]) <= T(kLengthTolerance);
    search.fits = j == 0 ? fits : (search.fits && fits);
  }
}

/// From a pose to the one whose struts are longer by `change`, as machine::forward_near has it, each lane until it has
/// converged. True where it has.
template <class T>
PLUMBLINE_INLINE MaskOf<T> move_struts(const Setup& setup, const machine::OrderedLu6<T>& lu,
                                       const machine::PerStrut<T>& lengths, const machine::PerStrut<T>& change,
                                       Pose<T>& pose) {
  Search<T> search;
  for (int j = 0; j < machine::kStruts; ++j) {
    const T wanted = lengths[j] + change[j];
    search.squares[j] = wanted * wanted;
    search.per_length[j] = T(0.5) / wanted;
  }
  search.misfit = change;
  search.fits = MaskOf<T>(false);
  for (int step = 0; step < kMostSteps && !all(search.fits || !lu.sound()); ++step) {
    const auto frozen = search.fits;
    const machine::Vector6<T> by = lu.solve(search.misfit);
    const Matrix3<T> next = turned<T>(Vector3<T>(by[3], by[4], by[5]), pose.R_WP);
    for (int a = 0; a < 3; ++a) {
      pose.p_WT[a] = select<T>(frozen, pose.p_WT[a], pose.p_WT[a] + by[a]);
      for (int q = 0; q < 3; ++q) pose.R_WP(a, q) = select<T>(frozen, pose.R_WP(a, q), next(a, q));
    }
    measure(setup, pose, search);
  }
  return search.fits && lu.sound();
}

template <class T>
PLUMBLINE_INLINE MaskOf<T> upright(const Matrix3<T>& R_WP, double squared_sine) {
  return R_WP(2, 2) > T(0.0) && R_WP(0, 2) * R_WP(0, 2) + R_WP(1, 2) * R_WP(1, 2) <= T(squared_sine);
}

/// machine::condition_bound at a pose, by the row order of home.
template <class T>
PLUMBLINE_INLINE MaskOf<T> well_conditioned(const Setup& setup, const Pose<T>& pose) {
  machine::Matrix6<T> J =
      machine::jacobian(machine::strut_geometry(setup.forces->machine.geometry, setup.arms_P, pose));
  T squares(0.0);
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < 6; ++k) {
      if (k >= 3) J(i, k) *= T(1.0 / setup.condition_radius);
      squares += J(i, k) * J(i, k);
    }
  }
  const machine::OrderedLu6<T> lu(J, setup.rows);
  T inverse(0.0);
  for (int j = 0; j < 6; ++j) {
    const machine::Vector6<T> column = lu.solve(machine::Vector6<T>::Unit(j));
    for (int i = 0; i < 6; ++i) inverse += column[i] * column[i];
  }
  return lu.sound() && squares * inverse < T(setup.bounds.condition_max * setup.bounds.condition_max);
}

/// Whether a commanded pose, whose struts have these lengths, surely keeps to the limits.
template <class T>
PLUMBLINE_INLINE MaskOf<T> surely_within(const Setup& setup, const Pose<T>& pose, const machine::PerStrut<T>& lengths) {
  const SureBounds& bounds = setup.bounds;
  MaskOf<T> within = upright(pose.R_WP, bounds.commanded_tilt);
  for (int a = 0; a < 3; ++a) {
    const machine::Range& range = bounds.travel[static_cast<std::size_t>(a)];
    within = within && pose.p_WT[a] >= T(range.lower) && pose.p_WT[a] <= T(range.upper);
  }
  for (int j = 0; j < machine::kStruts; ++j) {
    within = within && lengths[j] >= T(bounds.length_min[j]) && lengths[j] <= T(bounds.length_max[j]);
  }
  if (bounds.condition_max < __builtin_inf()) within = within && well_conditioned(setup, pose);
  return within;
}

/// The words of the commanded pose, and what is sure of them.
template <class T>
PLUMBLINE_INLINE void write(const Setup& setup, const Asked<T>& asked, const machine::AxisTurns<T>& turns,
                            const Pose<T>& asked_pose, const Pose<T>& commanded, MaskOf<T> found,
                            const MaskOf<T>& within, AnsweredBlock& answer, std::size_t lane) {
  const machine::AngleChange<T> change = machine::angle_change(setup.rotation, turns, commanded.R_WP);
  found = found && change.sure;
  MaskOf<T> small = found;
  T squares(0.0);
  for (int a = 0; a < 3; ++a) {
    const auto x = static_cast<std::size_t>(a);
    const T shift = (commanded.p_WT[a] - asked_pose.p_WT[a]) * T(1 / kMm);
    const T turn = change.abc[a] * T(1 / kDeg);
    squares += shift * shift;
    small = small && absolute<T>(turn) <= T(setup.small_deg);
    (asked.linear[a] + shift).store(&answer.pose[x][lane]);
    (asked.rotary[a] + turn).store(&answer.pose[x + 3][lane]);
  }
  small = small && squares <= T(setup.small_mm * setup.small_mm);
  const T state = select<T>(found, T(double(kFound)), T(0.0)) + select<T>(within, T(double(kWithin)), T(0.0)) +
                  select<T>(small, T(double(kSmall)), T(0.0));
  state.store(&answer.state[lane]);
}

/// The lanes of a block from `lane` on.
template <class T>
void correct_lanes(const Setup& setup, const AskedBlock& block, AnsweredBlock& answer, std::size_t lane) {
  const machine::Geometry& geometry = setup.forces->machine.geometry;
  const Asked<T> asked = read<T>(block, lane);
  const machine::AxisTurns<T> turns = machine::axis_turns<T>(setup.rotation, asked.rotary * T(kDeg));
  T per_sign_speed;
  const physics::Motion<T> motion = motion_of(setup, Friction::smoothed, asked, turns, per_sign_speed);
  const machine::StrutGeometry<T> struts = machine::strut_geometry(geometry, setup.arms_P, motion.pose);
  const physics::StrutRates<T> rates = physics::strut_rates(struts, motion, setup.environment, per_sign_speed);
  for (std::size_t j = 0; j < 6; ++j) rates.sign[static_cast<int>(j)].store(&answer.sign[j][lane]);

  const Loads<T> loads = loads_at(setup, motion, rates, motion.pose, struts);
  Pose<T> commanded = motion.pose;
  const auto found = move_struts<T>(setup, loads.lu, struts.length, -loads.stretch, commanded);
  machine::PerStrut<T> lengths = struts.length - loads.stretch;
  if (setup.has_tip) {
    commanded = machine::displaced<T>(commanded, -loads.tip);
    lengths = machine::strut_geometry(geometry, setup.arms_P, commanded).length;
  }
  const auto within =
      upright(motion.pose.R_WP, setup.bounds.programmed_tilt) && surely_within(setup, commanded, lengths);
  write<T>(setup, asked, turns, motion.pose, commanded, found, within, answer, lane);
}

/// `count` poses, each of them in the lanes of T.
template <class T>
void correct_blocks(const Setup& setup, const AskedBlock* asked, AnsweredBlock* answered, std::size_t count) {
  for (std::size_t i = 0; i < count; i += static_cast<std::size_t>(T::size())) {
    correct_lanes<T>(setup, asked[i / kBlock], answered[i / kBlock], i % kBlock);
  }
}

}  // namespace plumbline::compensate::exact

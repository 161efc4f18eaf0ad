// What the exact correction needs of a machine and does not change from pose to pose.
#pragma once

#include "machine/limits.hpp"
#include "machine/ordered_lu6.hpp"
#include "physics/force_model.hpp"
#include "physics/motion.hpp"

namespace plumbline::compensate::exact {

/// What a pose has to keep to so that no limit is broken, whatever rounding does.
struct SureBounds {
  std::array<machine::Range, 3> travel;  // m
  machine::PerStrut<double> length_min, length_max;
  double programmed_tilt = 0;  // squared sines; the tilt is below a right angle
  double commanded_tilt = 0;
  double condition_max = 0;  // infinite: not asked for
};
SureBounds sure_bounds(const machine::Limits& limits);

struct Setup {
  const physics::ForceModel* forces = nullptr;
  physics::Environment environment;
  machine::RotationOrder rotation;
  SureBounds bounds;
  machine::StrutVectors<double> arms_P;  // from the tip to the platform joints, m
  double radius = 0;                     // of the platform, m: turns a rotation into the speed of its joints
  double condition_radius = 0;           // that lengths of the Jacobian are divided by, m
  double sign_width_of_feed = 0;         // v0 is at least this share of the feed
  bool has_tip = false;                  // an effect moves the tip without a strut
  double time = 0;                       // on the clock of the measurements, s
  double small_mm = 0;                   // State::kSmall: both
  double small_deg = 0;
  machine::RowOrder rows{};  // of the struts, as the Jacobian at home is best solved

  /// `home`: a pose on the machine's side of every singularity.
  void take_geometry(const physics::ForceModel& model, const Pose<double>& home);
};

// Units that let Eigen align more than others must still see the same set-up.
static_assert(alignof(Setup) <= 16 && alignof(physics::MachineConstants) <= 16);

}  // namespace plumbline::compensate::exact

#include "compensate/exact/setup.hpp"

#include <cmath>
#include <numbers>

#include "machine/jacobian.hpp"

namespace plumbline::compensate::exact {
namespace {

constexpr double kSureM = 1e-12;  // beyond rounding, below anything that counts

// The largest squared sine that is surely within: half of the tolerance is left.
double squared_sine(double tilt) {
  const double angle = tilt + 0.5 * machine::kTiltTolerance;
  return angle < std::numbers::pi / 2 ? std::sin(angle) * std::sin(angle) : 1;
}

}  // namespace

SureBounds sure_bounds(const machine::Limits& limits) {
  SureBounds bounds;
  for (std::size_t a = 0; a < 3; ++a) {
    bounds.travel[a] = {limits.travel[a].lower + kSureM, limits.travel[a].upper - kSureM};
  }
  bounds.length_min = limits.length_min.array() + kSureM;
  bounds.length_max = limits.length_max.array() - kSureM;
  bounds.programmed_tilt = squared_sine(limits.tilt);
  bounds.commanded_tilt = squared_sine(limits.tilt + limits.tilt_allowance);
  bounds.condition_max = limits.condition_max;
  return bounds;
}

void Setup::take_geometry(const physics::ForceModel& model, const Pose<double>& home) {
  forces = &model;
  const machine::Geometry& geometry = model.machine.geometry;
  arms_P = machine::arms_of(geometry);
  condition_radius = machine::platform_radius(geometry);
  has_tip = false;
  physics::for_each_effect([&]<class Effect>(std::size_t i) {
    if constexpr (requires { &Effect::template tip<double>; }) has_tip = has_tip || !model.instances_of(i).empty();
  });
  rows = machine::pivot_order(machine::jacobian(machine::strut_geometry(geometry, home)));
}

}  // namespace plumbline::compensate::exact

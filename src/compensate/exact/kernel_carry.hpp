// What the struts carry where the machine is sent to, its giving way left out, for as many poses as T has lanes.
#pragma once

#include "compensate/exact/kernel_loads.hpp"

namespace plumbline::compensate::exact {

/// The lanes of a block from `lane` on.
template <class T>
void carry_lanes(const Setup& setup, Friction friction, const AskedBlock& block, CarriedBlock& carried,
                 std::size_t lane) {
  const Asked<T> asked = read<T>(block, lane);
  const machine::AxisTurns<T> turns = machine::axis_turns<T>(setup.rotation, asked.rotary * T(kDeg));
  T per_sign_speed;
  const physics::Motion<T> motion = motion_of(setup, friction, asked, turns, per_sign_speed);
  const machine::StrutGeometry<T> struts =
      machine::strut_geometry(setup.forces->machine.geometry, setup.arms_P, motion.pose);
  const physics::StrutRates<T> rates = physics::strut_rates(struts, motion, setup.environment, per_sign_speed);
  const Loads<T> loads = loads_at(setup, motion, rates, motion.pose, struts);
  for (std::size_t j = 0; j < 6; ++j) {
    struts.length[static_cast<int>(j)].store(&carried.length[j][lane]);
    loads.nut_tension[static_cast<int>(j)].store(&carried.nut_tension[j][lane]);
  }
  select<T>(loads.lu.sound(), T(double(kFound)), T(0.0)).store(&carried.state[lane]);
}

template <class T>
void carry_blocks(const Setup& setup, Friction friction, const AskedBlock* asked, CarriedBlock* carried,
                  std::size_t count) {
  for (std::size_t i = 0; i < count; i += static_cast<std::size_t>(T::size())) {
    carry_lanes<T>(setup, friction, asked[i / kBlock], carried[i / kBlock], i % kBlock);
  }
}

}  // namespace plumbline::compensate::exact

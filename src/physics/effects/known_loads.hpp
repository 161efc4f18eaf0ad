#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// The weight of what the moment brings along: another tool than the reference one, a known payload at the tip.
struct KnownLoads {
  static constexpr std::string_view name = "known-loads";
  static constexpr std::array<ParameterSpec, 0> parameters{};

  template <class T>
  static void wrench(Values<T>, const Situation<T>& at, Wrench<T>& sum) {
    const Vector3<T>& g = at.conditions.gravity;
    sum.add(g * T(at.environment.tool_mass), at.arm_to(at.environment.tool_centre_P.template cast<T>()));
    sum.add(g * T(at.environment.payload_mass), Vector3<T>::Zero());
  }
};

}  // namespace plumbline::physics

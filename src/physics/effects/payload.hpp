#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// A mass at the tool tip that nobody told the model of.
struct Payload {
  static constexpr std::string_view name = "payload";
  static constexpr std::array parameters{
      ParameterSpec{.key = "mass_kg", .unit = machine::units::kg, .lower = 0, .upper = 60}};

  // N += m g, at the tip: no moment
  template <class T>
  static void wrench(Values<T> p, const Situation<T>& at, Wrench<T>& sum) {
    sum.add(at.conditions.gravity * p[0], Vector3<T>::Zero());
  }
};

}  // namespace plumbline::physics

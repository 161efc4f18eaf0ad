#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Struts that are longer than the controller believes, by a constant.
struct StrutOffset {
  static constexpr std::string_view name = "strut-offset";
  static constexpr std::array parameters{ParameterSpec{.key = "length_um",
                                                       .unit = machine::units::um,
                                                       .count = 6,
                                                       .lower = -500,
                                                       .upper = 500,
                                                       .uncertainty = "strut_offset_um"}};
  static constexpr bool own_strut_alone = true;
  static constexpr bool geometry = true;

  template <class T>
  static void length(Values<T> p, const Situation<T>&, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) sum[j] += p[j];
  }
};

}  // namespace plumbline::physics

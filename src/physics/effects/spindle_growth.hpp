#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// A spindle that grows as it warms: the tip leaves the gauge point along the tool.
struct SpindleGrowth {
  static constexpr std::string_view name = "spindle-growth";
  static constexpr bool rare = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "length_um", .unit = machine::units::um, .lower = -1000, .upper = 1000},
      ParameterSpec{.key = "rate_um_h", .unit = machine::units::um_h, .lower = -1000, .upper = 1000}};
  static constexpr bool path = true;
  enum { kLength = 0, kRate = 1 };

  // dx = -(g + rate time) e_z of P: the tool points along -Z of P
  template <class T>
  static void tip(Values<T> p, const Situation<T>& at, machine::Vector6<T>& sum) {
    const T grown = p[kLength] + p[kRate] * at.motion.time;
    sum.template head<3>() -= grown * at.pose.R_WP.col(2);
  }
};

}  // namespace plumbline::physics

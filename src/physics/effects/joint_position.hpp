#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// Joints that are not where the model (and the controller) believes them: true minus believed, base joints in W,
/// platform joints in P.
struct JointPosition {
  static constexpr std::string_view name = "joint-position";
  static constexpr std::array parameters{ParameterSpec{.key = "base_um",
                                                       .unit = machine::units::um,
                                                       .count = 6,
                                                       .lower = -5000,
                                                       .upper = 5000,
                                                       .each = 3,
                                                       .uncertainty = "joint_position_um"},
                                         ParameterSpec{.key = "platform_um",
                                                       .unit = machine::units::um,
                                                       .count = 6,
                                                       .lower = -5000,
                                                       .upper = 5000,
                                                       .each = 3,
                                                       .uncertainty = "joint_position_um"}};
  enum { kBase = 0, kPlatform = 18 };
  static constexpr bool own_strut_alone = true;
  static constexpr bool geometry = true;
  static constexpr bool rare = true;

  // dL_j = u_j . dq_j - u_j . R dp_j
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) {
      const Vector3<T> base(p[kBase + 3 * j], p[kBase + 3 * j + 1], p[kBase + 3 * j + 2]);
      const Vector3<T> platform(p[kPlatform + 3 * j], p[kPlatform + 3 * j + 1], p[kPlatform + 3 * j + 2]);
      const Vector3<T> u = at.struts.direction.col(j);
      sum[j] += u.dot(base - at.pose.R_WP * platform);
    }
  }
};

}  // namespace plumbline::physics

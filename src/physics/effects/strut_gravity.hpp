#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// The weight of the struts: their platform joints carry a share of it across the strut, their nuts the part along it.
struct StrutGravity {
  static constexpr std::string_view name = "strut-gravity";
  static constexpr std::array parameters{
      model_key("strut", "screw_mass_kg", {.shared = true, .uncertainty = "strut_mass_kg", .label = "screw mass"}),
      model_key("strut", "joint_mass_kg", {.shared = true}),
      model_key("strut", "motor_mass_kg", {.shared = true, .uncertainty = "motor_mass_kg", .label = "motor mass"}),
      model_key("strut", "motor_arm_mm", {.shared = true}),
      model_key("strut", "joint_length_mm", {.shared = true}),
      model_key("strut", "screw_length_mm", {.shared = true})};
  enum { kScrew = 0, kJoint = 6, kMotor = 12, kMotorArm = 18, kJointLength = 24, kScrewLength = 30 };

  template <class T>
  static void conditions(Values<T> p, const Situation<T>&, Conditions<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) {
      sum.screw_mass[j] += p[kScrew + j];
      sum.joint_mass[j] += p[kJoint + j];
      sum.motor_mass[j] += p[kMotor + j];
    }
  }

  // N_j = mu_j (g - (g.u_j) u_j),  mu_j = [m_B (L_j - l2 - l3/2) + m_J L_j - m_S l1] / L_j: moments about the base
  // joint [Ibaraki et al., Eq. 6-7; docs/physics.md]
  template <class T>
  static void transverse_force(Values<T> p, const Situation<T>& at, machine::StrutVectors<T>& sum) {
    const Conditions<T>& with = at.conditions;
    for (int j = 0; j < machine::kStruts; ++j) {
      const T length = at.struts.length[j];
      const T screw_arm = length - p[kJointLength + j] - T(0.5) * p[kScrewLength + j];
      const T share =
          with.joint_mass[j] + (with.screw_mass[j] * screw_arm - with.motor_mass[j] * p[kMotorArm + j]) / length;
      const Vector3<T> u = at.struts.direction.col(j);
      sum.col(j) += share * (with.gravity - with.gravity.dot(u) * u);
    }
  }

  // t_nut,j = t_j + (m_B + m_J) g.u_j: a hanging strut's weight adds to its tension  [docs/physics.md; the sign of Eq.
  // 4 and 7 as printed is the other one]
  template <class T>
  static void nut_tension(Values<T>, const Situation<T>& at, machine::PerStrut<T>& sum) {
    for (int j = 0; j < machine::kStruts; ++j) {
      const Vector3<T> u = at.struts.direction.col(j);
      sum[j] += (at.conditions.screw_mass[j] + at.conditions.joint_mass[j]) * at.conditions.gravity.dot(u);
    }
  }
};

}  // namespace plumbline::physics

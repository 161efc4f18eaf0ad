#pragma once

#include <array>

#include "physics/situation.hpp"

namespace plumbline::physics {

/// A frame that gives way under what the struts pull at the ring of base joints, and takes the whole machine along.
struct FrameCompliance {
  static constexpr std::string_view name = "frame-compliance";
  static constexpr bool rare = true;
  static constexpr std::array parameters{
      ParameterSpec{.key = "shift_um_N", .unit = machine::units::um_N, .lower = 0, .upper = 1},
      ParameterSpec{.key = "tilt_urad_Nm", .unit = machine::units::urad_Nm, .lower = 0, .upper = 50}};
  enum { kShift = 0, kTilt = 1 };

  // F = sum t_j u_j,  M = sum (q_j - o) x t_j u_j, t_j of the nuts, o the middle of the base joints;
  // the tip turns by c M and moves by s F + c M x (x - o)
  template <class T>
  static void tip(Values<T> p, const Situation<T>& at, machine::Vector6<T>& sum) {
    const auto& joints = at.machine.geometry.base_joints_W;
    const Vector3<double> middle = joints.rowwise().mean();
    Vector3<T> force = Vector3<T>::Zero();
    Vector3<T> moment = Vector3<T>::Zero();
    for (int j = 0; j < machine::kStruts; ++j) {
      const Vector3<T> pull = at.nut_tension[j] * at.struts.direction.col(j);
      const Vector3<double> arm = joints.col(j) - middle;
      force += pull;
      moment += arm.template cast<T>().cross(pull);
    }
    const Vector3<T> turn = p[kTilt] * moment;
    const Vector3<T> to_tip = at.pose.p_WT - middle.template cast<T>();
    sum.template head<3>() += p[kShift] * force + turn.cross(to_tip);
    sum.template tail<3>() += turn;
  }
};

}  // namespace plumbline::physics

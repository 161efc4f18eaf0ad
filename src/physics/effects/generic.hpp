#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "physics/factors.hpp"

namespace plumbline::physics {

/// No cause but a description: a product of powers of what is known at a moment, added to one or more channels. What
/// `diagnose` writes when nothing in the catalogue explains what it sees.
struct Generic {
  static constexpr std::string_view name = "generic";
  static constexpr bool description = true;
  static constexpr double kMost = 1e6;
  static constexpr std::array parameters{
      ParameterSpec{.key = "length_um",
                    .unit = machine::units::um,
                    .count = 6,
                    .lower = -kMost,
                    .upper = kMost,
                    .optional = true},
      ParameterSpec{
          .key = "drive_N", .unit = machine::units::N, .count = 6, .lower = -kMost, .upper = kMost, .optional = true},
      ParameterSpec{.key = "torque_Nm",
                    .unit = machine::units::Nm,
                    .count = 6,
                    .lower = -kMost,
                    .upper = kMost,
                    .optional = true},
      ParameterSpec{
          .key = "force_N", .unit = machine::units::N, .count = 3, .lower = -kMost, .upper = kMost, .optional = true},
      ParameterSpec{
          .key = "tip_um", .unit = machine::units::um, .count = 3, .lower = -kMost, .upper = kMost, .optional = true},
      ParameterSpec{.key = "strut_powers",
                    .unit = machine::units::none,
                    .count = 8,
                    .lower = 0,
                    .upper = 4,
                    .optional = true,
                    .setting = true,
                    .whole = true},
      ParameterSpec{.key = "shared_powers",
                    .unit = machine::units::none,
                    .count = 6,
                    .lower = 0,
                    .upper = 4,
                    .optional = true,
                    .setting = true,
                    .whole = true},
      ParameterSpec{
          .key = "pitch_mm", .unit = machine::units::mm, .lower = 0, .upper = 1000, .optional = true, .setting = true},
      ParameterSpec{.key = "phase_deg", .unit = machine::units::deg, .lower = -360, .upper = 360, .optional = true}};
  static constexpr bool path = true;
  enum {
    kLength = 0,
    kDrive = 6,
    kTorque = 12,
    kForce = 18,
    kTip = 21,
    kStrutPowers = 24,
    kSharedPowers = 32,
    kPitch = 38,
    kPhase = 39
  };

  template <class T>
  static T shared(Values<T> p, const Situation<T>& at) {
    return times_powers<T>(T(1.0), shared_factors<T>(at), p, kSharedPowers);
  }

  // shared factors x per-strut factors x cos(2 pi L / pitch + phase), the last one where there is a pitch
  template <class T>
  static machine::PerStrut<T> per_strut(Values<T> p, const Situation<T>& at) {
    using std::cos;
    machine::PerStrut<T> product = machine::PerStrut<T>::Constant(shared<T>(p, at));
    const T pitch = select<T>(p[kPitch] > T(0.0), p[kPitch], T(1.0));
    for (int j = 0; j < machine::kStruts; ++j) {
      product[j] = times_powers<T>(product[j], strut_factors<T>(at, j), p, kStrutPowers);
      const T wave = cos(at.struts.length[j] * T(2 * std::numbers::pi) / pitch + p[kPhase]);
      product[j] *= select<T>(p[kPitch] > T(0.0), wave, T(1.0));
    }
    return product;
  }

  template <class T>
  static void add(Values<T> p, int coefficients, const Situation<T>& at, machine::PerStrut<T>& sum) {
    const machine::PerStrut<T> product = per_strut<T>(p, at);
    for (int j = 0; j < machine::kStruts; ++j) sum[j] += p[coefficients + j] * product[j];
  }

  // N += F x shared factors, at the tool tip
  template <class T>
  static void wrench(Values<T> p, const Situation<T>& at, Wrench<T>& sum) {
    const Vector3<T> force(p[kForce], p[kForce + 1], p[kForce + 2]);
    sum.add(force * shared<T>(p, at), Vector3<T>::Zero());
  }

  // f_j += c_j x factors
  template <class T>
  static void drive_tension(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    add<T>(p, kDrive, at, sum);
  }

  // dL_j += c_j x factors
  template <class T>
  static void length(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    add<T>(p, kLength, at, sum);
  }

  // dx += c x shared factors
  template <class T>
  static void tip(Values<T> p, const Situation<T>& at, machine::Vector6<T>& sum) {
    sum.template head<3>() += Vector3<T>(p[kTip], p[kTip + 1], p[kTip + 2]) * shared<T>(p, at);
  }

  // torque_j += c_j x factors
  template <class T>
  static void reading(Values<T> p, const Situation<T>& at, machine::PerStrut<T>& sum) {
    add<T>(p, kTorque, at, sum);
  }
};

}  // namespace plumbline::physics

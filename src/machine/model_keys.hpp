// Every key that a machine model file may hold: its table, shape, unit, range and meaning. A new key is a row here.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

#include "machine/unit.hpp"

namespace plumbline::machine {

/// What the value of a key may be.
enum class Shape {
  text,
  number,
  whole,        // a whole number
  six,          // a number for all struts, or an array of six
  vector,       // three numbers
  range,        // two numbers, the lower first
  six_vectors,  // an array of six arrays of three
};

/// How many numbers a shape holds.
constexpr std::size_t count_of(Shape shape) {
  switch (shape) {
    case Shape::text:
      return 0;
    case Shape::number:
    case Shape::whole:
      return 1;
    case Shape::range:
      return 2;
    case Shape::vector:
      return 3;
    case Shape::six:
      return 6;
    case Shape::six_vectors:
      break;
  }
  return 18;
}

inline constexpr double kRequired = std::numeric_limits<double>::quiet_NaN();

struct KeySpec {
  std::string_view table;  // empty: before the first table
  std::string_view key;
  Shape shape;
  Unit unit;
  double lower;  // in the file's unit, inclusive
  double upper;
  double fallback;  // where the key is missing, in the file's unit; kRequired: it may not be missing
  std::string_view meaning;
  double least_nonzero = 0;  // a value between zero and this is a slip of units
};

// clang-format off
inline constexpr std::array kKeys{
    KeySpec{"", "plumbline", Shape::text, units::none, 0, 0, kRequired, "\"machine 1\": what this file is"},
    KeySpec{"", "name", Shape::text, units::none, 0, 0, kRequired, "the name of the machine"},
    KeySpec{"", "provenance", Shape::text, units::none, 0, 0, 0, "where each number comes from"},
    KeySpec{"", "rotation", Shape::text, units::none, 0, 0, kRequired, "the order in which A, B, C compose; \"ZYX\" is R = Rz(C) Ry(B) Rx(A)"},
    KeySpec{"", "gravity_m_s2", Shape::vector, units::m_s2, -20, 20, kRequired, "gravity in W, as [0, 0, -9.80665]"},
    KeySpec{"base", "joints_mm", Shape::six_vectors, units::mm, -50000, 50000, kRequired, "the six base joints in W"},
    KeySpec{"platform", "joints_mm", Shape::six_vectors, units::mm, -50000, 50000, kRequired, "the six platform joints in P"},
    KeySpec{"platform", "tool_tip_mm", Shape::vector, units::mm, -50000, 50000, kRequired, "the gauge point of the spindle in P"},
    KeySpec{"platform", "mass_kg", Shape::number, units::kg, 0, 10000, kRequired, "mass of the platform with spindle and reference tool"},
    KeySpec{"platform", "centre_of_mass_mm", Shape::vector, units::mm, -50000, 50000, kRequired, "centre of mass of the platform in P"},
    KeySpec{"platform", "reference_tool_kg", Shape::number, units::kg, 0, 1000, 0, "mass of the tool that mass_kg already contains"},
    KeySpec{"strut", "screw_mass_kg", Shape::six, units::kg, 0, 1000, kRequired, "mass of one ball screw"},
    KeySpec{"strut", "joint_mass_kg", Shape::six, units::kg, 0, 1000, kRequired, "mass of one platform-joint unit"},
    KeySpec{"strut", "motor_mass_kg", Shape::six, units::kg, 0, 1000, kRequired, "mass of one servo motor"},
    KeySpec{"strut", "motor_arm_mm", Shape::six, units::mm, 0, 5000, kRequired, "from the base joint back to the motor's centre (l1)", 1},
    KeySpec{"strut", "joint_length_mm", Shape::six, units::mm, 0, 5000, kRequired, "length of one platform-joint unit (l2)", 1},
    KeySpec{"strut", "screw_length_mm", Shape::six, units::mm, 10, 50000, kRequired, "length of one ball screw (l3)"},
    KeySpec{"strut", "compliance_per_length_um_N_m", Shape::six, units::um_N_m, 0, 1, kRequired, "compliance of the screw for each metre of strut (K1)", 1e-4},
    KeySpec{"strut", "compliance_um_N", Shape::six, units::um_N, 0, 1, kRequired, "compliance of the rest of a strut (K2)", 1e-5},
    KeySpec{"strut", "coulomb_friction_N", Shape::six, units::N, 0, 5000, kRequired, "Coulomb friction of the screw (f0)", 0.1},
    KeySpec{"strut", "lead_mm", Shape::six, units::mm, 0.5, 200, kRequired, "lead of the screw: travel of one turn"},
    KeySpec{"strut", "length_min_mm", Shape::six, units::mm, 10, 50000, kRequired, "the shortest that a strut may become"},
    KeySpec{"strut", "length_max_mm", Shape::six, units::mm, 10, 50000, kRequired, "the longest that a strut may become"},
    KeySpec{"strut", "sign_speed_mm_s", Shape::number, units::mm_s, 1e-4, 10, 0.02, "speed v0 at which friction's sign has turned: tanh(speed / v0)"},
    KeySpec{"joint", "viscous_friction_Nms_rad", Shape::number, units::Nms_rad, 0, 10000, 0, "viscous friction of a base joint (c)"},
    KeySpec{"joint", "coulomb_friction_Nm", Shape::number, units::Nm, 0, 1000, 0, "Coulomb friction moment of a base joint (c_c)"},
    KeySpec{"limits", "tilt_deg", Shape::number, units::deg, 0, 90, kRequired, "the largest angle between Z of the platform and Z of the base"},
    KeySpec{"limits", "tilt_allowance_deg", Shape::number, units::deg, 0, 10, 0.1, "how far a compensated pose may tilt beyond tilt_deg"},
    KeySpec{"limits", "x_mm", Shape::range, units::mm, -50000, 50000, kRequired, "travel of the tool tip in X"},
    KeySpec{"limits", "y_mm", Shape::range, units::mm, -50000, 50000, kRequired, "travel of the tool tip in Y"},
    KeySpec{"limits", "z_mm", Shape::range, units::mm, -50000, 50000, kRequired, "travel of the tool tip in Z"},
    KeySpec{"limits", "condition_max", Shape::number, units::none, 1, 1e12, 1e12, "the largest condition number of the Jacobian, lengths over the platform radius"},
    KeySpec{"control", "block_time_ms", Shape::number, units::ms, 0, 10000, 0, "the shortest time that the control needs for a block"},
    KeySpec{"control", "increment_mm", Shape::number, units::none, 0, 1, 0, "the step that the control rounds linear positions to, mm"},
    KeySpec{"control", "increment_deg", Shape::number, units::none, 0, 1, 0, "the step that the control rounds rotary positions to, deg"},
    KeySpec{"control", "digits_mm", Shape::whole, units::none, 0, 9, 4, "decimals that the control reads in mm"},
    KeySpec{"control", "digits_deg", Shape::whole, units::none, 0, 9, 5, "decimals that the control reads in deg"},
    KeySpec{"control", "digits_inch", Shape::whole, units::none, 0, 9, 6, "decimals that the control reads in inch"},
    KeySpec{"uncertainty", "compliance_relative", Shape::number, units::none, 0, 1, 0, "1 sigma of K1 and of K2, relative"},
    KeySpec{"uncertainty", "coulomb_friction_N", Shape::number, units::N, 0, 5000, 0, "1 sigma of each screw's Coulomb friction"},
    KeySpec{"uncertainty", "centre_of_mass_mm", Shape::number, units::mm, 0, 1000, 0, "1 sigma of the centre of mass, each axis"},
    KeySpec{"uncertainty", "platform_mass_kg", Shape::number, units::kg, 0, 1000, 0, "1 sigma of the platform's mass"},
    KeySpec{"uncertainty", "strut_mass_kg", Shape::number, units::kg, 0, 1000, 0, "1 sigma of the screw mass"},
    KeySpec{"uncertainty", "motor_mass_kg", Shape::number, units::kg, 0, 1000, 0, "1 sigma of the motor mass"},
    KeySpec{"uncertainty", "level_mrad", Shape::number, units::mrad, 0, 100, 0, "1 sigma of the level about X and about Y"},
    KeySpec{"uncertainty", "strut_offset_um", Shape::number, units::um, 0, 10000, 0, "1 sigma of each strut's length"},
    KeySpec{"uncertainty", "joint_position_um", Shape::number, units::um, 0, 10000, 0, "1 sigma of each coordinate of each joint"},
    KeySpec{"posterior", "file", Shape::text, units::none, 0, 0, 0, "the file beside the model that says how sure its numbers are"},
    KeySpec{"posterior", "hash", Shape::text, units::none, 0, 0, 0, "the hash of that file"},
};
// clang-format on

/// The row of `table`.`key`; in constant expressions an unknown one does not compile.
constexpr const KeySpec& key_spec(std::string_view table, std::string_view key) {
  for (const KeySpec& spec : kKeys) {
    if (spec.table == table && spec.key == key) return spec;
  }
  throw "no such key in machine/model_keys.hpp";
}

}  // namespace plumbline::machine

// What a machine does that its model leaves out: one number or a few for each effect, SI, all zero by default.
#pragma once

#include "truth/vectors.hpp"

namespace truth {

struct Flaws {
  // the first shelf of docs/effects.md
  double payload = 0;                           // kg at the tip
  double platform_mass = 0;                     // kg at the centre of mass
  Vec centre_of_mass{0, 0, 0};                  // m
  std::array<double, 2> level{};                // rad about X and Y
  double screw_mass = 0;                        // kg, each
  Six coulomb{};                                // N
  Six viscous{};                                // N s/m
  double stribeck_force = 0;                    // N
  double stribeck_speed = 3e-3;                 // m/s
  double load_friction = 0;                     // of the tension
  double joint_moment = 0;                      // N m
  double joint_damping = 0;                     // N m s/rad
  Six backlash{};                               // m
  Six offset{};                                 // m
  Six drift{};                                  // K/s
  Six cyclic{};                                 // m
  Six cyclic_phase{};                           // rad
  double lag = 0;                               // s
  Six lags{};                                   // s
  Six torque_scale{};                           // of the torque
  std::array<double, 2> base_compliance{};      // m/N, in the base plane and along Z
  std::array<double, 2> platform_compliance{};  // m/N, the same in the platform's frame
  Six compliance{};                             // m/N
  double clearance = 0;                         // m
  Vec cable{0, 0, 0};                           // N
  double cable_stiffness = 0;                   // N/m
  double inertia = 0;                           // kg
  // the second shelf
  Vec counterbalance{0, 0, 0};                                                                                  // N
  Six lead_error{};                                                                                             // m/m
  double ring_rise = 0;                                                                                         // K
  std::array<Vec, 6> base_moved{Vec::Zero(), Vec::Zero(), Vec::Zero(), Vec::Zero(), Vec::Zero(), Vec::Zero()};  // m
  std::array<Vec, 6> platform_moved{Vec::Zero(), Vec::Zero(), Vec::Zero(), Vec::Zero(), Vec::Zero(), Vec::Zero()};  // m
  Six gimbal{};            // m, between the axes of a base joint
  double roll_share = 0;   // of the screws' roll that the control leaves
  double growth = 0;       // m, of the spindle
  double growth_rate = 0;  // m/s
  double frame_shift = 0;  // m/N
  double frame_tilt = 0;   // rad/(N m)
  // outside of every catalogue
  double hertz = 0;          // m at 1 kN: a contact gives way as the tension to the power of 2/3
  double gear_beat = 0;      // m: a gear's error of another pitch than the screw's
  double cogging = 0;        // N m: ripple of the motors, twelve to a turn
  double preload_slope = 0;  // N per metre that a strut is longer than in the middle: friction that grows outward
  double hardening = 0;      // m at (1 kN)^2: a spring that bends
  double hose = 0;           // N per square metre from the middle: a hose that pulls ever harder
  double table_sag = 0;      // m at 0.1 m x 0.1 m off the middle: a table that is warped
  double side_friction = 0;  // N of a strut that leans, none of one that stands upright
  double softening = 0;      // m at 1 kN in the middle: a strut that gives way as the square of its length
  double magnet = 0;         // N at 0.3 m: a magnet under the table
  Six two_gears{};           // m: two gears of nearly the same pitch
};

}  // namespace truth

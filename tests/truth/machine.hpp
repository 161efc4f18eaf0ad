// What a model file states, what its owner does not know, and machines drawn from both. Shares no code with plumbline.
#pragma once

#include <random>
#include <string>

#include "truth/flaws.hpp"

namespace truth {

using Random = std::mt19937_64;

/// SI. Rotations are Rz(C) Ry(B) Rx(A).
struct Machine {
  std::string name;
  std::array<Vec, 6> base, platform;                    // joints, m
  std::array<Vec, 6> believed_base, believed_platform;  // where the control takes them to be
  Vec tip, centre_of_mass, gravity;                     // m, m/s^2
  double mass = 0;                                      // of the platform, kg
  Six screw_mass{}, joint_mass{}, motor_mass{};         // kg
  Six motor_arm{}, joint_length{}, screw_length{};      // m
  Six per_length{}, constant{};                         // compliance, 1/N and m/N
  Six friction{}, lead{};                               // N, m
  Six length_offset{}, middle_length{};                 // m
  double joint_damping = 0, joint_moment = 0;           // N m s/rad, N m
};

/// 1 sigma of what a real machine has and its model has not; zero: known.
struct Spread {
  double joint = 0;           // m, on each coordinate
  double offset = 0;          // m
  double compliance = 0;      // of K1 and of K2
  double friction = 0;        // N
  double centre_of_mass = 0;  // m, on each axis
  double level = 0;           // rad about X and about Y
  double platform_mass = 0;   // kg
  double strut_mass = 0;      // kg, the same for all screws
  double motor_mass = 0;      // kg, the same for all motors
};

struct Model {
  Machine machine;
  Spread spread;
  std::string text;  // of the file
};

/// Throws std::runtime_error if the file does not state what is needed.
Model read_model(const std::string& path);

/// The machine with all that the spread leaves open drawn from it.
Machine drawn(const Model& model, Random& random);

/// Gravity turned by small angles about X and Y.
Vec tilted(const Vec& gravity, double about_x, double about_y);

}  // namespace truth

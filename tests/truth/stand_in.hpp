// A hexapod that stands in for a real one: it shares no code with plumbline, and solves its statics in another way.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace truth {

using Vec = Eigen::Vector3d;
using Six = std::array<double, 6>;

/// What a model file states, SI. Rotations are Rz(C) Ry(B) Rx(A).
struct Machine {
  std::array<Vec, 6> base, platform;                    // joints, m
  std::array<Vec, 6> believed_base, believed_platform;  // where the control takes them to be
  Vec tip, centre_of_mass, gravity;                     // m, m/s^2
  double mass = 0;                                      // of the platform, kg
  Six screw_mass{}, joint_mass{}, motor_mass{};         // kg
  Six motor_arm{}, joint_length{}, screw_length{};      // m
  Six per_length{}, constant{};                         // compliance, 1/N and m/N
  Six friction{}, lead{};                               // N, m
  Six length_offset{};                                  // m
};

/// 1 sigma of what a real machine has and its model has not.
struct Spread {
  double joint = 0;   // m, on each coordinate
  double offset = 0;  // m
  double compliance = 0;
  double friction = 0;        // N
  double centre_of_mass = 0;  // m
};

struct Circle {
  Vec centre;
  double radius = 0;
  double bar = 0;
  Vec abc;  // rad
  int turn = 1;
  double feed = 0;  // m/s
  double payload = 0;
};

struct Reading {
  double radial = 0;  // m
  Six torque{};       // N m
};

enum class FrictionLaw { tanh, root };  // s = tanh(v / v0) or v / sqrt(v^2 + v0^2)

struct Model {
  Machine machine;
  Spread spread;
};
/// Throws std::runtime_error if the file does not state what is needed.
Model read_model(const std::string& path);

/// The machine with joints, offsets, compliance, friction and centre of mass drawn from the spread.
Machine drawn(const Model& model, std::mt19937_64& random);

/// One reading at `angle` (rad) of the circle; the ball stands off its ideal place by `ball_off` (m).
Reading measure(const Machine& machine, const Circle& circle, double angle, const Vec& ball_off, FrictionLaw law);

/// Coloured noise: sigma, and the part of it that the next sample keeps.
std::vector<double> noise(std::size_t count, double sigma, double memory, std::mt19937_64& random);

}  // namespace truth

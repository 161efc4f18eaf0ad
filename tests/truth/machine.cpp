#include "truth/machine.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include <toml++/toml.h>

namespace truth {
namespace {

using Node = toml::node_view<const toml::node>;

double number(const Node& node) {
  const auto value = node.value<double>();
  if (!value) throw std::runtime_error("the model lacks a number");
  return *value;
}

Vec vector(const Node& node) { return {number(node[0]), number(node[1]), number(node[2])}; }

Six six(const Node& node, double unit) {
  Six values{};
  for (std::size_t j = 0; j < 6; ++j) values[j] = unit * (node.is_array() ? number(node[j]) : number(node));
  return values;
}

Spread spread_of(const Node& table) {
  const auto sigma = [&](const char* key, double unit) { return table[key].value_or(0.0) * unit; };
  return {sigma("joint_position_um", 1e-6), sigma("strut_offset_um", 1e-6),   sigma("compliance_relative", 1),
          sigma("coulomb_friction_N", 1),   sigma("centre_of_mass_mm", 1e-3), sigma("level_mrad", 1e-3),
          sigma("platform_mass_kg", 1),     sigma("strut_mass_kg", 1),        sigma("motor_mass_kg", 1)};
}

}  // namespace

Model read_model(const std::string& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error("cannot read " + path);
  const toml::table file = toml::parse(text.str(), path);
  const Node root(static_cast<const toml::node&>(file));
  Model model;
  model.text = text.str();
  Machine& m = model.machine;
  m.name = root["name"].value_or(std::string());
  for (std::size_t j = 0; j < 6; ++j) {
    m.believed_base[j] = m.base[j] = 1e-3 * vector(root["base"]["joints_mm"][j]);
    m.believed_platform[j] = m.platform[j] = 1e-3 * vector(root["platform"]["joints_mm"][j]);
  }
  m.tip = 1e-3 * vector(root["platform"]["tool_tip_mm"]);
  m.centre_of_mass = 1e-3 * vector(root["platform"]["centre_of_mass_mm"]);
  m.gravity = vector(root["gravity_m_s2"]);
  m.mass = number(root["platform"]["mass_kg"]);
  const auto strut = root["strut"];
  m.screw_mass = six(strut["screw_mass_kg"], 1);
  m.joint_mass = six(strut["joint_mass_kg"], 1);
  m.motor_mass = six(strut["motor_mass_kg"], 1);
  m.motor_arm = six(strut["motor_arm_mm"], 1e-3);
  m.joint_length = six(strut["joint_length_mm"], 1e-3);
  m.screw_length = six(strut["screw_length_mm"], 1e-3);
  m.per_length = six(strut["compliance_per_length_um_N_m"], 1e-6);
  m.constant = six(strut["compliance_um_N"], 1e-6);
  m.friction = six(strut["coulomb_friction_N"], 1);
  m.lead = six(strut["lead_mm"], 1e-3);
  const Six shortest = six(strut["length_min_mm"], 1e-3);
  const Six longest = six(strut["length_max_mm"], 1e-3);
  for (std::size_t j = 0; j < 6; ++j) m.middle_length[j] = (shortest[j] + longest[j]) / 2;
  m.joint_damping = root["joint"]["viscous_friction_Nms_rad"].value_or(0.0);
  m.joint_moment = root["joint"]["coulomb_friction_Nm"].value_or(0.0);
  model.spread = spread_of(root["uncertainty"]);
  return model;
}

Vec tilted(const Vec& gravity, double about_x, double about_y) {
  return gravity + gravity.norm() * Vec(-about_y, about_x, 0);
}

Machine drawn(const Model& model, Random& random) {
  std::normal_distribution<double> normal;
  const Spread& spread = model.spread;
  const auto some = [&](double sigma) { return sigma * normal(random); };
  const auto somewhere = [&](double sigma) { return Vec(some(sigma), some(sigma), some(sigma)); };
  Machine m = model.machine;
  const double k1 = 1 + some(spread.compliance);
  const double k2 = 1 + some(spread.compliance);
  const double screw = some(spread.strut_mass);
  const double motor = some(spread.motor_mass);
  for (std::size_t j = 0; j < 6; ++j) {
    m.base[j] += somewhere(spread.joint);
    m.platform[j] += somewhere(spread.joint);
    m.length_offset[j] += some(spread.offset);
    m.friction[j] += some(spread.friction);
    m.per_length[j] *= k1;
    m.constant[j] *= k2;
    m.screw_mass[j] += screw;
    m.motor_mass[j] += motor;
  }
  m.centre_of_mass += somewhere(spread.centre_of_mass);
  m.mass += some(spread.platform_mass);
  const double about_x = some(spread.level);
  m.gravity = tilted(m.gravity, about_x, some(spread.level));
  return m;
}

}  // namespace truth

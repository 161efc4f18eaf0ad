#include "truth/stand_in.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/QR>
#include <toml++/toml.h>

namespace truth {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

constexpr double kSignSpeed = 2e-5;  // m/s

// --- the model file ---

double number(const toml::node_view<const toml::node>& node) {
  const auto value = node.value<double>();
  if (!value) throw std::runtime_error("the model lacks a number");
  return *value;
}

Vec vector(const toml::node_view<const toml::node>& node) {
  return {number(node[0]), number(node[1]), number(node[2])};
}

Six six(const toml::node_view<const toml::node>& node, double unit) {
  Six values{};
  for (std::size_t j = 0; j < 6; ++j) values[j] = unit * (node.is_array() ? number(node[j]) : number(node));
  return values;
}

// --- kinematics ---

Eigen::Matrix3d turned(const Vec& abc) {
  return (Eigen::AngleAxisd(abc.z(), Vec::UnitZ()) * Eigen::AngleAxisd(abc.y(), Vec::UnitY()) *
          Eigen::AngleAxisd(abc.x(), Vec::UnitX()))
      .toRotationMatrix();
}

struct Stand {
  Vec x;              // tool tip
  Eigen::Matrix3d R;  // platform in the base frame
};

Vec6 lengths(const std::array<Vec, 6>& base, const std::array<Vec, 6>& platform, const Vec& tip, const Stand& at) {
  Vec6 lengths;
  for (std::size_t j = 0; j < 6; ++j) {
    lengths[static_cast<int>(j)] = (at.x + at.R * (platform[j] - tip) - base[j]).norm();
  }
  return lengths;
}

Stand moved(const Stand& from, const Vec6& by) {
  const Vec turn = by.tail<3>();
  const double angle = turn.norm();
  const Eigen::AngleAxisd rotation(angle, angle > 0 ? Vec(turn / angle) : Vec(Vec::UnitX()));
  return {from.x + by.head<3>(), rotation.toRotationMatrix() * from.R};
}

Stand commanded(const Circle& circle, double angle) {
  return {circle.centre + circle.radius * Vec(std::cos(angle), std::sin(angle), 0), turned(circle.abc)};
}

// --- statics: free bodies, moments about the origin of the base frame ---

struct Loads {
  Vec6 drive;   // tension at the screw's drive, N
  Vec6 longer;  // than commanded, m
};

Loads loads(const Machine& m, const Stand& at, double payload, const Vec6& signs) {
  Mat6 unknown;  // forces of the struts on the platform and their moments, for a tension of one
  Vec6 known = Vec6::Zero();
  const auto act = [&](const Vec& force, const Vec& where) {
    known.head<3>() += force;
    known.tail<3>() += where.cross(force);
  };
  act(m.mass * m.gravity, at.x + at.R * (m.centre_of_mass - m.tip));
  act(payload * m.gravity, at.x);
  Vec6 along_weight;
  Vec6 length;
  for (std::size_t j = 0; j < 6; ++j) {
    const int i = static_cast<int>(j);
    const Vec joint = at.x + at.R * (m.platform[j] - m.tip);
    const Vec strut = joint - m.base[j];
    length[i] = strut.norm();
    const Vec u = strut / length[i];
    unknown.col(i) << -u, joint.cross(-u);
    // the strut turns about its base joint: what it weighs across, the platform carries by the lever rule
    const double lever = m.screw_mass[j] * (length[i] - m.joint_length[j] - m.screw_length[j] / 2) +
                         m.joint_mass[j] * length[i] - m.motor_mass[j] * m.motor_arm[j];
    const Vec across = m.gravity - u * u.dot(m.gravity);
    act(lever / length[i] * across, joint);
    along_weight[i] = (m.screw_mass[j] + m.joint_mass[j]) * u.dot(m.gravity);
  }
  Loads result;
  result.drive = unknown.fullPivHouseholderQr().solve(-known) + along_weight;
  for (std::size_t j = 0; j < 6; ++j) {
    const int i = static_cast<int>(j);
    result.drive[i] -= m.friction[j] * signs[i];
    result.longer[i] = (m.per_length[j] * length[i] + m.constant[j]) * result.drive[i] + m.length_offset[j];
  }
  return result;
}

// Where the true machine stands: true lengths at the place equal the commanded ones plus what the loads there add.
Stand settled(const Machine& m, const Vec6& told, const Stand& start, double payload, const Vec6& signs) {
  const auto misfit = [&](const Stand& at) -> Vec6 {
    return lengths(m.base, m.platform, m.tip, at) - told - loads(m, at, payload, signs).longer;
  };
  Stand at = start;
  for (int step = 0; step < 50; ++step) {
    const Vec6 off = misfit(at);
    Mat6 slopes;
    for (int k = 0; k < 6; ++k) {
      const double h = 1e-6;
      slopes.col(k) = (misfit(moved(at, h * Vec6::Unit(k))) - misfit(moved(at, -h * Vec6::Unit(k)))) / (2 * h);
    }
    const Vec6 by = slopes.fullPivHouseholderQr().solve(-off);
    at = moved(at, by);
    if (by.norm() < 1e-12) return at;
  }
  throw std::runtime_error("the stand-in finds no place to stand");
}

}  // namespace

Model read_model(const std::string& path) {
  const toml::table file = toml::parse_file(path);
  const toml::node_view<const toml::node> root(static_cast<const toml::node&>(file));
  Model model;
  Machine& m = model.machine;
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
  const auto sigma = [&](const char* key, double unit) { return root["uncertainty"][key].value_or(0.0) * unit; };
  model.spread = {sigma("joint_position_um", 1e-6), sigma("strut_offset_um", 1e-6), sigma("compliance_relative", 1),
                  sigma("coulomb_friction_N", 1), sigma("centre_of_mass_mm", 1e-3)};
  return model;
}

Machine drawn(const Model& model, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const auto some = [&](double sigma) { return sigma * normal(random); };
  const auto somewhere = [&](double sigma) { return Vec(some(sigma), some(sigma), some(sigma)); };
  Machine m = model.machine;
  const double k1 = 1 + some(model.spread.compliance);
  const double k2 = 1 + some(model.spread.compliance);
  for (std::size_t j = 0; j < 6; ++j) {
    m.base[j] += somewhere(model.spread.joint);
    m.platform[j] += somewhere(model.spread.joint);
    m.length_offset[j] += some(model.spread.offset);
    m.friction[j] += some(model.spread.friction);
    m.per_length[j] *= k1;
    m.constant[j] *= k2;
  }
  m.centre_of_mass += somewhere(model.spread.centre_of_mass);
  return m;
}

Reading measure(const Machine& m, const Circle& circle, double angle, const Vec& ball_off, FrictionLaw law) {
  const auto told_at = [&](double where) {
    return lengths(m.believed_base, m.believed_platform, m.tip, commanded(circle, where));
  };
  // speeds of the struts on the commanded path, from a short piece of it
  const double piece = 1e-5;
  const Vec6 speeds =
      (told_at(angle + piece) - told_at(angle - piece)) / (2 * piece) * circle.turn * circle.feed / circle.radius;
  const Vec6 signs = law == FrictionLaw::tanh
                         ? Vec6((speeds.array() / kSignSpeed).tanh())
                         : Vec6(speeds.array() / (speeds.array().square() + kSignSpeed * kSignSpeed).sqrt());
  const Stand at = settled(m, told_at(angle), commanded(circle, angle), circle.payload, signs);
  const Vec ball =
      circle.centre + ball_off - Vec(0, 0, std::sqrt(circle.bar * circle.bar - circle.radius * circle.radius));
  Reading reading;
  reading.radial = (at.x - ball).norm() - circle.bar;
  const Loads there = loads(m, at, circle.payload, signs);
  for (std::size_t j = 0; j < 6; ++j) {
    reading.torque[j] = m.lead[j] / (2 * M_PI) * there.drive[static_cast<int>(j)];
  }
  return reading;
}

std::vector<double> noise(std::size_t count, double sigma, double memory, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> values(count);
  double now = sigma * normal(random);
  for (double& value : values) {
    value = now;
    now = memory * now + std::sqrt(1 - memory * memory) * sigma * normal(random);
  }
  return values;
}

}  // namespace truth

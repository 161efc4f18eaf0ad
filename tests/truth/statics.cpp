#include "truth/statics.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/LU>

namespace truth {
namespace {

constexpr double kSteel = 11.5e-6;   // 1/K
constexpr double kRestSpeed = 1e-5;  // m/s, at which a joint's dry friction fades
constexpr double kTurnTension = 20;  // N, at which a joint's play is passed through
const Vec kMiddle(0, 0, -1);         // of the room, m
constexpr double kBeatPitch = 0.37;  // of the screw's lead
constexpr std::array kGears{0.31, 0.345};
const Vec kMagnet(0.18, 0.1, -1.3);  // in W, m
constexpr double kMagnetFrom = 0.3;  // m
constexpr double kKilo = 1000;       // N

struct Strut {
  Vec foot, joint, u;
  double length;
};

std::array<Strut, 6> struts_at(const Truth& truth, const Stand& at) {
  std::array<Strut, 6> struts;
  const Machine& m = truth.machine;
  for (std::size_t j = 0; j < 6; ++j) {
    Strut& s = struts[j];
    s.foot = m.base[j] + truth.flaws.base_moved[j];
    s.joint = at.x + at.R * (m.platform[j] + truth.flaws.platform_moved[j] - m.tip);
    const Vec along = s.joint - s.foot;
    s.length = along.norm();
    s.u = along / s.length;
  }
  return struts;
}

// Outer axis of a universal joint: along the ring on which the joint sits.
Vec along_ring(const Vec& joint) { return Vec::UnitZ().cross(Vec(joint.x(), joint.y(), 0).normalized()); }

// How far each screw has turned in its nut because universal joints hold both ends: the angle about the strut from the
// inner axis of the one to that of the other.
Six roll(const Machine& m, const Stand& at) {
  Six angles{};
  for (std::size_t j = 0; j < 6; ++j) {
    const Vec u = (at.x + at.R * (m.platform[j] - m.tip) - m.base[j]).normalized();
    const Vec below = along_ring(m.base[j]).cross(u);
    const Vec above = (at.R * along_ring(m.platform[j])).cross(u);
    angles[j] = std::atan2(u.dot(below.cross(above)), below.dot(above));
  }
  return angles;
}

// Everything that pushes at the platform, besides the struts' drives.
void add_platform_forces(const Truth& truth, const Stand& at, const Moment& moment, const Vec& gravity, Vec6& known) {
  const Machine& m = truth.machine;
  const Flaws& f = truth.flaws;
  const auto act = [&](const Vec& force, const Vec& where) {
    known.head<3>() += force;
    known.tail<3>() += where.cross(force);
  };
  const Vec centre = at.x + at.R * (m.centre_of_mass + f.centre_of_mass - m.tip);
  const Vec off = at.x - kMiddle;
  act((m.mass + f.platform_mass) * gravity, centre);
  act((moment.payload + f.payload) * gravity, at.x);
  act(f.cable - f.cable_stiffness * off, centre);
  act(-f.inertia * moment.tip_acceleration + f.counterbalance, centre);
  act(-f.hose * off.norm() * off, centre);
  const Vec to_magnet = kMagnet - at.x;
  act(f.magnet * kMagnetFrom * kMagnetFrom / to_magnet.squaredNorm() * to_magnet.normalized(), at.x);
}

// What a strut gets longer by at its tension, in a machine that stands there.
double longer(const Truth& truth, const Stand& at, const Moment& moment, const Strut& s, std::size_t j, double tension,
              double drive) {
  const Machine& m = truth.machine;
  const Flaws& f = truth.flaws;
  const int i = static_cast<int>(j);
  const Vec in_platform = at.R.transpose() * s.u;
  const auto leaning = [](const std::array<double, 2>& c, const Vec& u) {
    return c[0] * (u.x() * u.x() + u.y() * u.y()) + c[1] * u.z() * u.z();
  };
  const double turns = s.length / m.lead[j];
  double more = (m.per_length[j] * s.length + m.constant[j]) * drive + m.length_offset[j];
  more += f.compliance[j] * drive;
  more += tension * (leaning(f.base_compliance, s.u) + leaning(f.platform_compliance, in_platform));
  more += f.clearance / 2 * std::tanh(tension / kTurnTension);
  more += f.offset[j] - f.backlash[j] / 2 * moment.sign[i];
  more += kSteel * s.length * f.drift[j] * moment.time;
  more += f.cyclic[j] * std::sin(2 * M_PI * turns + f.cyclic_phase[j]);
  more += f.lag * (f.lag * moment.acceleration[i] - moment.speed[i]) - f.lags[j] * moment.speed[i];
  more += f.lead_error[j] * (s.length - m.middle_length[j]);
  more += kSteel * f.ring_rise * (s.u.x() * m.believed_base[j].x() + s.u.y() * m.believed_base[j].y());
  const double along_axis = s.u.dot(along_ring(m.base[j]));
  more += f.gimbal[j] * std::sqrt(1 - along_axis * along_axis);
  more += f.hertz * std::copysign(std::pow(std::abs(tension) / kKilo, 2.0 / 3), tension);
  more += f.gear_beat * std::sin(2 * M_PI * turns / kBeatPitch + static_cast<double>(j));
  for (const double pitch : kGears) {
    more += f.two_gears[j] / 2 * std::sin(2 * M_PI * turns / pitch + static_cast<double>(j));
  }
  more += f.softening * tension / kKilo * std::pow(s.length / m.middle_length[j], 2);
  more += f.hardening * tension * std::abs(tension) / (kKilo * kKilo);
  return more;
}

double friction(const Truth& truth, const Moment& moment, const Strut& s, std::size_t j, double tension) {
  const Flaws& f = truth.flaws;
  const int i = static_cast<int>(j);
  const double ratio = moment.speed[i] / f.stribeck_speed;
  const double dry = truth.machine.friction[j] + f.coulomb[j] + f.stribeck_force * std::exp(-ratio * ratio) +
                     f.load_friction * std::abs(tension) +
                     f.preload_slope * (s.length - truth.machine.middle_length[j]) +
                     f.side_friction * (s.u.x() * s.u.x() + s.u.y() * s.u.y());
  return -dry * moment.sign[i] - f.viscous[j] * moment.speed[i];
}

}  // namespace

Vec6 true_lengths(const Truth& truth, const Stand& at) {
  Vec6 lengths;
  const auto struts = struts_at(truth, at);
  for (std::size_t j = 0; j < 6; ++j) lengths[static_cast<int>(j)] = struts[j].length;
  return lengths;
}

Vec6 believed_lengths(const Machine& m, const Stand& at) {
  Vec6 lengths;
  for (std::size_t j = 0; j < 6; ++j) {
    lengths[static_cast<int>(j)] = (at.x + at.R * (m.believed_platform[j] - m.tip) - m.believed_base[j]).norm();
  }
  return lengths;
}

Loads loads(const Truth& truth, const Stand& at, const Moment& moment) {
  const Machine& m = truth.machine;
  const Flaws& f = truth.flaws;
  const Vec gravity = tilted(m.gravity, f.level[0], f.level[1]);
  const auto struts = struts_at(truth, at);
  Mat6 unknown;  // forces of the struts on the platform and their moments, for a tension of one
  Vec6 known = Vec6::Zero();
  add_platform_forces(truth, at, moment, gravity, known);
  Vec6 along_weight;
  for (std::size_t j = 0; j < 6; ++j) {
    const Strut& s = struts[j];
    const int i = static_cast<int>(j);
    unknown.col(i) << -s.u, s.joint.cross(-s.u);
    // the strut turns about its base joint: what it weighs across, the platform carries by the lever rule
    const double screw = m.screw_mass[j] + f.screw_mass;
    const double lever = screw * (s.length - m.joint_length[j] - m.screw_length[j] / 2) + m.joint_mass[j] * s.length -
                         m.motor_mass[j] * m.motor_arm[j];
    Vec across = lever / s.length * (gravity - s.u * s.u.dot(gravity));
    // a moment about the base joint against the strut's turning, held by the platform joint at the end of the strut
    const Vec turning = s.u.cross(moment.across.col(i)) / s.length;
    const double fading = std::hypot(turning.norm() * s.length, kRestSpeed) / s.length;
    const Vec moment_on_strut =
        -(m.joint_damping + f.joint_damping + (m.joint_moment + f.joint_moment) / fading) * turning;
    across += moment_on_strut.cross(s.u) / s.length;
    known.head<3>() += across;
    known.tail<3>() += s.joint.cross(across);
    along_weight[i] = (screw + m.joint_mass[j]) * s.u.dot(gravity);
  }
  Loads result;
  result.tension = unknown.partialPivLu().solve(-known) + along_weight;
  const Six rolled = f.roll_share != 0 ? roll(m, at) : Six{};
  const Six at_home = f.roll_share != 0 ? roll(m, {kMiddle, Rotation::Identity()}) : Six{};
  for (std::size_t j = 0; j < 6; ++j) {
    const int i = static_cast<int>(j);
    const double tension = result.tension[i];
    result.drive[i] = tension + friction(truth, moment, struts[j], j, tension);
    result.longer[i] = longer(truth, at, moment, struts[j], j, tension, result.drive[i]) +
                       f.roll_share * m.lead[j] / (2 * M_PI) * (rolled[j] - at_home[j]);
    result.torque[i] = m.lead[j] / (2 * M_PI) * result.drive[i] * (1 + f.torque_scale[j]) +
                       f.cogging * std::sin(12 * 2 * M_PI * struts[j].length / m.lead[j]);
  }
  return result;
}

Stand moved(const Stand& from, const Vec6& by) {
  const Vec turn = by.tail<3>();
  const double angle = turn.norm();
  const Eigen::AngleAxisd rotation(angle, angle > 0 ? Vec(turn / angle) : Vec(Vec::UnitX()));
  return {from.x + by.head<3>(), rotation.toRotationMatrix() * from.R};
}

Vec6 misfit(const Truth& truth, const Stand& at, const Moment& moment) {
  return true_lengths(truth, at) - moment.told - loads(truth, at, moment).longer;
}

Standing settled(const Truth& truth, const Moment& moment) {
  Standing standing{moment.commanded, Mat6::Zero()};
  const auto differences = [&](const Stand& at) {
    const double h = 1e-6;
    for (int k = 0; k < 6; ++k) {
      const Vec6 way = h * Vec6::Unit(k);
      standing.slopes.col(k) =
          (misfit(truth, moved(at, way), moment) - misfit(truth, moved(at, -way), moment)) / (2 * h);
    }
  };
  double last = INFINITY;
  for (int step = 0; step < 100; ++step) {
    if (step == 0 || step % 10 == 0) differences(standing.at);
    const Vec6 by = standing.slopes.partialPivLu().solve(-misfit(truth, standing.at, moment));
    standing.at = moved(standing.at, by);
    const double size = by.norm();
    if (size < 1e-12 || (size < 1e-11 && size >= last)) return standing;
    last = size;
  }
  throw std::runtime_error("the stand-in finds no place to stand");
}

Vec tip_ball(const Truth& truth, const Stand& at, const Moment& moment) {
  const Flaws& f = truth.flaws;
  Vec tip = at.x - at.R.col(2) * (f.growth + f.growth_rate * moment.time);
  const Vec off = at.x - kMiddle;
  tip +=
      f.table_sag * (off.x() * off.y() / 0.01) * Vec::UnitZ() + f.table_sag * (off.x() * off.x() / 0.01) * Vec::UnitY();
  if (f.frame_shift == 0 && f.frame_tilt == 0) return tip;
  // the frame under the base joints gives way to the sum and the moment of what the struts pull at it
  const Loads there = loads(truth, at, moment);
  const auto struts = struts_at(truth, at);
  Vec middle = Vec::Zero();
  for (const Vec& joint : truth.machine.believed_base) middle += joint / 6;
  Vec pull = Vec::Zero();
  Vec twist = Vec::Zero();
  for (std::size_t j = 0; j < 6; ++j) {
    const Vec force = there.tension[static_cast<int>(j)] * struts[j].u;
    pull += force;
    twist += (struts[j].foot - middle).cross(force);
  }
  return tip + f.frame_shift * pull + (f.frame_tilt * twist).cross(at.x - middle);
}

}  // namespace truth

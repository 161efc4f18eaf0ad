// The equation of each effect of the catalogue, written out once more from docs/effects.md and compared with what the
// effect does to the whole calculation.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "physics/effect_info.hpp"
#include "physics/moments.hpp"
#include "physics/strut_stretch.hpp"

using namespace plumbline;
using namespace plumbline::physics;
using namespace plumbline::testing;

namespace {

using Six = machine::PerStrut<double>;
using Struts = machine::StrutVectors<double>;

// The machine at a moment, without and with one effect.
struct Trial {
  ForceModel bare{pm600_like()};
  ForceModel with{bare};
  std::vector<double> p;  // SI
  Motion<double> motion;
  Environment environment = bare.environment();
  StrutRates<double> rates;
  StrutStretch<double> before = strut_stretch(bare, environment, motion);  // until the moment is drawn
  StrutStretch<double> after = before;

  Trial(std::string_view effect, Random& random) {
    const int first = with.add(effect);
    const EffectInfo& info = effect_infos()[effect_index(effect)];
    for (const ParameterSpec& spec : info.parameters) {
      for (int i = 0; i < spec.size(); ++i) {
        p.push_back(uniform(random, 0.3 * spec.lower + 0.05 * spec.upper, 0.3 * spec.upper) * spec.unit.si);
      }
    }
    std::copy(p.begin(), p.end(), with.parameters.begin() + first);
    motion = moment_within(pm600_like().limits, random);
    motion.twist.v_WT *= 0.2;  // slow enough for what fades with speed
    motion.twist.w_WP *= 0.05;
    environment.sign_speed = 2 * kMm;
    before = strut_stretch(bare, environment, motion);
    after = strut_stretch(with, environment, motion);
    rates = strut_rates(before.struts, motion, environment);
  }

  double at(int i) const { return p[static_cast<std::size_t>(i)]; }
  double length(int j) const { return before.struts.length[j]; }
  Vector3<double> u(int j) const { return before.struts.direction.col(j); }
  Vector3<double> centre_of_mass() const {
    const auto first = static_cast<std::size_t>(bare.find("platform-gravity", "centre_of_mass_mm"));
    const Vector3<double> centre(bare.parameters[first], bare.parameters[first + 1], bare.parameters[first + 2]);
    return motion.pose.R_WP * (centre - bare.machine.geometry.tool_tip_P);
  }
  // What the platform's balance says that the effect added: J^T dt = dw, N and M about the tip.
  machine::Vector6<double> wrench() const {
    const machine::Matrix6<double> J = machine::jacobian(before.struts);
    return J.transpose() * (after.tension - before.tension);
  }
};

void check_equal(const Six& found, const Six& expected) {
  CHECK((found - expected).norm() <= 1e-9 * expected.norm() + 1e-15);
  CHECK(expected.norm() > 0);
}

using LengthOf = std::function<double(const Trial&, int)>;
struct PerStrutCase {
  std::string_view effect;
  LengthOf formula;
};

machine::Vector6<double> at_point(const Vector3<double>& force, const Vector3<double>& arm) {
  machine::Vector6<double> w;
  w << force, arm.cross(force);
  return w;
}

}  // namespace

TEST_CASE("effects on the length of a strut add what their equation says") {
  constexpr double kSteel = 11.5e-6;
  const std::vector<PerStrutCase> cases{
      {"backlash", [](const Trial& t, int j) { return -t.at(j) / 2 * t.rates.sign[j]; }},
      {"strut-offset", [](const Trial& t, int j) { return t.at(j); }},
      {"thermal-drift", [](const Trial& t, int j) { return kSteel * t.length(j) * t.at(j) * t.motion.time; }},
      {"cyclic",
       [](const Trial& t, int j) {
         return t.at(j) * std::sin(2 * std::numbers::pi * t.length(j) / (20 * kMm) + t.at(6 + j));
       }},
      {"servo-lag",
       [](const Trial& t, int j) { return -t.p[0] * t.rates.speed[j] + t.p[0] * t.p[0] * t.rates.acceleration[j]; }},
      {"servo-mismatch", [](const Trial& t, int j) { return -t.at(j) * t.rates.speed[j]; }},
      {"base-joint-compliance",
       [](const Trial& t, int j) {
         const Vector3<double> u = t.u(j);
         return t.before.nut_tension[j] * (t.p[0] * u.head<2>().squaredNorm() + t.p[1] * u.z() * u.z());
       }},
      {"platform-joint-compliance",
       [](const Trial& t, int j) {
         const Vector3<double> u = t.motion.pose.R_WP.transpose() * t.u(j);
         return t.before.nut_tension[j] * (t.p[0] * u.head<2>().squaredNorm() + t.p[1] * u.z() * u.z());
       }},
      {"strut-compliance", [](const Trial& t, int j) { return t.at(j) * t.before.drive_tension[j]; }},
      {"joint-clearance", [](const Trial& t, int j) { return t.p[0] / 2 * std::tanh(t.before.nut_tension[j] / 20); }},
      {"contact-compliance",
       [](const Trial& t, int j) {
         const double load = t.before.nut_tension[j] / 1000;
         return t.p[0] * load / std::cbrt(std::hypot(load, 1e-4));
       }},
      {"lead-error", [](const Trial& t, int j) { return t.at(j) * (t.length(j) - t.bare.machine.middle_length[j]); }},
      {"ring-thermal",
       [](const Trial& t, int j) {
         const Vector3<double> q = t.bare.machine.geometry.base_joints_W.col(j);
         return t.u(j).dot(kSteel * t.p[0] * Vector3<double>(q.x(), q.y(), 0));
       }},
      {"gimbal-offset",
       [](const Trial& t, int j) {
         const Vector3<double> q = t.bare.machine.geometry.base_joints_W.col(j);
         const Vector3<double> outer = Vector3<double>(-q.y(), q.x(), 0) / std::hypot(q.x(), q.y());
         // the strut begins off the joint, towards where it leans to across the outer axis
         const Vector3<double> way = outer.cross(t.u(j)).normalized().cross(outer);
         return t.at(j) * way.dot(t.u(j));
       }},
  };
  Random random(51);
  for (const PerStrutCase& test : cases) {
    INFO(test.effect);
    const Trial t(test.effect, random);
    check_equal(t.after.stretch - t.before.stretch,
                Six::NullaryExpr([&](Eigen::Index j) { return test.formula(t, static_cast<int>(j)); }));
    CHECK(t.after.torque == t.before.torque);
  }
}

TEST_CASE("effects on the drive add what their equation says, and stretch the strut") {
  const std::vector<PerStrutCase> cases{
      {"screw-coulomb", [](const Trial& t, int j) { return -t.at(j) * t.rates.sign[j]; }},
      {"screw-viscous", [](const Trial& t, int j) { return -t.at(j) * t.rates.speed[j]; }},
      {"screw-stribeck",
       [](const Trial& t, int j) {
         return -t.p[0] * t.rates.sign[j] * std::exp(-std::pow(t.rates.speed[j] / t.p[1], 2));
       }},
      {"load-friction",
       [](const Trial& t, int j) { return -t.p[0] * std::abs(t.before.nut_tension[j]) * t.rates.sign[j]; }},
  };
  Random random(52);
  for (const PerStrutCase& test : cases) {
    INFO(test.effect);
    const Trial t(test.effect, random);
    const Six added = t.after.drive_tension - t.before.drive_tension;
    check_equal(added, Six::NullaryExpr([&](Eigen::Index j) { return test.formula(t, static_cast<int>(j)); }));
    check_equal(t.after.torque - t.before.torque, added * (0.02 / (2 * std::numbers::pi)));
    CHECK((t.after.stretch - t.before.stretch).norm() > 0);
    CHECK(t.after.tension == t.before.tension);
  }
}

TEST_CASE("effects on the platform add their force where it acts") {
  const auto weight = [](const Trial& t, double mass) -> Vector3<double> { return mass * t.bare.machine.gravity; };
  using WrenchOf = std::function<machine::Vector6<double>(const Trial&)>;
  const std::vector<std::pair<std::string_view, WrenchOf>> cases{
      {"payload", [&](const Trial& t) { return at_point(weight(t, t.p[0]), Vector3<double>::Zero()); }},
      {"platform-mass", [&](const Trial& t) { return at_point(weight(t, t.p[0]), t.centre_of_mass()); }},
      {"centre-of-mass",
       [&](const Trial& t) {
         machine::Vector6<double> w = machine::Vector6<double>::Zero();
         const Vector3<double> offset(t.p[0], t.p[1], t.p[2]);
         const double mass = pm600_like().value("platform", "mass_kg").values[0];
         w.tail<3>() = (t.motion.pose.R_WP * offset).cross(weight(t, mass));
         return w;
       }},
      {"cable",
       [](const Trial& t) {
         const Vector3<double> off = t.motion.pose.p_WT - Vector3<double>(0, 0, -1);
         return at_point(Vector3<double>(t.p[0], t.p[1], t.p[2]) - t.p[3] * off, t.centre_of_mass());
       }},
      {"inertia", [](const Trial& t) { return at_point(-t.p[0] * t.motion.acceleration.v_WT, t.centre_of_mass()); }},
      {"counterbalance",
       [](const Trial& t) {
         return at_point({t.p[0], t.p[1], t.p[2]}, t.centre_of_mass());
       }},
      {"joint-viscous",
       [](const Trial& t) {
         machine::Vector6<double> w = machine::Vector6<double>::Zero();
         for (int j = 0; j < 6; ++j) {
           const double share = t.p[0] / (t.length(j) * t.length(j));
           w += at_point(-share * t.rates.transverse.col(j), t.before.struts.arm.col(j));
         }
         return w;
       }},
      {"joint-coulomb",
       [](const Trial& t) {
         machine::Vector6<double> w = machine::Vector6<double>::Zero();
         for (int j = 0; j < 6; ++j) {
           const Vector3<double> v = t.rates.transverse.col(j);
           w += at_point(-t.p[0] / t.length(j) * v / std::hypot(v.norm(), 1e-5), t.before.struts.arm.col(j));
         }
         return w;
       }},
  };
  Random random(53);
  for (const auto& [effect, formula] : cases) {
    INFO(effect);
    const Trial t(effect, random);
    const machine::Vector6<double> expected = formula(t);
    CHECK(expected.norm() > 0);
    CHECK((t.wrench() - expected).norm() <= 1e-9 * (expected.norm() + 1));
  }
}

TEST_CASE("a right-handed screw that is turned by its joints lengthens by lead over a turn") {
  Random random(57);
  const Trial t("screw-roll", random);
  // at home nothing has rolled; turned about Z by a small angle, each screw has by about that angle times u_z
  const auto stretch = [&](const ForceModel& model, double turn) -> Six {
    Motion<double> motion;
    motion.pose = {Vector3<double>(0, 0, -1), machine::axis_rotation<double>(2, turn)};
    return strut_stretch(model, model.environment(), motion).stretch;
  };
  CHECK((stretch(t.with, 0) - stretch(t.bare, 0)).norm() < 1e-15);
  const double turn = 1e-3;
  const Six rolled = (stretch(t.with, turn) - stretch(t.bare, turn)) / (t.p[0] * 0.02 / (2 * std::numbers::pi));
  Motion<double> home;
  home.pose.p_WT = Vector3<double>(0, 0, -1);
  const auto struts = strut_stretch(t.bare, t.bare.environment(), home).struts;
  for (int j = 0; j < 6; ++j) {
    CHECK(std::abs(rolled[j]) > 0.2 * turn * std::abs(struts.direction(2, j)));
    CHECK(std::abs(rolled[j]) < 5 * turn);
    CHECK(rolled[j] * struts.direction(2, j) > 0);  // upper end anticlockwise as seen against the strut
  }
}

TEST_CASE("a spindle that grows takes the tip along the tool") {
  Random random(58);
  const Trial t("spindle-growth", random);
  const Vector3<double> along = t.motion.pose.R_WP * Vector3<double>(0, 0, -1);
  CHECK(t.after.tip.head<3>().isApprox((t.p[0] + t.p[1] * t.motion.time) * along, 1e-12));
  CHECK(t.after.tip.tail<3>().isZero(0));
}

TEST_CASE("a frame gives way to what the struts pull at it, as a rigid body about its middle") {
  Random random(59);
  const Trial t("frame-compliance", random);
  const Struts base = t.bare.machine.geometry.base_joints_W;
  const Vector3<double> middle = base * Six::Constant(1 / 6.0);
  Vector3<double> force = Vector3<double>::Zero();
  Vector3<double> moment = Vector3<double>::Zero();
  for (int j = 0; j < 6; ++j) {
    force += t.before.nut_tension[j] * t.u(j);
    moment += base.col(j).cross(t.before.nut_tension[j] * t.u(j));
  }
  moment -= middle.cross(force);
  const Vector3<double> tip = t.p[0] * force + t.p[1] * moment.cross(t.motion.pose.p_WT - middle);
  CHECK(t.after.tip.head<3>().isApprox(tip, 1e-9));
  CHECK(t.after.tip.tail<3>().isApprox(t.p[1] * moment, 1e-9));
  CHECK(force.z() < 0);  // the machine hangs
}

TEST_CASE("level turns gravity by small angles about X and Y") {
  Random random(54);
  const Trial t("level", random);
  ForceModel turned(pm600_like());
  const double g = turned.machine.gravity.norm();
  turned.machine.gravity += g * Vector3<double>(-t.p[1], t.p[0], 0);
  CHECK(t.after.torque.isApprox(strut_stretch(turned, t.environment, t.motion).torque, 1e-12));
  // positive rx about +X takes -Z towards +Y
  const Vector3<double> down = machine::axis_rotation<double>(0, 1e-3) * Vector3<double>(0, 0, -1);
  CHECK(down.y() > 0);
}

TEST_CASE("heavier screws are those of a heavier model, and torque readings are off by their share") {
  Random random(55);
  const Trial mass("strut-mass", random);
  ForceModel heavier(pm600_like());
  const auto first = static_cast<std::size_t>(heavier.find("strut-gravity", "screw_mass_kg"));
  for (std::size_t j = 0; j < 6; ++j) heavier.parameters[first + j] += mass.p[0];
  CHECK(mass.after.torque.isApprox(strut_stretch(heavier, mass.environment, mass.motion).torque, 1e-12));

  const Trial scale("torque-scale", random);
  for (int j = 0; j < 6; ++j) {
    CHECK(scale.after.torque[j] == Approx(scale.before.torque[j] * (1 + scale.p[static_cast<std::size_t>(j)])));
  }
  CHECK(scale.after.stretch == scale.before.stretch);
}

TEST_CASE("inertia and the servo effects are silent where a control shapes the speed itself, and at rest") {
  Random random(56);
  const auto& infos = effect_infos();
  CHECK(std::count_if(infos.begin(), infos.end(), [](const EffectInfo& info) { return info.dynamic; }) == 3);
  for (const std::string_view effect : {"inertia", "servo-lag", "servo-mismatch"}) {
    INFO(effect);
    CHECK(infos[effect_index(effect)].dynamic);
    const Trial t(effect, random);
    for (const bool friction : {false, true}) {
      Environment silent = t.environment;
      silent.friction = friction;
      silent.dynamic = !friction;
      CHECK(strut_stretch(t.with, silent, t.motion).stretch == strut_stretch(t.bare, silent, t.motion).stretch);
    }
    CHECK(t.after.stretch != t.before.stretch);
  }
}

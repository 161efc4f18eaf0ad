#include "physics/strut_stretch.hpp"

#include <catch2/catch.hpp>

#include "physics/moments.hpp"

using namespace plumbline;
using namespace plumbline::physics;
using namespace plumbline::testing;

namespace {

const Vector3<double> kToolCentre(0.01, -0.02, -0.05);

Environment loaded(const ForceModel& model) {
  Environment environment = model.environment();
  environment.tool_mass = 4;
  environment.tool_centre_P = kToolCentre;
  environment.payload_mass = 11;
  return environment;
}

}  // namespace

TEST_CASE("the base carries the weight of everything that moves") {
  Random random(31);
  for (const machine::MachineModel& machine : three_machines()) {
    const ForceModel model(machine);
    Motion<double> motion = moment_within(machine.limits, random);
    Environment environment = loaded(model);
    environment.friction = false;
    const StrutStretch<double> s = strut_stretch(model, environment, motion);
    const auto value = [&](const char* table, const char* key) { return machine.value(table, key).values[0]; };
    const double strut =
        value("strut", "screw_mass_kg") + value("strut", "joint_mass_kg") + value("strut", "motor_mass_kg");
    const Vector3<double>& g = machine.gravity;
    Vector3<double> carried = Vector3<double>::Zero();  // by the base, as forces on it
    for (int j = 0; j < machine::kStruts; ++j) {
      const Vector3<double> u = s.struts.direction.col(j);
      // along the strut: the nut's tension pulls the base towards the platform, the motor hangs on the base joint
      carried += (s.nut_tension[j] + value("strut", "motor_mass_kg") * g.dot(u)) * u;
      // across it: the strut's weight less what its platform joint carries
      carried += strut * (g - g.dot(u) * u) - s.transverse.col(j);
    }
    const double moving = value("platform", "mass_kg") + 6 * strut + 4 + 11;
    CHECK((carried - moving * g).norm() < 1e-9 * moving);
  }
}

TEST_CASE("a platform that hangs straight below weighs on its struts as it should, and they grow longer") {
  // six parallel struts would be singular: a narrow funnel, its forces summed by hand
  const machine::MachineModel machine = pm600_like();
  const ForceModel model(machine);
  Motion<double> motion;
  motion.pose = machine::home_pose(machine);
  const StrutStretch<double> s = strut_stretch(model, model.environment(), motion);
  Vector3<double> on_platform = machine.gravity * machine.value("platform", "mass_kg").values[0];
  Vector3<double> moment = Vector3<double>::Zero();
  for (int j = 0; j < machine::kStruts; ++j) {
    const Vector3<double> force = s.transverse.col(j) - s.tension[j] * s.struts.direction.col(j);
    on_platform += force;
    moment += Vector3<double>(s.struts.arm.col(j)).cross(force);
  }
  CHECK(on_platform.norm() < 1e-10);
  CHECK(moment.norm() < 1e-10);
  CHECK(s.tension.minCoeff() > 0);
  CHECK((s.nut_tension - s.tension).minCoeff() > 0);  // a hanging strut's own weight adds
  CHECK(s.stretch.minCoeff() > 0);
}

TEST_CASE("lengthening pushes: friction lowers the tension of the drive, and the torque follows it") {
  const machine::MachineModel machine = pm600_like();
  const ForceModel model(machine);
  Motion<double> motion;
  motion.pose = machine::home_pose(machine);
  const auto rest = strut_stretch(model, model.environment(), motion);
  motion.twist.v_WT = {0, 0, -0.01};  // down: all struts lengthen
  const auto down = strut_stretch(model, model.environment(), motion);
  const std::vector<double>& friction = machine.value("strut", "coulomb_friction_N").values;
  for (int j = 0; j < machine::kStruts; ++j) {
    CHECK(rest.drive_tension[j] - down.drive_tension[j] == Approx(friction[static_cast<std::size_t>(j)]));
    CHECK(down.nut_tension[j] == Approx(rest.nut_tension[j]));
    CHECK(down.torque[j] == Approx(down.drive_tension[j] * 0.02 / (2 * std::numbers::pi)));
  }
}

TEST_CASE("a load below the tip and the same load on an arm differ by its moment") {
  const machine::MachineModel machine = pm600_like();
  ForceModel model(machine);
  Motion<double> motion;
  motion.pose = machine::home_pose(machine);
  Environment at_tip = model.environment();
  at_tip.payload_mass = 5;
  Environment as_tool = model.environment();
  as_tool.tool_mass = 5;
  const auto a = strut_stretch(model, at_tip, motion);
  const auto b = strut_stretch(model, as_tool, motion);
  CHECK((a.tension - b.tension).norm() < 1e-10);
  as_tool.tool_centre_P = {0.1, 0, 0};
  const auto c = strut_stretch(model, as_tool, motion);
  const machine::Vector6<double> load = machine::jacobian(c.struts).transpose() * (c.tension - a.tension);
  CHECK(load.head<4>().norm() < 1e-9);
  CHECK(load[4] == Approx(0.1 * 5 * 9.80665));
  CHECK(std::abs(load[5]) < 1e-9);

  model.parameters[static_cast<std::size_t>(model.add("payload"))] = 5;
  CHECK((strut_stretch(model, model.environment(), motion).tension - a.tension).norm() < 1e-10);
}

TEST_CASE("friction of the base joints acts against the transverse speed of the platform joints") {
  const machine::MachineModel machine = pm600_like();
  ForceModel model(machine);
  model.parameters[static_cast<std::size_t>(model.find("joint-friction", "viscous_friction_Nms_rad"))] = 200;
  Motion<double> motion;
  motion.pose = machine::home_pose(machine);
  motion.twist.v_WT = {0.03, 0, 0};
  Environment silent = model.environment();
  silent.friction = false;
  const auto moving = strut_stretch(model, model.environment(), motion);
  const auto still = strut_stretch(model, silent, motion);
  for (int j = 0; j < machine::kStruts; ++j) {
    const Vector3<double> u = moving.struts.direction.col(j);
    const Vector3<double> across = motion.twist.v_WT - u.dot(motion.twist.v_WT) * u;
    const double length = moving.struts.length[j];
    CHECK((moving.transverse.col(j) - still.transverse.col(j) + 200 / (length * length) * across).norm() < 1e-10);
  }
}

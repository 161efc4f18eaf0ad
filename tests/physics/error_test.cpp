#include "physics/error.hpp"

#include <catch2/catch.hpp>
#include <ceres/jet.h>

#include "machine/forward.hpp"
#include "physics/golden.hpp"
#include "physics/moments.hpp"

using namespace plumbline;
using namespace plumbline::physics;
using namespace plumbline::testing;

TEST_CASE("the error of forty poses agrees with an independent program") {
  const machine::MachineModel model = pm600_like();
  const ForceModel forces(model);
  const std::vector<GoldenRow> rows = golden_rows();
  REQUIRE(rows.size() == 40);
  for (const GoldenRow& row : rows) {
    Motion<double> motion;
    motion.pose = machine::pose_of(model.rotation, row.words);
    const TipError<double> error = tip_error(forces, forces.environment(), motion);
    INFO("row " << &row - rows.data() + 2 << ", iterations " << error.iterations);
    REQUIRE(error.converged());
    const auto commanded = machine::strut_lengths(model.geometry, motion.pose);
    for (int j = 0; j < 6; ++j) {
      const auto i = static_cast<std::size_t>(j);
      CHECK(commanded[j] / kMm == Approx(row.length_mm[i]).margin(1e-9).epsilon(0));
      CHECK(error.loads.nut_tension[j] == Approx(row.nut_tension[i]).margin(1e-6).epsilon(0));
      CHECK(error.loads.stretch[j] / kUm == Approx(row.stretch_um[i]).margin(2e-8).epsilon(0));
      CHECK(error.displacement[j] / kUm == Approx(row.displacement[i]).margin(1e-6).epsilon(0));
    }
  }
}

TEST_CASE("the error turns with the frame in which the machine is described") {
  const Matrix3<double> Q = machine::exponential(Vector3<double>(0.4, -1.1, 0.7));
  const machine::MachineModel model = pm600_like();
  machine::MachineModel turned = model;
  turned.geometry.base_joints_W = Q * model.geometry.base_joints_W;
  turned.gravity = Q * model.gravity;
  const ForceModel forces(turned);
  for (const GoldenRow& row : golden_rows()) {
    Motion<double> motion;
    motion.pose = machine::pose_of(model.rotation, row.words);
    motion.pose = {Q * motion.pose.p_WT, Q * motion.pose.R_WP};
    const TipError<double> error = tip_error(forces, forces.environment(), motion);
    REQUIRE(error.converged());
    const Eigen::Map<const machine::Vector6<double>> golden(row.displacement.data());
    CHECK((Q.transpose() * error.displacement.head<3>() / kUm - golden.head<3>()).norm() < 1e-6);
    CHECK((Q.transpose() * error.displacement.tail<3>() / kUm - golden.tail<3>()).norm() < 1e-6);
  }
}

TEST_CASE("the first-order error is near the exact one where the machine is stiff") {
  const machine::MachineModel model = pm600_like();
  const ForceModel forces(model);
  Motion<double> motion;
  motion.pose = machine::home_pose(model);
  const auto exact = tip_error(forces, forces.environment(), motion);
  const auto first = tip_error(forces, forces.environment(), motion, {.first_order = true});
  CHECK((exact.displacement - first.displacement).norm() < 1e-3 * exact.displacement.norm());
  CHECK(exact.displacement != first.displacement);
  const auto loads = strut_stretch(forces, forces.environment(), motion);
  CHECK((first.displacement - loads.jacobian.solve(loads.stretch)).norm() < 1e-14);
}

TEST_CASE("a machine that cannot stand says so") {
  machine::MachineModel model = pm600_like();
  Motion<double> motion;
  motion.pose = machine::home_pose(model);
  machine::MachineModel flat = model;
  flat.geometry.base_joints_W = flat.geometry.platform_joints_P;
  const ForceModel singular(flat);
  CHECK(tip_error(singular, singular.environment(), motion).stopped_because == ErrorStop::singular);

  ForceModel soft(model);  // springs a thousand times softer than any strut
  for (int j = 0; j < 6; ++j) {
    soft.parameters[static_cast<std::size_t>(soft.find("axial-elasticity", "compliance_um_N") + j)] = 1e-3;
  }
  motion.pose.p_WT.y() = 0.24;
  motion.pose.R_WP = machine::axis_rotation(0, -25 * kDeg);
  const auto error = tip_error(soft, soft.environment(), motion);
  CHECK_FALSE(error.converged());
  CHECK_FALSE(to_text(error.stopped_because).empty());
}

TEST_CASE("a compensated pose stands where it was programmed to") {
  const machine::MachineModel model = pm600_like();
  const ForceModel forces(model);
  for (const GoldenRow& row : golden_rows()) {
    Motion<double> motion;
    motion.pose = machine::pose_of(model.rotation, row.words);
    const auto loads = strut_stretch(forces, forces.environment(), motion);
    const auto sent =
        machine::forward_near<double>(model.geometry, motion.pose, loads.struts, loads.jacobian, -loads.stretch);
    REQUIRE(sent.converged);
    Motion<double> corrected;
    corrected.pose = sent.pose;
    const auto error = tip_error(forces, forces.environment(), corrected);
    REQUIRE(error.converged());
    CHECK(machine::displacement_between(motion.pose, error.pose).norm() < 1e-10);
  }
}

TEST_CASE("derivatives of the error by a parameter equal finite differences, and packs equal scalars") {
  using ByMass = ceres::Jet<double, 1>;
  Random random(40);
  const machine::MachineModel model = pm600_like();
  ForceModel forces(model);
  const auto mass = static_cast<std::size_t>(forces.find("platform-gravity", "mass_kg"));
  std::vector<Motion<double>> lanes;
  for (int n = 0; n < 20; ++n) {
    lanes.push_back(moment_within(model.limits, random));
    std::vector<ByMass> jets = parameters_as<ByMass>(forces);
    jets[mass].v[0] = 1;
    const Environment environment = forces.environment();
    const auto by_jet = tip_error(forces, jets.data(), environment, cast<ByMass>(lanes.back()));
    ForceModel more = forces;
    ForceModel less = forces;
    more.parameters[mass] += 0.01;
    less.parameters[mass] -= 0.01;
    const machine::Vector6<double> slope = (tip_error(more, environment, lanes.back()).displacement -
                                            tip_error(less, environment, lanes.back()).displacement) /
                                           0.02;
    for (int a = 0; a < 6; ++a) CHECK(std::abs(by_jet.displacement[a].v[0] - slope[a]) < 1e-12 + 1e-6 * slope.norm());
  }
  lanes.resize(static_cast<std::size_t>(Pack::size()));
  const auto packed = tip_error(forces, forces.parameters.data(), forces.environment(), packed_motion(lanes));
  for (int lane = 0; lane < Pack::size(); ++lane) {
    const auto alone = tip_error(forces, forces.environment(), lanes[static_cast<std::size_t>(lane)]);
    for (int a = 0; a < 6; ++a) CHECK(std::abs(packed.displacement[a][lane] - alone.displacement[a]) < 1e-11);
  }
}

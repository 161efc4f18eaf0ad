#include "physics/tip_stiffness.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "machine/model_file.hpp"
#include "machine/orientation.hpp"

using namespace plumbline;
using namespace plumbline::physics;

namespace {

Motion<double> tilted(const machine::MachineModel& model) {
  Motion<double> motion;
  motion.pose = machine::home_pose(model);
  motion.pose.p_WT += Vector3<double>(0.11, -0.07, 0.05);
  motion.pose.R_WP = machine::exponential<double>({0.2, -0.1, 0.05});
  return motion;
}

Environment at_rest(const ForceModel& forces) {
  Environment environment = forces.environment();
  environment.friction = false;
  return environment;
}

Matrix3<double> compliance_of(const machine::MachineModel& model, const Motion<double>& motion) {
  const ForceModel forces(model);
  const TipError<double> error = tip_error(forces, at_rest(forces), motion);
  REQUIRE(error.converged());
  return tip_compliance(forces, at_rest(forces), motion, error);
}

}  // namespace

TEST_CASE("of elastic struts alone the compliance is J^-1 (K1 L + K2) J^-T") {
  for (const machine::MachineModel& model : testing::three_machines()) {
    const Motion<double> motion = tilted(model);
    const ForceModel forces(model);
    const TipError<double> error = tip_error(forces, at_rest(forces), motion);
    REQUIRE(error.converged());
    const machine::StrutGeometry<double> struts = machine::strut_geometry(model.geometry, error.pose);
    machine::PerStrut<double> each;
    for (int j = 0; j < machine::kStruts; ++j) {
      const auto number = [&](const char* key) {
        return model.value("strut", key).values[static_cast<std::size_t>(j)];
      };
      each[j] = number("compliance_per_length_um_N_m") * struts.length[j] + number("compliance_um_N");
    }
    const machine::Matrix6<double> inverse = machine::jacobian(struts).inverse();
    const machine::Matrix6<double> all = inverse * each.asDiagonal() * inverse.transpose();
    const Matrix3<double> tip = all.topLeftCorner<3, 3>();
    const Matrix3<double> compliance = tip_compliance(forces, at_rest(forces), motion, error);
    CHECK((compliance - tip).norm() < 1e-6 * tip.norm());
    CHECK(least_stiffness(tip) ==
          Approx(1 / Eigen::SelfAdjointEigenSolver<Matrix3<double>>(tip).eigenvalues().maxCoeff()));
  }
}

TEST_CASE("a mass hung at the tip moves it as the compliance says") {
  const machine::MachineModel model = testing::pm600_like();
  const Motion<double> motion = tilted(model);
  const ForceModel forces(model);
  Environment environment = at_rest(forces);
  const TipError<double> without = tip_error(forces, environment, motion);
  environment.payload_mass = 5;
  const TipError<double> with = tip_error(forces, environment, motion);
  REQUIRE(with.converged());
  const Vector3<double> moved = with.displacement.head<3>() - without.displacement.head<3>();
  const Vector3<double> said = compliance_of(model, motion) * model.gravity * 5;
  CHECK((moved - said).norm() < 2e-3 * said.norm());  // struts turn as the tip gives way
}

TEST_CASE("what gives way besides the struts counts") {
  const std::string text = read_text(testing::source_path("models/pm600-like.toml"));
  const auto compliance = [&](const std::string& effect) {
    const machine::MachineModel model = machine::parse_model(text + effect, "model.toml");
    return compliance_of(model, tilted(model));
  };
  const Matrix3<double> bare = compliance("");
  // a frame that shifts by 0.01 um for each newton, in every direction alike
  const Matrix3<double> frame =
      compliance("[[effect]]\nname = \"frame-compliance\"\nshift_um_N = 0.01\ntilt_urad_Nm = 0\n");
  CHECK((frame - bare - 1e-8 * Matrix3<double>::Identity()).norm() < 1e-11);
  const Matrix3<double> joints =
      compliance("[[effect]]\nname = \"base-joint-compliance\"\nradial_um_N = 0.01\nvertical_um_N = 0.01\n");
  CHECK(least_stiffness(joints) < least_stiffness(bare));
  CHECK(least_stiffness(Matrix3<double>::Zero()) > 1e300);
}

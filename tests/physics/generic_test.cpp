// The effect `generic`: with the right powers it says what effects of the catalogue say.
#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "physics/generic_formula.hpp"
#include "physics/moments.hpp"
#include "physics/strut_stretch.hpp"

using namespace plumbline;
using namespace plumbline::physics;
using namespace plumbline::testing;

namespace {

ForceModel with_row(const std::string& keys) {
  const std::string text = pm600_like().document.text + "\n[[effect]]\n" + keys;
  return ForceModel(machine::parse_model(text, "m.toml"));
}

void check_alike(const std::string& generic, const std::string& other) {
  INFO(other);
  const ForceModel said = with_row("name = \"generic\"\n" + generic);
  const ForceModel named = with_row(other);
  const ForceModel bare(pm600_like());
  Random random(71);
  for (int n = 0; n < 5; ++n) {
    const Motion<double> motion = moment_within(pm600_like().limits, random);
    const auto one = strut_stretch(said, said.environment(), motion);
    const auto two = strut_stretch(named, named.environment(), motion);
    const auto none = strut_stretch(bare, bare.environment(), motion);
    CHECK(((one.stretch - two.stretch).norm() <= 1e-9 * (none.stretch - two.stretch).norm()));
    CHECK(((one.torque - two.torque).norm() <= 1e-9 * (none.torque - two.torque).norm()));
    CHECK(((one.tip - two.tip).norm() <= 1e-9 * (none.tip - two.tip).norm()));
    CHECK((one.stretch != none.stretch || one.torque != none.torque || one.tip != none.tip));
  }
}

}  // namespace

TEST_CASE("a generic effect with the powers of an effect of the catalogue is that effect") {
  check_alike("drive_N = [-1, 0, 0, 0, 0, -2]\nstrut_powers = [0, 1, 0, 0, 0, 0, 0, 0]",
              "name = \"screw-viscous\"\ndamping_N_s_m = [100, 0, 0, 0, 0, 200]");
  check_alike("drive_N = [-20, -20, -20, -20, -20, -20]\nstrut_powers = [0, 0, 1, 0, 1, 0, 0, 0]",
              "name = \"load-friction\"\nmu = 0.02");
  check_alike("length_um = [-2, 0, 0, -3, 0, 0]\nstrut_powers = [0, 0, 1, 0, 0, 0, 0, 0]",
              "name = \"backlash\"\nwidth_um = [4, 0, 0, 6, 0, 0]");
  check_alike("length_um = [0, 0, 3, 0, 0, 0]\npitch_mm = 20\nphase_deg = -60",
              "name = \"cyclic\"\namplitude_um = [0, 0, 3, 0, 0, 0]\nphase_deg = [0, 0, 30, 0, 0, 0]");
  check_alike("length_um = [2, 0, 0, 0, 0, 0]\nstrut_powers = [1, 0, 0, 0, 0, 0, 0, 0]",
              "name = \"lead-error\"\nerror_um_m = [20, 0, 0, 0, 0, 0]");
  check_alike("length_um = [10, 10, 10, 10, 10, 10]\nstrut_powers = [0, 0, 0, 1, 0, 0, 0, 2]",
              "name = \"base-joint-compliance\"\nradial_um_N = 0\nvertical_um_N = 0.01");
}

TEST_CASE("a generic effect pulls and moves at the tip by what all struts share") {
  Random random(72);
  const Motion<double> motion = moment_within(pm600_like().limits, random);
  const ForceModel bare(pm600_like());
  const ForceModel model =
      with_row("name = \"generic\"\nforce_N = [0, 3, 0]\ntip_um = [5, 0, 0]\nshared_powers = [1, 0, 0, 0, 0, 2]");
  const auto with = strut_stretch(model, model.environment(), motion);
  const auto without = strut_stretch(bare, bare.environment(), motion);
  const double share = motion.pose.p_WT.x() / 0.1 * std::pow(motion.time / 3600, 2);
  CHECK(with.tip.head<3>().isApprox(Vector3<double>(5e-6 * share, 0, 0), 1e-12));
  const machine::Vector6<double> wrench =
      machine::jacobian(without.struts).transpose() * (with.tension - without.tension);
  CHECK(wrench.head<3>().isApprox(Vector3<double>(0, 3 * share, 0), 1e-9));
  CHECK(wrench.tail<3>().norm() < 1e-9 * std::abs(share));
}

TEST_CASE("a generic effect has a formula in words") {
  const auto formula = [](const std::string& keys) {
    const ForceModel model = with_row("name = \"generic\"\n" + keys);
    const auto first = static_cast<std::size_t>(model.instances().back().first);
    return generic_formula(std::span(model.parameters).subspan(first));
  };
  CHECK(formula("").empty());
  CHECK(formula("length_um = [0, 3.2, 0, 0, 0, 0]\nstrut_powers = [0, 0, 1, 2, 0, 0, 0, 0]") ==
        "length_j: [0, 3.2, 0, 0, 0, 0] um x s x (t / kN)^2");
  CHECK(formula("tip_um = [1, 0, 0]\nshared_powers = [1, 1, 0, 0, 0, 0]") ==
        "tip: [1, 0, 0] um x (x / 100 mm) x (y / 100 mm)");
  CHECK(formula("drive_N = [1, 0, 0, 0, 0, 0]\ntorque_Nm = [2, 0, 0, 0, 0, 0]\npitch_mm = 7.5\nphase_deg = 90") ==
        "drive tension_j: [1, 0, 0, 0, 0, 0] N x cos(2 pi L / 7.5 mm + 90 deg)\n"
        "torque reading_j: [2, 0, 0, 0, 0, 0] N m x cos(2 pi L / 7.5 mm + 90 deg)");
}

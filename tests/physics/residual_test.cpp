// The effect `residual`: smooth functions of what is known at a moment, flat outside of the region measured.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "physics/moments.hpp"
#include "physics/strut_stretch.hpp"

using namespace plumbline;
using namespace plumbline::physics;
using namespace plumbline::testing;

namespace {

std::string weights(std::size_t place, double value) {
  std::string text = "[";
  for (std::size_t k = 0; k < static_cast<std::size_t>(Residual::kFunctions); ++k)
    text += (k == 0 ? "" : ", ") + (k == place ? std::to_string(value) : "0");
  return text + "]";
}

ForceModel with_residual(const std::string& keys) {
  const std::string text = pm600_like().document.text + "\n[[effect]]\nname = \"residual\"\n" + keys;
  return ForceModel(machine::parse_model(text, "m.toml"));
}

// What the row adds to the machine at that moment.
StrutStretch<double> added(const ForceModel& model, const Motion<double>& motion) {
  const ForceModel bare(pm600_like());
  StrutStretch<double> with = strut_stretch(model, model.environment(), motion);
  const StrutStretch<double> without = strut_stretch(bare, bare.environment(), motion);
  with.stretch -= without.stretch;
  with.tip -= without.tip;
  with.torque -= without.torque;
  return with;
}

}  // namespace

TEST_CASE("a residual function of a strut's length makes that strut longer by it, and is flat outside of its region") {
  Random random(75);
  const ForceModel model =
      with_residual("length_um = " + weights(2, 5) +
                    "\npart = 4\ncoordinates = [7, 0, 0]\nmiddle = [0.5, 0, 0]\nhalf_width = [3, 1, 1]\n"
                    "lower = [-1, 0, 0]\nupper = [0.8, 0, 0]");
  int below = 0;
  int above = 0;
  for (int n = 0; n < 60; ++n) {
    const Motion<double> motion = moment_within(pm600_like().limits, random);
    const machine::StrutGeometry<double> struts = machine::strut_geometry(model.machine.geometry, motion.pose);
    const double coordinate = (struts.length[3] - model.machine.middle_length[3]) / 0.1;
    if (coordinate < -1) ++below;
    if (coordinate > 0.8) ++above;
    const double x = (std::clamp(coordinate, -1.0, 0.8) - 0.5) / 3;
    machine::PerStrut<double> expected = machine::PerStrut<double>::Zero();
    expected[3] = 5e-6 * std::sin(std::numbers::pi * 3 * (x + 2) / 4);
    CHECK(added(model, motion).stretch.isApprox(expected, 1e-9));
  }
  CHECK(below > 3);
  CHECK(above > 3);
}

TEST_CASE("a residual function of the place moves the tip along its axis, and pulls at tip or centre of mass") {
  Random random(76);
  const std::string place = "\npart = 2\ncoordinates = [1, 3, 0]\nhalf_width = [2, 4, 1]";
  const ForceModel tip = with_residual("tip_um = " + weights(1, 7) + place);
  const ForceModel force = with_residual("force_N = " + weights(1, 7) + place);
  const ForceModel centre = with_residual("centre_N = " + weights(1, 7) + place);
  for (int n = 0; n < 5; ++n) {
    const Motion<double> motion = moment_within(pm600_like().limits, random);
    // the second function of two coordinates: orders 1 and 2
    const auto along = [](double x, int order) {
      return std::sin(std::numbers::pi * order * (std::clamp(x, -1.0, 1.0) + 2) / 4);
    };
    const double value = 7 * along(motion.pose.p_WT.x() / 0.1 / 2, 1) * along((motion.pose.p_WT.z() + 1) / 0.1 / 4, 2);
    CHECK(added(tip, motion).tip.head<3>().isApprox(Vector3<double>(0, 1e-6 * value, 0), 1e-9));
    CHECK(added(tip, motion).stretch.isZero(0));
    const auto wrench_of = [&](const ForceModel& model) {
      const ForceModel bare(pm600_like());
      const auto without = strut_stretch(bare, bare.environment(), motion);
      const auto with = strut_stretch(model, model.environment(), motion);
      return machine::Vector6<double>(machine::jacobian(without.struts).transpose() * (with.tension - without.tension));
    };
    const machine::Vector6<double> pull = (machine::Vector6<double>() << 0, value, 0, 0, 0, 0).finished();
    CHECK((wrench_of(force) - pull).norm() < 1e-8);
    const machine::Vector6<double> off_centre = wrench_of(centre);
    CHECK(std::abs(off_centre[1] - value) < 1e-8);
    CHECK(off_centre.tail<3>().norm() > 0.1 * std::abs(value));
  }
}

TEST_CASE("a residual function of what only struts have does nothing at the tip") {
  Random random(77);
  const ForceModel model = with_residual("tip_um = " + weights(0, 7) + "\ncoordinates = [7, 0, 0]");
  const Motion<double> motion = moment_within(pm600_like().limits, random);
  CHECK(added(model, motion).tip.isZero(0));
}

TEST_CASE("the functions of several coordinates are those of the lowest orders, each once") {
  for (const int dimensions : {1, 2, 3}) {
    const Residual::Orders orders = Residual::orders(dimensions);
    std::set<std::array<int, 3>> all(orders.begin(), orders.end());
    CHECK(all.size() == orders.size());
    int highest = 0;
    for (const auto& order : orders) {
      for (std::size_t d = 0; d < 3; ++d) {
        CHECK((order[d] > 0) == (static_cast<int>(d) < dimensions));
        highest = std::max(highest, order[d]);
      }
    }
    CHECK(highest == Residual::highest_of(dimensions));
  }
}

// Calibration: where the joints are, and what of that nothing shows.
#include "identify/unknowns/geometry.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "identify/identify.hpp"
#include "identify/plans.hpp"
#include "machine/model_file.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

namespace {

// The machine's model with other text in place of some of it.
machine::MachineModel with_uncertainty(const std::string& lines) {
  std::string text = pm600_like().document.text;
  text.resize(text.find("[uncertainty]"));
  return machine::parse_model(text + "[uncertainty]\n" + lines, "model.toml");
}

// By how much a change of the unknowns moves what the bar reads, in the largest reading, um.
double seen(const std::vector<measure::Run>& runs, const Unknowns& unknowns, const Eigen::VectorXd& change) {
  Objective objective(pm600_like().rotation, runs, unknowns);
  const std::vector<RunEquations> before = objective.equations(unknowns.start());
  const std::vector<RunEquations> after = objective.equations(unknowns.start() + change);
  double most = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Eigen::VectorXd moved = after[i].residual - before[i].residual;
    const Eigen::Index n = before[i].samples;
    most = std::max(most, moved.head(n).cwiseAbs().maxCoeff() * 1e6);
  }
  return most;
}

}  // namespace

TEST_CASE("geometry is unknown even where [uncertainty] does not list it") {
  const machine::MachineModel exact = with_uncertainty("coulomb_friction_N = 6\n");
  const Unknowns unknowns = geometry_unknowns(exact, physics::ForceModel(exact));
  CHECK(unknowns.size() == 6 + 6 + 36);
  CHECK(unknowns[static_cast<std::size_t>(unknowns.find("joint-position", "platform_um", 17))].sigma == 1e-3);
  CHECK(geometry_unknowns(exact, physics::ForceModel(exact), {.alone = true}).size() == 42);

  const machine::MachineModel listed = pm600_like();
  const Unknowns known = geometry_unknowns(listed, physics::ForceModel(listed));
  CHECK(known.size() == nuisances(listed, physics::ForceModel(listed)).size());
  CHECK(known[static_cast<std::size_t>(known.find("strut-offset", "length_um", 0))].sigma == Approx(5e-6));
}

TEST_CASE("rigid motions of a ring that no circle shows hardly move what the bar reads, and others do") {
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  const Unknowns unknowns = geometry_unknowns(machine, forces);
  const std::vector<measure::Run> runs = wider_plan(30);
  constexpr double kFar = 100e-6;  // m at a joint, or m per m
  for (const WholeMotion& motion : whole_motions(machine.geometry, unknowns)) {
    const double moved = seen(runs, unknowns, kFar * motion.direction);
    using Kind = WholeMotion::Kind;
    INFO(static_cast<int>(motion.kind) << " about " << motion.axis << ": " << moved << " um");
    // the base shifted, or turned about the vertical; the platform shifted: ball and bar take it. Loads move a little
    // with the struts' directions.
    const bool turns_base = motion.kind == Kind::turn && motion.ring == WholeMotion::Ring::base && motion.axis == 2;
    const bool hidden = motion.kind == Kind::shift || turns_base;
    const bool shape = motion.kind == Kind::wider_ring || motion.kind == Kind::longer_struts;
    if (hidden) CHECK(moved < 0.1);
    if (shape) CHECK(moved > 0.5);
  }
}

TEST_CASE("a miscalibrated machine is calibrated from circles: what they show of it is right within its errors") {
  Random random(71);
  const machine::MachineModel machine = pm600_like();
  const physics::ForceModel forces(machine);
  const Unknowns unknowns = geometry_unknowns(machine, forces);
  const Eigen::VectorXd truth = drawn(unknowns, random);
  const std::vector<measure::Run> runs = measured(wider_plan(), unknowns.at(truth), 0.3e-6, 0.03, random);
  const Identification found = identify::identify(machine, runs, {.stages = Stages::geometry});
  REQUIRE(found.converged());
  const Fit& fit = found.stages[0].fit;
  REQUIRE(fit.unknowns.size() == unknowns.size());
  const Eigen::VectorXd off = fit.values - truth;
  CHECK(off.dot(fit.covariance.ldlt().solve(off)) == Approx(static_cast<double>(off.size())).epsilon(0.6));
  CHECK(found.after.radial_rms == Approx(0.3e-6).epsilon(0.2));
  CHECK(found.before.radial_rms > 2 * found.after.radial_rms);

  REQUIRE(found.stages[0].geometry);
  const ShownGeometry& shown = *found.stages[0].geometry;
  CHECK(shown.directions == 42);
  CHECK(shown.better > 0);
  CHECK(shown.better < shown.directions);
  const auto hides = [&](WholeMotion::Kind kind, int axis) {
    return std::any_of(shown.hidden.begin(), shown.hidden.end(), [&](const WholeMotion& m) {
      return m.kind == kind && m.ring == WholeMotion::Ring::base && m.axis == axis;
    });
  };
  CHECK(hides(WholeMotion::Kind::shift, 0));
  CHECK(hides(WholeMotion::Kind::turn, 2));
}

TEST_CASE("what no circle shows of the geometry stays where it was, even with wide priors") {
  Random random(72);
  const machine::MachineModel machine = with_uncertainty("coulomb_friction_N = 6\n");
  const physics::ForceModel forces(machine);
  const Unknowns unknowns = geometry_unknowns(machine, forces, {.alone = true});
  Eigen::VectorXd truth = unknowns.start();
  const std::vector<WholeMotion> motions = whole_motions(machine.geometry, unknowns);
  const auto shift = std::find_if(motions.begin(), motions.end(), [](const WholeMotion& m) {
    return m.kind == WholeMotion::Kind::shift && m.ring == WholeMotion::Ring::base && m.axis == 0;
  });
  REQUIRE(shift != motions.end());
  truth += 300e-6 * shift->direction;
  const std::vector<measure::Run> runs = measured(wider_plan(), unknowns.at(truth), 0.1e-6, 0.01, random);
  const Identification found =
      identify::identify(machine, runs, {.stages = Stages::geometry, .geometry = {.alone = true}});
  REQUIRE(found.converged());
  const Fit fit = identify::fit(machine.rotation, runs, unknowns);
  const double share = shift->direction.dot(fit.values) / shift->direction.squaredNorm();
  // what the data leave of the prior says how far they may draw the estimate from it: through the loads alone
  const double left = left_of_prior(*shift, fit.unknowns, fit.covariance);
  CHECK(left > 0.7);
  CHECK(share == Approx(300e-6 * (1 - left * left)).margin(40e-6));
  // and the tip stays where it was, as far as the data do not surely say otherwise
  REQUIRE(found.stages[0].held);
  CHECK(found.stages[0].held->share > 0);
  CHECK(found.stages[0].held->back > 20e-6);
  CHECK(found.after.radial_rms < 0.2e-6);
}

#include "jobs/expected/tip_doubts.hpp"

#include <cmath>
#include <numeric>
#include <random>

#include <catch2/catch.hpp>

#include "identify/posterior/normal_length.hpp"
#include "machine/machines.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

compensate::Target at(double x, double y, double z, double a = 0) {
  compensate::Target target;
  target.pose[Axis::X] = x;
  target.pose[Axis::Y] = y;
  target.pose[Axis::Z] = z;
  target.pose[Axis::A] = a;
  return target;
}

compensate::Settings at_rest() {
  compensate::Settings settings;
  settings.friction = false;
  return settings;
}

double sum_of_squares(const jobs::TipDoubt& doubt) {
  return std::inner_product(doubt.rms.begin(), doubt.rms.end(), doubt.rms.begin(), 0.0);
}

// Where the tip of a machine with these forces stands.
Vector3<double> tip_of(const machine::MachineModel& model, const physics::ForceModel& forces,
                       const compensate::Target& target) {
  physics::Environment environment = forces.environment();
  environment.friction = false;
  const double radius = machine::platform_radius(model.geometry);
  return physics::tip_error(forces, environment, compensate::motion_at(model.rotation, radius, target, environment))
      .pose.p_WT;
}

}  // namespace

TEST_CASE("one machine of twenty that are as uncertain has its tip further off than is stated") {
  const machine::MachineModel model = pm600_like();
  const identify::Posterior prior = identify::prior_of(model);
  jobs::TipDoubts doubts(model, prior, at_rest());
  const compensate::Target zero = at(0, 0, -1000);
  const compensate::Target there = at(120, -60, -950, 12);
  REQUIRE(doubts.touch_off(zero.pose));
  const jobs::PoseDoubt doubt = doubts.at(there).value();
  const Vector3<double> model_there = tip_of(model, prior.unknowns.forces(), there);
  const Vector3<double> model_zero = tip_of(model, prior.unknowns.forces(), zero);
  Random random(3);
  std::normal_distribution<double> normal;
  int beyond = 0;
  int beyond_touched = 0;
  int beyond_x = 0;
  double sum = 0;
  constexpr int kMachines = 3000;
  for (int n = 0; n < kMachines; ++n) {
    Eigen::VectorXd values = prior.unknowns.start();
    for (Eigen::Index i = 0; i < values.size(); ++i)
      values[i] += prior.unknowns[static_cast<std::size_t>(i)].sigma * normal(random);
    const physics::ForceModel drawn = prior.unknowns.at(values);
    const Vector3<double> off = tip_of(model, drawn, there) - model_there;
    const Vector3<double> touched = off - (tip_of(model, drawn, zero) - model_zero);
    beyond += off.norm() > doubt.stands.within;
    beyond_touched += touched.norm() > doubt.touched_off->within;
    beyond_x += std::abs(off.x()) > doubt.stands.axis_within.x();
    sum += off.norm();
  }
  CHECK(beyond / double(kMachines) == Approx(0.05).margin(0.012));
  CHECK(beyond_touched / double(kMachines) == Approx(0.05).margin(0.012));
  CHECK(beyond_x / double(kMachines) == Approx(0.05).margin(0.012));
  CHECK(sum / kMachines == Approx(doubt.stands.mean).epsilon(0.03));
  CHECK(doubt.touched_off->mean < doubt.stands.mean);
  CHECK(doubts.at(zero)->touched_off->within < 1e-12);
}

TEST_CASE("what makes the tip uncertain adds up, the noise of readings beside what the priors leave") {
  const machine::MachineModel model = pm600_like();
  identify::Posterior posterior = identify::prior_of(model);
  jobs::TipDoubts before(model, posterior, {});
  compensate::Target moving = at(0, 100, -1008);
  moving.slope[Axis::X] = 10;
  moving.seconds = 1;
  const jobs::TipDoubt prior = before.at(moving)->stands;
  CHECK(prior.rms[jobs::index(jobs::Cause::noise)] == Approx(0).margin(1e-9));
  CHECK(prior.rms[jobs::index(jobs::Cause::friction)] > 0);
  CHECK(prior.rms[jobs::index(jobs::Cause::geometry)] > prior.rms[jobs::index(jobs::Cause::elasticity)]);

  // readings that tell as much again of each number as was known: half of what is left is their noise
  identify::PosteriorState& state = posterior.states.front();
  state.covariance /= 2;
  jobs::TipDoubts after(model, posterior, {});
  const jobs::TipDoubt halved = after.at(moving)->stands;
  CHECK(sum_of_squares(halved) == Approx(sum_of_squares(prior) / 2));
  CHECK(std::pow(halved.rms[jobs::index(jobs::Cause::noise)], 2) == Approx(sum_of_squares(prior) / 4));

  // what no number stands for, and priors that are too narrow
  posterior.unexplained = 1e-6;
  state.widening = 2;
  jobs::TipDoubts wider(model, posterior, {});
  const jobs::TipDoubt more = wider.at(moving)->stands;
  CHECK(sum_of_squares(more) == Approx(sum_of_squares(prior) + 3e-12));
  CHECK(more.within > halved.within);
}

TEST_CASE("a shift that was held back is expected, and effects that are not told apart are a mixture") {
  const machine::MachineModel model = pm600_like();
  identify::Posterior posterior = identify::prior_of(model);
  const int z = posterior.unknowns.find("joint-position", "base_um", 2);
  REQUIRE(z >= 0);
  for (int j = 0; j < 6; ++j) posterior.states.front().mean[z + 3 * j] += 20e-6;
  posterior.states.front().covariance *= 1e-6;
  jobs::TipDoubts doubts(model, posterior, at_rest());
  const jobs::TipDoubt shifted = doubts.at(at(0, 0, -1000))->stands;
  CHECK(std::abs(shifted.axis_mean.z()) == Approx(20e-6).epsilon(0.02));
  CHECK(shifted.within == Approx(20e-6).epsilon(0.02));

  posterior.states.push_back(posterior.states.front());
  posterior.states.front().weight = 0.9;
  posterior.states.back().weight = 0.1;
  for (int j = 0; j < 6; ++j) posterior.states.back().mean[z + 3 * j] += 30e-6;
  jobs::TipDoubts two(model, posterior, at_rest());
  const jobs::TipDoubt mixed = two.at(at(0, 0, -1000))->stands;
  CHECK(mixed.within == Approx(50e-6).epsilon(0.02));  // one of ten lies there
  CHECK(mixed.rms[jobs::index(jobs::Cause::which_effect)] == Approx(30e-6 * 0.3).epsilon(0.03));
}

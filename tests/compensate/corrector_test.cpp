// target.cpp is tested here as well: what a target means shows in its correction.
#include "compensate/corrector.hpp"

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "base/files/files.hpp"
#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using compensate::Corrected;
using compensate::Corrector;
using compensate::Settings;
using compensate::Target;

namespace {

const machine::MachineModel& pm600() {
  static const machine::MachineModel model = machine::read_model(PLUMBLINE_SOURCE_DIR "/models/pm600-like.toml");
  return model;
}

Target at(AxisWords pose) { return {pose, {{1, 0.3, -0.2, 0.05, 0, 0.1}}, {}, 0.06}; }

std::vector<Target> poses(int count) {
  std::mt19937_64 random(20260719);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Target> targets;
  for (int i = 0; i < count; ++i) {
    targets.push_back(at({{150 * unit(random), 150 * unit(random), -1008 + 100 * unit(random), 15 * unit(random),
                           15 * unit(random), 20 * unit(random)}}));
  }
  return targets;
}

double distance(const AxisWords& a, const AxisWords& b) {
  const AxisWords d = a - b;
  return std::hypot(d[Axis::X], d[Axis::Y], d[Axis::Z]);
}

machine::MachineModel with(const std::string& row) {
  static const std::string text = read_text(PLUMBLINE_SOURCE_DIR "/models/pm600-like.toml");
  return machine::parse_model(text + "\n[[effect]]\n" + row, "model.toml");
}

}  // namespace

TEST_CASE("the deformed machine stands on the target when it is told the exact correction") {
  for (const bool friction : {true, false}) {
    Settings settings;
    settings.friction = friction;
    const Corrector corrector(pm600(), settings);
    for (const Target& target : poses(200)) {
      const Corrected corrected = corrector.correct(target);
      REQUIRE(corrected.converged);
      const auto left = corrector.tip_distance_mm(target, corrected.pose);
      REQUIRE(left.has_value());
      // Friction moves by the speeds at the commanded pose, which is not the target's by a hair.
      CHECK(*left < (friction ? 1e-4 : 1e-8));
    }
  }
}

TEST_CASE("the correction is worth having, and the first order comes near it away from singular poses") {
  Settings first;
  first.method = compensate::Method::first_order;
  const Settings exact;
  const Corrector by_formula(pm600(), exact);
  const Corrector linear(pm600(), first);
  for (const Target& target : poses(50)) {
    const auto error = by_formula.error(target);
    REQUIRE(error.has_value());
    CHECK(distance(*error, {}) > 1e-3);
    const double left = linear.tip_distance_mm(target, linear.correct(target).pose).value();
    CHECK(left < 0.1 * distance(*error, {}));
    CHECK(left > by_formula.tip_distance_mm(target, by_formula.correct(target).pose).value());
  }
}

TEST_CASE("where no command puts the tool on the target the first order finds none either") {
  Settings first;
  first.method = compensate::Method::first_order;
  Corrector linear(pm600(), first);
  linear.set_tool({.length = 0.085, .mass = 1.4, .along = 0.02});
  for (const AxisWords& beyond :
       {AxisWords{{-72.5, 3.14, -830.9, -16.526, 17.761, 16.99}}, AxisWords{{-72.5, 3.14, -830.9, -16.8, 18, 16.99}},
        AxisWords{{-72.5, 3.14, -825, -16.526, 17.761, 16.99}}}) {
    CHECK_FALSE(linear.correct(at(beyond)).converged);
  }
  const Target within = at({{-72.5, 3.14, -930, -12, 12, 16.99}});
  CHECK(linear.correct(within).converged);
  CHECK(distance(linear.correct(within).pose, within.pose) < 0.5);
}

TEST_CASE("where rotary axes may not be written the tip is put right all the same") {
  Settings settings;
  const Corrector corrector(pm600(), settings);
  for (Target target : poses(50)) {
    target.fixed = AxisSet::rotary();
    target.pose[Axis::A] = target.pose[Axis::B] = target.pose[Axis::C] = 0;
    const Corrected corrected = corrector.correct(target);
    REQUIRE(corrected.converged);
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) CHECK(corrected.pose[axis] == 0);
    CHECK(corrector.tip_distance_mm(target, corrected.pose).value() < 1e-5);
  }
}

TEST_CASE("the length of the tool changes the correction, and so does its weight") {
  Settings settings;
  settings.friction = false;
  Corrector corrector(pm600(), settings);
  const Target target = at({{0, 100, -1008, -15, 0, 0}});
  const AxisWords bare = corrector.correct(target).pose;
  corrector.set_tool({.length = 0.08, .mass = 0, .along = 0});
  const AxisWords longer = corrector.correct(target).pose;
  CHECK(distance(bare, longer) > 1e-4);
  corrector.set_tool({.length = 0.08, .mass = 5, .along = 0.04});
  CHECK(distance(corrector.correct(target).pose, longer) > 1e-4);
  CHECK(corrector.error_per_kg_mm(target).value() > 1e-5);
  // Whatever the tool, its tip ends on the target.
  CHECK(corrector.tip_distance_mm(target, corrector.correct(target).pose).value() < 1e-9);
}

TEST_CASE("the correction turns smoothly where a strut turns around") {
  const Settings settings;
  const Corrector corrector(pm600(), settings);
  Target target = at({{0, 0, -1008, 0, 0, 0}});
  double largest_step = 0;
  AxisWords before;
  for (int i = 0; i <= 3600; ++i) {  // a circle of 100 mm at F1000, every 0.1 deg
    const double angle = i * 0.1 * kDeg;
    target.pose = {{100 * std::cos(angle), 100 * std::sin(angle), -1008, 0, 0, 0}};
    target.slope = {{-std::sin(angle), std::cos(angle), 0, 0, 0, 0}};
    target.seconds = 0.06;
    const AxisWords correction = corrector.correct(target).pose - target.pose;
    if (i > 0) largest_step = std::max(largest_step, distance(correction, before));
    before = correction;
  }
  CHECK(largest_step < 1e-3);
}

TEST_CASE("at rest friction is silent") {
  const Settings settings;
  Settings without;
  without.friction = false;
  Target target = at({{50, 0, -1008, 5, 0, 0}});
  target.slope = {};
  CHECK(Corrector(pm600(), settings).correct(target).pose == Corrector(pm600(), without).correct(target).pose);
}

TEST_CASE("a control's following error is compensated only where the control is said to hold the feed") {
  const Target target = at({{50, 20, -1008, 5, -5, 0}});
  const AxisWords plain = Corrector(pm600(), {}).correct(target).pose;
  const machine::MachineModel apart = with("name = \"servo-mismatch\"\nlag_ms = [4, 0, 0, -4, 0, 0]\n");
  const machine::MachineModel late = with("name = \"servo-lag\"\nlag_ms = 20\n");
  CHECK(Corrector(apart, {}).correct(target).pose == plain);
  CHECK(Corrector(late, {}).correct(target).pose == plain);
  Settings dynamic;
  dynamic.dynamic = true;
  CHECK(distance(Corrector(apart, dynamic).correct(target).pose, plain) > 0.01);
  CHECK(distance(Corrector(with("name = \"backlash\"\nwidth_um = [9, 0, 0, 0, 0, 0]\n"), {}).correct(target).pose,
                 plain) > 1e-4);
}

TEST_CASE("drives that all follow late alike are led out of an arc by what they cut of it, and not along it") {
  Settings settings;
  settings.dynamic = true;
  const machine::MachineModel late = with("name = \"servo-lag\"\nlag_ms = 20\n");
  const Corrector plain(pm600(), settings);
  const Corrector leading(late, settings);
  Target target = at({{50, 0, -1008, 0, 0, 0}});
  target.slope = {{0, 50, 0, 0, 0, 0}};  // of a circle of 50 mm, per radian
  target.bend = {{-50, 0, 0, 0, 0, 0}};
  target.seconds = 2;  // for a radian
  const AxisWords lead = leading.correct(target).pose - plain.correct(target).pose;
  // a first-order lag runs r / sqrt(1 + (w tau)^2) around: 50 mm at 0.5 rad/s and 20 ms are 2.5 um too small. That it
  // is 0.5 mm late on its way is no error of the path.
  CHECK(lead[Axis::X] == Approx(50 * 0.01 * 0.01 / 2).epsilon(0.05));
  CHECK(lead[Axis::Y] == Approx(0).margin(2e-4));
  CHECK(leading.tip_distance_mm(target, leading.correct(target).pose).value() < 1e-4);
}

TEST_CASE("mass that is accelerated pulls outwards on an arc") {
  Settings settings;
  settings.dynamic = true;
  const machine::MachineModel heavy = with("name = \"inertia\"\nmass_kg = 100\n");
  Target target = at({{50, 0, -1008, 0, 0, 0}});
  target.slope = {{0, 50, 0, 0, 0, 0}};
  target.bend = {{-50, 0, 0, 0, 0, 0}};
  target.seconds = 0.2;  // 250 mm/s: 1.25 m/s^2, 125 N
  const AxisWords there = Corrector(heavy, settings).correct(target).pose;
  const AxisWords plain = Corrector(pm600(), settings).correct(target).pose;
  const machine::MachineModel pulled = with("name = \"counterbalance\"\nforce_N = [125, 0, 0]\n");
  CHECK(distance(there, plain) > 1e-3);
  CHECK(distance(there, Corrector(pulled, settings).correct(target).pose) < 1e-7);
  target.bend = {};
  CHECK(distance(Corrector(heavy, settings).correct(target).pose, Corrector(pm600(), settings).correct(target).pose) ==
        Approx(0).margin(1e-9));
  target.bend = {{-50, 0, 0, 0, 0, 0}};
  settings.dynamic = false;
  CHECK(distance(Corrector(heavy, settings).correct(target).pose, Corrector(pm600(), settings).correct(target).pose) ==
        Approx(0).margin(1e-9));
}

TEST_CASE("a machine that warms up is corrected as it is at the stated time") {
  const machine::MachineModel warming = with("name = \"thermal-drift\"\nrate_K_h = [1, 1, 1, 1, 1, 1]\n");
  const Target target = at({{0, 0, -1008, 0, 0, 0}});
  Settings settings;
  const Settings cold;
  const Corrector plain(pm600(), cold);
  CHECK(distance(Corrector(warming, settings).correct(target).pose, plain.correct(target).pose) == 0);
  CHECK(Corrector(warming, settings).drift_per_hour_mm(target).value() > 5e-3);
  settings.time_s = 7200;
  const AxisWords led = Corrector(warming, settings).correct(target).pose - plain.correct(target).pose;
  CHECK(led[Axis::Z] == Approx(2 * Corrector(warming, settings).drift_per_hour_mm(target).value()).epsilon(1e-3));
}

TEST_CASE("the motion along a path has the acceleration of its turns and of its angles") {
  const machine::RotationOrder rotation = pm600().rotation;
  Target target = at({{10, 20, -1000, 12, -7, 30}});
  target.slope = {{1, -2, 3, 20, 15, -10}};
  target.seconds = 0.5;
  physics::Environment environment;
  const auto at_fraction = [&](double f) {
    Target moved = target;
    for (const Axis axis : kAllAxes) moved.pose[axis] += f * target.slope[axis];
    return compensate::motion_at(rotation, 0.2, moved, environment);
  };
  const double h = 1e-4;
  const physics::Motion<double> motion = at_fraction(0);
  CHECK((motion.twist.v_WT - Vector3<double>(2, -4, 6) * 1e-3).norm() < 1e-15);
  CHECK(motion.acceleration.v_WT.norm() == 0);
  const Vector3<double> turning = machine::displacement_between(at_fraction(-h).pose, at_fraction(h).pose).tail<3>();
  CHECK((motion.twist.w_WP - turning / (2 * h * 0.5)).norm() < 1e-6);
  const Vector3<double> speeding = (at_fraction(h).twist.w_WP - at_fraction(-h).twist.w_WP) / (2 * h * 0.5);
  CHECK(speeding.norm() > 1e-3);
  CHECK((motion.acceleration.w_WP - speeding).norm() < 1e-6);
  environment.dynamic = false;
  CHECK(at_fraction(0).twist.w_WP == motion.twist.w_WP);
  CHECK(at_fraction(0).acceleration.w_WP.isZero(0));
}

TEST_CASE("a touch-off has the error at its pose, where the machine comes") {
  Settings settings;
  settings.friction = false;
  const Corrector corrector(pm600(), settings);
  const auto error = [&](const AxisWords& pose) {
    Settings touched;
    touched.touch_off = pose;
    return compensate::touch_off_error(corrector, pm600().limits, touched);
  };
  CHECK(error({{0, 0, -1008, 0, 0, 0}})[Axis::Z] == Approx(-0.0154).margin(1e-3));
  CHECK_NOTHROW(error({{299, 0, -1008, 0, 24, 0}}));
  CHECK(compensate::touch_off_error(corrector, pm600().limits, {}) == AxisWords{});
  for (const auto& [pose, what] :
       std::vector<std::pair<AxisWords, std::string>>{{{{0, 0, 0, 0, 0, 0}}, "Z would be 0"},
                                                      {{{320, 0, -1008, 0, 0, 0}}, "X would be"},
                                                      {{{0, -301, -1008, 0, 0, 0}}, "Y would"},
                                                      {{{0, 0, -1008, 0, 26, 0}}, "tilt would"},
                                                      {{{0, 0, -1, 0, 0, 0}}, ""}}) {
    const Diagnostic refused = testing::refusal_of([&, &asked = pose] { error(asked); });
    INFO(refused.message);
    CHECK(refused.code == "compensate-touch-off");
    CHECK(refused.message.find(what) != std::string::npos);
  }
}

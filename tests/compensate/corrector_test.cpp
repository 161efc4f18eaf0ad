#include "compensate/corrector.hpp"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "base/files.hpp"
#include "base/units.hpp"
#include "machine/model_file.hpp"

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

Target at(AxisWords pose) { return {pose, {{1, 0.3, -0.2, 0.05, 0, 0.1}}, 0.06}; }

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

TEST_CASE("where rotary axes may not be written the tip is put right all the same") {
  Settings settings;
  Corrector corrector(pm600(), settings);
  corrector.fix_axes({Axis::A, Axis::B, Axis::C});
  for (Target target : poses(50)) {
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

TEST_CASE("a control's following error is not compensated") {
  const std::string text = read_text(PLUMBLINE_SOURCE_DIR "/models/pm600-like.toml");
  const auto with = [&](const std::string& row) {
    return machine::parse_model(text + "\n[[effect]]\n" + row, "model.toml");
  };
  const Target target = at({{50, 20, -1008, 5, -5, 0}});
  const AxisWords plain = Corrector(pm600(), {}).correct(target).pose;
  CHECK(Corrector(with("name = \"servo-lag\"\nlag_ms = 20\n"), {}).correct(target).pose == plain);
  CHECK(distance(Corrector(with("name = \"backlash\"\nwidth_um = [9, 0, 0, 0, 0, 0]\n"), {}).correct(target).pose,
                 plain) > 1e-4);
}

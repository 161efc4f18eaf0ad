// The exact correction and the played machine in packs, against the same formulas put together from the double parts of
// machine and physics.
#include "compensate/exact/pose_batch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "compensate/exact/kernel_units.hpp"
#include "machine/axis_words.hpp"
#include "machine/condition.hpp"
#include "machine/forward.hpp"
#include "machine/machines.hpp"
#include "physics/error.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using compensate::exact::Friction;
using compensate::exact::InstructionSet;
using compensate::exact::kFound;
using compensate::exact::kSmall;
using compensate::exact::kWithin;
using compensate::exact::PoseBatch;
using compensate::exact::Setup;
namespace exact = compensate::exact;

namespace {

// A machine with one effect more than it has, or none.
struct Machine {
  machine::MachineModel model;
  physics::ForceModel forces{model};
  Setup setup;

  explicit Machine(machine::MachineModel read, std::size_t effect = physics::kEffects, unsigned seed = 1)
      : model(std::move(read)) {
    if (effect < physics::kEffects) add(physics::effect_infos()[effect], seed);
    setup.environment = forces.environment();
    setup.environment.tool_mass = 1.5;
    setup.rotation = model.rotation;
    setup.bounds = compensate::exact::sure_bounds(model.limits);
    setup.radius = machine::platform_radius(model.geometry);
    setup.sign_width_of_feed = 0.01;
    setup.time = 3000;
    setup.small_mm = 0.2;
    setup.small_deg = 0.1;
    setup.take_geometry(forces, machine::home_pose(model));
  }

  Machine(const Machine&) = delete;  // the set-up points into it
  Machine& operator=(const Machine&) = delete;

  void add(const physics::EffectInfo& info, unsigned seed) {
    Random random(seed);
    const int first = forces.add(info.name);
    auto into = forces.parameters.begin() + first;
    for (const physics::ParameterSpec& spec : info.parameters) {
      // of the bounds: corrections of up to a millimetre
      const double share = info.description && !spec.setting ? 1e-5 : 0.05;
      for (int i = 0; i < spec.size(); ++i) {
        const double drawn = uniform(random, share * spec.lower, share * spec.upper);
        *into++ = (spec.whole ? std::round(uniform(random, 0.51, 1.49)) : drawn) * spec.unit.si;
      }
    }
  }
};

struct Asked {
  AxisWords pose, slope, bend;
  double seconds;
};

// Within the limits and away from singularities; some at rest, some without a speed, some turning alone.
std::vector<Asked> drawn(const Machine& machine, std::size_t count, unsigned seed) {
  Random random(seed);
  std::vector<Asked> asked;
  while (asked.size() < count) {
    const Pose<double> pose = pose_within(machine.model.limits, random);
    const auto struts = machine::strut_geometry(machine.model.geometry, pose);
    if (machine::condition_number(struts, machine.setup.radius) > 15) continue;  // no digits to lose
    Asked point{machine::words_of(machine.model.rotation, pose, {}), {}, {}, 0.05};
    const std::size_t kind = asked.size() % 7;
    for (std::size_t a = 0; a < 6; ++a) {
      if (kind != 1 && (kind != 2 || a >= 3)) point.slope.values[a] = uniform(random, -1, 1);
      point.bend.values[a] = uniform(random, -1, 1);
    }
    if (kind == 3) point.seconds = -1;
    asked.push_back(point);
  }
  return asked;
}

PoseBatch batch_of(const std::vector<Asked>& asked) {
  PoseBatch batch;
  for (const Asked& point : asked) batch.add(point.pose, point.slope, point.bend, point.seconds);
  return batch;
}

Vector3<double> linear(const AxisWords& words) { return {words[Axis::X], words[Axis::Y], words[Axis::Z]}; }
Vector3<double> rotary(const AxisWords& words) { return {words[Axis::A], words[Axis::B], words[Axis::C]}; }

// The motion that a target stands for, and its v0 where the correction smooths friction.
physics::Motion<double> motion_of(const Machine& machine, const Asked& asked, double& smoothed_speed) {
  const machine::RotationOrder& order = machine.model.rotation;
  physics::Motion<double> motion;
  motion.pose = machine::pose_of(order, asked.pose);
  motion.time = machine.setup.time;
  const Vector3<double> abc = rotary(asked.pose) * kDeg;
  const Vector3<double> rate = rotary(asked.slope) * kDeg;
  motion.twist = {linear(asked.slope) * kMm, machine::angular_velocity<double>(order, abc, rate)};
  const double size = std::hypot(motion.twist.v_WT.norm(), machine.setup.radius * motion.twist.w_WP.norm());
  const double sign_speed = machine.setup.environment.sign_speed;
  const double per_second = asked.seconds >= 0 ? 1 / asked.seconds : (size > 0 ? 100 * sign_speed / size : 0);
  motion.twist.v_WT *= per_second;
  motion.twist.w_WP *= per_second;
  smoothed_speed = std::max(sign_speed, 0.01 * size * per_second);
  if (asked.seconds < 0) return motion;
  const double step = 1e-4;
  motion.acceleration.v_WT = linear(asked.bend) * kMm * per_second * per_second;
  motion.acceleration.w_WP = (machine::angular_velocity<double>(order, abc + step * rate, rate) -
                              machine::angular_velocity<double>(order, abc - step * rate, rate)) *
                             (per_second * per_second / (2 * step));
  return motion;
}

// T_c = FK(IK(T) - dL(T)), less what moves the tip without a strut.
AxisWords by_the_formula(const Machine& machine, const Asked& asked) {
  physics::Environment environment = machine.setup.environment;
  const physics::Motion<double> motion = motion_of(machine, asked, environment.sign_speed);
  const auto loads = physics::strut_stretch(machine.forces, environment, motion);
  const auto reached = machine::forward_near<double>(machine.forces.machine.geometry, motion.pose, loads.struts,
                                                     loads.jacobian, -loads.stretch, {.most_iterations = 16});
  REQUIRE(reached.converged);
  return machine::words_of(machine.model.rotation, machine::displaced<double>(reached.pose, -loads.tip), asked.pose);
}

template <class Numbers>
bool same_bits_of(const Numbers& a, const Numbers& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return std::equal(a.data(), a.data() + a.size(), b.data(), [&](double x, double y) { return bits(x) == bits(y); });
}
bool same_bits(const AxisWords& a, const AxisWords& b) { return same_bits_of(a.values, b.values); }
bool same_bits(const machine::PerStrut<double>& a, const machine::PerStrut<double>& b) { return same_bits_of(a, b); }

void check_same(const PoseBatch& a, std::size_t i, const PoseBatch& b, std::size_t k) {
  REQUIRE(a.state(i) == b.state(k));
  REQUIRE(same_bits(a.sign(i), b.sign(k)));
  if ((a.state(i) & kFound) != 0) REQUIRE(same_bits(a.commanded(i), b.commanded(k)));
  REQUIRE(a.carries(i) == b.carries(k));
  if (a.carries(i)) REQUIRE(same_bits(a.nut_tension(i), b.nut_tension(k)));
  if (a.carries(i)) REQUIRE(same_bits(a.length(i), b.length(k)));
  REQUIRE(a.stands(i) == b.stands(k));
  if (!a.stands(i)) return;
  const Pose<double> here = a.stands_at(i);
  const Pose<double> there = b.stands_at(k);
  REQUIRE(same_bits_of(here.p_WT, there.p_WT));
  REQUIRE(same_bits_of(here.R_WP, there.R_WP));
  REQUIRE(same_bits(a.speed(i), b.speed(k)));
}

void correct_and_play(PoseBatch& batch, const Machine& machine, const InstructionSet& with) {
  batch.correct(machine.setup, with);
  batch.play(machine.setup, Friction::as_modelled, with);
  batch.carry(machine.setup, Friction::as_modelled, with);
}

void check_formula(const Machine& machine, std::size_t poses) {
  const std::vector<Asked> asked = drawn(machine, poses, 3);
  PoseBatch batch = batch_of(asked);
  batch.correct(machine.setup);
  std::size_t unsure = 0;  // where the rows' order at home does not suit the pose
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if ((batch.state(i) & kFound) == 0) {
      ++unsure;
      continue;
    }
    const AxisWords off = batch.commanded(i) - by_the_formula(machine, asked[i]);
    for (const double x : off.values) CHECK(std::abs(x) < 1e-9);  // mm, deg
  }
  CHECK(unsure <= poses / 50);
}

// Where the machine stands, against physics::tip_error.
void check_played(const Machine& machine, std::size_t poses) {
  const std::vector<Asked> asked = drawn(machine, poses, 4);
  for (const Friction friction : {Friction::as_modelled, Friction::smoothed}) {
    PoseBatch batch = batch_of(asked);
    batch.play(machine.setup, friction);
    std::size_t unsure = 0;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      physics::Environment environment = machine.setup.environment;
      double smoothed_speed = 0;
      const physics::Motion<double> motion = motion_of(machine, asked[i], smoothed_speed);
      if (friction == Friction::smoothed) environment.sign_speed = smoothed_speed;
      const auto error = physics::tip_error(machine.forces, environment, motion);
      if (!batch.stands(i)) {
        ++unsure;
        continue;
      }
      REQUIRE(error.converged());
      const Pose<double> stands = batch.stands_at(i);
      CHECK((stands.p_WT - error.pose.p_WT).norm() < 2e-12);
      CHECK((stands.R_WP - error.pose.R_WP).norm() < 1e-11);
      const auto struts = machine::strut_geometry(machine.forces.machine.geometry, motion.pose);
      CHECK((batch.speed(i) - physics::strut_rates(struts, motion, environment).speed).norm() < 1e-14);
    }
    CHECK(unsure <= poses / 50);
  }
}

// What the struts carry, against physics::strut_stretch.
void check_carried(const Machine& machine, std::size_t poses) {
  const std::vector<Asked> asked = drawn(machine, poses, 8);
  PoseBatch batch = batch_of(asked);
  batch.carry(machine.setup, Friction::as_modelled);
  std::size_t unsure = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (!batch.carries(i)) {
      ++unsure;
      continue;
    }
    double ignored = 0;
    const physics::Motion<double> motion = motion_of(machine, asked[i], ignored);
    const auto loads = physics::strut_stretch(machine.forces, machine.setup.environment, motion);
    CHECK((batch.length(i) - loads.struts.length).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((batch.nut_tension(i) - loads.nut_tension).norm() < 1e-7 * (1 + loads.nut_tension.norm()));
  }
  CHECK(unsure <= poses / 50);
}

}  // namespace

TEST_CASE("the correction in packs is the formula's, over the workspaces of three machines") {
  for (machine::MachineModel& model : three_machines()) {
    INFO(model.name);
    check_formula(Machine(std::move(model)), 500);
  }
}

TEST_CASE("played in packs the machine stands where the error says, over three workspaces and with every effect") {
  for (machine::MachineModel& model : three_machines()) {
    INFO(model.name);
    check_played(Machine(std::move(model)), 200);
  }
  for (std::size_t effect = physics::kBaseEffects; effect < physics::kEffects; ++effect) {
    INFO(physics::effect_infos()[effect].name);
    check_played(Machine(pm600_like(), effect, 19 + static_cast<unsigned>(effect)), 64);
  }
}

TEST_CASE("in packs the struts carry what the physics says, with every effect") {
  for (std::size_t effect = physics::kBaseEffects; effect < physics::kEffects; ++effect) {
    INFO(physics::effect_infos()[effect].name);
    check_carried(Machine(pm600_like(), effect, 23 + static_cast<unsigned>(effect)), 64);
  }
}

TEST_CASE("the correction in packs is the formula's with every effect") {
  for (std::size_t effect = physics::kBaseEffects; effect < physics::kEffects; ++effect) {
    INFO(physics::effect_infos()[effect].name);
    check_formula(Machine(pm600_like(), effect, 7 + static_cast<unsigned>(effect)), 64);
  }
}

TEST_CASE("every instruction set gives the same bits, whatever stands beside a pose and wherever it stands") {
  std::vector<std::size_t> effects{physics::kEffects};  // none
  for (std::size_t effect = physics::kBaseEffects; effect < physics::kEffects; ++effect) effects.push_back(effect);
  for (const std::size_t effect : effects) {
    const Machine machine(pm600_like(), effect, 11);
    std::vector<Asked> asked = drawn(machine, 41, 5);
    asked[9].pose[Axis::B] = 90;                   // near the lock
    asked[10].pose = {{0, 0, -300, 40, -50, 80}};  // through the base
    asked[11].pose[Axis::X] = std::nan("");
    asked[12].pose[Axis::A] = 1e9;
    PoseBatch alone = batch_of(asked);
    correct_and_play(alone, machine, compensate::exact::instruction_sets().front());
    CHECK((alone.state(9) & kFound) == 0);
    CHECK((alone.state(11) & kFound) == 0);
    CHECK((alone.state(12) & kFound) == 0);
    CHECK((alone.state(13) & kFound) != 0);
    for (const InstructionSet& set : compensate::exact::instruction_sets()) {
      INFO(set.name);
      PoseBatch together = batch_of(asked);
      correct_and_play(together, machine, set);
      std::vector<Asked> turned = asked;
      std::reverse(turned.begin(), turned.end());
      PoseBatch backwards = batch_of(turned);
      correct_and_play(backwards, machine, set);
      for (std::size_t i = 0; i < asked.size(); ++i) {
        check_same(together, i, alone, i);
        check_same(backwards, asked.size() - 1 - i, alone, i);
      }
    }
  }
}

// Units kernel_any, kernel_x86_64_v2, kernel_x86_64_v3 and kernel_x86_64_v4.
TEST_CASE("a processor is offered what every one runs, then each level that it has, the widest last") {
  std::vector<std::string> names{"one lane", "any processor"};
#ifdef PLUMBLINE_X86_64_UNITS
  const bool has[] = {exact::has_x86_64_v2(), exact::has_x86_64_v3(), exact::has_x86_64_v4()};
  for (int level = 2; level <= 4; ++level) {
    if (has[level - 2]) names.push_back("x86-64-v" + std::to_string(level));
    if (level > 2 && has[level - 2]) CHECK(has[level - 3]);
  }
#endif
  std::vector<std::string> offered;
  int lanes = 0;
  for (const InstructionSet& set : exact::instruction_sets()) {
    offered.emplace_back(set.name);
    CHECK(set.lanes >= lanes);
    lanes = set.lanes;
  }
  CHECK(offered == names);
}

TEST_CASE("a batch that is used again keeps nothing of what it held") {
  const Machine machine(pm600_like());
  const std::vector<Asked> asked = drawn(machine, 19, 6);
  PoseBatch fresh = batch_of({asked.begin() + 8, asked.end()});
  const InstructionSet& best = compensate::exact::instruction_sets().back();
  correct_and_play(fresh, machine, best);
  PoseBatch used = batch_of(asked);
  correct_and_play(used, machine, best);
  used.clear();
  CHECK(used.size() == 0);
  for (std::size_t i = 8; i < asked.size(); ++i) {
    used.add(asked[i].pose, asked[i].slope, asked[i].bend, asked[i].seconds);
  }
  correct_and_play(used, machine, best);
  for (std::size_t i = 0; i < fresh.size(); ++i) check_same(used, i, fresh, i);
}

TEST_CASE("what is said to be within the limits is, and what lies well inside is said to be") {
  for (machine::MachineModel& model : three_machines()) {
    model.limits.condition_max = 60;
    Machine machine(model);
    Random random(17);
    std::vector<Asked> asked;
    for (int i = 0; i < 400; ++i) {
      Pose<double> pose = pose_within(model.limits, random);
      pose.p_WT *= 1.05;
      asked.push_back({machine::words_of(model.rotation, pose, {}), {}, {}, -1});
    }
    PoseBatch batch = batch_of(asked);
    batch.correct(machine.setup);
    int within = 0;
    int broken = 0;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if ((batch.state(i) & kFound) == 0) continue;
      const Pose<double> programmed = machine::pose_of(model.rotation, asked[i].pose);
      const Pose<double> commanded = machine::pose_of(model.rotation, batch.commanded(i));
      const bool kept = machine::check_programmed(model.limits, programmed).empty() &&
                        machine::check_compensated(model.limits, model.geometry, commanded).empty();
      const bool said = (batch.state(i) & kWithin) != 0;
      if (said) CHECK(kept);
      within += said ? 1 : 0;
      broken += kept ? 0 : 1;
      const AxisWords shift = batch.commanded(i) - asked[i].pose;
      const double turn = rotary(shift).cwiseAbs().maxCoeff();
      if (std::abs(length_mm(shift) - 0.2) < 1e-9 || std::abs(turn - 0.1) < 1e-9) continue;
      CHECK(((batch.state(i) & kSmall) != 0) == (length_mm(shift) < 0.2 && turn < 0.1));
    }
    CHECK(within > 40);
    CHECK(broken > 40);
  }
}

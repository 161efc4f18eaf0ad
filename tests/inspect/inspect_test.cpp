// Of drawn machines, by a simulator of its own: scripts/spoil.
#include "inspect/inspect.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <random>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "inspect/spoiled.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using inspect::Fault;
using inspect::FaultKind;
using measure::Run;

namespace {

struct Case {
  FaultKind kind;
  std::function<void(Run&)> spoil;
};

}  // namespace

TEST_CASE("nothing is wrong with measurements of a machine that departs from its model") {
  const inspect::Inspection inspection = Measured().inspection();
  CHECK(inspection.faults.empty());
  CHECK_FALSE(inspection.blocks());
  CHECK(inspection.usual == Approx(1).margin(0.25));
  REQUIRE(inspection.runs.size() == 8);
  for (const inspect::RunMisfit& run : inspection.runs) CHECK(run.all < 1.4);
}

TEST_CASE("what is wrong with one run is found, and what would mend it") {
  const std::vector<Case> cases{
      {FaultKind::direction,
       [](Run& run) {
         run.direction = measure::Direction::cw;
         for (double& angle : run.angle) angle = -angle;
       }},
      {FaultKind::angle_zero,
       [](Run& run) {
         for (double& angle : run.angle) angle += 0.5;
       }},
      {FaultKind::tilt, [](Run& run) { run.tilt = -run.tilt; }},
      {FaultKind::payload, [](Run& run) { run.payload_mass = 20; }},
      {FaultKind::bar_sign, [](Run& run) { multiply(run.radial, -1); }},
      {FaultKind::motor_sign, [](Run& run) { multiply(run.torque[2], -1); }},
      {FaultKind::motors_swapped, [](Run& run) { std::swap(run.torque[1], run.torque[4]); }},
      {FaultKind::torque_unit,
       [](Run& run) {
         for (auto& torque : run.torque) multiply(torque, 5);
       }},
      {FaultKind::drift,
       [](Run& run) {
         for (std::size_t i = 0; i < run.samples(); ++i) run.radial[i] += 30e-6 * static_cast<double>(i) / 72;
       }},
  };
  for (const Case& of : cases) {
    INFO(to_text(of.kind));
    Measured measured;
    of.spoil(measured.runs[1]);
    const inspect::Inspection inspection = measured.inspection();
    REQUIRE(inspection.faults.size() == 1);
    const Fault& fault = inspection.faults[0];
    INFO("found " << to_text(fault.kind));
    const bool said = fault.kind == of.kind ||
                      std::find(fault.or_these.begin(), fault.or_these.end(), of.kind) != fault.or_these.end();
    CHECK(said);
    CHECK(fault.runs == std::vector<std::size_t>{1});
    CHECK(fault.blocks);
    CHECK(fault.before > 1.3 * fault.after);
    CHECK(fault.after < 1.5);
    CHECK(fault.nats > 25);
  }
}

TEST_CASE("motors in another order are told, in one run and in all, be they two pairs or three in turn") {
  const std::vector<std::array<std::size_t, 6>> orders{{1, 0, 3, 2, 4, 5}, {1, 2, 0, 3, 4, 5}, {0, 5, 4, 3, 2, 1}};
  for (const std::array<std::size_t, 6>& order : orders) {
    for (const bool all : {false, true}) {
      CAPTURE(order, all);
      Measured measured;
      std::vector<int> moved;
      for (std::size_t motor = 0; motor < 6; ++motor) {
        if (order[motor] != motor) moved.push_back(static_cast<int>(motor + 1));
      }
      for (std::size_t r = 0; r < measured.runs.size(); ++r) {
        if (r != 3 && !all) continue;
        const auto torque = measured.runs[r].torque;
        for (std::size_t motor = 0; motor < 6; ++motor) measured.runs[r].torque[order[motor]] = torque[motor];
      }
      const inspect::Inspection inspection = measured.inspection();
      REQUIRE(inspection.faults.size() == 1);
      const Fault& fault = inspection.faults[0];
      CHECK(fault.kind == FaultKind::motors_swapped);
      CHECK(fault.all == all);
      CHECK(fault.channels == moved);
      for (std::size_t i = 0; i < moved.size(); ++i) {
        CHECK(fault.values.at(i) == static_cast<double>(order[static_cast<std::size_t>(moved[i] - 1)] + 1));
      }
    }
  }
}

TEST_CASE("a payload that hung there is told in kg") {
  Measured measured;
  measured.runs[2].payload_mass = 12;
  const inspect::Inspection inspection = measured.inspection();
  REQUIRE(inspection.faults.size() == 1);
  REQUIRE(inspection.faults[0].kind == FaultKind::payload);
  CHECK(inspection.faults[0].values.at(0) == Approx(0).margin(0.5));
}

TEST_CASE("what is wrong alike with all runs is said of all") {
  for (const auto& [kind, by] : {std::pair{FaultKind::bar_sign, -1.0}, std::pair{FaultKind::torque_unit, 8.0}}) {
    INFO(to_text(kind));
    Measured measured;
    for (Run& run : measured.runs) {
      if (kind == FaultKind::bar_sign) multiply(run.radial, by);
      for (std::size_t j = 0; kind == FaultKind::torque_unit && j < 6; ++j) multiply(run.torque[j], by);
    }
    const inspect::Inspection inspection = measured.inspection();
    REQUIRE(inspection.faults.size() == 1);
    CHECK(inspection.faults[0].kind == kind);
    CHECK(inspection.faults[0].all);
    if (kind == FaultKind::torque_unit) CHECK(inspection.faults[0].values.at(0) == Approx(8).epsilon(0.25));
  }
}

TEST_CASE("centres that have another sign in all runs are told") {
  const std::vector<std::function<void(Run&)>> slips{[](Run& run) { run.centre_W.x() *= -1; },
                                                     [](Run& run) { run.centre_W.y() *= -1; },
                                                     [](Run& run) { run.centre_W.z() *= -1; }};
  for (const auto& slip : slips) {
    Measured measured;
    std::vector<Vector3<double>> right;
    for (const Run& run : measured.runs) right.push_back(run.centre_W);
    for (Run& run : measured.runs) slip(run);
    const inspect::Inspection inspection = measured.inspection();
    REQUIRE(inspection.faults.size() == 1);
    const Fault& fault = inspection.faults[0];
    CAPTURE(to_text(fault.kind));
    CHECK(fault.kind == FaultKind::centre);
    CHECK(fault.all);
    REQUIRE(fault.values.size() == 3);
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(fault.values[static_cast<std::size_t>(axis)] == Approx(right[fault.runs[0]][axis]).margin(1e-3));
    }
  }
}

TEST_CASE("one line about the bar or the circle that is wrong in all runs is told") {
  const auto stated = [](double bar_mm, double radius_mm, double turned_deg = 0) {
    Measured measured;
    const double bar = measured.runs[0].bar_length(), radius = measured.runs[0].radius;
    for (Run& run : measured.runs) {
      run.bar = bar + bar_mm * kMm;
      run.radius += radius_mm * kMm;
      run.feed *= run.radius / radius;
      for (double& angle : run.angle) angle += turned_deg * kDeg;
    }
    const inspect::Inspection inspection = measured.inspection();
    return std::tuple(inspection, bar, radius);
  };
  for (const double off : {25.0, 50.0}) {
    INFO("the bar by " << off << " mm");
    const auto& [inspection, bar, radius] = stated(off, 0);
    REQUIRE(inspection.faults.size() == 1);
    CHECK(inspection.faults[0].kind == FaultKind::bar_length);
    CHECK(inspection.faults[0].all);
    CHECK(inspection.faults[0].values.at(0) == Approx(bar).margin(0.5 * kMm));
  }
  for (const double off : {-20.0, -40.0}) {
    INFO("the radius by " << off << " mm");
    const auto& [inspection, bar, radius] = stated(0, off);
    REQUIRE(inspection.faults.size() == 1);
    CHECK((inspection.faults[0].kind == FaultKind::radius || inspection.faults[0].kind == FaultKind::bar_length));
    CHECK(inspection.faults[0].all);
  }
  for (const double off : {5.0, -4.0, 11.0}) {
    INFO("the angles by " << off << " deg");
    const auto& [inspection, bar, radius] = stated(0, 0, off);
    REQUIRE(inspection.faults.size() == 1);
    CHECK(inspection.faults[0].kind == FaultKind::angle_zero);
    CHECK(inspection.faults[0].all);
    CHECK(inspection.faults[0].values.at(0) == Approx(-off * kDeg).margin(0.5 * kDeg));
  }
  CHECK(std::get<0>(stated(0.3, 0, 0.3)).faults.empty());  // no more than a model may be off
}

TEST_CASE("torques that have lost their signs are told") {
  Measured measured;
  const std::vector<Run> signed_ones = measured.runs;
  for (Run& run : measured.runs) {
    for (std::vector<double>& torque : run.torque) {
      for (double& value : torque) value = std::abs(value);
    }
  }
  const inspect::Inspection inspection = measured.inspection();
  REQUIRE(inspection.faults.size() == 1);
  CHECK(inspection.faults[0].kind == FaultKind::motors_unsigned);
  CHECK(inspection.faults[0].all);
  CHECK(inspection.blocks());
  // one that is negative says that there are signs
  for (std::size_t r = 0; r < signed_ones.size(); ++r) measured.runs[r].torque[4] = signed_ones[r].torque[4];
  for (const inspect::Fault& fault : measured.inspection().faults) CHECK(fault.kind != FaultKind::motors_unsigned);
}

TEST_CASE("a motor that reads too much in all runs is told") {
  for (const double zero : {0.5, -0.4}) {
    Measured measured;
    for (Run& run : measured.runs) {
      for (double& torque : run.torque[1]) torque += zero;
    }
    const inspect::Inspection inspection = measured.inspection();
    REQUIRE(inspection.faults.size() == 1);
    CHECK(inspection.faults[0].kind == FaultKind::motor_zero);
    CHECK(inspection.faults[0].all);
    CHECK(inspection.faults[0].values.at(0) == Approx(zero).margin(0.05));
    CHECK(inspection.faults[0].after < 1.1);
  }
}

TEST_CASE("a bar that drifts alike in all runs is told") {
  for (const double size : {12e-6, -8e-6}) {
    CAPTURE(size);
    Measured measured;
    for (Run& run : measured.runs) {
      const auto samples = static_cast<double>(run.samples());
      for (std::size_t i = 0; i < run.samples(); ++i) run.radial[i] += size * static_cast<double>(i) / samples;
    }
    const inspect::Inspection inspection = measured.inspection();
    REQUIRE(inspection.faults.size() == 1);
    CHECK(inspection.faults[0].kind == FaultKind::drift);
    CHECK(inspection.faults[0].all);
    CHECK(inspection.faults[0].values.at(0) == Approx(size).epsilon(0.4));
  }
}

TEST_CASE("what is said of all runs explains most of what is off and leaves little more than noise") {
  // half of the runs are wrong, each in a way that no change of all of them mends
  const std::vector<std::function<void(Run&)>> spoils{
      [](Run& run) { std::swap(run.torque[1], run.torque[2]); },
      [](Run& run) {
        for (auto& torque : run.torque) multiply(torque, 1 / 0.7);
      },
      [](Run& run) {
        for (double& angle : run.angle) angle += 1;
      },
      [](Run& run) { multiply(run.radial, -1.5); },
  };
  for (const auto& spoil : spoils) {
    CAPTURE(&spoil - spoils.data());
    Measured measured;
    for (std::size_t r = 0; r < measured.runs.size(); r += 2) spoil(measured.runs[r]);
    for (const Fault& fault : measured.inspection().faults) {
      if (!fault.all || fault.after == 0) continue;
      CAPTURE(to_text(fault.kind), fault.before, fault.after);
      CHECK(fault.after < 1.5);
      CHECK(fault.before - fault.after > 0.5 * (fault.before - 1));
    }
  }
}

TEST_CASE("readings of all runs in mm, or in inches, are told by a noise that no bar has") {
  for (const double um : {1e-3, 1 / 25400.0}) {
    Measured measured;
    for (Run& run : measured.runs) multiply(run.radial, um);
    const inspect::Inspection inspection = measured.inspection();
    REQUIRE(inspection.faults.size() == 1);
    CHECK(inspection.faults[0].kind == FaultKind::bar_unit);
    CHECK(inspection.faults[0].all);
    CHECK(inspection.faults[0].values.at(0) == Approx(um).epsilon(1e-9));
    CHECK(inspection.faults[0].values.at(1) < 0.02e-6);
  }
}

TEST_CASE("readings of all runs in thousandths of an inch are told though the bar is noisy") {
  for (const bool in_um : {false, true}) {
    CAPTURE(in_um);
    Measured measured;
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 1.5e-6);
    for (Run& run : measured.runs) {
      for (double& reading : run.radial) reading = (reading + noise(random)) / (in_um ? 1 : 25.4);
    }
    const inspect::Inspection inspection = measured.inspection();
    if (in_um) {
      CHECK(inspection.faults.empty());
      continue;
    }
    REQUIRE(inspection.faults.size() == 1);
    CHECK(inspection.faults[0].kind == FaultKind::bar_unit);
    CHECK(inspection.faults[0].all);
    CHECK(inspection.faults[0].values == std::vector<double>{1 / 25.4});
  }
}

TEST_CASE("several runs that ask for the same setting by little are told, and stand in nobody's way") {
  const bool several = GENERATE(false, true);
  CAPTURE(several);
  Measured measured;
  measured.runs[5].payload_mass = 4;
  if (several) measured.runs[3].payload_mass = 4;
  inspect::InspectOptions options;
  options.clearly = 3;  // times: few samples have little noise to be compared with
  const inspect::Inspection inspection = inspect::inspect(measured.machine, measured.runs, options);
  REQUIRE(inspection.faults.size() == (several ? 2 : 1));
  CHECK(inspection.blocks() == !several);
  for (const Fault& fault : inspection.faults) {
    CHECK(fault.kind == FaultKind::payload);
    CHECK(fault.may_be_effect == several);
    CHECK(fault.blocks == !several);
  }
}

TEST_CASE("a channel of one run is noisy where most of its samples are off, and not where a few are") {
  const auto disturb = [](Run& run, std::size_t every, double um) {
    for (std::size_t i = 0; i < run.samples(); i += every) run.radial[i] += (i / every % 3 == 0 ? -um : um) * 1e-6;
  };
  Measured noisy;
  Random random(3);
  std::normal_distribution<double> noise(0, 5e-6);
  for (double& radial : noisy.runs[2].radial) radial += noise(random);
  const inspect::Inspection found = noisy.inspection();
  REQUIRE(found.faults.size() == 1);
  CHECK(found.faults[0].kind == FaultKind::noisy);
  Measured steps;
  disturb(steps.runs[2], 14, 7);
  REQUIRE(steps.inspection().faults.size() == 1);
  CHECK(steps.inspection().faults[0].kind == FaultKind::stands_out);
  for (const std::size_t other : {4U, 6U}) disturb(steps.runs[other], 14, 8);
  for (const Fault& fault : steps.inspection().faults) CHECK(fault.runs != std::vector<std::size_t>{2});
}

TEST_CASE("an effect that the model lacks is no spoiled run") {
  Measured measured;
  const physics::ForceModel forces(measured.machine);
  identify::Unknowns unknowns = identify::nuisances(measured.machine, forces);
  const std::size_t backlash = unknowns.add("backlash", "width_um", 3);
  Random random(8);
  Eigen::VectorXd values = drawn(unknowns, random);
  values[static_cast<Eigen::Index>(backlash)] = 20e-6;
  measured.runs = plumbline::testing::measured(wider_plan(72), unknowns.at(values), 0.5e-6, 0.05, random);
  CHECK(measured.inspection().faults.empty());
}

TEST_CASE("angles that are half a turn off are no clock, though motors read alike") {
  for (const std::size_t run : {1U, 3U, 6U}) {
    INFO("run " << run);
    Measured measured(11);
    for (double& angle : measured.runs[run].angle) angle += 180 * kDeg;
    const std::vector<Fault> faults = measured.inspection().faults;
    REQUIRE(faults.size() == 1);
    const std::vector<FaultKind>& others = faults[0].or_these;
    const bool named = faults[0].kind == FaultKind::angle_zero ||
                       std::find(others.begin(), others.end(), FaultKind::angle_zero) != others.end();
    CHECK(named);
    CHECK(faults[0].runs == std::vector<std::size_t>{run});
  }
}

TEST_CASE("a run that the machine cannot make is said, and the others are looked at") {
  Measured measured;
  measured.runs[0].centre_W.z() = -3;
  const inspect::Inspection inspection = measured.inspection();
  REQUIRE(inspection.faults.size() == 1);
  CHECK(inspection.faults[0].kind == FaultKind::unreachable);
  CHECK(inspection.runs[0].all == 0);
  CHECK(inspection.runs[1].all > 0);
}

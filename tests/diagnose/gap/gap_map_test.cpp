#include "diagnose/gap/gap_map.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <catch2/catch.hpp>

#include "diagnose/readings/sample_states.hpp"
#include "diagnose/usual_noise.hpp"
#include "identify/plans.hpp"

namespace plumbline::diagnose {
namespace {

using identify::RunEquations;
using measure::Direction;
using measure::Run;

constexpr double kBar = 1e-6;

// The residuals of a run as functions of its angle: of the bar and of the motors.
RunEquations residual_of(const Run& run, const std::function<double(double)>& radial,
                         const std::function<double(double)>& torque) {
  RunEquations equations;
  equations.samples = static_cast<Eigen::Index>(run.samples());
  equations.residual.resize(identify::kChannels * equations.samples);
  for (int channel = 0; channel < identify::kChannels; ++channel) {
    equations.channels.push_back(channel);
    for (Eigen::Index i = 0; i < equations.samples; ++i) {
      const double angle = run.angle[static_cast<std::size_t>(i)];
      equations.residual[channel * equations.samples + i] = channel == 0 ? radial(angle) : torque(angle);
    }
  }
  return equations;
}

GapMap where(const std::vector<Run>& runs, const std::vector<RunEquations>& residuals) {
  const machine::MachineModel machine = testing::pm600_like();
  return gap_map_of(machine.rotation, runs, physics::ForceModel(machine), residuals, testing::usual_noise());
}

const Contrast& by(const GapMap& where, Difference what) {
  const auto found =
      std::find_if(where.contrasts.begin(), where.contrasts.end(), [&](const Contrast& c) { return c.by == what; });
  REQUIRE(found != where.contrasts.end());
  return *found;
}

TEST_CASE("what turns its sign with the direction is odd, what does not is even") {
  const std::vector<Run> runs{testing::circle_run({0, 100, -1008}, {0, 0, 0}, Direction::ccw, 72),
                              testing::circle_run({0, 100, -1008}, {0, 0, 0}, Direction::cw, 72)};
  const auto even = [](double angle) { return 2 * kBar * std::cos(3 * angle); };
  const auto odd = [](double angle) { return 0.3 * std::sin(2 * angle); };
  const auto turned = [&](double angle) { return -odd(angle); };
  const GapMap found = where(runs, {residual_of(runs[0], even, odd), residual_of(runs[1], even, turned)});
  CHECK(found.contrasts.size() == 1);
  const Contrast& direction = by(found, Difference::direction);
  CHECK(direction.pairs == 1);
  CHECK(direction.differs.radial < 1e-12);
  CHECK(direction.common.radial == Approx(2 * kBar));  // sqrt 2 times the rms of a wave
  CHECK(direction.common.torque < 1e-6);
  CHECK(direction.differs.torque == Approx(0.3));
}

TEST_CASE("feed, payload and time are compared between runs that differ in nothing else") {
  std::vector<Run> runs(4, testing::circle_run({0, 100, -1008}, {0, 0, 0}, Direction::ccw, 36));
  runs[1].feed *= 6;
  runs[2].payload_mass = 20;
  runs[3].start = 3600;
  const auto nothing = [](double) { return 0.0; };
  std::vector<RunEquations> residuals;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double size = static_cast<double>(i) * kBar;
    residuals.push_back(residual_of(
        runs[i], [=](double angle) { return size * std::sin(2 * angle); }, nothing));
  }
  const GapMap found = where(runs, residuals);
  // runs 0 and 3 are repeats: each is compared with the fast and with the loaded one
  CHECK(by(found, Difference::feed).pairs == 2);
  CHECK(by(found, Difference::payload).pairs == 2);
  CHECK(by(found, Difference::time).pairs == 1);
  CHECK(by(found, Difference::time).differs.radial == Approx(3 * kBar / 2));
  const auto slow = std::find_if(found.groups.begin(), found.groups.end(),
                                 [](const RunGroup& g) { return g.by == Grouping::feed && g.from == 1000; });
  REQUIRE(slow != found.groups.end());
  CHECK(slow->runs == 3);
  CHECK(slow->rms.radial == Approx(kBar * std::sqrt((0 + 4 + 9) / 3.0 / 2)));
}

TEST_CASE("waves and arcs show where on the circle the gap is") {
  const std::vector<Run> runs{testing::circle_run({0, 100, -1008}, {0, 0, 0}, Direction::cw, 120)};
  const auto wave = [](double angle) { return 3 * kBar * std::cos(4 * angle - 1); };
  const auto arc = [](double angle) {
    const double turn = angle - 2 * M_PI * std::floor(angle / (2 * M_PI));
    return turn > M_PI / 2 && turn < 2 * M_PI / 3 ? 1.0 : 0.0;
  };
  const GapMap found = where(runs, {residual_of(runs[0], wave, arc)});
  REQUIRE(found.channels.size() == 7);
  const ChannelResiduals& radial = found.channels[0];
  CHECK(radial.rms == Approx(3 * kBar / std::sqrt(2)));
  CHECK(radial.waves[3] == Approx(3 * kBar / std::sqrt(2)));
  CHECK(radial.waves[2] < 1e-9);
  // white noise of variance 1 makes a wave of rms sqrt(2 / n)
  CHECK(radial.wave_noise[3] == Approx(0.5e-6 * std::sqrt(2 / 120.0)));
  const auto& arcs = found.channels[1].arcs;
  CHECK(std::max_element(arcs.begin(), arcs.end()) - arcs.begin() == 3);
  CHECK(arcs[5] == 0);
}

TEST_CASE("a step where a strut turns around is found on that strut") {
  const machine::MachineModel machine = testing::pm600_like();
  const physics::ForceModel forces(machine);
  const std::vector<Run> runs = testing::wider_plan(120);
  std::vector<RunEquations> residuals;
  for (const Run& run : runs) {
    const std::vector<SampleState> states = sample_states(machine.rotation, forces, run);
    std::size_t i = 0;
    residuals.push_back(residual_of(
        run, [](double) { return 0.0; }, [](double) { return 0.0; }));
    for (const SampleState& state : states) {
      // torque of strut 2 follows the sign of its speed
      residuals.back().residual[2 * residuals.back().samples + static_cast<Eigen::Index>(i++)] =
          state.speed[1] < 0 ? -0.2 : 0.2;
    }
  }
  const GapMap found = where(runs, residuals);
  REQUIRE(found.reversals.size() == 6);
  CHECK(found.reversals[1].count >= 8);
  CHECK(found.reversals[1].torque == Approx(0.4).epsilon(0.1));
  CHECK(found.reversals[0].torque == 0);
  CHECK(found.reversals[1].length == 0);
}

}  // namespace
}  // namespace plumbline::diagnose

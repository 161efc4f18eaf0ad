#include "inspect/records/records.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "inspect/spoiled.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using inspect::FaultKind;

namespace {

std::vector<FaultKind> kinds_of(const std::vector<measure::Run>& runs) {
  std::vector<FaultKind> kinds;
  for (const inspect::Fault& fault : inspect::record_faults(runs)) kinds.push_back(fault.kind);
  return kinds;
}

}  // namespace

TEST_CASE("records of a machine have no flaw") { CHECK(kinds_of(Measured().runs).empty()); }

TEST_CASE("single spikes are found, and left out when they are few") {
  Measured measured;
  measure::Run& run = measured.runs[3];
  run.radial[10] += 50e-6;
  run.torque[2][40] -= 20;
  CHECK(inspect::spikes_in(run) == std::vector<std::size_t>{10, 40});
  CHECK(kinds_of(measured.runs) == std::vector<FaultKind>{FaultKind::spikes});
  const std::vector<measure::Run> mended = inspect::cleaned(measured.runs, {});
  CHECK(mended[3].samples() == run.samples() - 2);
  CHECK(mended[3].radial[10] == run.radial[11]);
  CHECK(mended[3].torque[5].size() == run.samples() - 2);
  CHECK(mended[2].samples() == measured.runs[2].samples());
  // a step is no spike
  measure::Run stepped = Measured().runs[3];
  for (std::size_t i = 30; i < stepped.samples(); ++i) stepped.radial[i] += 50e-6;
  CHECK(inspect::spikes_in(stepped).empty());
}

TEST_CASE("a spike on a steep slope is found by what it is off its neighbours, whatever these have in common") {
  Random random(7);
  std::normal_distribution<double> noise(0, 0.5e-6);
  for (const double amplitude : {20e-6, 200e-6, 400e-6}) {
    for (const double height : {15e-6, -20e-6, 30e-6}) {
      CAPTURE(amplitude, height);
      measure::Run run = Measured().runs[3];
      const auto wave = [&](std::size_t i) {
        return amplitude * std::sin(4 * std::numbers::pi * static_cast<double>(i) / 72);
      };
      for (std::size_t i = 0; i < run.samples(); ++i) run.radial[i] = wave(i) + noise(random);
      const measure::Run smooth = run;
      CHECK(inspect::spikes_in(smooth).empty());
      for (const std::size_t at : {0U, 18U, 20U, 23U, 71U}) {  // on the slope, the bend, the top; at either end
        run.radial[at] += height;
        CHECK(inspect::spikes_in(run) == std::vector<std::size_t>{at});
        run.radial[at] = smooth.radial[at];
      }
      for (std::size_t i = 30; i < run.samples(); ++i) run.radial[i] += height;  // a step is none, nor is a kink
      for (std::size_t i = 30; i < 50; ++i) run.radial[i] += height * static_cast<double>(i - 30) / 3;
      CHECK(inspect::spikes_in(run).empty());
    }
  }
}

TEST_CASE("noisy steps, as friction makes them where struts turn round, are no spikes") {
  Random random(11);
  std::normal_distribution<double> noise(0, 0.05);
  const measure::Run drawn_once = Measured().runs[3];
  for (const double step : {0.7, 1.0, 1.5}) {
    std::size_t found = 0;
    for (int draw = 0; draw < 300; ++draw) {
      measure::Run run = drawn_once;
      for (auto& torque : run.torque) {
        for (std::size_t i = 0; i < torque.size(); ++i) torque[i] = (i >= 20 && i < 50 ? step : 0) + noise(random);
      }
      found += inspect::spikes_in(run).size();
    }
    CAPTURE(step);
    CHECK(found <= 1);  // of 3600 steps
  }
}

TEST_CASE("readings without noise have no spikes") {
  for (const double amplitude : {0.2, 2.0, 6.0}) {
    measure::Run run = Measured().runs[3];
    for (std::size_t j = 0; j < 6; ++j) {
      for (std::size_t i = 0; i < run.samples(); ++i) {
        const double way = 2 * std::numbers::pi * (static_cast<double>(i) / 72 + 0.1 * static_cast<double>(j));
        run.torque[j][i] = amplitude * std::sin(way) + (std::cos(way) > 0 ? 0.5 : -0.5);
      }
    }
    CHECK(inspect::spikes_in(run).empty());
  }
}

TEST_CASE("a gap is said in degrees, and stands in nobody's way") {
  Measured measured;
  measured.runs[1] = measure::without_samples(measured.runs[1], {20, 21, 22, 23, 24});
  const auto faults = inspect::record_faults(measured.runs);
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].kind == FaultKind::gaps);
  CHECK(faults[0].values.at(0) / kDeg == Approx(30));
  CHECK_FALSE(faults[0].blocks);
}

TEST_CASE("a channel that stands still, one that is cut off") {
  Measured measured;
  for (double& value : measured.runs[0].torque[4]) value = 1.25;
  std::vector<double>& radial = measured.runs[2].radial;
  const auto [least, most] = std::minmax_element(radial.begin(), radial.end());
  const double middle = (*least + *most) / 2;
  for (double& value : radial) value = std::min(value, middle);
  const auto faults = inspect::record_faults(measured.runs);
  REQUIRE(faults.size() == 2);
  CHECK(faults[0].kind == FaultKind::stuck);
  CHECK(faults[0].channels == std::vector<int>{5});
  CHECK(faults[1].kind == FaultKind::clipped);
  CHECK(faults[1].runs == std::vector<std::size_t>{2});
}

TEST_CASE("readings in coarse steps are not cut off, and those that are cut off are, coarse or not") {
  const auto steps = [](std::vector<double>& values, double step) {
    for (double& value : values) value = step * std::round(value / step);
  };
  for (const double step : {0.12, 0.2, 0.5}) {
    CAPTURE(step);
    Measured measured;
    for (measure::Run& run : measured.runs) {
      for (std::vector<double>& torque : run.torque) steps(torque, step);
      steps(run.radial, 5e-6);
    }
    CHECK(kinds_of(measured.runs).empty());
  }
  for (const double step : {1e-9, 0.02, 0.1}) {
    CAPTURE(step);
    Measured measured;
    std::vector<double>& torque = measured.runs[2].torque[1];
    for (std::size_t i = 0; i < torque.size(); ++i) {
      torque[i] = std::min(2.0, 4 * std::sin(2 * std::numbers::pi * static_cast<double>(i) / 72));
    }
    steps(torque, step);
    CHECK(kinds_of(measured.runs) == std::vector<FaultKind>{FaultKind::clipped});
  }
}

TEST_CASE("two runs with the same readings, whatever is said of them") {
  Measured measured;
  measured.runs[5].radial = measured.runs[1].radial;
  measured.runs[5].torque = measured.runs[1].torque;
  const auto faults = inspect::record_faults(measured.runs);
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].kind == FaultKind::same_readings);
  CHECK(faults[0].runs == std::vector<std::size_t>{5, 1});
  CHECK(faults[0].like == 1);
}

TEST_CASE("a feed that the times do not have, and what a table says otherwise than the dataset") {
  Measured measured;
  for (double& time : measured.runs[0].time) time *= 1.1;
  measured.runs[1].contradictions = {measure::Contradiction::direction};
  const auto faults = inspect::record_faults(measured.runs);
  REQUIRE(faults.size() == 2);
  CHECK(faults[0].kind == FaultKind::feed);
  CHECK(faults[0].values.at(0) == Approx(measured.runs[0].feed / 1.1));
  CHECK(faults[1].kind == FaultKind::direction);
}

TEST_CASE("a motor that reads noise in all runs is told") {
  for (const double sigma : {0.02, 3.0}) {
    CAPTURE(sigma);
    Measured measured;
    Random random(11);
    std::normal_distribution<double> noise(0, sigma);
    const auto silence = [&](measure::Run& run) {
      for (double& torque : run.torque[3]) torque = noise(random);
    };
    silence(measured.runs[2]);
    CHECK(kinds_of(measured.runs).empty());  // of one run the others tell
    for (measure::Run& run : measured.runs) silence(run);
    const std::vector<inspect::Fault> faults = inspect::record_faults(measured.runs);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].kind == FaultKind::motor_silent);
    CHECK(faults[0].channels == std::vector<int>{4});
    CHECK(faults[0].all);
    CHECK(faults[0].blocks);
  }
}

TEST_CASE("runs that would go on while the next ones begin are not on one clock") {
  Measured measured;
  const auto begin = [&](double between, std::size_t of_a_day) {
    for (std::size_t r = 0; r < measured.runs.size(); ++r) {
      measured.runs[r].start = between * static_cast<double>(r % of_a_day) * measured.runs[r].time.back();
    }
  };
  begin(1.2, 100);
  CHECK(kinds_of(measured.runs).empty());
  begin(1.2, 3);  // days, each with its own clock
  CHECK(kinds_of(measured.runs).empty());
  begin(0, 100);  // nobody said when
  CHECK(kinds_of(measured.runs).empty());
  begin(1.2 / 60, 100);
  const std::vector<inspect::Fault> faults = inspect::record_faults(measured.runs);
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].kind == FaultKind::start);
  CHECK(faults[0].all);
  CHECK(faults[0].like == 0);
  CHECK(faults[0].runs[0] == 1);
}

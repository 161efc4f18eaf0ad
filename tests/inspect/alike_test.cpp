#include "inspect/records/alike.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <catch2/catch.hpp>

#include "inspect/records/records.hpp"
#include "inspect/spoiled.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using inspect::FaultKind;
using measure::Run;

namespace {

void for_each_channel(Run& run, const std::function<void(std::vector<double>&, double)>& change) {
  change(run.radial, 1e-7);
  for (std::vector<double>& torque : run.torque) change(torque, 0.01);
}

Run rounded(Run run, double steps) {
  for_each_channel(run, [&](std::vector<double>& values, double unit) {
    for (double& value : values) value = std::round(value / (steps * unit)) * steps * unit;
  });
  return run;
}

// Every so many samples, from one on to the end less some.
Run thinned(const Run& run, std::size_t first, std::size_t step, std::size_t less) {
  Run made = run;
  const auto thin = [&](std::vector<double>& values) {
    std::vector<double> kept;
    for (std::size_t i = first; i + less < values.size(); i += step) kept.push_back(values[i]);
    values = kept;
  };
  thin(made.angle);
  thin(made.time);
  for_each_channel(made, [&](std::vector<double>& values, double) { thin(values); });
  return made;
}

}  // namespace

TEST_CASE("a run that is given twice is told, cut short, thinned or rounded") {
  Measured measured;
  for (Run& run : measured.runs) run = rounded(run, 0.1);
  const Run& run = measured.runs[1];
  Run backwards = run;
  std::reverse(backwards.angle.begin(), backwards.angle.end());
  for_each_channel(backwards, [](std::vector<double>& values, double) { std::reverse(values.begin(), values.end()); });
  for (const Run& again : {run, thinned(run, 0, 1, 1), thinned(run, 0, 2, 0), thinned(run, 1, 3, 2), rounded(run, 1),
                           rounded(thinned(run, 0, 2, 0), 1), backwards}) {
    CAPTURE(again.samples());
    measured.runs[5] = again;
    const inspect::AlikeRuns alike(measured.runs);
    CHECK(alike.alike(1, 5, 0.9));
    CHECK(alike.alike(5, 1, 0.9));
    CHECK_FALSE(alike.alike(0, 5, 0.9));
    CHECK_FALSE(alike.alike(0, 1, 0.9));
  }
}

TEST_CASE("a circle that was measured twice is not given twice, however coarse its readings are") {
  Measured one, other;
  other = Measured(4);
  for (const double steps : {1.0, 10.0, 50.0}) {
    for (std::size_t r = 0; r < one.runs.size(); ++r) {
      CAPTURE(steps, r);
      const std::vector<Run> both{rounded(one.runs[r], steps), rounded(other.runs[r], steps)};
      CHECK_FALSE(inspect::AlikeRuns(both).alike(0, 1, 0.9));
    }
  }
}

TEST_CASE("a motor with the readings of another one is told, in one run and in all") {
  for (const double sign : {1.0, -1.0}) {
    Measured measured;
    measured.runs[2].torque[4] = measured.runs[2].torque[0];
    multiply(measured.runs[2].torque[4], sign);
    std::vector<inspect::Fault> faults = inspect::motors_alike(measured.runs, 0.9);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].kind == FaultKind::motors_alike);
    CHECK(faults[0].channels == std::vector<int>{5, 1});
    CHECK(faults[0].runs == std::vector<std::size_t>{2});
    CHECK_FALSE(faults[0].all);
    for (Run& run : measured.runs) run.torque[4] = run.torque[0];
    faults = inspect::record_faults(measured.runs);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].all);
    CHECK(faults[0].blocks);
  }
  Measured still;  // that they stand still is said as such
  for (Run& run : still.runs) run.torque[1] = run.torque[2] = std::vector<double>(run.samples(), 0.0);
  CHECK(inspect::motors_alike(still.runs, 0.9).empty());
}

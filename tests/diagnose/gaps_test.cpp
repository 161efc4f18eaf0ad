#include "diagnose/gaps.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "measure/runs.hpp"

namespace plumbline::diagnose {
namespace {

// What is left of two samples of the bar and of the motor of strut 1.
identify::RunEquations left(double bar, double torque) {
  identify::RunEquations run;
  run.channels = {identify::kRadial, 1};
  run.samples = 2;
  run.residual = Eigen::Vector4d(bar, -bar, torque, torque);
  return run;
}

TEST_CASE("rms is of the runs held out or of the others, each sample alike") {
  const std::vector<identify::RunEquations> runs{left(3e-6, 0.3), left(4e-6, 0.4), left(9e-6, 0.5)};
  const std::vector<bool> out{false, false, true};
  const Rms fitted = rms_of(runs, out, false);
  CHECK(*fitted.radial == Approx(std::sqrt((9 + 16) / 2.0) * 1e-6));
  CHECK(*fitted.torque == Approx(std::sqrt((0.09 + 0.16) / 2)));
  CHECK(*rms_of(runs, out, true).radial == Approx(9e-6));
  CHECK_FALSE(rms_of(runs, {false, false, false}, true).radial);
}

TEST_CASE("where there is no runner-up its gap is that of the base model") {
  StageResiduals residuals{{left(3e-6, 0.3)}, {}, {left(1e-6, 0.1)}};
  const Gap without = gap_of(residuals, {false}, false);
  CHECK(*without.before.radial == Approx(3e-6));
  CHECK(*without.runner_up.radial == Approx(3e-6));
  CHECK(*without.after.torque == Approx(0.1));
  residuals.second = {left(2e-6, 0.2)};
  CHECK(*gap_of(residuals, {false}, false).runner_up.radial == Approx(2e-6));
}

TEST_CASE("each run has its channels, its residuals of the bar and its circle") {
  const machine::MachineModel machine = testing::pm600_like();
  measure::Run run = testing::circle_run({0, 100, -1008}, {0, 0, 0}, measure::Direction::ccw, 2);
  measure::Run no_bar = run;
  no_bar.id = "torques";
  no_bar.radial.clear();
  identify::RunEquations torque;
  torque.channels = {1};
  torque.samples = 2;
  torque.residual = Eigen::Vector2d(0.3, 0.4);
  const StageResiduals residuals{{left(3e-6, 0.3), torque}, {}, {left(1e-6, 0.1), torque}};
  const std::vector<RunGap> gaps =
      run_gaps(machine, {run, no_bar}, {true, false}, residuals, physics::ForceModel(machine), {});
  REQUIRE(gaps.size() == 2);
  CHECK(gaps[0].held_out);
  REQUIRE(gaps[0].channels.size() == 2);
  CHECK(gaps[0].channels[0].before == Approx(3e-6));
  CHECK(gaps[0].channels[1].after == Approx(0.1));
  CHECK(gaps[0].radial_before[1] == -3e-6);
  CHECK(gaps[0].circularity);
  CHECK(gaps[1].id == "torques");
  CHECK(gaps[1].channels.at(0).before == Approx(std::sqrt(0.125)));
  CHECK(gaps[1].radial_before.size() == 0);
  CHECK_FALSE(gaps[1].circularity);
}

}  // namespace
}  // namespace plumbline::diagnose

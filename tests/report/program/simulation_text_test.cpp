// Tables of whole programs are in tests/jobs/simulate_test.cpp.
#include "report/program/simulation_text.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

TEST_CASE("a simulated point is a row in the units of its columns") {
  const testing::Scratch scratch;
  OutputFile out(scratch.path("sim.csv"));
  report::SimulationTable table(out);
  jobs::SimulatedPoint point;
  point.line = 12;
  point.motion = nc::MotionKind::arc;
  point.time_s = 1.5;
  point.pose = {{60, -10, -1008, 10, -5, 0}};
  point.error << 1e-6, -2e-6, 3e-6, 4e-6, 0, 0;
  point.lengths.setConstant(1.25);
  point.nut_tension.setConstant(-100);
  point.torque.setConstant(0.5);
  table.add(point);
  point.motion = nc::MotionKind::rapid;
  table.add(point);
  out.commit();
  const std::string text = scratch.text("sim.csv");
  const std::string first = text.substr(text.find('\n') + 1);
  CHECK(text.starts_with("line,motion,time_s,x_mm,"));
  CHECK(first.starts_with("12,arc,1.500000,60,-10,-1008,10,-5,0,1.0000,-2.0000,3.0000,4.0000,0.0000,0.0000,1250."));
  CHECK(first.find(",-100.0000,0.500000,") != std::string::npos);
  CHECK(first.find("\n12,rapid,") != std::string::npos);
}

TEST_CASE("a simulation is told by its points, its time and the largest error") {
  jobs::SimulationSummary summary;
  CHECK(report::simulation_text(summary) == "0 points in 0.00 s\n");
  summary = {1234, 1, 41.25, 17, 12.5, 65};
  CHECK(report::simulation_text(summary) ==
        "1,234 points in 1 min 05.0 s: the tip up to 41.250 um off (line 17), rms 12.500 um\n"
        "1 move left out of the table: machine coordinates, probing, or from where nobody knows\n");
  summary.untimed_moves = 2;
  CHECK(report::simulation_text(summary).find(
            "time not known of 2 moves under G95, or in strokes that a cycle makes in its own way\n") !=
        std::string::npos);
  CHECK(report::dataset_simulation_text({1, 3120}) == "1 run, 3,120 samples\n");
}

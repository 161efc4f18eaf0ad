#include "jobs/simulate.hpp"

#include <cmath>
#include <sstream>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "jobs/compensate/compensate_file.hpp"
#include "jobs/error_table.hpp"
#include "machine/model_file.hpp"
#include "report/program/simulation_text.hpp"
#include "settings/options.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

settings::Options playback() {
  settings::Options o;
  o.paths.model = testing::source_file("models/pm600-like.toml");
  o.program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  return o;
}

// Rows of numbers; the motion's name counts as zero.
std::vector<std::vector<double>> simulate(const testing::Scratch& scratch, const std::string& program,
                                          const settings::Options& how) {
  OutputFile out(scratch.path("sim.csv"));
  report::SimulationTable table(out);
  jobs::simulate_program(scratch.file("sim.ngc", program), how,
                         [&](const jobs::SimulatedPoint& point) { table.add(point); });
  out.commit();
  std::istringstream text(scratch.text("sim.csv"));
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(text, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::atof(cell.c_str()));
  }
  rows.erase(rows.begin());
  return rows;
}

constexpr const char* kArcProgram = "G0 X0 Y0 Z0 A0 B0 C0\nG1 X50 Y-20 A10 B-5 F1000\nG2 X60 Y-10 I0 J10\n";

}  // namespace

TEST_CASE("a simulation without friction has the errors and tensions of the table of the machine at rest") {
  const testing::Scratch scratch;
  settings::Options how = playback();
  how.compensation.friction = false;
  const auto rows = simulate(scratch, kArcProgram, how);
  REQUIRE(rows.size() > 60);
  const machine::MachineModel model = machine::read_model(how.paths.model);
  jobs::PoseRow pose;
  for (std::size_t i = 0; i < kAxes; ++i) pose.pose.values[i] = rows.back()[3 + i];
  CHECK(pose.pose == AxisWords{{60, -10, -1008, 10, -5, 0}});
  jobs::PoseError rest;
  jobs::error_table(model, std::span(&pose, 1), [&](const jobs::PoseError& error) { rest = error; });
  for (std::size_t i = 0; i < 6; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    CHECK(rows.back()[9 + i] == Approx(rest.error[k] / kUm).margin(1e-3));
    CHECK(rows.back()[15 + i] == Approx(rest.lengths[k] / kMm).margin(1e-6));
    CHECK(rows.back()[21 + i] == Approx(rest.nut_tension[k]).margin(1e-3));
  }
}

TEST_CASE("time goes on by the feed, and friction turns with the direction") {
  const testing::Scratch scratch;
  const auto rows = simulate(scratch, "G0 X0 Y0 Z0 A0 B0 C0\nG1 Z10 F600\nG1 Z0\n", playback());
  CHECK(rows.back()[2] == Approx(2.0));
  const auto& up = rows[5];
  const auto& down = rows[15];
  CHECK(up[5] == Approx(-1003));
  CHECK(down[5] == Approx(-1003));
  CHECK(std::abs(up[11] - down[11]) > 1);    // um in z
  CHECK(std::abs(up[27] - down[27]) > 0.5);  // N m at motor 1
}

TEST_CASE("the tip of a compensated program goes where the source meant it to go") {
  const testing::Scratch scratch;
  settings::Options how = playback();
  how.compensation.friction = false;
  jobs::compensate_file(scratch.file("p.ngc", kArcProgram), scratch.path("c.ngc"), how);
  how.compensation.step = {90, 1e4, 0};  // the blocks' ends alone
  const auto wanted = simulate(scratch, kArcProgram, playback());
  const auto got = simulate(scratch, scratch.text("c.ngc"), how);
  REQUIRE(got.size() == wanted.size());
  for (std::size_t row = 0; row < got.size(); ++row) {
    INFO("row " << row);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(got[row][3 + i] + got[row][9 + i] * 1e-3 == Approx(wanted[row][3 + i]).margin(1.5e-4));
    }
  }
}

TEST_CASE("a move that cannot be looked at is refused in the file that it stands in") {
  const testing::Scratch scratch;
  const std::string sub = scratch.file("turn.ngc", "o<turn> sub\nG1 C90 F1000\no<turn> endsub\n");
  const Diagnostic unreachable =
      testing::refusal_of([&] { simulate(scratch, "G0 X0 Y0 Z0 A0 B0 C0\no<turn> call\nM2\n", playback()); });
  CHECK(unreachable.code == "simulate-unreachable");
  CHECK(unreachable.place.file == sub);
  CHECK(unreachable.place.line == 2);
  const Diagnostic unknown = testing::refusal_of([&] { simulate(scratch, "G0 X0\no<turn> call\nM2\n", playback()); });
  CHECK(unknown.code == "walk-position-unknown");
  CHECK(unknown.place.file == sub);
}

TEST_CASE("points beyond the limits are counted, and the first is told at its block") {
  const testing::Scratch scratch;
  const auto summary = [&](const std::string& program) {
    return jobs::simulate_program(scratch.file("sim.ngc", program), playback(), [](const jobs::SimulatedPoint&) {});
  };
  const jobs::SimulationSummary within = summary(kArcProgram);
  CHECK(within.beyond_travel == 0);
  CHECK_FALSE(within.first_beyond);
  CHECK(report::simulation_text(within).find("beyond") == std::string::npos);
  const std::string start = "G0 X0 Y0 Z0 A0 B0 C0\n";
  for (const auto& [move, what] : std::vector<std::pair<std::string, std::string>>{
           {"G1 X302 F1000\n", "X would be"}, {"G0 Z209\n", "Z would be"}, {"G1 B26 F1000\n", "tilt would be"}}) {
    const jobs::SimulationSummary beyond = summary(start + move);
    INFO(move);
    REQUIRE(beyond.first_beyond);
    CHECK(beyond.beyond_travel >= 1);
    CHECK(beyond.beyond_travel < beyond.points);
    CHECK(beyond.first_beyond->severity == Severity::warning);
    CHECK(beyond.first_beyond->message.starts_with(what));
    CHECK(beyond.first_beyond->place.line == 2);
    CHECK(report::simulation_text(beyond).find("beyond the limits") != std::string::npos);
  }
}

TEST_CASE("a simulation says of how many cuts it does not know the time") {
  const testing::Scratch scratch;
  const auto untimed = [&](const std::string& program) {
    return jobs::simulate_program(scratch.file("sim.ngc", "G21 G90 G94\nG0 X0 Y0 Z0 A0 B0 C0\nM3 S1000\n" + program),
                                  playback(), [](const jobs::SimulatedPoint&) {})
        .untimed_moves;
  };
  CHECK(untimed("G95 F0.1\nG1 X5\nG0 Y5\nG2 X10 Y5 I2.5\nG94\n") == 2);
  CHECK(untimed("G95 F0.1\nG1 X5\nG94 F500\nX6\nX7\n") == 1);
  CHECK(untimed("G94 F500\nG1 X5\nG93 X7 F10\nG0 X9\n") == 0);
}

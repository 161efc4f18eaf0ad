// Programs of circular tests, by the project's own interpreter and by LinuxCNC's.
#include "jobs/test_program.hpp"

#include <cstdlib>
#include <sstream>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "jobs/check.hpp"
#include "jobs/trace.hpp"
#include "machine/model_file.hpp"
#include "support/scratch.hpp"
#include "support/skip.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

const std::string kTestedModel = source_file("models/pm600-like.toml");

measure::Run tilted_run(measure::Direction direction) {
  measure::Run run;
  run.id = "07 (last); <M0>";
  run.centre_W = {0.1, -0.05, -0.95};
  run.radius = 0.144;
  run.bar = 0.15;
  run.tilt = {-12 * kDeg, 8 * kDeg, 0};
  run.direction = direction;
  run.feed = 3000 * kMmPerMin;
  run.payload_mass = 20;
  return run;
}

std::string program_of(const measure::Run& run, const std::string& dialect = "linuxcnc") {
  return jobs::test_program(machine::read_model(kTestedModel), run, nc::dialect(dialect));
}

std::vector<nc::Motion> motions_of(const Scratch& scratch, const std::string& text, const std::string& dialect) {
  std::vector<nc::Motion> motions;
  settings::Options options;
  options.dialect = dialect;
  options.paths.model = kTestedModel;
  jobs::trace_file(scratch.file("test." + dialect, text), options, [&](const nc::Motion& motion) {
    if (motion.kind != nc::MotionKind::dwell) motions.push_back(motion);
  });
  return motions;
}

// X, Y, Z, A, B, C of the machine.
void check_at(const nc::Motion& motion, double x, double y, double z) {
  CHECK(motion.machine[Axis::X] == Approx(x).margin(1e-4));
  CHECK(motion.machine[Axis::Y] == Approx(y).margin(1e-4));
  CHECK(motion.machine[Axis::Z] == Approx(z).margin(1e-4));
  CHECK(motion.machine[Axis::A] == Approx(-12));
  CHECK(motion.machine[Axis::B] == Approx(8));
  CHECK(motion.machine[Axis::C] == Approx(0).margin(1e-9));
}

void check_circle(const std::vector<nc::Motion>& motions, double turn) {
  REQUIRE(motions.size() == 7);
  CHECK(motions[0].kind == nc::MotionKind::rapid);
  check_at(motions[0], -44, -50, -900);
  CHECK(motions[1].kind == nc::MotionKind::feed);
  CHECK(motions[1].feed == 1000);  // slower than the test
  check_at(motions[1], -44, -50, -950);
  CHECK(motions[2].kind == nc::MotionKind::rapid);  // after the stop: where it stands
  check_at(motions[2], -44, -50, -950);
  // half a turn to angle 0, the turn, half a turn: all about the centre, at the feed of the test
  for (const std::size_t i : {3U, 4U, 5U}) {
    CHECK(motions[i].kind == nc::MotionKind::arc);
    CHECK(motions[i].feed == 3000);
    CHECK(motions[i].arc.plane == nc::Plane::xy);
    CHECK(motions[i].arc.centre_mm[0] == Approx(100));
    CHECK(motions[i].arc.centre_mm[1] == Approx(-50));
    CHECK(motions[i].arc.turns == turn);
  }
  check_at(motions[3], 244, -50, -950);
  check_at(motions[4], 244, -50, -950);
  check_at(motions[5], -44, -50, -950);
  CHECK(motions[6].kind == nc::MotionKind::rapid);
  check_at(motions[6], -44, -50, -900);
}

}  // namespace

TEST_CASE("a test's program makes its circle in every dialect") {
  const Scratch scratch;
  for (const char* const dialect : {"linuxcnc", "fanuc", "siemens", "okuma"}) {
    INFO(dialect);
    check_circle(motions_of(scratch, program_of(tilted_run(measure::Direction::ccw), dialect), dialect), 1);
    check_circle(motions_of(scratch, program_of(tilted_run(measure::Direction::cw), dialect), dialect), -1);
  }
}

TEST_CASE("a test's program keeps the machine's limits, and goes up less high where they are near") {
  const Scratch scratch;
  measure::Run run = tilted_run(measure::Direction::ccw);
  settings::Options options;
  options.paths.model = kTestedModel;
  options.program.work_offsets[0] = nc::WorkOffset{};
  CHECK(jobs::check_file(scratch.file("p.ngc", program_of(run)), options).violations == 0);
  run.centre_W.z() = -0.825;  // travel ends at -0.8
  const std::string near = program_of(run);
  CHECK(near.find("G0 X-44.0 Y-50.0 Z-805.0 A-12.0 B8.0 C0.0") != std::string::npos);
  CHECK(jobs::check_file(scratch.file("near.ngc", near), options).violations == 0);
}

TEST_CASE("names of runs cannot become words of a program") {
  const std::string text = program_of(tilted_run(measure::Direction::ccw));
  CHECK(text.find("circular test 07__last____M0_, for pm600-like") != std::string::npos);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    CHECK(std::count(line.begin(), line.end(), '(') == std::count(line.begin(), line.end(), ')'));
  }
  CHECK(jobs::test_program_name(std::string(500, 'x'), nc::dialect("fanuc")) == std::string(60, 'x') + ".nc");
  CHECK(jobs::test_program_name("../a b", nc::dialect("linuxcnc")) == "___a_b.ngc");
  CHECK(jobs::test_program_name("01-ccw", nc::dialect("siemens")) == "01-ccw.mpf");
}

TEST_CASE("a bar in the plane of the circle has its ball in the centre") {
  measure::Run run = tilted_run(measure::Direction::ccw);
  CHECK(program_of(run).find("the ball on the table stands at X100 Y-50 Z-992") != std::string::npos);
  run.bar.reset();
  CHECK(program_of(run).find("ball on the table in its centre") != std::string::npos);
}

TEST_CASE("LinuxCNC's interpreter makes the circle, and stops where a work offset acts") {
  if (!has_rs274_or_skips()) return;
  const auto canon_with = [](const std::string& set_up) {
    const Scratch scratch;
    scratch.file("p.ngc", set_up + program_of(tilted_run(measure::Direction::ccw)));
    scratch.file("tools.tbl", "");
    scratch.file("v.var", "");
    const std::string command = "cd " + scratch.path("") + " && HOME=" + scratch.path("") +
                                " rs274 -g -n 2 -t tools.tbl -v v.var p.ngc canon >log 2>&1";
    const int status = std::system(command.c_str());
    INFO(scratch.text("log"));
    CHECK(status == 0);
    return scratch.text("canon");
  };
  const std::string canon = canon_with("");
  INFO(canon);
  CHECK(canon.find("STRAIGHT_TRAVERSE(-44.0000, -50.0000, -900.0000, -12.0000, 8.0000, 0.0000") != std::string::npos);
  // the end, the centre, turns, the end along Z
  const std::string whole = "ARC_FEED(244.0000, -50.0000, 100.0000, -50.0000, 1, -950.0000, -12.0000, 8.0000, 0.0000";
  const std::size_t first = canon.find(whole);
  CHECK(first != std::string::npos);
  CHECK(canon.find(whole, first + 1) != std::string::npos);  // the half turn before ends there as well
  CHECK(canon.find("ARC_FEED(-44.0000, -50.0000, 100.0000, -50.0000, 1, -950.0000") != std::string::npos);
  CHECK(canon_with("G21\nG10 L2 P1 X1\n").find("ARC_FEED") == std::string::npos);
}

// The commands about a model itself: new_model_command.
#include <catch2/catch.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;

namespace {

const std::string kCircles =
    "--base-radius 1000 --base-angles -5,5,115,125,235,245 --platform-radius 300 --platform-angles "
    "-55,55,65,175,185,295 --home 0,0,900 ";

}  // namespace

TEST_CASE("new-model writes a model that every command takes, and says what it assumed") {
  const Scratch scratch;
  const Outcome made = run(scratch, "new-model " + kCircles + "--friction 90 --set control.block_time_ms=2 -o m.toml");
  CHECK(made.code == 0);
  CHECK(made.out.empty());
  CHECK(contains(made.err, "assumed, as nothing says it:\n"));
  CHECK(contains(made.err, "[strut] lead_mm = "));
  CHECK_FALSE(contains(made.err, "coulomb_friction_N = 90"));
  CHECK(contains(made.err, "8 of 8 in reach"));
  const std::string text = scratch.text("m.toml");
  CHECK(contains(text, "coulomb_friction_N = 90\n"));
  CHECK(contains(text, "block_time_ms = 2\n"));
  scratch.file("poses.csv", "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n0,0,900,0,0,0\n");
  CHECK(run(scratch, "error -m m.toml poses.csv").code == 0);
  const Outcome printed = run(scratch, "new-model -q " + kCircles);
  CHECK(printed.err.empty());
  CHECK(contains(printed.out, "plumbline = \"machine 1\"\n"));
}

TEST_CASE("new-model makes a model of the control that control wrote") {
  const Scratch scratch;
  CHECK(run(scratch, "control linuxcnc -o sim " + kModel).code == 0);
  const Outcome made = run(scratch, "new-model --ini sim/hexapod.ini -o m.toml");
  CHECK(made.code == 0);
  CHECK(contains(made.err, "read: hexapod.ini, hexapod.hal\n"));
  CHECK(contains(scratch.text("m.toml"), "joints_mm = [[556.2231, -831.03301, 41.44], "));
  CHECK(contains(scratch.text("m.toml"), "name = \"pm600-like\"\n"));
}

TEST_CASE("new-model refuses what is no machine, and writes nothing") {
  const Scratch scratch;
  const Outcome nothing = run(scratch, "new-model -o m.toml");
  CHECK(nothing.code == 1);
  CHECK(contains(nothing.err, "[draft-missing]"));
  const Outcome misspelt = run(scratch, "new-model " + kCircles + "--set strut.led_mm=3 -o m.toml");
  CHECK(misspelt.code == 2);
  CHECK(contains(misspelt.err, "strut.lead_mm"));
  CHECK(run(scratch, "new-model " + kCircles + "--set strut.lead_mm=x -o m.toml").code == 2);
  CHECK(run(scratch, "new-model " + kCircles + "--lead 3,4 -o m.toml").code == 2);
  CHECK(run(scratch, "new-model " + kCircles + "--home 0,0 -o m.toml").code == 2);
  CHECK(run(scratch, "new-model --hal a.hal -o m.toml").code == 2);
  CHECK(run(scratch, "new-model " + kCircles + "--rotation XXY -o m.toml").code == 1);
  scratch.file("a.ini", "[KINS]\nKINEMATICS = trivkins coordinates=xyz\n");
  const Outcome other = run(scratch, "new-model --ini a.ini -o m.toml");
  CHECK(other.code == 1);
  CHECK(contains(other.err, "a.ini:2:14: error: "));
  CHECK(run(scratch, "new-model --ini a.ini -o a.ini").code == 1);
  CHECK(contains(scratch.text("a.ini"), "trivkins"));
  CHECK_FALSE(scratch.has("m.toml"));
}

// The commands about a model itself: new_model_command, map_command; number_list, which both take.
#include <algorithm>

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

TEST_CASE("new-model writes over a model that was worked on only where it is told to") {
  const Scratch scratch;
  REQUIRE(run(scratch, "new-model " + kCircles + "-o m.toml").code == 0);
  CHECK(run(scratch, "new-model " + kCircles + "-o m.toml").code == 0);  // it holds the same
  scratch.file("m.toml", scratch.text("m.toml") + "# measured\n");
  const Outcome again = run(scratch, "new-model " + kCircles + "-o m.toml");
  CHECK(again.code == 1);
  CHECK(contains(again.err, "m.toml: error: there is another file of this name already [model-exists]"));
  CHECK(contains(scratch.text("m.toml"), "# measured\n"));
  CHECK(run(scratch, "new-model --force " + kCircles + "-o m.toml").code == 0);
  CHECK_FALSE(contains(scratch.text("m.toml"), "# measured\n"));
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

TEST_CASE("map tabulates the workspace, and says what is in reach and how sure the model is") {
  const Scratch scratch;
  const Outcome whole = run(scratch, "map --step 150 -o map.csv " + kModel);
  CHECK(whole.code == 0);
  CHECK(whole.out.empty());
  CHECK(contains(whole.err, "100 poses, 100.0 % in reach\n"));
  CHECK(contains(whole.err, "the model knows the tip within "));
  const std::string table = scratch.text("map.csv");
  CHECK(std::count(table.begin(), table.end(), '\n') == 101);
  CHECK(table.starts_with("x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,in_reach,limit,error_um,"));
  CHECK(
      contains(table, ",uncertainty_um,touched_off_uncertainty_um\n-300.000,-300.000,-1250.000,0.000,0.000,0.000,1,,"));
  const Outcome part =
      run(scratch, "map -q --box 0,100,0,100,-1000,-900 --step 100 --z -1000 --tilt 0,0 --tilt -30,0,5 " + kModel);
  CHECK(part.err.empty());
  CHECK(std::count(part.out.begin(), part.out.end(), '\n') == 9);
  CHECK(contains(part.out, "0.000,0.000,-1000.000,-30.000,0.000,5.000,0,tilt too large,,,,,,,,,\n"));
}

TEST_CASE("map refuses boxes, steps and tilts that are none") {
  const Scratch scratch;
  CHECK(run(scratch, "map -o map.csv").code == 2);
  CHECK(run(scratch, "map --tilt 3 -o map.csv " + kModel).code == 2);
  CHECK(run(scratch, "map --tilt 3,x -o map.csv " + kModel).code == 2);
  CHECK(run(scratch, "map --tilt 1e9,0 -o map.csv " + kModel).code == 2);
  CHECK(run(scratch, "map --box 1,2,3 -o map.csv " + kModel).code == 2);
  CHECK(run(scratch, "map --step 0 -o map.csv " + kModel).code == 2);
  CHECK(contains(run(scratch, "map --step 0.001 -o map.csv " + kModel).err, "[map-step]"));
  CHECK(contains(run(scratch, "map --box 1,0,0,1,0,1 -o map.csv " + kModel).err, "[map-box]"));
  CHECK_FALSE(scratch.has("map.csv"));
}

TEST_CASE("map writes a page, and the table beside it only if it is asked for") {
  const Scratch scratch;
  const Outcome page = run(scratch, "map --step 150 --report map.html " + kModel);
  CHECK(page.code == 0);
  CHECK(page.out.empty());
  CHECK(contains(scratch.text("map.html"), "\"The workspace of pm600-like\""));
  CHECK(run(scratch, "map --step 150 -o both.csv --report both.html " + kModel).code == 0);
  CHECK(scratch.text("both.html") == scratch.text("map.html"));
  CHECK(scratch.text("both.csv").starts_with("x_mm,"));
  CHECK(contains(run(scratch, "map --step 2 --report large.html " + kModel).err, "[map-page]"));
  CHECK(run(scratch, "map --step 150 -o same --report same " + kModel).code == 1);
  CHECK_FALSE(scratch.has("large.html"));
}

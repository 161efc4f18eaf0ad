// Plans for a tip that is certain over a box.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;
using nlohmann::json;

TEST_CASE("a plan for the tip is made over a box, and what is no box is said") {
  const Scratch scratch;
  const std::string plan = "plan -n 2 --candidates 30 " + kModel + " ";
  const Outcome made =
      run(scratch, plan + "--for tip --box -100:100,-80:80,-1100:-900 --tilts 0,10 --json p.json --report p.html");
  CHECK(made.code == 0);
  CHECK(made.err.empty());
  CHECK(contains(made.out, "Z -1100 to -900 mm, tilted by 0, 10 deg (625 of 625 poses in reach), 1 sigma"));
  CHECK(contains(scratch.text("p.html"), "The tip over the box"));
  const json tip = json::parse(scratch.text("p.json")).at("tip");
  CHECK(tip.at("after").size() == 2);
  CHECK(tip.at("after")[1].at("stands").at("rms_um") < tip.at("before").at("stands").at("rms_um"));
  CHECK(run(scratch, plan + "--for tip").code == 0);

  for (const char* const wrong :
       {"--for tip --box nan:1,2:3,4:5", "--for tip --box 1:2,3:4", "--for tip --box 1,2:3:4,5:6",
        "--for tip --tilts -5", "--for tip,geometry", "--for geometry --tilts 3", "--box 1:2,3:4,5:6",
        "--separate backlash,backlash", "--separate cyclic,cyclic -d x", "--separate level,level --seed 2",
        "--separate backlash,cyclic --box 1:2,3:4,5:6"}) {
    CAPTURE(wrong);
    CHECK(run(scratch, plan + wrong).code == 2);
  }
  for (const char* const refused :
       {"--for tip --box 100:-100,-80:80,-1100:-900", "--for tip --box -100:100,-80:80,900:1100",
        "--for tip --tilts 0,60", "--for tip --tilts nan"}) {
    CAPTURE(refused);
    const Outcome out = run(scratch, plan + refused + " --json no.json -o no");
    CHECK(out.code == 1);
    CHECK(contains(out.err, "[plan-box]"));
    CHECK(contains(out.err, "help: "));
    CHECK_FALSE(scratch.has("no"));
    CHECK_FALSE(scratch.has("no.json"));
  }
}

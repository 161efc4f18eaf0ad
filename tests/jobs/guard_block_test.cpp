#include "jobs/guard_block.hpp"

#include <cstdlib>

#include <catch2/catch.hpp>

#include "support/scratch.hpp"
#include "support/skip.hpp"

using namespace plumbline;

namespace {

// The state of a control, and what LinuxCNC's interpreter makes of a guard in it.
struct Control {
  std::string set_up = "G21\nG10 L2 P1 X0 Y0 Z-1008 A0 B0 C0\nG10 L2 P2 X1.5 Y2 Z-7 C5 R30\n";  // a program
  std::string tools = "T1 P1 Z3.3464567\n";                                                     // lengths in inch
};

std::vector<std::string> guard() {
  nc::ProgramSettings program;
  program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  program.work_offsets[1] = nc::WorkOffset{{{1.5, 2, -7, 0, 0, 5}}, 30};
  const std::vector<nc::Tool> tools{{1, 85, {}, {}, {}}};
  return jobs::guard_block(program, tools, AxisSet{Axis::B}, nc::dialect("linuxcnc"));
}

// True if the program behind the guard is reached.
bool goes_on(const Control& control, const std::string& units = "") {
  const testing::Scratch scratch;
  std::string text = control.set_up + units;
  for (const std::string& line : guard()) text += line + "\n";
  scratch.file("p.ngc", text + "G0 X77\nM2\n");
  scratch.file("tools.tbl", control.tools);
  scratch.file("v.var", "");
  const std::string command = "cd " + scratch.path("") + " && HOME=" + scratch.path("") +
                              " rs274 -g -n 2 -t tools.tbl -v v.var p.ngc canon >log 2>&1";
  const int status = std::system(command.c_str());
  INFO(scratch.text("log"));
  CHECK(status == 0);
  const std::string canon = scratch.text("canon");
  const bool reached = canon.find("STRAIGHT_TRAVERSE(77.0000") != std::string::npos;
  CHECK(reached == (canon.find("plumbline guard") == std::string::npos));
  return reached;
}

}  // namespace

TEST_CASE("a guard goes on where the control is set as the program was made for, in mm and in inch") {
  if (!testing::has_rs274_or_skips()) return;
  CHECK(goes_on({}));
  CHECK(goes_on({}, "G20\n"));
  CHECK(goes_on({}, "G0 X3 Y4 Z5 A6 C7\n"));
}

TEST_CASE("a guard stops the control at each difference") {
  if (!testing::has_rs274_or_skips()) return;
  for (const char* const change :
       {"G10 L2 P1 Z-1008.002\n", "G10 L2 P1 A0.002\n", "G10 L2 P2 X1.502\n", "G10 L2 P2 Y1.998\n",
        "G10 L2 P2 R30.01\n", "G10 L2 P2 C5.002\n", "G55\n", "G92 X0.1\n", "G43 H1\n", "G0 B0.01\n"}) {
    INFO(change);
    Control control;
    control.set_up += change;
    CHECK_FALSE(goes_on(control));
    CHECK_FALSE(goes_on(control, "G20\n"));
  }
  Control control;
  control.tools = "T1 P1 Z3.3466\n";
  CHECK_FALSE(goes_on(control));
}

TEST_CASE("the lines of a guard fit the control") {
  for (const std::string& line : guard()) {
    INFO(line);
    CHECK(line.size() <= nc::dialect("linuxcnc").line_length);
  }
}

TEST_CASE("a guard is refused where it cannot be said") {
  nc::Dialect other = nc::dialect("linuxcnc");
  other.name = "okuma";
  CHECK(testing::refusal_of([&] { jobs::guard_block({}, {}, {}, other); }).code == "guard-dialect");
  nc::ProgramSettings with_g92;
  with_g92.variables = {{5210, 1}, {5211, 3}};
  CHECK(testing::refusal_of([&] { jobs::guard_block(with_g92, {}, {}, nc::dialect("linuxcnc")); }).code == "guard-g92");
}

// What an OSP makes of its programs, case by case: where it is refused, or where its moves end.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/osp_cases.hpp"
#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

TEST_CASE("OSP: an increment after a change of offsets is refused until an absolute word made the axis follow") {
  check_osp({{"G15 H1 G0 X0 Y0 Z50 A0 B0\nG91 G56 H1 Z-10\n", 2, 12},
             {"G15 H1 G0 X0 Y0 Z50 A0 B0\nG56 H1 Z40\nG91 Z-1\nG53 Z-1\n", 4, 5},
             {"G15 H1 G0 X0 Y0 Z50\nG15 H2\nG91 Y1\nX1\n", 4, 1},
             {"G15 H1 G0 X0 Y0 Z50\nG56 H1 Z40\nG91 Z-10 X1\nG90 G15 H2 X0\nG91 X1\n", 0, 0}});
}

TEST_CASE("OSP: tool-tip mode puts the length of its H in force, and its end leaves open which one is") {
  check_osp({{"G15 H1 G0 X0 Y0 Z0 A0 B0\nG169 H1\nG0 Z50\nG170\nG1 X1 F100\n", 5, 1},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0\nG169 X1 Y1 Z50 H1\nG170\nZ0\n", 4, 1},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0\nG169 H1\nG170\nG170\nG169 X0\n", 5, 1},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0\nG169 H1\nG170\nG170\nG56 H1 G0 Z10\nX0\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0\nG169 H2\n", 2, 6, "nc-tool-unknown"},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0\nG91 G169 X1 H1\n", 2, 10},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0\nG169 H1\nG170\nG56 H1 G0 Z10\nG169 H0\nG170\nG0 Z5\nG0 Z9999\n", 0, 0}});
  const ProgramFile text("G15 H1 G0 X0 Y0 Z0\nG169 H1 X1 Y2 Z3\nG0 Z3\nG170\nG53 Z3\n");
  const InputFile file(text.path());
  ProgramSettings settings = empty_tables();
  Tool tool;
  tool.number = 1;
  tool.length_mm = 100;
  settings.tools = ToolTable({tool});
  Program blocks(file, dialect("okuma"), settings);
  std::vector<double> heights;
  while (const Step* step = blocks.next()) {
    for (const Motion& motion : step->motions) heights.push_back(motion.machine[Axis::Z]);
  }
  CHECK(heights == std::vector<double>{0, 103, 103, 3});
}

TEST_CASE("OSP: what goes to a limit or to machine coordinates leaves the axis where nobody knows") {
  check_osp({{"G15 H1 G0 X0 Y0 Z0\nG0 Z9999\nG2 X5 I2.5 F100\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0\nG0 X9999\nG2 X5 I2.5 F100\n", 3, 1, "nc-position-unknown"},
             {"G15 H1 G0 X0 Y0 Z0\nG16 H0 Y0\nG91 G3 X5 I2.5 F100\n", 3, 5, "nc-position-unknown"},
             {"G15 H1 G0 X0 Y0 Z0\nG15 H0\nG0 X5\nG15 H1\nG3 X5 I2.5 F100\n", 5, 1, "nc-position-unknown"},
             {"G15 H0\nG0 X5 Z0 Y0\nG92 X0\n", 3, 1}});
}

TEST_CASE("OSP: groups of codes are those of its manual") {
  check_osp({{"G15 H1 G0 X0 Y0 Z0\nM8 M7 M51 M3 M131\nG40 G61 G90 G94 G17 G53 X1\n", 0, 0},
             {"G15 G16 H1\n", 1, 5, "nc-same-group"},
             {"G17 G18\n", 1, 5, "nc-same-group"},
             {"G53 G56 H1\n", 1, 5, "nc-same-group"},
             {"M53 M54\n", 1, 5, "nc-same-group"},
             {"M3 M19\n", 1, 4, "nc-same-group"}});
}

TEST_CASE("OSP: a program whose name begins with O is called like any other") {
  check_osp({{"G15 H1\nCALL OO88 PX=5\nG0 X1\nM2\nOO88\nG0 X=PX Y0 Z0\nRTS\n", 0, 0},
             {"G15 H1\nCALL OORI Q2\nM2\nOORI\nG0 X0 Y0 Z0\nRTS\n", 0, 0},
             {"CALL OO88 PX=0 PY=0 PZ=0 PA=-90 PC=0 PH=1 PP=2\nM2\n", 1, 1, "nc-flow-open"}});
}

TEST_CASE("OSP: HP= is a home position, and no P") {
  check_osp({{"G15 H1\nG20 HP=4\nM2\n", 0, 0},
             {"G15 H1\nG20 P4\nM2\n", 2, 5, "nc-word-unused"},
             {"G15 H1\nG21 P=1\nM2\n", 2, 5, "nc-word-unused"},
             {"G15 H1\nG0 X0 Y0 Z50\nG71 Z50\nG82 X9 Z-5 R2 HP=2 F9 M53\nM2\n", 4, 15, "nc-word-unused"}});
}

TEST_CASE(
    "OSP: a label that stands twice is refused where a program jumps to it, and an arc by its radius without an end") {
  check_osp({{"G15 H1\nG0 X0 Y0 Z0\nGOTO N6\nN06 X8\nN6 X3\nM2\n", 3, 1, "nc-not-interpreted"},
             {"G15 H1\nG0 X0 Y0 Z0\nGOTO N3\nN3 X6\nN3 X7\nM2\n", 3, 1, "nc-not-interpreted"},
             {"G15 H1\nG0 X0 Y0 Z0\nVC1=1\nIF [VC1 EQ 1] NA\nX2\nNA X6\nNA X7\nM2\n", 4, 1, "nc-not-interpreted"},
             {"G15 H1\nG0 X0 Y0 Z0\nN3 X6\nN3 X7\nM2\n", 0, 0},
             {"G15 H1\nG0 X0 Y0 Z0\nG2 R5 F100\nG1 X1\nM2\n", 3, 1, "nc-arc-ends"},
             {"G15 H1\nG0 X0 Y0 Z0\nG2 I5 F100\nG1 X1\nM2\n", 0, 0}});
}

TEST_CASE("OSP: what is set in the block of a statement is not lost") {
  check_osp({{"G15 H1\nVC1=5 GOTO N10\nN10 G0 X=VC1 Y0 Z0\nM2\n", 2, 7, "nc-flow-control"},
             {"G15 H1\nVC2=0\nVC1=5 IF [VC2 EQ 0] N10\nN10 G0 X=VC1 Y0 Z0\nM2\n", 3, 7, "nc-flow-control"},
             {"CALL O8\nM2\nO8\nVC1=5 RTS\n", 4, 7, "nc-flow-control"}});
}

TEST_CASE("OSP: what a variable becomes that is set to one without a value is refused") {
  const char* const unset = "nc-parameter-unset";
  check_osp({{"G15 H1 G0 X0 Y0 Z50\nPY=PX\n", 2, 1, unset},
             {"G15 H1 G0 X0 Y0 Z50\nVC2=PX\n", 2, 1, unset},
             {"G15 H1 G0 X0 Y0 Z50\nPY=[PX]\n", 2, 1, unset},
             {"G15 H1 G0 X0 Y0 Z50\nPY=-PX\n", 2, 1, unset},
             {"G15 H1 G0 X0 Y0 Z50\nPY=EMPTY\n", 2, 1, unset},
             {"G15 H1 G0 X0 Y0 Z50\nCALL O7 PY=PX\nM2\nO7\nRTS\n", 2, 9, unset},
             {"G15 H1 G0 X0 Y0 Z50\nIF [[PX] EQ EMPTY] N9\nN9 M2\n", 2, 10, unset},
             {"G15 H1 G0 X0 Y0 Z50\nIF [[PX] NE EMPTY] N9\nN9 M2\n", 2, 10, unset},
             {"G15 H1 G0 X0 Y0 Z50\nIF [PX EQ EMPTY] N9\nX5\nN9 M2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z50\nPX=3\nPY=[PX]\nIF [[PY] EQ 3] N9\nN9 M2\n", 0, 0}});
}

TEST_CASE("OSP: what hands a value on hands on that its last digits are open") {
  check_osp({{"G15 H1 G0 X0 Y0 Z50\nCALL O7 PY=0.1+0.2\nM2\nO7\nIF [PY EQ 0.3] N9\nN9 RTS\n", 5, 8},
             {"G15 H1 G0 X0 Y0 Z50\nVC1=0.1+0.2\nCALL O7\nM2\nO7\nIF [VC1 LT 0.3] N9\nN9 RTS\n", 6, 9},
             {"G15 H1 G0 X0 Y0 Z50\nPX=0.1+0.2\nCALL O7 PY=PX\nM2\nO7\nPZ=FIX[PY*10]\nRTS\n", 6, 4},
             {"G15 H1 G0 X0 Y0 Z50\nCALL O7 PY=0.3\nM2\nO7\nIF [PY EQ 0.3] N9\nN9 RTS\n", 0, 0}});
}

TEST_CASE("OSP: a label that differs by zeros is not taken for the same") {
  check_osp({{"G15 H1 G0 X0 Y0 Z50\nVC1=1\nIF [VC1 EQ 1] N5\nX1\nN05 X2\nM2\n", 3, 1},
             {"G15 H1 G0 X0 Y0 Z50\nN0010 X5\nVC1=VC1+1\nIF [VC1 LT 3] GOTO N10\nM2\n", 3, 5, "nc-parameter-unset"},
             {"G15 H1 G0 X0 Y0 Z50\nGOTO N0100\nX3\nN100 X5\nM2\n", 2, 1},
             {"G15 H1 G0 X0 Y0 Z50\nGOTO N0100\nX3\nN0100 X5\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z50\nGOTO NA01\nX3\nNA01 X5\nM2\n", 0, 0}});
}

// Variables of an OSP that have no value, and numbers finer than the control keeps.
#include <string>

#include <catch2/catch.hpp>

#include "nc/osp_cases.hpp"

using namespace plumbline::nc::tests;

TEST_CASE("OSP: what has no value is compared, and nothing else comes of it") {
  check_osp({{"G15 H1 G0 X0\nLA=EMPTY\nIF [LA EQ EMPTY] N10\nX1\nN10 X2\nM2\n", 2, 1, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nLB=LC\nIF [LB EQ EMPTY] N10\nX1\nN10 X2\nM2\n", 2, 1, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nLB=LC\nX=LB\nM2\n", 2, 1, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nVC1=EMPTY\nX=VC1+1\nM2\n", 2, 1, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nVC1=-LC\nM2\n", 2, 1, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nCALL OSUB PX=LC\nM2\nOSUB\nRTS\n", 2, 11, "nc-parameter-unset"},
             {"G15 H1 G0 X0\nIF [LC] N10\nX1\nN10 X2\nM2\n", 2, 1, "nc-flow-control", "no condition"}});
  check_osp({{"G15 H1 G0 X0\nIF [LC EQ EMPTY] N10\nX1\nN10 X2\nM2\n", 0, 0},
             {"G15 H1 G0 X0\nLC=0\nIF [LC NE EMPTY] N10\nX1\nN10 X=LC\nM2\n", 0, 0},
             {"G15 H1 G0 X0\nCALL OSUB PX=1\nM2\nOSUB\nIF [PY EQ EMPTY] N1\nX=PY\nN1 X=PX\nRTS\n", 0, 0}});
}

TEST_CASE("OSP: an increment finer than the control keeps is refused") {
  check_osp({{"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG91 G1 X0.1234 F100\nM2\n", 2, 8, "nc-not-interpreted", "0.001 mm"},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG91 G0 A0.00005\nM2\n", 2, 8, "nc-not-interpreted", "0.001 deg"},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nVC1=1\nG91 G0 Y=VC1/3\nM2\n", 3, 8, "nc-not-interpreted", "3 decimals"},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG91 G0 Z1000.0004\nM2\n", 2, 8}});
  check_osp({{"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG91 G1 X0.123 Y10.0000 A2.5 F100\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG91 G1 X0.123 Y10.0000 F100\nG0 A2.505\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG90 G1 X0.12345 F100\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nVC1=0.1\nG91 G0 Y=VC1+0.2\nX=VC1*3\nM2\n", 0, 0}});
}

TEST_CASE("OSP: variables of a call are set once, and not used beside") {
  const std::string rest = "M2\nOSUB\nX=PX\nRTS\n";
  const auto check = [&](const std::string& call, std::size_t column, const char* part = "") {
    const std::string program = "G15 H1 G0 X0\nPY=1\n" + call + "\n" + rest;
    check_osp({{program.c_str(), column == 0 ? std::size_t{0} : std::size_t{3}, column, "nc-not-interpreted", part}});
  };
  check("CALL OSUB PX=1 PX=2", 16, "twice");
  check("CALL OSUB PX=1 PZ=3 px=2", 21, "twice");
  check("CALL OSUB PX=5 PZ=PX", 19, "set and used");
  check("CALL OSUB PX=PY PZ=PX+1", 20, "set and used");
  check("CALL OSUB PX=PY PZ=PY", 0);
  check("CALL OSUB Q2 PX=1 PZ=2", 0);
}

TEST_CASE("OSP: remainders and halves below 0, signs in a row and signs that compare are refused") {
  const auto check = [](const std::string& line, std::size_t column, const char* code) {
    const std::string program = "G15 H1 G0 X0\n" + line + "\nN5 X1\nM2\n";
    check_osp({{program.c_str(), column == 0 ? std::size_t{0} : std::size_t{2}, column, code}});
  };
  check("X=MOD[-5,3]", 3, "nc-not-interpreted");
  check("X=MOD[5,-3]", 3, "nc-not-interpreted");
  check("X=MOD[5.5,3]", 3, "nc-not-whole");
  check("X=MOD[5,3]", 0, "");
  check("X=ROUND[-2.5]", 3, "nc-not-interpreted");
  check("X=ROUND[2.5]", 0, "");
  check("X=ROUND[-2.4]", 0, "");
  check("X=2--3", 5, "nc-bad-number");
  check("X=2+-3", 5, "nc-bad-number");
  check("X=2- -3", 6, "nc-bad-number");
  check("X=2-3", 0, "");
  check("IF [1 == 1] N5", 7, "nc-operator");
  check("IF [1 <> 2] N5", 7, "nc-operator");
  check("IF [1 >= 2] N5", 7, "nc-operator");
  check("IF [1 LT 2] N5", 0, "");
}

TEST_CASE("OSP: what is no number of a block, no value of a code and no variable") {
  check_osp({{"G15 H1 G0 X0\n:5 X3\nM2\n", 2, 1, "nc-bad-character", "write N"},
             {"G15 H1 G0 X0\n/:7 M8\nM2\n", 2, 2, "nc-bad-character"},
             {"G15 H1 G0 X0\n:12\nM2\n", 2, 1, "nc-bad-character"},
             {"G15 H1 G0 X0\nM=3\nM2\n", 2, 1, "nc-not-interpreted"},
             {"G15 H1 G0 X0\nVC1=4\nM=VC1\nM2\n", 3, 1, "nc-not-interpreted"},
             {"G15 H1 G0 X0\nVC1=3\nX5 M=VC1\nM2\n", 3, 4, "nc-not-interpreted"},
             {"G15 H1 G0 X0\nVC[0]=1\nM2\n", 2, 1, "nc-parameter-number", "1 to 200"},
             {"G15 H1 G0 X0\nX=VC[0]\nM2\n", 2, 3, "nc-parameter-number", "1 to 200"},
             {"G15 H1 G0 X0\nVC0=1\nM2\n", 2, 1, "nc-parameter-number", "1 to 200"},
             {"G15 H1 G0 X0\nVC[1]=1\nX=VC[1]\nM2\n", 0, 0}});
}

TEST_CASE("OSP: what stands in round brackets behind a variable is a comment, and in square ones makes it a field") {
  const char* const no = "nc-not-interpreted";
  check_osp({{"G15 H1 G0 X0 Y0 Z50\nPF1=500. (CUTTING)\nG1 X5. F=PF1 (FIRST MOVE)\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z50\nPX=2\nX=PX (MOVE)\nVC1=PX (SET)\nY=-PX(DOWN)Z=VC1(UP)\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z50\nLX=2\nCALL OA PX=LX (NOTE)\nM2\nOA\nX=PX (THERE)\nRTS\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z50\nLX=3\nIF [LX EQ 3] N1 (V)\nN1 M2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z50\nPX=2\nPY=PX[5]\nM2\n", 3, 4, no, "field"},
             {"G15 H1 G0 X0 Y0 Z50\nLX=3\nIF [LX (V) EQ 3] N1\nN1 M2\n", 3, 8, no, "comment"},
             {"G15 H1 G0 X0 Y0 Z50\nVC1=3\nVC2=[VC1 (V) +5]\nM2\n", 3, 10, no, "comment"},
             {"G15 H1 G0 X0 Y0 Z50\nVC1=3\nVC2=SQRT[VC1 (V)]\nM2\n", 3, 14, no, "comment"}});
}

TEST_CASE("OSP: a local that a program and its subprogram may share is refused") {
  check_osp({{"G15 H1 G0 X0 Y0 Z50\nLX=1\nCALL OA\nX=LX\nM2\nOA\nLX=7\nRTS\n", 4, 3},
             {"G15 H1 G0 X0 Y0 Z50\nCALL OA\nX=LX\nM2\nOA\nLX=7\nRTS\n", 3, 3},
             {"G15 H1 G0 X0 Y0 Z50\nLX=1\nCALL OA PX=LX\nX=LX\nM2\nOA\nX=PX\nRTS\n", 0, 0}});
}

// Words of an OSP, and lines that are none of a program's own: each is read, or refused with its own reason.
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "nc/osp_cases.hpp"

using namespace plumbline::nc::tests;

TEST_CASE("OSP: a shape that is drawn ends before anything else stands") {
  check_osp({{"G15 H1\nDEF WORK\nPS LC,[0,0,0],[10,10,10]\nG1 X100 F1000\nM2\n", 4, 1, "nc-flow-open", "END"},
             {"G15 H1\nDEF WORK\nPS LC,[0,0,0],[10,10,10]\nM2\n", 4, 1, "nc-flow-open"},
             {"G15 H1\nDEF WORK\nNEND\nM2\n", 3, 1, "nc-flow-open"},
             {"G15 H1\nDEF WORK\nX5\nEND\nM2\n", 3, 1, "nc-flow-open"},
             {"G15 H1\nCALL OSUB\nM2\nOSUB\nDEF WORK\nRTS\n", 6, 1, "nc-flow-open"},
             {"G15 H1\nDEF WORK\nOSUB\n", 3, 1, "nc-flow-open"},
             {"G15 H1\nDEF WORK\nVC1=5\nEND\nM2\n", 3, 1, "nc-flow-open"},
             {"G15 H1\n/DEF WORK\nEND\nM2\n", 2, 1, "nc-not-interpreted", "take the / away"}});
  check_osp({{"G15 H1\nDEF WORK\nPS LC,[0,0,0],[10,10,10]\n\n(BLANK)\nEND\nDRAW\nM2\n", 0, 0},
             {"G15 H1\nN1 DEF WORK\nN2 PS LC,[0,0,0],[10,10,10]\nN3 END\nN4 DRAW\nM2\n", 0, 0},
             {"G15 H1\nN10DEF WORK\nEND\nG0 X0\nM2\n", 0, 0}});
}

TEST_CASE("OSP: what stands behind the end of a program and is never reached is refused") {
  check_osp({{"$A.MIN%\nG15 H1 G0 X0\nM2\n$B.MIN%\nG15 H1 G1 X100 F500\nM2\n", 4, 1, "nc-flow-open"},
             {"G15 H1 G0 X0\nM2\nG1 X100 F500\n", 3, 1, "nc-flow-open"},
             {"N1 G15 H1 G0 X0\nN2 M2\nN3 G1 X100 F500\n", 3, 1, "nc-flow-open"},
             {"G15 H1 G0 X0\nM30\n(SECOND)\nX5\nM2\n", 4, 1, "nc-flow-open"},
             {"G15 H1 G0 X0\nCALL OSUB\nM02\nX7\nOSUB\nX1\nRTS\n", 4, 1, "nc-flow-open"}});
  check_osp({{"G15 H1 G0 X0\nM2\n\n(REMARK)\n%\n", 0, 0},
             {"G15 H1 G0 X0\nCALL OSUB\nM2\nOSUB\nX1\nRTS\n", 0, 0},
             {"G15 H1 G0 X0\nVC1=1\nIF [VC1 GT 5] NALM\nX1\nM2\nNALM X0\nM2\n", 0, 0},
             {"G15 H1 G0 X0\nGOTO N9\nN5 M2\nN9 X1\nGOTO N5\n", 0, 0}});
}

TEST_CASE("OSP: what a subprogram jumps to does not reach what stands behind the end of the main program") {
  const std::string sub = "OSUB\nIF [1 EQ 1] NEND\nX1\nNEND X2\nRTS\n";
  const auto check = [](const std::string& program, std::size_t line, std::size_t column, const char* code = "") {
    check_osp({{program.c_str(), line, column, code}});
  };
  check("G15 H1 G0 X0\nCALL OSUB\nM2\nNEND X7\nM2\n" + sub, 4, 1, "nc-flow-open");
  check("G15 H1 G0 X0\nCALL OSUB\nM2\nN7 X7\nM2\nOSUB\nGOTO N7\nX3\nN7 X1\nRTS\n", 4, 1, "nc-flow-open");
  check("$A.MIN%\nG15 H1 G0 X0\nCALL OSUB\nM2\nNEND X7\nM2\n" + sub, 5, 1, "nc-flow-open");
  check("G15 H1 G0 X0\nCALL OSUB\nGOTO NEND\nM2\nNEND X7\nM2\n" + sub, 0, 0);
}

TEST_CASE("OSP: the head of a program stands before the shape of its workpiece") {
  const std::string shape = "DEF WORK\nPS LC,[0,0,0],[1,1,1]\nEND\n";
  const auto check = [](const std::string& program, std::size_t line, std::size_t column, const char* code = "") {
    check_osp({{program.c_str(), line, column, code}});
  };
  check(shape + "$P.MIN%\nG15 H1 G0 X0\nM2\n", 4, 1, "nc-bad-character");
  check("(PART)\n" + shape + "%\nG15 H1 G0 X0\nM2\n", 6, 1, "nc-bad-character");
  check("$P.MIN%\n" + shape + "G15 H1 G0 X0\nM2\n", 0, 0);
  check(shape + "G15 H1 G0 X0\nM2\n", 0, 0);
}

TEST_CASE("OSP: codes beside which no source lets a move stand") {
  check_osp({{"G15 H1 G0 X0 Y0\nCLEAR X5\nM2\n", 2, 1, "nc-not-interpreted", "beside a move"},
             {"G15 H1 G0 X0 Y0\nDRAW G1 X10 F100\nM2\n", 2, 1},
             {"G15 H1 G0 X0 Y0\nMODOUT G1 X100 F100\nM2\n", 2, 1},
             {"G15 H1 G0 X0 Y0\nG130 Y6\nM2\n", 2, 1},
             {"G15 H1 G0 X0 Y0\nG10 X5\nM2\n", 2, 1},
             {"G15 H1 G0 X0 Y0\nG97 X5\nM2\n", 2, 1},
             {"G15 H1 G0 X0 Y0 A0\nM26 A5\nM2\n", 2, 1},
             {"G15 H1 G0 X0 Y0 A0\nG0 A5 M21\nM2\n", 2, 7}});
  check_osp({{"G15 H1 G0 X0 Y0 A0\nCLEAR\nDRAW\nMODOUT\nG130\nG10\nG97 S100\nM26\nA5\nM27\nM20 M8\nM2\n", 0, 0}});
}

TEST_CASE("OSP: a feed per revolution needs a spindle that no M6 or M19 has stopped") {
  check_osp({{"G15 H1 G0 X0\nS100 M3\nM19\nG95 G1 X5 F0.1\nM2\n", 4, 5, "nc-feed-missing"},
             {"G15 H1 G0 X0\nS100 M3\nT1 M6\nG0 X1\nG95 G1 X5 F0.1\nM2\n", 5, 5, "nc-feed-missing"},
             {"G15 H1 G0 X0\nS100 M3\nG116 T1\nG0 X1\nG95 G1 X5 F0.1\nM2\n", 5, 5, "nc-feed-missing"},
             {"G15 H1 G0 X0\nS100 M3\nG95 G1 X5 F0.1 M19\nX6\nM2\n", 4, 1, "nc-feed-missing"}});
  check_osp({{"G15 H1 G0 X0\nS100 M3\nM19\nM3\nG95 G1 X5 F0.1 M19\nM2\n", 0, 0},
             {"G15 H1 G0 X0\nT1 M6\nS100 M3\nG0 X1\nG95 G1 X5 F0.1\nM2\n", 0, 0}});
}

TEST_CASE("OSP: a word that is not known is called so") {
  const char* const unknown = "nc-unknown-code";
  const char* const slip = "no word of this control that is known here";
  check_osp({{"G15 H1 G0 X0\nCOPYF Q3 X10\nM2\n", 2, 1, unknown, slip},
             {"G15 H1 G0 X0\nRTMDI\nM2\n", 2, 1, unknown, slip},
             {"G15 H1 G0 X0\nSELECT\nM2\n", 2, 1, unknown, slip},
             {"G15 H1 G0 X0\nG56 Z50. HB\nM2\n", 2, 10, "nc-not-interpreted", "write H and that number"},
             {"G15 H1 G0 X0\nTLFON\nM2\n", 2, 1, "nc-not-interpreted", "care for its tools"},
             {"G15 H1 G0 X0\nG605 H1 Q51\nM2\n", 2, 1, "nc-not-interpreted", "tilted work planes"},
             {"G15 H1 G0 X0\nG445\nM2\n", 2, 1, "nc-not-interpreted", "no source"},
             {"G15 H1 G0 X0\nVC1=6\nM=VC1\nM2\n", 3, 1, "nc-not-interpreted", "write the code itself"},
             {"G15 H1 G0 X0\nM=2\n", 2, 1, "nc-not-interpreted", "write the code itself"},
             {"G15 H1 G0 X0\n/$ Y5\nM2\n", 2, 1, "nc-not-interpreted", "on one line"},
             {"G15 H1 G0 X0\n/2 $Y5\nM2\n", 2, 1, "nc-not-interpreted", "on one line"},
             {"G15 H1 G0 X0\nPB=1\nIF[PB EQ EMPTY]NE\nNE M2\n", 3, 16, "nc-flow-control", "NEND"},
             {"G15 H1 G0 X0\nPB=1\nIF [PB EQ 2] NE (OUT)\nNE M2\n", 3, 14, "nc-flow-control", "NEND"}});
  check_osp({{"G15 H1 G0 X0\nPB=1\nIF [PB NE 2] NEND\nX1\nNEND M2\n", 0, 0}});
}

TEST_CASE("OSP: G0 beside G169 is the mode behind it, and the words are those of G169") {
  check_osp({{"G15 H1 G0 X0 Y0 Z0 A0 B0 C0\nG0 G169 Z50. H1\nX5 Y2\nM2\n", 0, 0},
             {"G15 H1 G1 X0 Y0 Z0 F100\nG169 G0 X1 Y1 Z50 H3\nG1 Z3\nG170\nG53 G0 Z9\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0\nG169 H1\nG0 G169 Z20 H1\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0\nG1 G169 Z20 H1 F100\nM2\n", 2, 1, "nc-axes-twice"},
             {"G15 H1 G0 X0 Y0 Z0\nG91 G0 G169 Z20 H1\nM2\n", 2, 13}});
}

TEST_CASE("OSP: beside a home position by its number stands neither a move nor a word of an axis") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z0\n";
  for (const std::string line :
       {"G1 X3 F100 G30 P1\n", "G30 P1 G0 X5\n", "G30 P2 X5\n", "G30 P1 G2 X1 I0.5 F100\n", "G30 P1 A5\n",
        "G20 HP=1 X5\n", "G21 HP=1 X0\n", "G0 Z5 G20 HP=4\n", "G20 HP=2 G92 X0\n"}) {
    const std::string program = begin + line + "M2\n";
    const auto column = static_cast<std::size_t>(line.find_first_of('G') + 1);
    const std::size_t home = std::min({line.find("G30"), line.find("G20"), line.find("G21")}) + 1;
    check_osp({{program.c_str(), 2, std::max(column, home), "nc-not-interpreted", "block of its own"}});
  }
  check_osp({{"G15 H1 G0 X0 Y0 Z0\nG30 P1\nG0 X0 Y0 Z0\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0\nG20 HP=4 M9\nG0 X0 Y0 Z0\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z0\nG21 G90 G0 X5\nM2\n", 0, 0}});
}

TEST_CASE("OSP: J, I, R and K of G131 are its own behind an arc, too") {
  check_osp({{"G15 H1 G0 X0 Y0\nG3 I5 J0 F400\nG131 F900 J1 E0.02\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0\nG2 X10 Y0 I5 F400\nG131 F900 J1 E0.02 D2 I3 L12 R0.25 K0\nG1 X20\nM2\n", 0, 0},
             {"G15 H1 G17 G0 X0 Y0\nG2 X10 Y0 R5 F400\nG131 J2 E0.01\nG2 X0 Y0 I-5\nM2\n", 0, 0}});
  check_osp({{"G15 H1 G0 X0 Y0\nG3 I5 J0 F400\nG131 J1 E0.02 X5\nM2\n", 3, 1}});
}

TEST_CASE("OSP: the clamps of all three rotary axes are read alone") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z0 A0 B0 C0\n";
  for (const std::string rest : {"M11\nM27\nG0 A5\nM10\nM26\n", "M21 M11\nM20 M10 (LOCK)\n", "m11\nG1 A5 F100\n"}) {
    INFO(rest);
    check_osp({{(begin + rest + "M2\n").c_str(), 0, 0}});
  }
  check_osp({{(begin + "G0 A5 M11\nM2\n").c_str(), 2, 7, "nc-not-interpreted", "beside a move"}});
}

TEST_CASE("OSP: / may stand behind the name of its block as well") {
  check_osp({{"G15 H1 G0 X0\nN10 /X5\nM2\n", 2, 5, "nc-block-delete"},
             {"G15 H1 G0 X0\nNAB /X5\nM2\n", 2, 5, "nc-block-delete"},
             {"G15 H1 G0 X0\nN10 /2 G1 X5 F100\nM2\n", 2, 5, "nc-block-delete"},
             {"G15 H1 G0 X0\nN10 /M8\nM2\n", 0, 0},
             {"G15 H1 G0 X0\nG0 /X5\nM2\n", 2, 4, "nc-bad-character"},
             {"G15 H1 G0 X0\n/N10 /X5\nM2\n", 2, 6, "nc-bad-character"}});
}

TEST_CASE("OSP: G111 T changes the tool, as G116 does") {
  check_osp({{"G15 H1 G0 X0 Y0 Z50\nG111 T1\nG56 H1 G0 X0 Y0 Z50\nG1 X5 F100\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z50\nG111 T1 Q2\nG56 H1 G0 X0 Y0 Z50\nG1 X5 F100\nM2\n", 0, 0}});
}

TEST_CASE("OSP: codes that call a program of the machine's owner are refused as such") {
  for (const int code : {101, 105, 109, 112, 115, 117, 120}) {
    const std::string text = "G15 H1 G0 X0 Y0 Z50\nG" + std::to_string(code) + " X5\nM2\n";
    check_osp({{text.c_str(), 2, 1, "nc-not-interpreted", code < 110 ? "MODIN" : "CALL"}});
  }
}

// What no source says of an OSP's language, and how it is told.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/osp_cases.hpp"
#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

TEST_CASE("OSP: what stands behind the RTS of the first program is refused as behind M2") {
  check_osp({{"G15 H1 G0 X0 Y0 Z0\nG1 X5 F300\nRTS\nX6\nM2\n", 4, 1, "nc-flow-open", "RTS"},
             {"O1\nG15 H1 G0 X0 Y0 Z0\nN5 RTS (BACK)\nX6\n", 4, 1, "nc-flow-open"},
             {"RTS\nOB\nG1 X9 F300\nRTS\n", 2, 1, "nc-flow-open", "of its own"},
             {"O1\nG15 H1 G0 X0 Y0 Z0\nCALL OB\nRTS\nOB\nX5\nRTS\nOC\nX7\nRTS\n", 8, 1, "nc-flow-open"}});
  check_osp({{"G15 H1 G0 X0 Y0 Z0\nG1 X5 F300\nM2\n\x1a", 0, 0},  // the end of a file of DOS
             {"G15 H1 G0 X0 Y0 Z0\nG1 X5 F300\nM2\nX6\n\x1a", 4, 1, "nc-flow-open"}});
  check_osp({{"O1\nG15 H1 G0 X0 Y0 Z0\nCALL OB\nRTS\nOB\nX5\nRTS\n", 0, 0},
             {"O1\nG15 H1 G0 X0 Y0 Z0\nIF [1 EQ 1] N9\nRTS\nN9 X5\nRTS\n", 0, 0},
             {"O1\nG15 H1 G0 X0 Y0 Z0\nRTS\n(THE END)\n%\n", 0, 0},
             {"O1\nG15 H1 G0 X0 Y0 Z0\nCALL OB\nM2\nOB\nIF [1 EQ 1] N9\nRTS\nN9 X5\nRTS\n", 0, 0}});
}

TEST_CASE("OSP: the speed of the spindle is a whole number") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z0\n";
  for (const std::string block : {"S1500.5 M3\n", "S=1001/2 M3\n", "S=2/3\n", "S=1000-0.5\n", "S=1000.6\n"}) {
    check_osp({{(begin + block + "M2\n").c_str(), 2, 1, "nc-not-whole", "speed"}});
  }
  for (const std::string block : {"S1500 M3\n", "S1500.\n", "S=3000/2 M3\n", "S=0.1*30\n"}) {
    check_osp({{(begin + block + "M2\n").c_str(), 0, 0}});
  }
}

TEST_CASE("OSP: G takes no value, and no variable or count stands twice in a block") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z0\nVC1=1\n";
  for (const std::string block : {"G=1 X5 F100\n", "G=VC1 X5 F100\n", "G=VC1+1\n", "VC2=5 VC2=6\n", "VC2=5 VC02=6\n",
                                  "CALL OA Q2 PX=5 Q3\n", "CALL OA Q2 Q2\n", "CALL OA Q=VC1 Q3\n"}) {
    const std::string program = begin + block + "M2\nOA\nRTS\n";
    const ProgramFile text(program);
    INFO(block);
    const std::optional<Diagnostic> found = refusal_of(program, empty_tables(), "okuma");
    REQUIRE(found);
    CHECK(found->code == "nc-not-interpreted");
    CHECK(found->place.line == 3);
  }
  check_osp({{(begin + "VC2=5 VC3=6\nCALL OA PX=5 Q2\nCALL OA Q2 PX=5 PY=3\nM2\nOA\nRTS\n").c_str(), 0, 0}});
}

TEST_CASE("OSP: NCYL goes to a place") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z50\nG71 Z50 M53\n";
  check_osp({{(begin + "G81 X5 Y0 Z-5 R2 F100\nNCYL\nX7\nM2\n").c_str(), 4, 1, "nc-not-interpreted", "alone"},
             {(begin + "NCYL\nM2\n").c_str(), 3, 1},
             {(begin + "G81 X5 Y0 Z-5 R2 F100\nN9 NCYL (NONE)\nM2\n").c_str(), 4, 4}});
  check_osp({{(begin + "G81 X5 Y0 Z-5 R2 F100\nNCYL X7\nX9\nM2\n").c_str(), 0, 0}});
}

TEST_CASE("OSP: NCYL beside the code of a cycle without X and Y states its words, and drills nothing") {
  const std::string begin = "G15 H1 G0 X3 Y0 Z50\nG71 Z50 M53\n";
  for (const std::string rest :
       {"NCYL G81 Z-2 R2 F40\nCALL O2\nG80\nM2\nO2\nX5 Y5\nX8\nRTS\n", "NCYL G83 Z-9 R2 Q3 F40\nX5\nM2\n",
        "G84 NCYL Z-9 R2 F40\nX5\nG0 X8\nM2\n", "G81 X5 Z-5 R2 F100\nNCYL Z-7\nX7\nM2\n"}) {
    INFO(rest);
    check_osp({{(begin + rest).c_str(), 0, 0}});
  }
  const ProgramFile text(begin + "NCYL G81 Z-2 R2 F40\nG0 X9\nM2\n");
  for (const Motion& motion : motions_of_file(text.path(), empty_tables(), "okuma")) {
    CHECK(motion.kind == MotionKind::rapid);
    CHECK(motion.to[Axis::Z] == 50);
  }
  check_osp({{(begin + "G0 Z60\nNCYL G81 Z-2 R2 F40\nX5\nM2\n").c_str(), 4, 6, "nc-not-interpreted", "Z60"},
             {(begin + "NCYL G81 Z-2 R2 F40 M54\nX5\nM2\n").c_str(), 3, 6, "nc-not-interpreted", "Z50"},
             {(begin + "NCYL G81 R2 F40\nX5\nM2\n").c_str(), 3, 1, "nc-word-missing"},
             {(begin + "G81 Z-2 R2 F40\nX5\nM2\n").c_str(), 3, 1, "nc-not-interpreted", "X or Y"},
             {(begin + "G73 X5 Z-9 R2 I2 J6 F40\nX9 Q3\nM2\n").c_str(), 4, 4, "nc-not-interpreted", "I and J"}});
}

TEST_CASE("OSP: what is no word of the control, or of another machine, is told with a way out") {
  const std::string begin = "G15 H1 G0 X3 Y0 Z50 A0 B0 C0\n";
  check_osp(
      {{(begin + "G169 HL=1 X1 Y1 Z5 A0 B0 C0\nM2\n").c_str(), 2, 6, "nc-unknown-code", "leave HL out"},
       {(begin + "G611 HL=1\nM2\n").c_str(), 2, 1, "nc-not-interpreted", "G169 H"},
       {(begin + "G612\nM2\n").c_str(), 2, 1, "nc-not-interpreted", "G170"},
       {(begin + "M19 RS=90\nM2\n").c_str(), 2, 5, "nc-unknown-code", "leave RS out"},
       {(begin + "L1=90\nM2\n").c_str(), 2, 1, "nc-unknown-code", "two letters"},
       {(begin + "OMIT R2\nM2\n").c_str(), 2, 1, "nc-not-interpreted", "CAM system write each hole"},
       {(begin + "G4 P2\nM2\n").c_str(), 2, 4, "nc-word-unused", "G4 F0.5"},
       {(begin + "G4 X2\nM2\n").c_str(), 2, 4, "nc-not-interpreted", "as F, in seconds"},
       {(begin + "G4 F2 X2\nM2\n").c_str(), 2, 7, "nc-not-interpreted", "blocks of their own"},
       {(begin + "IF [1 EQ 1] CALL OA\nM2\nOA\nRTS\n").c_str(), 2, 1, "nc-flow-control", "nothing else"},
       {(begin + "IF [1 EQ 1] X5\nM2\n").c_str(), 2, 1, "nc-flow-control", "N100"},
       {(begin + "M98 P1\nM2\n").c_str(), 2, 1, "nc-not-interpreted", "CALL O"},
       {(begin + "G71 Z50\nG81 X3 Y0 Z-5 R2 F99 M53\nG111 T1\nX5\nM2\n").c_str(), 5, 1, "nc-not-interpreted", "G56 H"},
       {(begin + "G71 Z50\nG81 X3 Y0 Z-5 R2 F99 M53\nG116 T1\nX5\nM2\n").c_str(), 5, 1, "nc-position-unknown",
        "G116"}});
}

TEST_CASE("OSP: values that are written as elsewhere are told how they are written here") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z0\nVC1=1\n";
  const auto help = [&](const std::string& block) {
    const std::optional<Diagnostic> found = refusal_of(begin + block + "N20 M2\n", empty_tables(), "okuma");
    return found ? found->message + "; " + found->help : std::string();
  };
  const auto says = [&](const std::string& block, const std::string& part) {
    const std::string said = help(block);
    INFO(block << said);
    CHECK(said.find(part) != std::string::npos);
  };
  says("X=VC1 MOD 4\n", "X=MOD[VC1,2]");
  says("VC2=VC1 SIN 4\n", "X=SIN[VC1]");
  says("IF[VC1EQ1]N20\n", "a blank behind VC1");
  says("VC2=VC1MOD4\n", "a blank behind VC1");
  check_osp({{"G15 H1 G0 X0 Y0 Z0\nX=SIN30\nM2\n", 2, 1, "nc-parameter-unset", "write SIN[30]"},
             {"G15 H1 G0 X0 Y0 Z0\nVC2=SQRT4\nM2\n", 2, 1, "nc-parameter-unset", "write SQRT[4]"},
             {"G15 H1 G0 X0 Y0 Z0\nX=PX30\nM2\n", 2, 1, "nc-parameter-unset", "EMPTY"}});
  says("IF [VC1 EQ1] N20\n", "EQ1 is no operator");
}

TEST_CASE("OSP: G116 selects T and is M6, for --keeps-position as well") {
  const std::string text = "G15 H1 G0 X0 Y0 Z50 A0 B0 C0\nG116 T1\nG92 X5\nM2\n";
  ProgramSettings settings = at_zero();
  CHECK(code_of(text, settings, "okuma") == "nc-position-unknown");
  settings.keeps_position = {116};
  CHECK(code_of(text, settings, "okuma") == "nc-position-unknown");
  settings.keeps_position = {6};
  CHECK(code_of(text, settings, "okuma").empty());
}

TEST_CASE("OSP: codes of the manual's tables that are not read are not taken for slips") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z0\n";
  for (const std::string block : {"G68 X1 Y1\n", "G69\n", "G173 X1\n", "G187\n", "G189 H1\n", "G196\n", "G14\n",
                                  "DGRDX X1 Y1 I1 J1 K1 P1\n", "ARC X1 Y1 I1 J1 K1\n", "COPY Q4 P90\n", "CHFR 5\n"}) {
    INFO(block);
    const std::optional<Diagnostic> found = refusal_of(begin + block + "M2\n", empty_tables(), "okuma");
    REQUIRE(found);
    CHECK(found->message.find("no G code") == std::string::npos);
    CHECK(found->message.find("no word of this control") == std::string::npos);
  }
  for (const std::string block : {"G43\n", "G50\n", "NMSG\n", "MSG (DOOR)\n"})
    check_osp({{(begin + block + "M2\n").c_str(), 0, 0}});
}

TEST_CASE("OSP: whether a shift by G92 outlives G15 is said by no source") {
  check_osp({{"G15 H1 G0 X10 Y0 Z0\nG92 X15\nG15 H1\nM2\n", 3, 1, "nc-not-interpreted", "chosen again"},
             {"G15 H1 G0 X10 Y0 Z0\nG92 X15\nG15 H2\nM2\n", 3, 1, "nc-not-interpreted", "another work system"},
             {"G15 H1 G0 X10 Y0 Z0\nG92 Y15\nX20\nG15 H1 X0\nM2\n", 4, 1},
             {"G15 H1 G0 X10 Y0 Z0\nG15 H1\nG92 X15\nM2\n", 0, 0}});
}

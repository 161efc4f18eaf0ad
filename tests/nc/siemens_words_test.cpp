// Words, codes and counts of a SINUMERIK that would change nothing, or something else than they say: refused.
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

const std::string kHead = "G54 G17 G90 G94 G710\nG0 X0 Y0 Z50 A0 B0 C0 S1000 M3\nG1 Z10 F500\n";

std::string code_of(const std::string& lines, std::optional<bool> block_delete = std::nullopt) {
  const ProgramFile program(kHead + lines);
  const InputFile file(program.path());
  ProgramSettings settings = empty_tables();
  settings.block_delete = block_delete;
  for (std::size_t i = 0; i < 2; ++i) settings.work_offsets[i] = WorkOffset{};
  try {
    Program blocks(file, dialect("siemens"), settings);
    while (blocks.next() != nullptr) {
    }
  } catch (const Refusal& refusal) {
    CHECK_FALSE(refusal.diagnostic().help.empty());
    return refusal.diagnostic().code;
  }
  return {};
}

void check_all(const std::string& code, const std::vector<std::string>& programs) {
  for (const std::string& lines : programs) {
    INFO(lines);
    CHECK(code_of(lines) == code);
  }
}

}  // namespace

TEST_CASE("DC, ACP and ACN are of axes that turn") {
  check_all("nc-not-interpreted",
            {"X=DC(5)\n", "Z=ACP(5)\n", "G0 Y=ACN(5)\n", "G2 X10 Y0 I=DC(5) J0\n", "CIP X10 Y10 I1=ACP(10) J1=0\n"});
  check_all("", {"C=DC(5)\n", "A=ACP(5) X1\n", "G2 X10 Y0 I=AC(5) J=IC(0)\n"});
}

TEST_CASE("AC and IC are of axes and points, not of other words") {
  check_all("nc-not-interpreted", {"G2 X10 Y0 CR=IC(5)\n", "F=IC(5) X10\n", "S=AC(100)\n", "D=AC(0)\n", "T=IC(1)\n",
                                   "G2 X10 Y0 I5 TURN=IC(1)\n", "G4 F=AC(2)\n"});
  check_all("", {"X=AC(5) Y=IC(1)\n", "CIP X10 Y10 I1=IC(10) J1=AC(0)\n"});
}

TEST_CASE("a word in the place of another is not that word") {
  check_all("nc-word-unused", {"G2 X10 Y0 I5 RPL=2\n", "G2 X10 Y0 I5 P2\n", "G3 X10 Y0 I5 FP=2\n", "ROT TURN=45\n",
                               "AROT P45\n", "ROT FP=45\n", "G75 TURN=2 Z0\n", "G74 P1 X1=0\n", "ROT Q45\n"});
  check_all("nc-word-unused", {"CIP X10 Y10 I1=10 J1=0 TURN=1\n", "G18 CIP X10 Z20 I1=10 K1=10 TURN=2\n",
                               "CIP X=AC(10) Y=IC(10) I1=10 J1=0 TURN=0\n"});
  check_all("", {"G2 X10 Y0 I5 TURN=2\n", "ROT RPL=45\nX1 Y1\n", "G75 FP=2 Z0\n"});
}

TEST_CASE("in machine coordinates words say positions") {
  check_all("nc-machine-move",
            {"SUPA G0 Z=IC(5) D0\n", "G53 G0 X=IC(1) Y0 D0\n", "G153 G1 A=IC(5) D0\n", "G53 G0 C=DC(5) D0\n"});
  check_all("", {"SUPA G0 Z=AC(5) D0\n"});
}

TEST_CASE("a path group is names of axes in brackets") {
  check_all("nc-not-interpreted",
            {"FGROUP(X Y Z)\n", "FGROUP(X1,Y1,Z1)\n", "FGROUP\n", "FGROUP(XYZ)\n", "FGROUP(,X,Y,Z)\n"});
  check_all("", {"FGROUP(X,Y,Z)\n", "FGROUP( x , Y,Z )\n", "FGROUP()\n", "FGROUP(X,Y,Z,A,B,C)\n"});
}

TEST_CASE("another main spindle, and a limit of the speed under a feed per revolution, are refused") {
  check_all("nc-not-interpreted", {"SETMS(2)\n", "SETMS( 3 )\n", "SETMS(R1)\n", "LIMS=500\nG97 F0.1 X10\n",
                                   "G95 F0.1\nLIMS=500\nX10\n", "LIMS[1]=500 G97 F0.1 X10\n"});
  check_all("", {"SETMS\n", "SETMS(1)\n", "LIMS=500\nG94 F100 X10\n"});
}

TEST_CASE("FOR counts by whole numbers, REPEAT at least once, and DEFAULT is the last choice") {
  check_all("nc-not-interpreted", {"FOR R1=0.5 TO 2\nX=R1\nENDFOR\n", "FOR R1=1 TO 2.5\nX=R1\nENDFOR\n",
                                   "FOR R1=1 TO 3\nR1=R1+0.25\nX=R1\nENDFOR\n"});
  check_all("nc-out-of-range", {"AA: X1\nREPEAT AA P=0\n", "AA: X1\nREPEATB AA P=R1\n", "AA: X1\nREPEAT AA P=-2\n"});
  check_all("nc-flow-control", {"CASE R1 OF DEFAULT GOTOF AA 0 GOTOF AA\nAA: X1\n",
                                "CASE R1 OF 1 GOTOF AA DEFAULT GOTOF AA 0 GOTOF BB\nBB:\nAA: X1\n",
                                "CASE R1 OF DEFAULT GOTOF AA DEFAULT GOTOF AA\nAA: X1\n"});
}

TEST_CASE("swivel cycles where no source says what else they end, move or turn are refused") {
  const std::string tilt = "CYCLE800(0,\"\",0,57,0,0,0,5,0,0,0,0,0,-1)\n";
  check_all("nc-tilted-plane",
            {"TRANS X5\nCYCLE800()\n", "ROT Z5\nCYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\n", "G58 X1\nCYCLE800()\n",
             "MCALL CYCLE81(50,10,2,-5)\nCYCLE800()\n", "MCALL CYCLE81(50,10,2,-5)\n" + tilt, "G18\n" + tilt,
             "G19\n" + tilt, "CYCLE800(0,\"0\",0,57,0,0,0,5,0,0,0,0,0,-1)\n",
             "CYCLE800(0, \"0\" ,0,39,0,0,0,0,5,0,0,0,0,1)\n", "CYCLE800(1,\"0\",0,27,0,0,0,0,0,5,0,0,0,1)\n"});
  check_all("", {tilt + "X0 Y0 Z10\nCYCLE800()\n", "CYCLE800(0,\"0\",0,57,0,0,0,0,0,0,0,0,0,1)\n"});
}

TEST_CASE("NOT before a comparison needs brackets") {
  check_all("nc-not-interpreted", {"IF NOT R1==5 GOTOF AA\nAA: X1\n", "WHILE NOT R1>2\nR1=R1+1\nENDWHILE\n",
                                   "IF NOT (R1+1)<>R2\nX1\nENDIF\n"});
  check_all("", {"IF NOT (R1==5) GOTOF AA\nAA: X1\n", "IF NOT R1\nX1\nENDIF\n", "IF R1==NOT R2\nX1\nENDIF\n"});
}

TEST_CASE("positions of the spindle say which way round as those of axes do") {
  check_all("", {"SPOS=DC(90)\n", "SPOS[1]=ACP(R1+5) X1\n", "SPOSA=IC(30)\n", "SPOS=90\n"});
  check_all("nc-bracket-open", {"SPOS=DC(90\n"});
}

TEST_CASE("what is refused is called by its name") {
  check_all("nc-not-interpreted", {"X=7 B_AND 3\n", "R1=R2 B_OR 4\n", "PROC UP(REAL DEEP=5)\n", "X=MINVAL(1,2)\n"});
  check_all("nc-axes-unused", {"CIP X10 Y10 I1=10 J1=0\nX20 Y10 I1=15 J1=15\n"});
}

TEST_CASE("ATRANS and AROT say what they add") {
  check_all("nc-not-interpreted", {"ATRANS\n", "TRANS X5\nATRANS\nX1\n", "AROT\n", "G18 AROT\n"});
  check_all("", {"ATRANS X0\n", "AROT RPL=5\nX1 Y1\n", "TRANS\n", "ROT\n"});
}

TEST_CASE("what is set in the block of a statement is not lost") {
  check_all("nc-flow-control",
            {"R2=5 IF R1==0\nX1\nENDIF\n", "R2=5 GOTOF AA\nAA: X1\n", "R2=5 FOR R1=1 TO 2\nX=R1\nENDFOR\n",
             "R2=5 WHILE R1<2\nR1=R1+1\nENDWHILE\n", "IF R1==0\nX1\nR2=5 ELSE\nX2\nENDIF\n",
             "REPEAT\nR1=R1+1\nR2=7 UNTIL R1>2\n", "AA: X1\nR2=5 REPEAT AA\n", "R2=5 CASE R1 OF 0 GOTOF AA\nAA: X1\n",
             "R2=5 DEF REAL CC=3\nX=CC\n"});
}

TEST_CASE("a branch that is left out does not end in a line behind /") {
  for (const std::string lines : {"IF R1==1\nX1\n/ELSE\nX5\nENDIF\nX2\n", "IF R1==1\nX1\n/ENDIF\nX2\nENDIF\n",
                                  "WHILE R1>1\nX1\n / ENDWHILE\nX2\nENDWHILE\n"}) {
    INFO(lines);
    CHECK(code_of(lines, true) == "nc-not-interpreted");
  }
  CHECK(code_of("/IF R1==1\nX1\n/ENDIF\nX2\n", true).empty());
  CHECK(code_of("IF R1==1\n/X1\nELSE\n/X5\nENDIF\n", true).empty());
  CHECK(code_of("IF R1==1\nX1\n/ELSE\nX5\nENDIF\nX2\n", false).empty());
}

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
  check_all("nc-not-interpreted", {"R3=4\nFOR R1=1 TO R3\nR3=2\nX=R1\nENDFOR\n",
                                   "R3=1\nFOR R1=1 TO R3\nX=R1\nR3=R3+1\nIF R1>5 GOTOF AA\nENDFOR\nAA: X1\n",
                                   "FOR R1=1 TO 6-R1\nX=R1\nENDFOR\n"});
  check_all("", {"R3=4\nFOR R1=1 TO R3\nX=R1\nENDFOR\nR3=1\nFOR R1=1 TO R3\nX1\nENDFOR\n",
                 "FOR R2=1 TO 3\nFOR R1=1 TO R2\nX=R1\nENDFOR\nENDFOR\n"});
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

TEST_CASE("a dwell in turns needs a spindle that turns") {
  check_all("nc-feed-missing", {"M5\nG4 S30\n", "SPOS=0\nG4 S3\n", "M19\nG4 S3\n"});
  check_all("nc-not-interpreted",
            {"M5\nX10\nCYCLE82(50,0,2,-10,,-3)\n", "CYCLE86(50,0,2,-5,,0,3,0,0,0,0)\nCYCLE82(50,0,2,-10,,-3)\n",
             "CYCLE840(50,0,2,-5,,0,0,5,0,0,1)\nS300 F500\nCYCLE82(50,0,2,-10,,-3)\n"});
  check_all("", {"G4 S30\n", "M5\nM4\nG4 S30\n", "CYCLE82(50,0,2,-10,,-3)\n", "M5\nG4 F3\n"});
}

TEST_CASE("the share of the first feed of CYCLE83 is one or less") {
  check_all("nc-not-interpreted", {"CYCLE83(50,0,2,-10,,-3,,0,0,0,1.5,1)\n", "CYCLE83(50,0,2,-10,,-3,,0,0,0,100,1)\n",
                                   "CYCLE83(50,0,2,-10,,-3,,0,0,0,50,1,,,,0,0,0,1,1001110)\n",
                                   "CYCLE83(50,0,2,-10,,-3,,0,0,0,0.5,1,,,,0,0,0,1,20000002)\n",
                                   "CYCLE83(50,0,2,-10,,-3,,0,0,1,1,1,,,,0,0,0,1,202)\n"});
  check_all("",
            {"CYCLE83(50,0,2,-10,,-3,,0,0,0,0.5,1)\n", "CYCLE83(50,0,2,-10,,-3,,0,0,0,50,1,,,,0,0,0,1,11111112)\n"});
}

TEST_CASE("what is refused is called by its name") {
  check_all("nc-not-interpreted", {"X=7 B_AND 3\n", "R1=R2 B_OR 4\n", "PROC UP(REAL DEEP=5)\n", "X=BOUND(3,2,1)\n"});
  check_all("nc-operator", {"X=MINVAL(1)\n", "X=MAXVAL(1,2,3)\n"});
  check_all("nc-axes-unused", {"CIP X10 Y10 I1=10 J1=0\nX20 Y10 I1=15 J1=15\n"});
}

TEST_CASE("ATRANS and AROT say what they add") {
  check_all("nc-not-interpreted", {"ATRANS\n", "TRANS X5\nATRANS\nX1\n", "AROT\n", "G18 AROT\n"});
  check_all("", {"ATRANS X0\n", "AROT RPL=5\nX1 Y1\n", "TRANS\n", "ROT\n"});
}

TEST_CASE("what is set in the block of a statement is not lost") {
  check_all("nc-flow-control",
            {"R2=5 IF R1==0\nX1\nENDIF\n", "R2=5 GOTOF AA\nAA: X1\n", "R2=5 FOR R1=1 TO 2\nX=R1\nENDFOR\n",
             "R2=5 WHILE R1<2\nR1=R1+1\nENDWHILE\n", "IF R1==0\nX1\nR2=5 ELSE\nX2\nENDIF\n", "AA: X1\nR2=5 REPEAT AA\n",
             "R2=5 CASE R1 OF 0 GOTOF AA\nAA: X1\n", "R2=5 DEF REAL CC=3\n"});
  check_all("nc-flow-open", {"REPEAT\nR1=R1+1\nR2=7 UNTIL R1>2\n", "IF R1==0\nX1\nR2=5 ENDIF\n",
                             "LOOP\nX1\nGOTOF AA\nR2=5 ENDLOOP\nAA: X2\n"});
}

TEST_CASE("a label that differs by zeros before its number is refused") {
  check_all("nc-not-interpreted",
            {"GOTOF N010\nX1\nN10 X2\n", "IF R1==0 GOTOF N10\nX1\nN010 X2\nN10 X3\n",
             "CASE R1 OF 0 GOTOF N007 DEFAULT GOTOF N8\nN7 X1\nN8 X2\n", "GOTOF N10\nX1\n:010 X2\n"});
  check_all("", {"GOTOF N010\nX1\nN010 X2\n", "GOTOF N10\nX1\nN10 X2\nN010 X3\n",
                 "n05 X1\nR1=R1+1\nIF R1<3 GOTOB N05\n", "GOTOF LAB01\nX1\nLAB01: X2\n"});
}

TEST_CASE("what ends a branch or a loop stands alone in its block, wherever it is reached from") {
  check_all("nc-flow-control",
            {"IF R1==1\nX1\nELSE IF R1==0\nX2\nENDIF\nENDIF\n", "IF R1==1\nX1\nELSE GOTOF AA\nX2\nENDIF\nAA: X3\n",
             "IF R1==1\nX1\nELSE G0 X2 M8\nENDIF\n", "IF R1==1\nX1\nENDIF X2\n", "WHILE R1>0\nX1\nENDWHILE X2\n",
             "FOR R1=2 TO 1\nX1\nENDFOR M8\n", "IF R1==0\nX1\nENDIF X2\n", "REPEAT\nR1=R1+1\nUNTIL R1>2 X5\n"});
  check_all("nc-flow-label",
            {"IF R1==1\nX1\nELSEIF R1==0\nX2\nENDIF\n", "IF R1==0\nX1\nELSEIF R1==1\nX2\nELSE\nX3\nENDIF\n", "ENDIF\n",
             "ELSE\nX1\nENDIF\n", "IF R1==0\nX1\nELSE\nX2\nELSE\nX3\nENDIF\n",
             "IF R1==1\nX1\nELSE\nX2\nELSE\nX3\nENDIF\n", "LOOP\nX1\nELSE\nGOTOF AA\nENDLOOP\nAA: X2\n"});
  check_all("nc-flow-control", {"ELSEIF R1==0\n", "ELSIF\n"});
  check_all("nc-flow-open",
            {"IF R1==0\nX1\n", "IF R1==0\nX1\nELSE\nX2\n", "FOR R1=1 TO 2\nIF R1==1\nX1\nENDFOR\nENDIF\n",
             "IF R1==0\nFOR R2=1 TO 2\nX1\nENDIF\nENDFOR\n"});
  check_all("", {"IF R1==1\nX1\nELSE ; X2\nX3\nENDIF ; of R1\n", "N10 IF R1==1\nX1\nN20 ELSE\nX3\nAA: ENDIF\n",
                 "IF R1==0 GOTOF AA\nX1\nAA: X2\n", "IF R1==1\nIF R1==0\nELSE\nENDIF\nELSE\nX1\nENDIF\n"});
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

TEST_CASE("a label is not looked for in a line that is left out") {
  for (const std::string lines :
       {"GOTOF ZIEL\nX50\n/ZIEL: X10\nX20\n", "GOTOF N100\nX50\n /N100 X10\nX20\n", "GOTO ZIEL\nX5\n/2 ZIEL: X10\n",
        "ANF: X10\n/MITTE: X20\nENDE: X30\nREPEAT MITTE ENDE\n", "ANF: X10\n/ENDE: X30\nREPEAT ANF ENDE\n",
        "/ZEILE: X1\nX2\nREPEATB ZEILE P=2\n", "ANF: X10\n/ENDLABEL: X2\nX3\nREPEAT ANF\n",
        "R1=0\nCASE R1 OF 0 GOTOF EINS DEFAULT GOTOF ZWEI\n/EINS: X20\nZWEI: X30\n"}) {
    INFO(lines);
    CHECK(code_of(lines, true) == "nc-not-interpreted");
    CHECK(code_of(lines, false).empty());
  }
  CHECK(code_of("GOTOF ZIEL\nX50\nZIEL:\n/X10\nX20\n", true).empty());
  CHECK(code_of("ANF: X10\n/X20\nENDE: X30\nREPEAT ANF ENDE\n", true).empty());
}

TEST_CASE("what FOR leaves in its variable is not known") {
  check_all("nc-value-unknown", {"FOR R1=0 TO 2\nX=R1\nENDFOR\nY=R1\n", "FOR R1=0 TO 2\nENDFOR\nR2=R1+1\nX=R2\n",
                                 "FOR R1=0 TO 2\nX=R1\nENDFOR\nIF R1>2 GOTOF AUS\nX5\nAUS: X6\n",
                                 "FOR R1=1 TO 1\nENDFOR\nWHILE R1<5\nR1=R1+1\nX=R1\nENDWHILE\n"});
  check_all("", {"FOR R1=0 TO 2\nX=R1\nENDFOR\nR1=7\nY=R1\n", "FOR R1=5 TO 2\nX=R1\nENDFOR\nY=R1\n",
                 "FOR R1=0 TO 2\nFOR R2=0 TO R1\nX=R1 Y=R2\nENDFOR\nENDFOR\n",
                 "FOR R1=0 TO 9\nIF R1==3 GOTOF AUS\nENDFOR\nAUS: X=R1\n",
                 "FOR R1=0 TO 1\nENDFOR\nFOR R1=0 TO 1\nX=R1\nENDFOR\n"});
}

TEST_CASE("a feed per revolution needs a spindle that turns") {
  check_all("nc-feed-missing",
            {"M5\nG95 F0.1 X10\n", "G95 F0.1 X10\nM5\nX20\n", "SPOS=0\nG95 F0.1 X10\n",
             "M19\nG97 F0.1\nG2 X10 Y0 I5 J0\n", "SPOSA=DC(90)\nG95 F0.1 X10\n", "M70\nG95 F0.1\nCYCLE81(60,0,2,-5)\n",
             "M1=5\nG95 F0.1 X10\n", "CYCLE86(60,0,2,-5,,1,3,0,0,0,0)\nG95 F0.1 X10\n",
             "CYCLE84(60,0,2,-5,,,5,,1,,300,600)\nG95 F0.1 X10\n", "CYCLE840(60,0,2,-5,,,4,5,0,,1.5)\nG95 F0.1 X10\n"});
  check_all("", {"CYCLE86(60,0,2,-5,,1,3,0,0,0,0)\nG95 F0.1 M3 X10\n",
                 "M5\nCYCLE84(60,0,2,-5,,,3,,1,,300,600)\nG95 F0.1 S300 X10\n",
                 "CYCLE840(60,0,2,-5,,,4,3,0,,1.5)\nG95 F0.1 X10\n", "CYCLE85(60,0,2,-5,,1,80,160)\nG95 F0.1 X10\n"});
  check_all("", {"G95 F0.1\nM5\nM4\nX10\n", "M5\nG0 X10\n", "SPOS=90\nM3\nG95 F0.1 X10\n", "M5\nG94 F100 X10\n",
                 "SPOS=90\nG95 F0.1\nM1=3 X10\n"});
}

TEST_CASE("digits of an older CYCLE832 may deselect a frame") {
  check_all("nc-not-interpreted", {"TRANS X5\nCYCLE832(0.05,112103)\n", "ROT RPL=90\nX1 Y1\nCYCLE832(0.05, 10100,1)\n",
                                   "G58 X5\nR1=3\nCYCLE832(0.05,R1)\n", "TRANS Y1\nCYCLE832(0.05,1000203,1)\n"});
  check_all("", {"CYCLE832(0.05,112103)\n", "TRANS X5\nCYCLE832(0.05,3,1)\n", "TRANS X5\nCYCLE832(0.05,_FINISH,1)\n",
                 "TRANS X5\nCYCLE832()\nCYCLE832(0.05)\n", "TRANS X5\nCYCLE832(0.05,2000013,0.5)\n",
                 "TRANS X5\nTRANS\nCYCLE832(0.05,112103)\n"});
}

TEST_CASE("counts that a program says itself are not counted out") {
  check_all("nc-too-many-blocks", {"LAB_A:\nREPEAT LAB_A P=100000000\n", "FOR R1=1 TO 100000000\nENDFOR\n",
                                   "SUB P1000000000\nM30\n%_N_SUB_SPF\nM17\n", "LAB_A: X1\nREPEATB LAB_A P=20000000\n",
                                   "R2=90000000\nFOR R1=-5 TO R2\nENDFOR\n", "L77 P30000000\nM30\n%_N_L77_SPF\nRET\n"});
  check_all("", {"LAB_A:\nREPEAT LAB_A P=10\n", "FOR R1=1 TO 100\nENDFOR\n", "SUB P10\nM30\n%_N_SUB_SPF\nM17\n",
                 "FOR R1=1 TO 100000000\nIF R1==5 GOTOF OUT_\nENDFOR\nOUT_: X1\n"});
}

TEST_CASE("words whose reason is told") {
  check_all("nc-not-interpreted", {"R6='HFF'\n", "R7='B101'\n", "X='H0F'\n", "TC(\"MILL10\",,1)\n",
                                   "F_HEAD(1,\"\",0)\n", "IPOENDA[X]\n", "COARSEA[X]\n", "FINEA[A]\n"});
  check_all("nc-flow-control", {"DISPLOF\n", "N10 DISPLON\n", "X1\nACTBLOCNO\n"});
  check_all("nc-axes-unused", {"CIP X10 Y10 I1=10 J1=0\nX50 Y20\n", "CIP X10 Y10 I1=10 J1=0\nX5 I1=3\n",
                               "CIP X10 Y10 I1=10 J1=0\nM8\nZ5\n"});
  check_all("", {"CIP X10 Y10 I1=10 J1=0\nG1 X50 Y20\n", "CIP X10 Y10 I1=10 J1=0\nG0 Z50\nX3\n", "X5 M25 M26\n",
                 "M25 M26\n", "G1 X20 M=8\n", "M=3 S=500 X5\n", "M=9\n", "M111 M112 M113\n"});
}

TEST_CASE("an arc that ends a hundredth off its circle is refused: where the control goes there is not known") {
  check_all("nc-arc-radius", {"G2 X5 Y5.025 I5 J0\n", "G2 X10 Y0.5 I5 J0\n", "G2 X100 Y100.09 I100 J0\n"});
  check_all("", {"G2 X5 Y5.002 I5 J0\n", "G2 X7.071 Y2.929 I0 J10\n", "G2 X100 Y100.001 I100 J0\n"});
}

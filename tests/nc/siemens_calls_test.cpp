// How a SINUMERIK program calls others, and parts of itself: how often, by which labels, and with whose variables.
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "nc/programs.hpp"
#include "nc/siemens_cases.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

constexpr const char* kSubs =
    "M30\n%_N_L55_SPF\nX7\nRET\n%_N_SUBP_SPF\nX8\nM17\n%_N_TAKES_SPF\nPROC TAKES(REAL AT)\nX=AT\nRET\n";

// The X of its moves, or the code that refuses it.
std::string path_of(const std::string& lines) {
  ProgramSettings settings = empty_tables();
  settings.work_offsets[0] = WorkOffset{};
  const ProgramFile program(lines);
  if (const auto refused = refusal_of_file(program.path(), settings, "siemens")) {
    INFO(refused->message);
    CHECK_FALSE(refused->help.empty());
    return refused->code;
  }
  std::string ends;
  for (const Motion& motion : motions_of_file(program.path(), settings, "siemens")) {
    ends += fmt::format("{:g} ", motion.to[Axis::X]);
  }
  return ends;
}

std::string said_of(const std::string& text) {
  const auto refused = refusal_of(text, at_zero(), "siemens");
  return refused ? refused->message + " | " + refused->help : "";
}

void check_said(const std::string& text, const std::vector<std::string>& words, const std::string& but_not = "") {
  const std::string said = said_of(text);
  INFO(text << said);
  for (const std::string& word : words) CHECK(said.find(word) != std::string::npos);
  CHECK((but_not.empty() || said.find(but_not) == std::string::npos));
}

}  // namespace

TEST_CASE("P= says how often a program is called, as P does") {
  const auto path = [](const std::string& lines) { return path_of("G54 G0 X0\n" + lines + kSubs); };
  for (const std::string call : {"L55 P2", "L55 P=2", "L55P=2", "R1=2\nL55 P=R1", "L55 P=1+1 ; twice"}) {
    INFO(call);
    CHECK(path(call + "\nX1\n") == "0 7 7 1 ");
  }
  CHECK(path("R1=3\nSUBP P=R1\n") == "0 8 8 8 ");
  CHECK(path("TAKES(5) P=2\nTAKES(R1+1) P=R1+1\n") == "0 5 5 1 ");
  CHECK(path("SUBP P=0\n") == "nc-out-of-range");
  CHECK(path("SUBP P=2.5\n") == "nc-not-whole");
  CHECK(path("SUBP P=\n") == "nc-value-missing");
  CHECK(path("SUBP P=2 X5\n") == "nc-flow-control");
  for (const std::string call : {"P2 SUBP", "P=2 SUBP", "P2 L55"}) {
    INFO(call);
    CHECK(path(call + "\n") == "nc-flow-control");
    check_said("G54 G0 X0\n" + call + "\n" + kSubs, {"stands behind its name", " P2"});
  }
}

// As Autodesk's post for the 840D writes it: the parts behind M30, each with a LABEL0 of its own.
TEST_CASE("CALL BLOCK executes the part between two labels once") {
  const std::string two = "M30\nLABEL1:; CONTOUR\nX2\nX3\nLABEL0:\n\nLABEL2:\nX4\nLABEL0:";
  CHECK(path_of("G54 G0 X1\nCALL BLOCK LABEL1 TO LABEL0\nX9\n" + two) == "1 2 3 9 ");
  CHECK(path_of("G54 G0 X1\nN5 CALL BLOCK LABEL2 TO LABEL0 ; it\nX9\nCALL BLOCK LABEL2 TO LABEL0\n" + two) ==
        "1 4 9 4 ");
  CHECK(path_of("G54 G0 X1\ncall block label2 to label0\nCALL BLOCK LABEL1 TO LABEL0\n" + two + "\nX99\n") ==
        "1 4 2 3 ");
  CHECK(path_of("G54 G0\nPART: G91 X1\nX1\nENDP:\nCALL BLOCK PART TO ENDP\nG90 X9\n") == "1 2 3 4 9 ");
  CHECK(path_of("G54 G0\nFOR R1=1 TO 2\nX=R1\nCALL BLOCK AA TO BB\nENDFOR\nM30\nAA:\nX=R1+10\nBB:\n") == "1 11 2 12 ");
  CHECK(path_of("G54 G0 X1\nCALL BLOCK AA TO BB\nM30\nAA:\nL55\nX5\nREPEAT CC BB\nCC:\nBB:\n%_N_L55_SPF\nX7\nRET\n") ==
        "nc-not-interpreted");
  CHECK(path_of("G54 G0 X1\nCALL BLOCK AA TO BB\nX2\nM30\nAA:\nL55\nX5\nBB:\n%_N_L55_SPF\nX7\nRET\n") == "1 7 5 2 ");
  CHECK(path_of("G54 G0 X1\nSUB\nX2\nM30\n%_N_SUB_SPF\nCALL BLOCK AA TO BB\nX3\nRET\nAA:\nX5\nBB:\n") == "1 5 3 2 ");
  CHECK(path_of("G54 G0 X1\nCALL BLOCK AA TO BB\nM30\nAA:\nX2\nIF R1==0 GOTOF CC\nX3\nCC: X4\nBB:\n") == "1 2 4 ");
}

TEST_CASE("what CALL BLOCK does where no source says so") {
  const std::string start = "G54 G0 X1\nCALL BLOCK AA TO BB\nX9\nM30\n";
  for (const std::string part :
       {"AA:\nX2\nBB: X3\n", "AA:\nX2\nM30\nBB:\n", "AA:\nX2 M17\nBB:\n", "AA:\nX2\nRET\nBB:\n", "/AA:\nX2\nBB:\n",
        "AA:\nX2\n/BB:\n", "AA:\nX2\nBB:\nAA:\nX3\nBB:\n", "AA:\nM=30\nBB:\n",
        "AA:\nIF R1==0 GOTOF CC\nBB:\nCC: X5\n"}) {
    INFO(part);
    CHECK(path_of(start + part) == "nc-not-interpreted");
  }
  CHECK(path_of("DEF REAL LONG=3\n" + start + "AA:\nX=LONG\nBB:\n") == "nc-not-interpreted");
  CHECK(path_of("G54 G0 X1\nAA:\nCALL BLOCK AA TO BB\nBB:\n") == "nc-not-interpreted");
  CHECK(path_of(start + "AA:\nX2 M8\nMSG(\"M2\")\nM3 S100 ; M30\nBB:\n") == "1 2 9 ");
  for (const std::string part : {"AA:\nX2\n", "BB:\nX2\n", "BB:\nX2\nAA:\n", "CC:\nX2\nBB:\n"}) {
    INFO(part);
    CHECK(path_of(start + part) == "nc-flow-label");
  }
  for (const std::string call :
       {"CALL BLOCK", "CALL BLOCK AA", "CALL BLOCK AA BB", "CALL BLOCK AA TO", "CALL BLOCK AA TO BB P2"}) {
    INFO(call);
    CHECK(path_of("G54 G0 X1\n" + call + "\nM30\nAA:\nX2\nBB:\n") == "nc-flow-control");
  }
  CHECK(path_of("G54 G0 X1\nX5 CALL BLOCK AA TO BB\nM30\nAA:\nX2\nBB:\n") == "nc-flow-control");
  CHECK(path_of("G54 G0 X1\nCALL BLOCK N10 TO N20\nM30\nN10 X2\nN20\n") == "nc-flow-control");
  check_said("CALL \"SUB\" BLOCK AA TO BB\n", {"in a way that is not interpreted"});
}

TEST_CASE("parts that lead back to themselves are told at once") {
  const std::string start = "G54 G0 X1\nCALL BLOCK AA TO BB\nX9\nM30\n";
  for (const std::string parts :
       {"AA:\nCALL BLOCK CC TO DD\nBB:\nCC:\nCALL BLOCK AA TO BB\nDD:\n",
        "AA:\nX2\nIF R1<9\nR1=R1+1\nCALL BLOCK CC TO DD\nENDIF\nBB:\nCC:\nX3\nCALL BLOCK AA TO BB\nDD:\n",
        "AA:\nCALL BLOCK CC TO DD\nBB:\nCC:\nCALL BLOCK EE TO FF\nDD:\nEE:\nX3\nCALL BLOCK AA TO BB\nFF:\n",
        "AA:\nX2\nCALL BLOCK CC TO DD\nBB:\nCC:\nEE: X3\nREPEAT EE P=2\nCALL BLOCK AA TO BB\nDD:\n"}) {
    INFO(parts);
    CHECK(path_of(start + parts) == "nc-not-interpreted");
    check_said("R1=0\n" + start + parts, {"is being executed, called in line 3", "leads back to it"});
  }
  CHECK(path_of(start + "AA:\nX2\nCALL BLOCK CC TO DD\nCALL BLOCK CC TO DD\nBB:\nCC:\nX3\nDD:\n") == "1 2 3 3 9 ");
  CHECK(path_of("G54 G0\nCALL BLOCK AA TO CC\nM30\nAA:\nX2\nBB:\nX3\nCALL BLOCK AA TO BB\nCC:\n") == "2 3 2 ");
}

TEST_CASE("a part that is repeated or called holds loops and branches whole") {
  for (const std::string lines :
       {"IF R1==0\nAA: X1\nELSE\nX2\nENDIF\nREPEAT AA\n", "AA: X1\nFOR R1=1 TO 2\nBB:\nX=R1\nENDFOR\nREPEAT AA BB\n",
        "CALL BLOCK AA TO BB\nM30\nAA:\nX1\nFOR R2=1 TO 3\nBB:\nX2\nENDFOR\n",
        "CALL BLOCK AA TO BB\nM30\nWHILE R2<3\nAA:\nX1\nR2=R2+1\nENDWHILE\nBB:\n",
        "AA: X1\nIF R1<2\nR1=R1+1\nBB: X2\nREPEAT AA BB\nENDIF\n"}) {
    INFO(lines);
    CHECK(path_of("G54 G0\n" + lines) == "nc-not-interpreted");
    check_said("R1=0 R2=0\nG54 G0\n" + lines, {"begins or ends inside"});
  }
  CHECK(path_of("G54 G0\nFOR R1=1 TO 2\nAA: X=R1\nBB:\nREPEAT AA BB\nENDFOR\n") == "1 1 2 2 ");
  CHECK(path_of("G54 G0\nAA: X5\nFOR R1=1 TO 2\nX=R1\nENDFOR\nREPEAT AA\n") == "5 1 2 5 1 2 ");
  CHECK(path_of("G54 G0\nIF R1==0\nAA: X1\nX2\nREPEAT AA\nELSE\nX3\nENDIF\n") == "1 2 1 2 ");
  CHECK(path_of("G54 G0\nIF R1==0\nX1\nBB: X4\nENDIF\nREPEATB BB\n") == "1 4 4 ");
}

TEST_CASE("names that begin with _ are those of the program that declares them") {
  const std::string main = "DEF REAL _AA=5\nG54 G0 X=_AA\nSUB(_AA)\nX=_AA\nM30\n%_N_SUB_SPF\nPROC SUB(REAL ";
  CHECK(path_of(main + "BB)\nDEF REAL _AA=7\nX=_AA+BB\nM17\n") == "5 12 5 ");
  CHECK(path_of(main + "_AA)\n_AA=_AA*2\nX=_AA\nM17\n") == "5 10 5 ");
  CHECK(path_of(main + "_BB)\nX=_BB+1\nM17\n") == "5 6 5 ");
  CHECK(path_of("DEF INT _NN=2\nG54 G0\nSUB\nX=_NN\nM30\n%_N_SUB_SPF\nDEF REAL _NN=2.5\nX=_NN\nM17\n") == "2.5 2 ");
  CHECK(path_of("G54 G0\nSUB\nSUB\nM30\n%_N_SUB_SPF\nDEF REAL _NN\n_NN=_NN+1\nX=_NN\nM17\n") == "1 1 ");
  const std::vector<std::string> other = {"_AA is a variable of another program"};
  check_said(main + "BB)\nX=_AA\nM17\n", other);
  check_said(main + "BB)\n_AA=3\nM17\n", other);
  check_said("G54 G0\nSUB\nX=_AA\nM30\n%_N_SUB_SPF\nDEF REAL _AA=5\nM17\n", other);
  CHECK(path_of("DEF REAL _LONG=3\nG54 G0 X1\nCALL BLOCK AA TO BB\nM30\nAA:\nX=_LONG\nBB:\n") == "nc-not-interpreted");
}

TEST_CASE("a name that nothing declares is refused, also where what is not given counts as zero") {
  for (const std::string line :
       {"X=R1*FOO", "X=R1*R2Y5", "X=SIN(FOO)", "R5=FOO", "R5=FOO+1", "IF FOO==0 GOTOF LAB", "IF FOO GOTOF LAB",
        "FOR R5=FOO TO 3\nENDFOR", "CYCLE81(FOO,0,2,-5)", "F=_FOO+3", "TRANS X=FOO+1", "G4 F=FOO+1", "R[FOO+1]=3",
        "WHILE FOO<0\nENDWHILE", "X=IC(FOO)", "X=_VALUE", "X=_TASK+1", "R5=_VALUE_RETURNED"}) {
    INFO(line);
    const auto refused =
        refusal_of("G54 G17 G0 X0 Y0 Z5 S9 M3 F99\n" + line + "\nLAB: M30\n", empty_tables(), "siemens");
    REQUIRE(refused);
    CHECK(refused->code == "nc-parameter-unset");
    CHECK(refused->help.find("DEF") != std::string::npos);
  }
  CHECK(path_of("G54 G0 X=R1+1\nX=R[7]\n") == "1 0 ");
  check_said("G54 G0 X=R1+1\n", {"R1 was never given a value", "--variables"}, "DEF");
}

TEST_CASE("what a program takes from its caller is not known where none calls it") {
  const std::string head = "PROC POCK(REAL LEN, INT _NN, BOOL OK)\nG54 G0 X0\n";
  for (const std::string line : {"X=LEN+5", "R1=LEN", "IF _NN>2\nX1\nENDIF",
                                 "IF OK GOTOF LAB\nLAB:", "FOR R1=1 TO _NN\nENDFOR", "POCK(LEN,1,TRUE)", "G4 F=LEN"}) {
    INFO(line);
    check_said(head + line + "\nRET\n", {"is a parameter of this program", "the program that calls this one"});
  }
  CHECK(said_of(head + "LEN=7\nX=LEN+5\nRET\n").empty());
  CHECK(said_of(head + "X5\nRET\n").empty());
  CHECK(said_of("G54 G0 X0\nPOCK(1)\nM30\n%_N_POCK_SPF\n" + head + "X=LEN+_NN\nRET\n").empty());
  CHECK(path_of(head + "X=LEN+5\nRET\n") == "0 5 ");  // what is not given counts as zero in trace
}

TEST_CASE("GOTO finds one label before its line, and GOTOB the nearest") {
  const auto path = [](const std::string& jump) {
    return path_of("G54 G0 X0\nLAB: R1=R1+1\nX1\nIF R1==1 GOTOF LAB\nX9\nLAB: X2\nIF R1<2 " + jump + " LAB\nX3\n");
  };
  CHECK(path("GOTO") == "nc-not-interpreted");
  CHECK(path_of("G54 G0 X0\nLAB: X1\nLAB: X2\nR1=R1+1\nIF R1<2 GOTO LAB\n") == "nc-not-interpreted");
  CHECK(path_of("G54 G0 X0\nN10 X1\nN10 X2\nR1=R1+1\nCASE R1 OF 1 GOTO N10\n") == "nc-not-interpreted");
  CHECK(path_of("G54 G0 X0\nLAB: X1\nLAB: X2\nR1=R1+1\nIF R1<2 GOTOB LAB\n") == "0 1 2 2 ");
  CHECK(path_of("G54 G0 X0\nLAB: X1\nR1=R1+1\nIF R1<2 GOTO LAB\n") == "0 1 1 ");
  CHECK(path_of("G54 G0 X0\nLAB: X1\nLAB: X2\nGOTO LAB\nX9\nLAB: X3\nLAB: X4\n") == "0 1 2 3 4 ");
  check_said("LAB: G54\nLAB: G90\nGOTO LAB\n", {"the lines 1 and 2", "GOTOB"});
}

TEST_CASE("a variable of another program is said to be one") {
  const std::string head = "DEF REAL ABC=5\nG54 G0 X0\nSUBLUD\nM30\n%_N_SUBLUD_SPF\n";
  for (const std::string line :
       {"X=ABC", "R1=ABC*2", "ABC=3", "IF ABC>3 GOTOF LA1\nLA1:", "G1 X=ABC F100", "X=2*ABC"}) {
    INFO(line);
    const std::string text = head + line + "\nM17\n";
    check_said(text, {"ABC is a variable of another program", "PROC NAME(REAL ABC)"}, "--variables");
    const auto traced = refusal_of(text, empty_tables(), "siemens");
    REQUIRE(traced);
    CHECK(traced->message + " | " + traced->help == said_of(text));
  }
  check_said("G54 G0 X0\nSUBLUD\nX=ABC\nM30\n%_N_SUBLUD_SPF\nDEF REAL ABC=5\nM17\n", {"of another program"});
  check_said("G54 G0 X0\nX=ABC\nM30\n", {"ABC was never given a value", "DEF"}, "--variables");
}

TEST_CASE("words of calls and conditions that are not read name a way out") {
  check_said("PROC KONT2(REAL XX, INT N)\nM17\n", {"a name, which begins with two letters"});
  check_said("G54 G0 X0\nIF R1==1 GOTOF AA IF R1==2 GOTOF BB\nAA:\nBB:\nM30\n", {"several conditions", "each IF"});
  check_said("IF R1==1 GOTOF AA IF R1==0 GOTOB AA\nAA:\n", {"each IF"});
  for (const std::string jump : {"GOTOF \"LB\"<<R1", "GOTOB \"LAB\"", "IF R1==1 GOTO \"LAB\""}) {
    check_said("R1=1\n" + jump + "\nLAB: M30\n", {"given as a text", "without quotes"}, "is missing");
  }
  for (const std::string condition :
       {"IF R1=1 GOTOF LAB", "IF R1=>1 GOTOF LAB", "IF (R1)=2\nENDIF", "WHILE R1=1\nENDWHILE"}) {
    check_said("R1=1\n" + condition + "\nLAB: M30\n", {"==", "compare"}, "words into a block");
  }
  check_said("R1=1\nIF R1==1 THEN\nX1\nENDIF\n", {"no THEN", "leave it out"});
  check_said("R1=1\nIF R1==1 THEN GOTOF LAB\nLAB: M30\n", {"no THEN"});
  check_said("DEFINE ABSAUGEN AS M8\nG54 G0 X0\nABSAUGEN\nM30\n", {"a macro", "where the name stands"}, "SPF");
  check_said("G54 G[1]=2 X0\nM30\n", {"G[..]", "the code itself"});
  check_said("G54 G0 X0 F[X]=100\nM30\n", {"F[..]"}, "a value is missing");
  check_said("G54 G0 X0\nNOWHERE\nM30\n", {"NOWHERE.SPF", "a word of the control"});
  check_said("G54 G0 X0\nNOWHERE=5\nM30\n", {"DEF REAL NOWHERE", "a word of the control"});
}

TEST_CASE("a program of an archive begins with its name behind %, with _N_ or without") {
  const auto x_at_end = [](const std::vector<Motion>& motions) {
    return fmt::format("X{:g}", motions.empty() ? 0 : motions.back().to[Axis::X]);
  };
  const std::string start = "G54 G17 G90 G94 G710\nG0 X0 Y0 Z50 A0 B0 C0\nF100\n";
  check_siemens(start, x_at_end, "X3",
                {"SUB1\nM30\n%_N_SUB1_SPF\nG1 X3\nM17\n", "SUB1\nM30\n%SUB1_SPF\nG1 X3\nM17\n",
                 "Sub1\nM30\n% sub1_spf\nG1 X3\nM17\n%OTHER_SPF\nG1 X9\nM17\n", "G1 X3\nM30\n%\n"});
}

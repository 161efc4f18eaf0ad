// How a SINUMERIK program calls others, and parts of itself: how often, by which labels, and with whose variables.
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "nc/programs.hpp"

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
  check_said("DEFINE ABSAUGEN AS M8\nG54 G0 X0\nABSAUGEN\nM30\n", {"a macro", "where the name stands"}, "SPF");
  check_said("G54 G[1]=2 X0\nM30\n", {"G[..]", "the code itself"});
  check_said("G54 G0 X0 F[X]=100\nM30\n", {"F[..]"}, "a value is missing");
  check_said("G54 G0 X0\nNOWHERE\nM30\n", {"NOWHERE.SPF", "a word of the control"});
  check_said("G54 G0 X0\nNOWHERE=5\nM30\n", {"DEF REAL NOWHERE", "a word of the control"});
}

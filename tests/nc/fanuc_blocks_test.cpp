// Blocks of Fanuc's language of which a control makes something else than their words seem to say.
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

const std::string kFanucHead = "G21 G90 G54 G0 X0 Y0 Z50.\n";

struct FanucEnd {
  std::string said;  // code, line and column of the refusal, its message and help; empty: none
  AxisWords position;
};

FanucEnd fanuc_end_of(const std::string& blocks, bool as_it_stands, const std::string& dialect_name = "fanuc") {
  ProgramSettings settings = empty_tables();
  settings.as_with_empty_tables = as_it_stands;
  settings.work_offsets[0] = WorkOffset{};
  for (auto& axis : settings.start) axis = 0;
  const ProgramFile program(blocks);
  const InputFile file(program.path());
  FanucEnd end;
  try {
    Program steps(file, dialect(dialect_name), settings);
    while (const Step* step = steps.next()) end.position = step->position;
  } catch (const Refusal& refusal) {
    const Diagnostic& what = refusal.diagnostic();
    end.said = what.code + " " + std::to_string(what.place.line) + ":" + std::to_string(what.place.column) + " " +
               what.message + " | " + what.help;
  }
  return end;
}

struct FanucRefusal {
  std::string blocks, begins, names;
};

// Both to who looks at the program as it stands, and to who corrects it.
void check_fanuc_refused(const std::vector<FanucRefusal>& cases) {
  for (const FanucRefusal& c : cases) {
    for (const bool as_it_stands : {true, false}) {
      INFO(c.blocks << (as_it_stands ? " as it stands" : " corrected"));
      const std::string said = fanuc_end_of(kFanucHead + c.blocks + "\nM30\n", as_it_stands).said;
      INFO(said);
      CHECK(said.substr(0, c.begins.size()) == c.begins);
      CHECK(said.find(c.names) != std::string::npos);
    }
  }
}

void check_fanuc_read(const std::vector<std::string>& cases) {
  for (const std::string& blocks : cases) {
    for (const bool as_it_stands : {true, false}) {
      INFO(blocks << (as_it_stands ? " as it stands" : " corrected"));
      CHECK(fanuc_end_of(kFanucHead + blocks + "\nM30\n", as_it_stands).said.empty());
    }
  }
}

}  // namespace

TEST_CASE("fanuc: the code of a cycle without a place drills nothing twice: it is refused") {
  const std::string code = "nc-axes-missing 3:";
  const std::string cycle = "G81 X10. Y0 Z-5. R2. F100.\n";
  check_fanuc_refused({{"G84 X5. Y0 Z-5. R5. F500.\nG84 S400 F400.\nX10.\nG80", code + "1", "G84 without X, Y or Z"},
                       {cycle + "G82 P500\nX20.", code + "1", "differs between controls"},
                       {cycle + "G81", code + "1", "beside X and Y"},
                       {cycle + "G81 M8", code, ""},
                       {cycle + "G99 G81 F200.", code + "5", ""},
                       {cycle + "G83 Q2.", code, ""},
                       {cycle + "G98 G73 Q2.\nX5.", code + "5", ""},
                       {cycle + "G81 R3.", code, ""},
                       {cycle + "G81 X#3\nX20.", code, ""},
                       {cycle + "G89 P300", code, ""},
                       {"G81", "nc-axes-missing 2:1", ""}});
  check_fanuc_read({cycle + "F200.\nX20.", cycle + "M8\nX20.", cycle + "X#3\nY5.", cycle + "G82 X5. P500\nG80",
                    "G81 Z-5. R2. F100.\nG80", cycle + "G98\nX20."});
}

TEST_CASE("fanuc: G68 and G68.2 count by the G90 or G91 of their own block") {
  check_fanuc_refused({{"G68 X0 Y0 G91 R30.", "nc-not-interpreted 2:1", "under G91"},
                       {"G91 G68 X5. Y5. R30.", "nc-not-interpreted 2:5", "under G91"},
                       {"G91\nG68 X5. Y5. R30.", "nc-not-interpreted 3:1", "under G91"},
                       {"G91 G68.2 X10. Y5. Z3. I0 J10. K0", "nc-tilted-plane 2:5", "under G91"},
                       {"G68.2 X10. Y5. Z3. I0 J10. K0 G91", "nc-tilted-plane 2:1", "under G91"}});
  check_fanuc_read({"G91\nG90 G68 X5. Y5. R30.\nG69", "G91\nG68 X5. Y5. R30. G90\nG69",
                    "G91\nG90 G68.2 X10. Y5. Z3. I0 J10. K0\nG69"});
}

TEST_CASE("fanuc: a condition is no number, and a number no condition") {
  const std::string number = "nc-flow-control 3:", condition = "nc-operator 3:";
  const std::string set = "#1=5.\n";
  check_fanuc_refused({{set + "IF [#1] GOTO 5\nN5", number + "4 ", "[#1 NE 0]"},
                       {set + "IF [2] GOTO 6\nN6", number, "no condition"},
                       {set + "IF [3 AND 2] GOTO 7\nN7", number, ""},
                       {set + "IF [[#1+2]*3] THEN #2=1", number, ""},
                       {set + "WHILE [#1] DO1\n#1=0\nEND1", number + "7 ", ""},
                       {set + "#2=[3 LT 4]", condition + "3 ", "a number is needed"},
                       {set + "#2=[#1 GT 3]*10", condition, ""},
                       {set + "#2=3 LT 4", condition, ""},
                       {set + "#2=-[#1 EQ 5]", condition, ""},
                       {set + "#2=ABS[#1 EQ 5]", condition, ""},
                       {set + "#[1 EQ 1]=3", condition, ""},
                       {set + "X[1 EQ 1]", condition + "1 ", ""},
                       {set + "Y[[#1 EQ 5]+1]", condition, ""},
                       {set + "IF [[#1 EQ 5] EQ 1] GOTO 8\nN8", condition, ""},
                       {set + "IF [[#1 EQ 5] AND 1] GOTO 8\nN8", condition, ""},
                       {set + "GOTO [1 EQ 1]\nN1", condition, ""}});
  check_fanuc_read({set + "IF [[#1 EQ 5] AND [#1 GT 2]] GOTO 8\nN8", set + "IF [[#1 AND 4] EQ 4] GOTO 8\nN8",
                    set + "IF [[#1 EQ 5]] GOTO 8\nN8", set + "WHILE [#1 GT 3 + 1] DO1\n#1=#1-1\nEND1",
                    set + "IF [[#1 LT 2] OR [[#1 EQ 5] XOR [#1 EQ 6]]] THEN #2=1", set + "#2=[#1 AND 4]*10\nX[#2/4]"});
}

TEST_CASE("okuma: a condition is no number, and a number no condition") {
  const std::string head = "G15 H1 G90 G0 X0 Y0 Z50\nVC1=5\n";
  for (const std::string line : {"IF [VC1] N9", "IF [VC1+1] N9", "IF [[VC1 AND VC1] GT [VC1 EQ 5]] N9", "X=[2 GT 1]*5",
                                 "VC2=[VC1 EQ 5]", "X=ABS[VC1 EQ 5]", "VC2=-[VC1 EQ 5]", "X=[VC1 EQ 1]"}) {
    INFO(line);
    const std::string said = fanuc_end_of(head + line + "\nN9 X1\nM2\n", true, "okuma").said;
    INFO(said);
    CHECK((said.find("no condition") != std::string::npos || said.find("a number is needed") != std::string::npos));
  }
  for (const std::string line : {"IF [VC1 EQ 5] N9", "IF [[VC1 EQ 5] AND [VC1 GT 2]] N9",
                                 "IF [[VC1 EQ 5] OR [VC1 GT 9]] N9", "IF [VC1 GT [2+2]] N9", "X=[VC1+1]*2"}) {
    INFO(line);
    const std::string said = fanuc_end_of(head + line + "\nN9 X1\nM2\n", true, "okuma").said;
    INFO(said);
    CHECK(said.empty());
  }
}

TEST_CASE("fanuc: no block has the number 0 to go on at") {
  check_fanuc_refused({{"GOTO 0\nX1.\nN0 X5.", "nc-out-of-range 2:1", "N0"},
                       {"#1=0\nIF [#1 EQ 0] GOTO #1\nN0 X5.", "nc-out-of-range 3:1", "1 to 99999"},
                       {"GOTO [3-4]\nN1 X5.", "nc-out-of-range 2:1", "N-1"},
                       {"M98 P7\nN0 X5.\nM30\nO7\nM99 P0", "nc-out-of-range 6:1", "N0"}});
  check_fanuc_read({"N0 X5.", "GOTO 1\nX3.\nN1 X5.", "GOTO 99999\nN99999 X1."});
}

TEST_CASE("fanuc: increments of X and Y after a turn are refused for who corrects as well") {
  const std::string turn = "X10. Y10.\nG68 X0 Y0 R30.\n", code = "nc-not-interpreted ";
  check_fanuc_refused({{turn + "X10. Y0\nG69\nG91 X1. Y1.", code + "6:5", "G90"},
                       {turn + "X10. Y0\nG91 G69 X1. Y1.", code + "5:9", "G90"},
                       {turn + "G91 X5. Y5.", code + "4:5", "G90"},
                       {turn + "G91 G1 Y5. F100.", code + "4:8", "G90"},
                       {turn + "Z5.\nG91 G99 G81 X1. R-40. Z-5. F100.", code + "5:13", "G90"}});
  check_fanuc_read({turn + "X10. Y0\nG91 X1. Y1.", turn + "X10. Y0\nG69\nX1. Y1.\nG91 X5.", turn + "G69\nG91 Z5."});
}

TEST_CASE("fanuc: what is missing is named, with the vacant variable that is behind it") {
  check_fanuc_refused({{"G4", "nc-word-missing 2:1", "an X or a P word"},
                       {"G4 P#1", "nc-word-missing 2:1", "P#1 has no value here"},
                       {"G4 X#2", "nc-word-missing 2:1", "X#2 has no value here"},
                       {"G68 X0 Y0 R#5", "nc-word-missing 2:1", "R#5 has no value here"},
                       {"G81 X5. Y0 Z-5. R#7 F100.", "nc-word-missing 2:1", "R#7 has no value here"},
                       {"X1. (A(B))", "nc-comment-nested 2:7", "do not nest"},
                       {"GOTO 5 (A(B))\nN5", "nc-comment-nested 2:10", "do not nest"},
                       {"GOTO 5 (A\nN5", "nc-comment-open 2:8", ""}});
  CHECK(fanuc_end_of("O0001(T(EST))\n" + kFanucHead, true).said.substr(0, 21) == "nc-comment-nested 1:8");
  CHECK(fanuc_end_of("O0001(TEST\n" + kFanucHead, true).said.substr(0, 19) == "nc-comment-open 1:6");
}

TEST_CASE("fanuc: a rotary word in a cycle is read where it turns nothing") {
  const std::string cycle = "G81 X10. Y0 Z-5. R2. F100.";
  check_fanuc_read({cycle + " A0", cycle + " A0. B0. C0.\nX20. A0.", "G0 C30.\n" + cycle + " C30.\nY5. C30. A0",
                    cycle + "\nG91 X5. R-48. Z-7. B0"});
  check_fanuc_refused({{cycle + " A0.001", "nc-axes-unused 2:28", "stand still"},
                       {cycle + "\nX20. C5.", "nc-axes-unused 3:6", ""},
                       {"G0 C30.\n" + cycle + " C0", "nc-axes-unused 3:28", ""},
                       {cycle + "\nA0.", "nc-axes-missing 3:1", "without X, Y or Z"}});
  CHECK_FALSE(fanuc_end_of("G90 G21 G0 X0 Y0 Z50.\n" + cycle + " A0\nM2\n", true, "linuxcnc").said.empty());
}

TEST_CASE("fanuc: P of eight digits calls the program of that number where the file has it") {
  const std::string whole = "O00010002\nX5.\nM99\n";
  const std::string short_one = "O2\nX7.\nM99\n";
  const auto end_x = [&](const std::string& call, const std::string& programs) {
    const FanucEnd end = fanuc_end_of("%\nO00010001\n" + kFanucHead + call + "\nM30\n" + programs + "%\n", true);
    return end.said.empty() ? std::to_string(std::lround(end.position[Axis::X])) : end.said.substr(0, 25);
  };
  CHECK(end_x("M98 P00010002", whole) == "5");
  CHECK(end_x("M98 P10002", whole) == "5");
  CHECK(end_x("M98 P00010002", short_one) == "7");
  CHECK(end_x("M98 P00010002 L1", whole + short_one) == "5");
  CHECK(end_x("M98 P2", whole + short_one) == "7");
  CHECK(end_x("M98 P00010002", whole + short_one) == "nc-subprogram-ambiguous 4");
}

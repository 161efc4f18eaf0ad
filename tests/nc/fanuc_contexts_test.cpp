// Codes of Fanuc beside others, or in a mode, where its manuals forbid it or no source says what comes of it.
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

struct Reading {
  std::string code;  // of the refusal; empty: none
  std::size_t line = 0, column = 0;
  AxisWords end;
};

Reading reading_of(const std::string& text, bool as_with_empty_tables,
                   std::optional<bool> block_delete = std::nullopt) {
  ProgramSettings settings = empty_tables();
  settings.block_delete = block_delete;
  settings.as_with_empty_tables = as_with_empty_tables;
  settings.work_offsets[0] = WorkOffset{};
  Tool tool;
  tool.number = 1;
  tool.length_mm = 100;
  settings.tools = ToolTable({tool});
  const ProgramFile program(text);
  const InputFile file(program.path());
  Reading ran;
  try {
    Program blocks(file, dialect("fanuc"), settings);
    while (const Step* step = blocks.next()) ran.end = step->position;
  } catch (const Refusal& refusal) {
    ran.code = refusal.diagnostic().code;
    ran.line = refusal.diagnostic().place.line;
    ran.column = refusal.diagnostic().place.column;
  }
  return ran;
}

struct RefusedAt {
  const char* program;
  std::size_t line, column;
};

void check_refused_at(const std::vector<RefusedAt>& cases) {
  for (const RefusedAt& c : cases) {
    const Reading ran = reading_of(c.program, true);
    INFO(c.program);
    CHECK(ran.code == "nc-not-interpreted");
    CHECK(ran.line == c.line);
    CHECK(ran.column == c.column);
  }
}

}  // namespace

TEST_CASE("increments of X and Y after G69 are refused until absolute words stand") {
  check_refused_at(
      {{"G90 G54 G0 X10. Y10. Z50.\nG68 X0 Y0 R30.\nX5. Y5.\nG69\nG91 X5.\n", 5, 5},
       {"G90 G54 G0 X10. Y10. Z50.\nG68 X0 Y0 R30.\nX5. Y5.\nG69 G91 Y5.\n", 4, 9},
       {"G90 G54 G0 X10. Y10. Z50.\nG68 X1. Y2. R90.\nG91 G1 X1. F100.\n", 3, 8},
       {"G90 G54 G0 X10. Y10. Z50.\nG68 X1. Y2. R90.\nX0 Y0\nG69\nG99 G91 G81 X1. R-40. Z-5. F100.\n", 5, 13},
       {"G90 G54 G0 X10. Y10. Z50.\nG68 X1. Y2. R90.\nX0 Y0\nG69 G99 G91 G81 X1. R-40. Z-5. F100.\n", 4, 17}});
  const Reading ran =
      reading_of("G90 G54 G0 X10. Y10. Z50.\nG68 X0 Y0 R90.\nX5. Y5.\nG91 X1.\nG69\nG90 X0 Y0\nG91 X2.\n", true);
  CHECK(ran.code.empty());
  CHECK(ran.end[Axis::X] == 2);
}

TEST_CASE("X without Y as the first move after a turn is refused, Z alone is not") {
  check_refused_at({{"G90 G54 G0 X10. Y10. Z50.\nG68 X0 Y0 R30.\nX5.\n", 3, 1},
                    {"G90 G54 G0 X10. Y10. Z50.\nG68 X0 Y0 R30.\nG1 Y5. Z1. F100.\n", 3, 4},
                    {"G90 G54 G0 X10. Y10. Z50.\nG68 X0 Y0 R30.\nX5. Y5.\nG69\nX0\n", 5, 1},
                    {"G90 G54 G0 X10. Y10. Z50.\nG68 X0 Y0 R30.\nX5. Y5.\nG69 X0\n", 4, 5},
                    {"G90 G54 G0 X10. Y10. Z50.\nG68 X0 Y0 R-8.\nX5. Y5.\nG69 G1 Y2. F100.\n", 4, 8}});
  CHECK(reading_of("G90 G54 G0 X10. Y10. Z50.\nG68 X0 Y0 R30.\nZ5.\nX1. Y1.\nX2.\nG69\nZ50.\n", true).code.empty());
}

TEST_CASE("increments of Z after G43 and G49 alone are refused until Z is stated") {
  check_refused_at({{"G90 G54 G0 X0 Y0 Z50.\nG43 H1\nG91 Z-10.\n", 3, 5},
                    {"G90 G54 G0 X0 Y0 Z50.\nG43 H1 Z50.\nG49\nG91 G1 X1. Z-10. F100.\n", 4, 12},
                    {"G90 G54 G0 X0 Y0 Z50.\nG43.4 H1\nG91 X1.\nG1 Z-1. F100.\n", 4, 4},
                    {"G90 G54 G0 X0 Y0 Z50.\nG91 G43 H7 Z-1.\n", 2, 12}});
  CHECK(reading_of("G90 G54 G0 X0 Y0 Z50.\nG43 H1 Z20.\nG49\nG91 G28 Z0\nG28 X0 Y0\n", true).code.empty());
  const Reading ran = reading_of("G90 G54 G0 X0 Y0 Z50.\nG43 H1 Z20.\nG91 Z-10.\nX3.\n", true);
  CHECK(ran.code.empty());
  CHECK(ran.end[Axis::Z] == 10);
}

TEST_CASE("a jump to a number that stands twice is refused, as parameters decide where it goes") {
  const std::string head = "G90 G54 G0 X10. Y10. Z50.\n";
  check_refused_at({{(head + "N9 X1.\nGOTO 9\nN9 X5.\nM30\n").c_str(), 3, 1},
                    {(head + "#1=1\nIF [#1 EQ 1] GOTO 20\nX1.\nN20 X2.\nN0020 X3.\nM30\n").c_str(), 3, 1},
                    {(head + "M98 P7\nN30 X1.\nN30 X2.\nM30\nO7\nX9.\nM99 P30\n").c_str(), 8, 1}});
  CHECK(reading_of(head + "N9 X1.\nN9 X5.\nGOTO 10\nN10 X2.\nM30\n", true).code.empty());
}

TEST_CASE("G92 in a system shifted by G52 is refused") {
  const std::string head = "G90 G54 G0 X10. Y10. Z50.\n";
  check_refused_at({{(head + "G52 X10. Y5.\nX0 Y0\nG92 X0 Y0\n").c_str(), 4, 1},
                    {(head + "G52 Z-5.\nX0 Y0\nG92 X3.\n").c_str(), 4, 1},
                    {(head + "G52 X1.\nG0 X0\nG52 Y2.\nG92 Y0\n").c_str(), 5, 1}});
  CHECK(reading_of(head + "G52 X10.\nX0\nG52 X0 Y0 Z0\nG92 X0 Y0\n", true).code.empty());
}

TEST_CASE("G52 and G92 under G91 are refused") {
  check_refused_at({{"G91 G54 G52 X5.\n", 1, 9},
                    {"G90 G54 G0 X10. Y10. Z50.\nG91\nG52 X0 Y0 Z0\n", 3, 1},
                    {"G90 G54 G0 X10. Y10. Z50.\nG92 X0 G91\n", 2, 1}});
  const Reading ran = reading_of("G90 G54 G0 X10. Y10. Z50.\nG91\nG90 G52 X5.\nX1.\n", true);
  CHECK(ran.code.empty());
  CHECK(ran.end[Axis::X] == 1);
}

TEST_CASE("G92.1 brings the named axes back alone") {
  const std::string shifted = "G90 G54 G0 X10. Y10. Z50.\nG92 X0. Y3. Z1.\n";
  Reading ran = reading_of(shifted + "G92.1 X0\n", true);
  CHECK(ran.code.empty());
  CHECK(ran.end == AxisWords{{10, 3, 1, 0, 0, 0}});
  ran = reading_of(shifted + "G92.1 Y0 Z0\n", true);
  CHECK(ran.end == AxisWords{{0, 10, 50, 0, 0, 0}});
  ran = reading_of(shifted + "G92.1 X0 Y0 Z0\nG91 X1.\n", true);
  CHECK(ran.end == AxisWords{{11, 10, 50, 0, 0, 0}});
}

TEST_CASE("a drilling cycle keeps its levels only while the zero of Z stays") {
  const std::string cycle = "G90 G54 G0 X0 Y0 Z50.\nG43 H1 Z50.\nG81 X0 Y0 Z-5. R2. F100.\n";
  check_refused_at({{(cycle + "G49\nX5.\n").c_str(), 5, 1},
                    {(cycle + "G92 Z0.\nX5. Y5.\n").c_str(), 5, 1},
                    {(cycle + "G52 X1. Z-1.\nX5. Y5.\n").c_str(), 5, 1}});
  CHECK(reading_of(cycle + "G52 X1.\nX5. Y5.\n", true).code.empty());
  CHECK(reading_of(cycle + "G80\nG52 Z1.\nG81 X5. Z-5. R2. F100.\n", true).code.empty());
}

TEST_CASE("a turn about the place of the tool is looked at, and not rewritten") {
  const std::string text = "G90 G54 G0 X10. Y10. Z50.\nG68 R90.\nX20. Y10.\nG69\nX0 Y0\n";
  CHECK(reading_of(text, true).code.empty());
  CHECK(reading_of(text, false).code == "nc-position-read");
}

TEST_CASE("a number is not looked for in a line that is left out") {
  const std::string head = "O1000\nG21 G90 G94 G54\nG0 X0 Y0 Z10.\n";
  for (const std::string lines : {"GOTO 100\nX50.\n/N100 X10.\nM30\n", "IF [1 EQ 1] GOTO 100\nX50.\n /N100 X10.\nM30\n",
                                  "M98 P2000\nX3.\n/N200 X5.\nM30\nO2000\nX1.\nM99 P200\n"}) {
    INFO(lines);
    CHECK(reading_of(head + lines, true, true).code == "nc-not-interpreted");
    CHECK(reading_of(head + lines, true, false).code.empty());
  }
  CHECK(reading_of(head + "GOTO 100\n/X50.\nN100 X10.\nM30\n", true, true).code.empty());
}

TEST_CASE("fanuc: what depends on the last digits that a control keeps is refused") {
  const std::string head = "O1\nG90 G21 G54 G0 X0 Y0 Z50.\n";
  for (const std::string loop :
       {"#11=0\nWHILE[#11GT-3.]DO1\n#11=#11-0.3\nG1 Z#11 F100.\nEND1\n", "#1=FIX[1.15*100]\nG1 X#1 F100.\n",
        "#1=0.7\nN1 G1 X#1 F100.\n#1=#1+0.7\nIF[#1LE7.]GOTO1\n", "IF[1.1*1.1 EQ 1.21]GOTO9\nG1 X5. F100.\nN9\n",
        "#1=FUP[0.1*3*10]\nG1 X#1 F100.\n", "#1=1.005*100\n#2=ROUND[#1]\nG1 X#2 F100.\n", "IF[1/3*3 EQ 1]GOTO9\nN9\n",
        "#1=FIX[360/[360/11]]\n", "#1=FIX[2.4/0.3]\n", "#1=30*COS[60]\nIF[#1 LT 15]GOTO9\nN9\n",
        "#1=0\nWHILE[#1LT2.4]DO1\n#1=#1+0.3\nEND1\n"}) {
    INFO(loop);
    CHECK(reading_of(head + loop + "M30\n", false).code == "nc-not-interpreted");
  }
  for (const std::string loop :
       {"#11=0\nWHILE[#11GT-2.95]DO1\n#11=#11-0.3\nG1 Z#11 F100.\nEND1\n", "#1=FIX[1.15*100+0.01]\nG1 X#1 F100.\n",
        "#1=0\nN1 G1 X#1 F100.\n#1=#1+0.25\nIF[#1LE7.]GOTO1\n", "#1=FUP[2.5]\n#2=ROUND[2.5]\nG1 X#1 F100.\n",
        "#1=0.3\nIF[#1 EQ 0.3]GOTO9\nN9\n", "IF[1000.0001 GT 1000.]GOTO9\nN9\n",
        "#1=7\n#2=#1*22.5/2\nIF[#2 LT 78.75]GOTO9\nN9\n", "#1=0\nWHILE[#1LT3]DO1\n#1=#1+1\nEND1\n",
        "IF[1000.001 GT 1000.]GOTO9\nG1 X5. F100.\nN9\n"}) {
    INFO(loop);
    CHECK(reading_of(head + loop + "M30\n", false).code.empty());
  }
}

TEST_CASE("fanuc: what hands a value on hands on that its last digits are open") {
  const std::string head = "O1\nG90 G21 G54 G0 X0 Y0 Z50.\n#1=0.1+0.2\n";
  for (const std::string text :
       {"G65 P2 A[0.1+0.2]\nM30\nO2\nIF[#1 EQ 0.3]GOTO9\nN9 M99\n", "G65 P2 I#1\nM30\nO2\n#5=FIX[#4*10]\nM99\n",
        "G65 P2 X-#1\nM30\nO2\nG65 P3 Z#24\nM99\nO3\nIF[#26 GE -0.3]GOTO9\nN9 M99\n",
        "G65 P2 A#1 K[#1*10]\nM30\nO2\n#100=#6\nM98 P3\nM99\nO3\nWHILE[#100 LT 3]DO1\n#100=#100+1\nEND1\nM99\n",
        "#101=#1\nM98 P2\nM30\nO2\nIF[#101 EQ 0.3]GOTO9\nN9 M99\n"}) {
    INFO(text);
    CHECK(reading_of(head + text, false).code == "nc-not-interpreted");
  }
  for (const std::string text :
       {"G65 P2 A0.3 B[0.25*2]\nM30\nO2\nIF[#1 EQ 0.3]GOTO9\nN9 M99\n",
        "G65 P2 A#1\nM30\nO2\nIF[#1 GT 0.25]GOTO9\nN9 M99\n", "G65 P2 A[0.25*2]\nM30\nO2\n#3=FIX[#1*2]\nM99\n"}) {
    INFO(text);
    CHECK(reading_of(head + text, false).code.empty());
  }
}

TEST_CASE("fanuc: a vacant variable counts as 0 in an expression, and in the brackets of a word nobody knows") {
  const std::string head = "G90 G21 G54 G0 X0 Y0 Z50.\nG65 P100 X10.\nM30\nO100\n";
  for (const std::string text : {"#10=-#26", "#10=+#26", "#10=-[#26]", "#10=[#26]*1", "#10=#26+0", "#10=ABS[#26]"}) {
    INFO(text);
    CHECK(reading_of(head + text + "\nG1 Z#10 F100.\nM99\n", false).end[Axis::Z] == Approx(0).margin(1e-9));
  }
  CHECK(reading_of(head + "#10=#26\nG1 Z#10 F100.\nM99\n", false).end[Axis::Z] == Approx(50));
  CHECK(reading_of(head + "G1 Z-#26 F100.\nM99\n", false).end[Axis::Z] == Approx(50));
  CHECK(reading_of(head + "IF[-#33 EQ #0]GOTO9\nG1 Z3. F100.\nN9 M99\n", false).end[Axis::Z] == Approx(3));
  for (const std::string text : {"Z[-#26]", "Z[#26]", "Z-[#26]"}) {
    INFO(text);
    CHECK(reading_of(head + "G1 " + text + " F100.\nM99\n", false).code == "nc-parameter-unset");
  }
}

TEST_CASE("fanuc: whether a vacant variable alone in brackets counts as 0 is not guessed") {
  const std::string head = "G90 G21 G54 G0 X0 Y0 Z50.\nG65 P100 X10.\nM30\nO100\n";
  for (const std::string text :
       {"#10=[#26]", "#10=[[#26]]", "IF[[#26] EQ #0]GOTO9", "IF[#0 NE [#26]]GOTO9", "IF[[#26] EQ 0]GOTO9",
        "IF[[#24-10] NE [#26]]GOTO9", "WHILE[[[#3]] EQ #0]DO1\n#3=1\nEND1", "IF[[#26] EQ #0]THEN #5=1"}) {
    INFO(text);
    CHECK(reading_of(head + text + "\nN9 M99\n", false).code == "nc-parameter-unset");
  }
  for (const std::string text :
       {"IF[[#24] EQ #0]GOTO9", "IF[[#26] EQ 5]GOTO9", "IF[[#26] LT 0]GOTO9", "IF[[#26 NE #0] AND [#24 EQ 10]]GOTO9",
        "#10=[#24]", "IF[[#25] NE [#26]]GOTO9", "IF[[#26+0] EQ #0]GOTO9", "#10=ABS[#26]"}) {
    INFO(text);
    CHECK(reading_of(head + text + "\nG1 Z3. F100.\nN9 M99\n", false).end[Axis::Z] == Approx(3));
  }
}

TEST_CASE("fanuc: a macro has its arguments with all their digits, whatever the letter") {
  const std::string head = "G90 G21 G54 G0 X0 Y0 Z50.\n#1=10.\n";
  for (const std::string letters : {"A#1 I#4", "X#24 J#5", "Z#26 K#6"}) {
    const std::string first = letters.substr(0, 1), second = letters.substr(letters.find(' ') + 1, 1);
    const std::string one = letters.substr(1, letters.find(' ') - 1), two = letters.substr(letters.find(' ') + 2);
    INFO(letters);
    const Reading ran =
        reading_of(head + "G65 P100 " + first + "[#1/3] " + second + "[#1/3]\nM30\nO100\nG1 X[" + one + "*3] Y[" + two +
                       "*3] F100.\nIF[" + one + " EQ " + two + "]GOTO5\nG1 Z0.\nN5 M99\n",
                   false);
    CHECK(ran.end[Axis::X] == Approx(10));
    CHECK(ran.end[Axis::Y] == Approx(10));
    CHECK(ran.end[Axis::Z] == Approx(50));
  }
}

TEST_CASE("fanuc: the cancel of a compensation of the setting is read, and nothing stands beside it") {
  const std::string head = "O1\nG90 G21 G54\nG0 X0 Y0 Z50.\n";
  CHECK(reading_of(head + "G54.4 P0\nG1 X5. F100.\nM30\n", false).end[Axis::X] == Approx(5));
  for (const std::string refused : {"G54.4 P1", "G54.4", "G54.4 P0 X3.", "G54.4 P8"}) {
    INFO(refused);
    CHECK_FALSE(reading_of(head + refused + "\nM30\n", false).code.empty());
  }
}

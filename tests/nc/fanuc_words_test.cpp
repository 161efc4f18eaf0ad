// Words of Fanuc's cycles and calls that more than one source speaks of, or none.
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

const std::string kStart20 = "O1\nG90 G54 G0 X0 Y0 Z20. A0 B0 C0\n";

std::string code_behind(const std::string& rest) { return nc::tests::code_of(kStart20 + rest, at_zero(), "fanuc"); }

std::vector<Motion> motions_behind(const std::string& rest) {
  const ProgramFile program(kStart20 + rest);
  return motions_of_file(program.path(), at_zero(), "fanuc");
}

}  // namespace

TEST_CASE("of two counts of a hole, K and L, none is taken") {
  for (const char* const hole : {"G81 X5. Y0 Z-5. R2. F100. K2 L3\n", "G84 X5. Y0 Z-5. R2. F100. L3 K2\n",
                                 "G91 G83 X5. Y0 Z-5. R-2. Q1. F100. K2 L3\n"}) {
    INFO(hole);
    CHECK(code_behind(hole + std::string("G80\nM30\n")) == "nc-not-interpreted");
  }
  CHECK(code_behind("G81 X5. Y0 Z-5. R2. F100. K2\nG80\nM30\n").empty());
  CHECK(code_behind("G91 G81 X5. Y0 Z-5. R-2. F100. L3\nG80\nM30\n").empty());
}

TEST_CASE("I, J and K of a macro that may belong to two sets are refused") {
  for (const char* const arguments :
       {"I1. I2. J3.", "I1. J2. I3. K4.", "I1. J2. K3. I4. K5.", "J1. J2. K3.", "I1. I2. I3. K4."}) {
    INFO(arguments);
    const bool clear = std::string(arguments) == "I1. J2. K3. I4. K5.";
    const std::string code = code_behind("G65 P2 " + std::string(arguments) + "\nM30\nO2\nM99\n");
    CHECK(code == (clear ? "" : "nc-not-interpreted"));
  }
  CHECK(code_behind("G65 P2 I1. J2. K3. I4. J5. K6.\nM30\nO2\nM99\n").empty());
  CHECK(code_behind("G65 P2 I1. K2. J3.\nM30\nO2\nM99\n").empty());
}

TEST_CASE("pecks smaller than the gap before them never go above R") {
  for (const char* const hole :
       {"G83 X5. Y0 Z-1. R2. Q.5 F100.\n", "G73 X5. Y0 Z-1. R2. Q.3 F100.\n", "G98 G83 X5. Y0 Z1. R2. Q.25 F100.\n"}) {
    INFO(hole);
    const std::vector<Motion> motions = motions_behind(hole + std::string("G80\nM30\n"));
    REQUIRE(motions.size() > 6);
    for (std::size_t i = 2; i + 1 < motions.size(); ++i) CHECK(motions[i].to[Axis::Z] < 2 + 1e-9);
  }
}

TEST_CASE("an axis goes home by itself, however the plane is tilted") {
  for (const char* const frame : {"G68.2 X0 Y0 Z0 I90. J10. K-90.\nG53.1\n",
                                  "G68.2 X1. Y2. Z3. I90. J20. K-90.\nG53.1\n", "G68.2 X0 Y0 Z0 I0 J15. K0\nG53.1\n"}) {
    for (const std::string home : {"G28 X0", "G28 Y0", "G28 Z0"}) {
      const std::string text = kStart20 + frame + "G0 X5. Y6.\nZ10.\nG91 " + home + "\nG69\nM30\n";
      INFO(text);
      const ProgramFile program(text);
      ProgramSettings settings = empty_tables();
      settings.work_offsets[0] = WorkOffset{};
      settings.free_rotation = FreeRotation::c_zero;
      const std::vector<Motion> motions = motions_of_file(program.path(), settings, "fanuc");
      REQUIRE(motions.size() > 2);
      const AxisWords before = motions[motions.size() - 2].machine;
      const AxisWords after = motions.back().machine;
      for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        INFO(letter(axis));
        CHECK(after[axis] == Approx(letter(axis) == home[4] ? 0 : before[axis]).margin(1e-9));
      }
    }
  }
}

TEST_CASE("what is worked out for a word is rounded as its decimals are, not as a binary fraction of them") {
  for (const auto& [word, wanted] :
       {std::pair{"X[1.0005]", 1.001}, std::pair{"X[4.0035]", 4.004}, std::pair{"X[2.0005]", 2.001},
        std::pair{"X[8.1235]", 8.124}, std::pair{"X[-1.0005]", -1.001}, std::pair{"X[2.001/2]", 1.001},
        std::pair{"X[1.0004]", 1.0}, std::pair{"X1.0009", 1.0}}) {
    INFO(word);
    const std::vector<Motion> motions = motions_behind("G1 " + std::string(word) + " F100.\nM30\n");
    REQUIRE(!motions.empty());
    CHECK(motions.back().to[Axis::X] == Approx(wanted).epsilon(0).margin(1e-9));
  }
  const std::vector<Motion> steps =
      motions_behind("#1=2.001\n#2=0\nG91\nWHILE[#2LT50]DO1\nG1 X[#1/2] F100.\nX-1.\n#2=#2+1\nEND1\nM30\n");
  CHECK(steps.back().to[Axis::X] == Approx(0.05).epsilon(0).margin(1e-9));
}

TEST_CASE("messages of Fanuc's words name what is odd") {
  for (const auto& [line, said] :
       {std::pair{"G10 L1 P1 R5.", "G10 L1 is not interpreted"},
        std::pair{"G1 X5. F100. G4 P500", "X5. stands beside a dwell"},
        std::pair{"X5. G4 P500", "X5. stands beside a dwell"}, std::pair{"G4 P500 Y1.", "Y1. stands beside a dwell"},
        std::pair{"ELSE", "ELSE is no statement"}, std::pair{"SETVN 500[A,B]", "SETVN names variables"},
        std::pair{"CALL 5", "CALL is no statement"}, std::pair{"PCLOS", "PCLOS sends values"},
        std::pair{"G234 H1", "G234 is the tool centre point control of a Haas"},
        std::pair{"G254", "G254 has a Haas move its work system"}, std::pair{"G255", "G255 ends the G254 of a Haas"},
        std::pair{"M98 <SUB1>", "a program is called by its name"},
        std::pair{"WH[1EQ0]DO1", "WH may be short for WHILE"}, std::pair{"GO 10", "GO may be short for GOTO"},
        std::pair{"N5 WH [#1 GT 0] DO 2", "WH may be short for WHILE"}}) {
    INFO(line);
    const std::string text = kStart20 + line + "\nM30\n";
    const Diagnostic refused = testing::refusal_of([&] {
      const ProgramFile program(text);
      motions_of_file(program.path(), at_zero(), "fanuc");
    });
    CHECK(refused.message.rfind(said, 0) == 0);
  }
}

TEST_CASE("G80 ends a cycle in the block of G53 as well") {
  const std::string holes = "G0 X0 Y0\nG98 G81 X1. Y1. Z-4. R2. F100.\nX2.\n";
  for (const std::string end : {"G80 G53 Z-1.", "G53 G80 Z-1.", "G80 G49 G53 Z-1.", "G80 G53 G90 Z-1. M5"}) {
    INFO(end);
    const std::vector<Motion> motions = motions_behind(holes + end + "\nX5. Y5.\nM30\n");
    REQUIRE(motions.size() > 2);
    CHECK(motions.back().kind == MotionKind::rapid);
    CHECK(motions.back().to[Axis::X] == 5);
    CHECK(motions[motions.size() - 2].in_machine_coordinates);
  }
  CHECK(code_behind("G1 X1. F100.\nG81 X2. Y0 Z-5. R2.\nG80 G53 Z-1.\nX5.\nM30\n") == "nc-axes-unused");
}

TEST_CASE("G80 ends nothing where no cycle is in force") {
  for (const std::string off : {"G80 G40 G49", "G80", "G80 G90"}) {
    INFO(off);
    const std::vector<Motion> motions = motions_behind("G1 X.5 F100.\n" + off + "\nX.7\nM30\n");
    REQUIRE(!motions.empty());
    CHECK(motions.back().kind == MotionKind::feed);
    CHECK(motions.back().to[Axis::X] == Approx(0.7));
  }
  CHECK(code_behind("G1 X1. F100.\nG81 X2. Y0 Z-5. R2.\nG80\nX3.\nM30\n") == "nc-axes-unused");
}

TEST_CASE("a fixture offset that is cancelled is none") {
  CHECK(code_behind("G54.2 P0\nG0 X1.\nM30\n").empty());
  CHECK(code_behind("G54.2 P1\nG0 X1.\nM30\n") == "nc-not-interpreted");
  CHECK(code_behind("G54.2\nG0 X1.\nM30\n") == "nc-word-missing");
}

TEST_CASE("headers that begin with a motion code cancel what takes axis words elsewhere") {
  for (const std::string header : {"G00 G17 G21 G40 G49 G50.1 G69 G80 G90", "G0 G17 G22 G40", "G0 G90 G17 G5.1 Q0",
                                   "G1 G5.1 Q1", "G22 G50.1", "G5.1 Q0 G50.1", "G0 G5 P0", "G50.1 G4 P100"}) {
    INFO(header);
    CHECK(code_behind(header + "\nX1.\nM30\n") == (header.starts_with("G1 ") ? "nc-feed-missing" : ""));
  }
  for (const std::string line : {"G0 G50.1 X0", "G2 X5. I2.5 G50.1 F100.", "G1 G5.1 Q1 X5. F100."}) {
    INFO(line);
    CHECK_FALSE(code_behind(line + "\nM30\n").empty());
  }
}

TEST_CASE("P of G86 is no word of the manual: the hole stays a cycle") {
  const auto stays = [](const std::string& cycle) {
    const ProgramFile text(kStart20 + cycle + "G80\nM30\n");
    const InputFile file(text.path());
    Program program(file, dialect("fanuc"), at_zero());
    CycleForm form = CycleForm::none;
    while (const Step* const step = program.next()) {
      if (step->cycle != CycleForm::none) form = step->cycle;
    }
    return form;
  };
  CHECK(stays("G86 X1. Y1. Z-8. R1. F100. P500\n") == stays("G85 X1. Y1. Z-8. R1. F100. P500\n"));
  CHECK(stays("G86 X1. Y1. Z-8. R1. F100. P500\n") != stays("G89 X1. Y1. Z-8. R1. F100. P500\n"));
}

TEST_CASE("K beside Q repeats a hole where it is one step after the other") {
  CHECK(code_behind("G91 G83 X5. Y0 Z-5. R-2. Q1. F100. K2\nG80\nM30\n").empty());
  CHECK(code_behind("G83 X5. Y0 Z-5. R2. Q1. F100. K1\nG80\nM30\n").empty());
  CHECK(code_behind("G81 X5. Y0 Z-5. R2. F100. K3\nG80\nM30\n").empty());
}

TEST_CASE("the control stops at a way home while a drilling cycle is in force") {
  const std::string hole = "G81 X1. Y1. Z-4. R5. F100.\n";
  for (const char* const home : {"G91 G28 X0\n", "G30 P2 Y0\n", "G28 Z30.\n", "X2.\nG91 G28 Z0\n", "M8 G28 A0\n"}) {
    INFO(home);
    CHECK(code_behind(hole + home + "M30\n") == "nc-not-interpreted");
    CHECK(code_behind(hole + "G80\n" + home + "M30\n").empty());
  }
  CHECK(code_behind(hole + "G80 G91 G28 Z0\nM30\n").empty());
  CHECK(code_behind(hole + "G0 G91 G28 Z0\nM30\n").empty());
  CHECK(code_behind(hole + "G0 Z9.\nG28 Z9.\nM30\n").empty());
}

TEST_CASE("nothing moves between M29 and the tap that it is for") {
  const std::string tap = "G84 X5. Y5. Z-5. R2. F500.\n";
  CHECK(code_behind("M29 S500\n" + tap + "X7.\nG80\nM30\n").empty());
  CHECK(code_behind("M29 S500\nG99 G74 X5. Z-5. R2. F500.\nG80\nG0 X1.\nM30\n").empty());
  CHECK(code_behind("M29 S500\nG98 M8\n(tap)\n" + tap + "G80\nM30\n").empty());
  CHECK(code_behind("M19\nG0 X1.\nM30\n").empty());
  for (const char* const move : {"G0 X5.\n", "Z9.\n", "G1 Y1. F100.\n", "G81 X1. Y1. Z-4. R5. F100.\nG80\n"}) {
    INFO(move);
    CHECK(code_behind("M29 S500\n" + std::string(move) + tap + "M30\n") == "nc-not-interpreted");
  }
}

TEST_CASE("brackets are five deep at most") {
  CHECK(code_behind("G1 X[[[[[5.]]]]] F100.\nM30\n").empty());
  CHECK(code_behind("#1=[[[[1]]]]+[[[[2]]]]\nX[#1] Y[[[[[2.]]]]]\nM30\n").empty());
  CHECK(code_behind("#1=ABS[SQRT[ABS[[[4.]]]]]\nX#1\nM30\n").empty());
  for (const char* const deep :
       {"G1 X[[[[[[5.]]]]]] F100.\n", "#1=ABS[SQRT[ABS[[[[4.]]]]]]\n", "#1=SIN[[[ATAN[[[1.]],2.]]]]\n"}) {
    INFO(deep);
    CHECK(code_behind(std::string(deep) + "M30\n") == "nc-operator");
  }
}

#include "nc/language/rotary.hpp"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

ProgramSettings with_rule(RotaryRule rule) {
  ProgramSettings settings = empty_tables();
  settings.rotary.fill(rule);
  return settings;
}

std::vector<double> ends_of_c(std::string_view text, const ProgramSettings& settings,
                              std::string_view control = "linuxcnc") {
  const ProgramFile written(text);
  const InputFile file(written.path());
  Program program(file, dialect(control), settings);
  std::vector<double> ends;
  while (const Step* const step = program.next()) {
    for (const Motion& motion : step->motions) ends.push_back(motion.to[Axis::C]);
  }
  return ends;
}

}  // namespace

TEST_CASE("the sign of a word says which way round") {
  // rs274 with WRAPPED_ROTARY gives these.
  const std::string text =
      "G0 C0\nG1 C10 F100\nC350\nC-10\nC-350\nC10\nC10\nC-10\nC-0\nC0\nC0\nC-350\nG91 C20\nG90 C-20\nG10 L2 P2 C5\n"
      "G55 C10\nG53 G1 C10\nG53 G1 C-3\nG53 G1 C0\nC[5-5]\nC-[5-5]\nM2\n";
  const std::vector<double> canon = {0, 10,  350, 10,   -10, 10,  10, 10,  0,   0,
                                     0, -10, 10,  -340, 10,  365, 8,  365, 720, 720};
  const std::vector<double> ends = ends_of_c(text, with_rule(RotaryRule::sign));
  REQUIRE(ends.size() == canon.size());
  for (std::size_t i = 0; i < canon.size(); ++i) {
    INFO(i);
    CHECK(ends[i] == Approx(canon[i]).margin(1e-9));
  }
  // Where the axis stands is not known, the sign is no part of the place either.
  CHECK(rotary_end(RotaryRule::sign, -10, true, {}) == Approx(10));
  CHECK(rotary_end(RotaryRule::sign, -350, true, {}) == Approx(-10));
  CHECK(rotary_end(RotaryRule::sign, 10, false, {}) == Approx(10));
  CHECK(rotary_end(RotaryRule::shortest, -10, true, {}) == Approx(-10));
  CHECK(code_of("G0 C360\n", with_rule(RotaryRule::sign)) == "nc-out-of-range");
  CHECK(code_of("G91 G0 C360\n", with_rule(RotaryRule::sign)).empty());
}

TEST_CASE("a word of where a wrapped axis stands but for rounding is refused, as it may be a full turn") {
  const ProgramSettings settings = with_rule(RotaryRule::sign);
  const std::string head = "G21 G90 G17 G94 G54 F100\nG0 X0 Y0 Z20 A0 B0\n";
  for (const std::string moves :  // rs274 with WRAPPED_ROTARY turns all the way round in these
       {"G0 C-359.3\nG1 X5 C5.3\nG1 X10 C5.3\n", "G0 A-359.9\nA0.1\nA0.1\n", "G0 B359.999\nB4\nB-147.28\nB-147.28\n",
        "G0 C10.2\nG92 C-0.3\nG1 C359.7\n", "G10 L2 P1 C0.7\nG0 C10.3\nG10 L2 P1 C0\nG1 C11\n",
        "G0 C0\nG91 C0.1\nC0.1\nC0.1\nG90 C0.3\n"}) {
    INFO(moves);
    CHECK(code_of(head + moves + "M2\n", settings) == "nc-not-interpreted");
  }
  for (const std::string moves : {"G0 C5.3\nG1 X5 C5.3\n", "G0 C0\nC-352\nX5 C-352\n", "G0 C-359.3\nG1 X5 C5.3\nX10\n",
                                  "G0 C10\nC370\n", "G0 C0\nG91 C0.1\nC0.1\nG90 C0.4\n"}) {
    INFO(moves);
    CHECK(code_of(head + moves + "M2\n", settings) ==
          (moves.find("370") == std::string::npos ? "" : "nc-out-of-range"));
  }
}

TEST_CASE("what of a wrapped axis counts otherwise beside G53, a tool's offset and a change of tools") {
  const ProgramSettings settings = with_rule(RotaryRule::sign);
  const std::string head = "G21 G90 G54\nG0 X0 Y0 Z20 A0 B0 C0\n";
  for (const std::string word : {"C370", "C-370", "A360", "B-360"}) {
    INFO(word);
    CHECK(code_of(head + "G53 G0 " + word + "\nM2\n", settings) == "nc-out-of-range");
  }
  for (const std::string tool : {"G43.1 C40", "G43.1 A-3 Z5", "G10 L1 P1 C20\nG43 H1"}) {
    INFO(tool);
    CHECK(code_of(head + tool + "\nM2\n", settings) == "nc-not-interpreted");
    CHECK(code_of(head + tool + "\nM2\n", with_rule(RotaryRule::linear)).empty());
  }
  CHECK(code_of(head + "G43.1 Z40\nG53 G0 C359\nM2\n", settings).empty());
  // rs274 with WRAPPED_ROTARY: the place stays over M6, and with it the way round
  CHECK(ends_of_c("G90 G0 C0\nT1 M6\nG0 C-5\nM2\n", settings).back() == -355);
  CHECK(ends_of_c("G0 C-20\nG91 C-700\nG90 T1 M6\nC5\nM2\n", settings).back() == -715);
}

TEST_CASE("the sign of 0 says no way round where a control is not known to keep it") {
  const ProgramSettings sign = with_rule(RotaryRule::sign);
  const ProgramSettings shortest = with_rule(RotaryRule::shortest);
  for (const std::string_view control : {"fanuc", "okuma"}) {
    CAPTURE(control);
    for (const std::string word : {"C-0.", "C-.0", "C-0"}) {
      CAPTURE(word);
      CHECK(code_of("G90 G0 C4.5\n" + word + "\n", sign, control) == "nc-not-interpreted");
      CHECK(code_of("G90 G0 C4.5\n" + word + "\n", shortest, control).empty());
      CHECK(code_of("G90 G0 C4.5\nG91 " + word + "\n", sign, control).empty());
    }
    CHECK(code_of("G90 G0 C4.5\nC0.\nC-0.5\n", sign, control).empty());
  }
  CHECK(code_of("G90 G0 C4.5\nC-0.0000001\n", sign, "fanuc") == "nc-not-interpreted");  // kept as 0
  CHECK(code_of("G90 G0 C4.5\nG53 C-0.\n", sign, "fanuc") == "nc-not-interpreted");
}

TEST_CASE("the shorter way round") {
  // Moves of -150, -30, -80, +380 and -840 deg  [B-63534EN 20.2.1]
  const std::vector<double> ends = ends_of_c("G90 G0 C0.\nC-150.\nC540.\nC-620.\nG91 C380.\nC-840.\nM30\n",
                                             with_rule(RotaryRule::shortest), "fanuc");
  const std::vector<double> manual = {0, -150, -180, -260, 120, -720};
  REQUIRE(ends.size() == manual.size());
  for (std::size_t i = 0; i < manual.size(); ++i) CHECK(ends[i] == Approx(manual[i]).margin(1e-9));
}

TEST_CASE("after DC, ACP and ACN absolute words count within the turn") {
  const ProgramSettings settings = empty_tables();
  const std::vector<double> ends =
      ends_of_c("G54 G0 C350\nC=DC(10)\nC20\nC=ACN(350)\nC340\nC=ACP(340)\nC=IC(30)\nC20\nM30\n", settings, "siemens");
  const std::vector<double> expected = {350, 370, 380, 350, 340, 340, 370, 380};
  REQUIRE(ends.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO(i);
    CHECK(ends[i] == Approx(expected[i]).margin(1e-9));
  }
}

TEST_CASE("a rotary word sends the axis where it was meant to go") {
  for (const RotaryRule rule : {RotaryRule::sign, RotaryRule::shortest, RotaryRule::one_turn}) {
    int found = 0;
    for (double from = -725; from < 725; from += 7.25) {
      for (double to = -700; to < 700; to += 6.5) {
        const std::optional<double> word = rotary_word(rule, to, from);
        if (!word) continue;
        ++found;
        CHECK(std::abs(*word) < 360);
        CHECK(rotary_end(rule, *word, std::signbit(*word), from) == Approx(to).margin(1e-9));
      }
    }
    CHECK(found > 1000);
  }
  CHECK_FALSE(rotary_word(RotaryRule::sign, 0, 10));        // -0
  CHECK_FALSE(rotary_word(RotaryRule::sign, 400, 10));      // more than a turn
  CHECK_FALSE(rotary_word(RotaryRule::shortest, 200, 10));  // the longer way
  CHECK_FALSE(rotary_word(RotaryRule::one_turn, -1, 10));   // over 0
  CHECK(rotary_word(RotaryRule::linear, 400, 10) == 400);
}

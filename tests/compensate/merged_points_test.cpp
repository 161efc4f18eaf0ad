// G64 P makes one line of moves that stay within Q of it, and Q is P where it is not written: the control would leave
// away what the corrections ask for.
#include <string>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

std::string points_of(const std::string& text) { return run(text, without_friction()).text; }

const std::string kCircle = "G0 X20 Y0 Z5 A0 B0 C0\nG1 Z0 F600\nG2 I-20\nG1 X30\nM2\n";

}  // namespace

TEST_CASE("linuxcnc: each point counts under G64 P") {
  CHECK(has_text(points_of("G21 G90 G94 G17 G54\nG64 P0.02\n" + kCircle), "\nG64 P0.02 Q0\n"));
  CHECK(has_text(points_of("G21 G90 G94 G17 G54 G64P0.02\n" + kCircle), "G54 G64P0.02Q0\n"));
  CHECK(has_text(points_of("G21 G90 G94 G17 G54\n#1=0.05\nG64 P[#1] (as the roughing has it)\n" + kCircle),
                 "\nG64 P[#1] Q0 (as the roughing has it)\n"));
  CHECK(has_text(points_of("G21 G90 G94 G17 G54\ng64 p0.02\n" + kCircle), "\ng64 p0.02 q0\n"));
}

TEST_CASE("linuxcnc: another Q makes way, and so it does behind the first change") {
  CHECK(has_text(points_of("G21 G90 G94 G17 G54\nG64 P0.02 Q0.01\n" + kCircle), "\nG64 P0.02 Q0\n"));
  const std::string later = points_of("G21 G90 G94 G17 G54\nG0 X20 Y0 Z5 A0 B0 C0\nG1 X30 F600\nG64 P0.1\nX20\nM2\n");
  CHECK(has_text(later, "\nG64 P0.1 Q0\n"));
}

TEST_CASE("linuxcnc: a move beside G64 P keeps its points as well") {
  const std::string text = points_of("G21 G90 G94 G17 G54\nG0 X20 Y0 Z5 A0 B0 C0\nG64 P0.02 G1 X30 F600\nX20\nM2\n");
  CHECK(has_text(text, "G64 P0.02 Q0 G1 X"));
}

TEST_CASE("linuxcnc: G64 without P, with Q0, and G61 stay as they are") {
  for (const std::string mode : {"G64", "G64 P0.02 Q0", "G61", "G64 P0"}) {
    const std::string text = points_of("G21 G90 G94 G17 G54\n" + mode + "\n" + kCircle);
    INFO(text);
    CHECK(has_text(text, "\n" + mode + "\n"));
  }
}

TEST_CASE("linuxcnc: where nothing changes, G64 P stays as it is") {
  const std::string rapids = "G21 G90 G94 G17 G54\nG64 P0.02\nG53 G0 Z0\nM2\n";
  CHECK(points_of(rapids) == rapids);
}

TEST_CASE("linuxcnc: a program that is written out comes back to G64 with each point") {
  Job job = without_friction();
  const std::string text =
      "G21 G90 G94 G17 G54\nG64 P0.02\nG0 X20 Y0 Z5 A0 B0 C0\nF600\no1 repeat [2]\nG64 P0.01\nG1 X[#1]\n#1=[#1+5]\no1 "
      "endrepeat\nM2\n";
  const Result result = run("#1=0\n" + text, job);
  INFO(result.text);
  CHECK_FALSE(has_text(result.text, "P0.02\n"));
  CHECK_FALSE(has_text(result.text, "P0.01\n"));
  CHECK(has_text(result.text, "P0.01 Q0\n"));
}

TEST_CASE("linuxcnc: G64 P beside a cycle that is written out is refused") {
  CHECK(code_of("G21 G90 G94 G17 G54\nG0 X20 Y0 Z5 A0 B0 C0\nF300 S500 M3\nG64 P0.01 G81 X25 Z-5 R2\nG80\nM2\n",
                without_friction()) == "emit-shared-words");
}

TEST_CASE("linuxcnc: Q below 0 is none, and makes way for Q0") {
  CHECK(has_text(points_of("G21 G90 G94 G17 G54\nG64 P0.05 Q-0.1\n" + kCircle), "\nG64 P0.05 Q0\n"));
  CHECK(has_text(points_of("G21 G90 G94 G17 G54\nG64 P0.05 Q[0-1]\n" + kCircle), "\nG64 P0.05 Q0\n"));
}

TEST_CASE("linuxcnc: G64 P beside another code that takes P or Q is refused") {
  for (const std::string block :
       {"G64 P0.05 M68 E0 Q2", "G64 P0.05 M67 E0 Q1", "G64 G10 L2 P2 X1", "G64 G2 X10 I5 P2"}) {
    INFO(block);
    CHECK(code_of("G21 G90 G94 G17 G54\nG0 X0 Y0 Z5 A0 B0 C0\nF600\n" + block + "\nG1 X10\nM2\n", without_friction()) ==
          "emit-shared-words");
  }
}

// M99 of the main program begins it again: with what is in force, and from where the machine stands then.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

// Where the machine stands is known: all axes at zero.
void check_again(const std::string& expected, const std::vector<std::string>& programs) {
  for (const std::string& program : programs) {
    INFO(program);
    const std::optional<Diagnostic> refusal = refusal_of(program, at_zero(), "fanuc");
    CHECK((refusal ? refusal->code : "") == (expected.empty() ? "" : "nc-not-interpreted"));
    if (refusal) CHECK_THAT(refusal->message, Catch::Contains(expected));
  }
}

}  // namespace

TEST_CASE("a second pass that begins elsewhere is refused where a motion leans on that") {
  check_again("another place of X", {"O1\nG91 G1 X10. F100.\nM99\n", "O1\nG90 G54 G1 X10. F100.\nY5.\nM99\n",
                                     "O1\nG90 G54 G2 X10. R5. F100.\nM99\n", "O1\nG91 G0 X1.\nG90 Y5.\nM99\n"});
  check_again("another place of Z", {"O1\nG90 G54 G0 X0 Y0\nZ5.\nG1 Z-5. F100.\nX10.\nG0 Z200.\nM99\n",
                                     "O1\nG90 G54 G0 X0 Y0 A0 B0 C0\nG1 Z-5. F100.\nM99\n"});
  check_again("another place of C", {"O1\nG90 G54 G0 X0 Y0 Z5.\nG1 C30. F100.\nG0 Z7.\nM99\n"});
}

TEST_CASE("a second pass is read where the program comes back, or names its axes before it leans on them") {
  check_again("", {"O1\nG90 G54 G0 X0 Y0 Z20. A0 B0 C0\nG1 X5. F100.\nM99\n", "O1\nG90 G54 G1 X10. F100.\nG0 X0\nM99\n",
                   "O1\nG90 G54 G0 X0 Y0\nZ5.\nG1 Z-5. F100.\nG0 Z0\nM99\n", "O1\nG91 G1 X10. F100.\nX-10.\nM99\n"});
}

TEST_CASE("a path control, a shift of some axes and a motion that are not stated again are refused") {
  const std::string first = "O1\nG90 G54 G0 X0 Y0 Z20. A0 B0 C0\n";
  check_again("path control", {first + "G1 X5. F100.\nG61\nM99\n", first + "G61\nG1 X5. F100.\nM99\n"});
  check_again("",
              {first + "G61\nG1 X5. F100.\nG64\nM99\n", "O1\nG64\n" + first.substr(3) + "G61\nG1 X5. F100.\nM99\n"});
  check_again("G52", {"O1\nG52 X0\n" + first.substr(3) + "G52 X0 Y5.\nG0 X0 Y0\nG1 X5. F100.\nM99\n",
                      "O1\nG52 Z0\n" + first.substr(3) + "G52 X1.\nG0 X0 Y0\nM99\n"});
  check_again("", {"O1\nG52 X0 Y0\n" + first.substr(3) + "G52 X0 Y5.\nG0 X0 Y0\nG1 X5. F100.\nM99\n"});
  check_again("another motion", {"O1\nG90 G80 G54\nX0 Y0 Z20. A0 B0 C0\nG1 X5. F100.\nM99\n"});
}

TEST_CASE("a second pass begins in the unit that the control was in at the start, where none is stated") {
  const std::string moves = "G90 G54 G0 X0 Y0 Z2. A0 B0 C0\nG0 X1.\nX0\n";
  ProgramSettings in_inches = at_zero();
  in_inches.inches = true;
  const auto refused = [](const std::string& program, const ProgramSettings& settings) {
    const std::optional<Diagnostic> refusal = refusal_of(program, settings, "fanuc");
    return refusal ? refusal->message : std::string();
  };
  CHECK(refused("O1\n" + moves + "M99\n", in_inches).empty());
  CHECK_THAT(refused("O1\n" + moves + "G21\nM99\n", in_inches), Catch::Contains("G21"));
  CHECK_THAT(refused("O1\n" + moves + "G20\nM99\n", at_zero()), Catch::Contains("G20"));
  CHECK(refused("O1\nG21\n" + moves + "G20\nM99\n", in_inches).empty());
}

// Frames of a SINUMERIK that turn, mirror or scale nothing, and what moves nothing in machine coordinates.
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "nc/siemens_cases.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

double rounded_place(double mm) { return std::round(mm * 1e6) / 1e6; }

std::string place_at_end(const std::vector<Motion>& motions) {
  const AxisWords place = motions.empty() ? AxisWords{} : motions.back().machine;
  return fmt::format("X{:g} Y{:g}", rounded_place(place[Axis::X]), rounded_place(place[Axis::Y]));
}

std::string rotary_at_end(const std::vector<Motion>& motions) {
  const AxisWords place = motions.empty() ? AxisWords{} : motions.back().machine;
  return fmt::format("B{:g} C{:g}", rounded_place(place[Axis::B]), rounded_place(place[Axis::C]));
}

void check_places(const std::string& expected, const std::vector<std::string>& programs) {
  check_siemens("G54 G17 G90 G94 G710\nG0 X0 Y0 Z50 A0 B0 C0\n", place_at_end, expected, programs);
}

}  // namespace

TEST_CASE("ROT about X and Y by zero turns about Z alone") {
  check_places("X0 Y5", {"ROT X0 Y0 Z90\nX5 Y0\n", "ROT Z90 Y0\nX5 Y0\n", "ROT Z45\nAROT X0 Y0 Z45\nX5 Y0\n"});
  check_places("X5 Y0", {"ROT X0 Y0 Z0\nX5 Y0\n", "ROT Z90\nROT X0\nX5 Y0\n", "TRANS X3\nROT Y0 Z0\nX5 Y0\n"});
  check_places("X0 Y5", {"ROT Z90\nAROT X0\nX5 Y0\n", "R1=0\nROT X=R1 Y=-R1 Z90\nX5 Y0\n"});
  check_places("nc-not-interpreted", {"ROT X0 Y10 Z45\nX5 Y0\n", "AROT X0.001\n", "ROT A0\n", "ROT X0 Y0 C0 Z5\n"});
}

TEST_CASE("MIRROR and SCALE alone, as headers have them") {
  check_places("X5 Y7", {"TRANS X3 Y4\nSCALE\nX5 Y7\n", "ROT Z90\nX1 Y1\nSCALE\nX5 Y7\n",
                         "TRANS X1\nAROT Z30\nTRANS\nROT\nMIRROR\nSCALE\nX5 Y7\n", "MIRROR\nSCALE\nX5 Y7\n"});
  check_places("nc-not-interpreted", {"MIRROR X0\nX5 Y7\n", "SCALE X2 Y2\nX5 Y7\n", "SCALE X1\n", "TRANS X3\nMIRROR\n",
                                      "ROT Z5\nMIRROR\n", "AMIRROR\n", "ASCALE X1 Y1\n", "MIRROR Z0\n"});
  check_places("nc-word-unused", {"MIRROR RPL=5\n", "SCALE P2\n", "MIRROR I5\n"});
}

TEST_CASE("where no axis is named nothing moves in machine coordinates") {
  check_places("X5 Y7", {"X5 Y7\nG0 G153 D0\n", "X5 Y7\nSUPA D0\n", "X5 Y7\nG53\n", "X5 Y7\nG1 G53 F100\n"});
  check_places("X1 Y7", {"TRANS X3\nSUPA\nX-2 Y7\n", "G0 SUPA D0\nX1 Y7\n", "G1 F100 G153\nX1 Y7\n"});
  check_places("nc-machine-move", {"G2 SUPA X5 Y0 I2.5\n", "G3 G53 I2.5\n"});
}

TEST_CASE("G62 and G621 slow down where the tool's radius is offset alone") {
  check_places("X5 Y7", {"G62\nX5 Y7\n", "G64 G621 G1 F100 X5 Y7\n", "G62 G0 X5 Y7\nFENDNORM\n"});
}

TEST_CASE("100000 and 200000 of CYCLE800's status choose a way of the axes, other status is refused") {
  const auto swivel_call = [](const std::string& status) {
    return "CYCLE800(1,\"TC1\"," + status + ",57,0,0,0,5,0,0,0,0,0,-1)\n";
  };
  check_places("X0 Y0", {swivel_call("100000"), swivel_call("200000"), swivel_call("R1+200000")});
  check_places("nc-tilted-plane", {swivel_call("R1+200001"), swivel_call("300000"), swivel_call("1")});
  const auto said_of_status = [&](const std::string& status) {
    ProgramSettings settings = empty_tables();
    settings.work_offsets[0] = WorkOffset{};
    const auto refusal = refusal_of("G54 G90 G0 X0 Y0 Z50 A0 B0 C0\n" + swivel_call(status), settings, "siemens");
    return refusal ? refusal->message : std::string();
  };
  CHECK(said_of_status("1").find("on top") != std::string::npos);
  CHECK(said_of_status("200010").find("on top") != std::string::npos);
}

TEST_CASE("X0 Y0 Z0 of CYCLE800 is the point that the plane turns about, in the work system") {
  const auto zero_of = [](const std::string& swivel) {
    ProgramSettings settings = empty_tables();
    settings.work_offsets[0] = WorkOffset{};
    settings.free_rotation = FreeRotation::c_stays;
    const ProgramFile program("G54 G90 G0 X0 Y0 Z50 A0 B0 C0\n" + swivel + "\nG0 X0 Y0 Z0\nM30\n");
    const InputFile file(program.path());
    Program blocks(file, dialect("siemens"), settings);
    AxisWords at;
    while (const Step* const step = blocks.next()) {
      if (!step->motions.empty()) at = step->frame->to_machine(step->position);
    }
    return at;
  };
  for (const auto& [swivel, x, y, z] :
       {std::tuple{"CYCLE800(0,\"TC1\",0,57,10,0,0,0,30,0,0,0,0,1,,0)", 10.0, 0.0, 0.0},
        std::tuple{"CYCLE800(0,\"TC1\",0,57,1,2,3,8,-10,0,0,0,0,1)", 1.0, 2.0, 3.0},
        std::tuple{"G700\nCYCLE800(0,\"TC1\",100000,57,0,1,-2,5,0,0,0,0,0,-1)\nG710", 0.0, 25.4, -50.8},
        std::tuple{"CYCLE800(0,\"TC1\",0,57,0,0,0,5,0,0,0,0,0,-1)", 0.0, 0.0, 0.0}}) {
    INFO(swivel);
    const AxisWords at = zero_of(swivel);
    CHECK(at[Axis::X] == Approx(x).margin(1e-9));
    CHECK(at[Axis::Y] == Approx(y).margin(1e-9));
    CHECK(at[Axis::Z] == Approx(z).margin(1e-9));
  }
}

TEST_CASE("after a stop that lost the place axes without end are in their first turn") {
  const auto check = [](const std::string& expected, const std::vector<std::string>& programs) {
    check_siemens("G54 G17 G90 G94 G710\nG0 X0 Y0 Z50 A0 B0 C0\n", rotary_at_end, expected, programs);
  };
  check("B0 C0", {"G1 B=DC(359.9) F500\nM0\nG0 X1 Y0 Z21 A0 B0 C0\nG1 X2\n", "G0 C=ACP(5)\nC=ACP(3)\nM1\nG0 B0 C0\n",
                  "G0 C=ACN(350)\nM6\nG0 X1 Y0 Z21 A0 B0 C0\nC0\n"});
  check("B-360 C0", {"G1 B=DC(359.9) F500\nG0 B0\n", "M0\nG0 B0\nG1 B=DC(359.9) F500\nM8\nG0 B0\n"});
  check("B0 C20", {"G0 C=DC(350)\nM0\nG0 B0 C20\n", "G0 C=DC(10)\nM0\nG0 C=DC(20)\n"});
}

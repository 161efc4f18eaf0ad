// Rapids of an OSP that go through as they stand: behind the end of tool-tip mode, and before the first work system.
#include <cstddef>
#include <string>

#include <catch2/catch.hpp>

#include "nc/osp_cases.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

TEST_CASE("OSP: behind the end of tool-tip mode rapids go on that leave Z alone, and nothing else does") {
  const auto behind = [](const char* blocks, std::size_t line, std::size_t column, const char* code, const char* part) {
    const std::string program = std::string("G15 H1 G0 X0 Y0 Z50 A0 B0 C0\nG169 H1\nG170\n") + blocks;
    check_osp({{program.c_str(), line, column, code, part}});
  };
  const char* const no = "nc-not-interpreted";
  behind("G0 A0 B0 C0\nX5 Y5\nG56 Z50 H1\nG1 Z40 F100\nM2\n", 0, 0, no, "");
  behind("G0 Z9999\nX5 Y5 A20\nG53 Z50 A0\nM2\n", 0, 0, no, "");
  behind("G0 X5 Z9999\nM2\n", 0, 0, no, "");
  behind("G91 G0 C5\nM2\n", 0, 0, no, "");
  behind("G0 X5\nZ40\n", 5, 1, no, "G56 H or G53");
  behind("G0 X9999 Z40\n", 4, 1, no, "G56 H or G53");
  behind("G0 X5\nG1 X6 F100\n", 5, 1, no, "G56 H or G53");
  behind("G2 X5 I2.5 F100\n", 4, 1, no, "G56 H or G53");
  behind("G0 X5 G169\n", 4, 1, no, "G56 H or G53");
  behind("G71 Z50\n", 4, 1, no, "G56 H or G53");
  behind("G92 Z5\n", 4, 5, "nc-position-unknown", "Z stands");
  behind("G0 A20\nA0\nG92 X5\n", 6, 5, "nc-position-unknown", "X stands");
  behind("G0 A0\nG92 X5\n", 0, 0, no, "");
}

TEST_CASE("OSP: before the first G15 rapids of A, B and C alone go through, and what needs a work system does not") {
  const char* const unknown = "nc-work-offset-unknown";
  check_osp({{"G90 G0 Z9999\nA0 B0 C0\nT1 M6\nG15 H1\nG0 A0 B0 C0\nX10 Y10\nG56 Z50 H1\nG1 Z5 F100\nM2\n", 0, 0},
             {"G0 C90\nG15 H1\nG0 X0 Y0 Z50 A0 B0 C0\nG1 X5 F100\nM2\n", 0, 0},
             {"G0 Z9999 A0\nM2\n", 0, 0},
             {"G0 A0 X5\n", 1, 1, unknown},
             {"G1 A5 F100\n", 1, 1, unknown},
             {"G91 G0 A5\n", 1, 5, unknown},
             {"G0 X0 Y0\n", 1, 1, unknown},
             {"G0 A5\nG169 A0 H1\n", 2, 1, unknown},
             {"G0 A5\nG15 H1\nG92 A0\n", 3, 5, "nc-position-unknown"},
             {"G15 H9\nG0 A5\n", 2, 1, unknown, "G15H9"}});
}

TEST_CASE("OSP: VPSLX, VPSLY and VPSLZ are read in rapids, and nowhere else") {
  const std::string begin = "G15 H1 G0 X0 Y0 Z50 A0 B0 C0\n";
  for (const std::string rest :
       {"G16 H0 G0 Z=VPSLZ\nG0 X5 Y5\nG56 Z50 H1\nG1 Z40 F100\nM2\n",
        "G16 H00 G00 Z=VPSLZ (UP)\nG15 H1 G0 Z20\nG1 Z15 F100\nM2\n", "G15 H0\nG0 X=VPSLX Y=VPSLY\nM2\n",
        "g16 h0 g0 z = vpslz m9\nM2\n", "G0 Z=VPSLZ\nX5 Y5\nM2\n", "G169 H1\nG170\nG0 Z=VPSLZ\nX5\nG53 Z50\nM2\n",
        "G0 Z=VPSLZ X9\nY5\nM2\n"}) {
    INFO(rest);
    check_osp({{(begin + rest).c_str(), 0, 0}});
  }
  const auto refused = [&](const char* rest, std::size_t column, const char* part) {
    check_osp({{(begin + rest).c_str(), 2, column, "nc-not-interpreted", part}});
  };
  refused("G1 Z=VPSLZ F100\nM2\n", 4, "G16 H0 G0 Z=VPSLZ");
  refused("G2 X5 I2.5 Z=VPSLZ F100\nM2\n", 12, "G0 Z9999");
  refused("G16 H0 G1 Z=VPSLZ F100\nM2\n", 11, "G16 H0");
  refused("G81 X5 Z=VPSLZ R2 F100\nM2\n", 8, "G16 H0");
  refused("G91 G0 Z=VPSLZ\nM2\n", 8, "G90");
  refused("G92 Z=VPSLZ\nM2\n", 5, "G16 H0");
  refused("G71 Z=VPSLZ\nM2\n", 5, "G16 H0");
  refused("G169 X0 Z=VPSLZ H1\nM2\n", 9, "G16 H0");
  refused("G28 Z=VPSLZ\nM2\n", 5, "G16 H0");
  refused("G91 G16 H0 G0 Z=VPSLZ\nM2\n", 15, "G90");
  refused("G16 H0 G0 Z=VPSLZ-10\nM2\n", 13, "control itself");
  refused("G16 H0 G0 Z=VPSLX\nM2\n", 13, "control itself");
  refused("G16 H0 G0 Z=[VPSLZ]\nM2\n", 14, "control itself");
  refused("G16 H0 G0 S=VPSLZ\nM2\n", 13, "control itself");
  refused("VC1=VPSLZ\nM2\n", 5, "control itself");
}

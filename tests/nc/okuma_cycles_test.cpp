// Drilling cycles of an OSP: what they keep, and what no source says of them.
#include <catch2/catch.hpp>

#include "nc/osp_cases.hpp"

using namespace plumbline::nc::tests;

TEST_CASE("OSP: a level of G71 holds no longer than the zero of its axis does") {
  check_osp({{"G15 H1\nT3 M6\nG56 H3 G0 X5 Y0 Z50\nG71 Z50\nM53\nG81 X5 Y0 Z-5 R2 F100\nG0 Z100\n"
              "T1 M6\nG0 X5 Y0\nG56 H1 Z50\nG81 X5 Y0 Z-5 R2 F100\nM2\n",
              11, 1, "nc-not-interpreted", "G71 Z"},
             {"G15 H1 G0 X0 Y0 Z50\nG71 Z50\nM53\nG15 H2 G0 X0 Y0 Z50\nG82 X0 Y0 Z-5 R2 F100\nM2\n", 5, 1},
             {"G15 H1 G0 X0 Y0 Z50\nG71 Z50\nM53\nG92 Z80\nG83 X0 Y0 Z-5 R2 Q1 F100\nM2\n", 5, 1},
             {"G15 H1 G0 X0 Y0 Z50\nG71 Z50 M53\nG169 H1\nG0 Z50\nG85 X0 Y0 Z-5 R2 F100\nM2\n", 5, 1},
             {"G15 H1 G0 X0 Y0 Z50\nG71 Z50 M53\nG18 G0 X0 Y50\nG81 X0 Z0 Y-5 R2 F100\nM2\n", 4, 1,
              "nc-not-interpreted", "another plane"}});
  check_osp({{"G15 H1\nG56 H3 G0 X5 Y0 Z50\nG71 Z50 M53\nG81 X5 Y0 Z-5 R2 F100\nG0 Z100\nG56 H1 Z50\n"
              "G71 Z50\nG81 X5 Y0 Z-5 R2 F100\nM2\n",
              0, 0},
             {"G15 H1\nG56 H3 G0 X5 Y0 Z50\nG71 Z50 M53\nG56 H1 G0 Z60\nG56 H3 Z50\nG81 X5 Y0 Z-5 R2 F100\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z50\nG71 Z50 M53\nG92 X7\nG81 X0 Y0 Z-5 R2 F100\nM2\n", 0, 0},
             {"G15 H1 G0 X0 Y0 Z50\nG71 Z50 M54\nG15 H2 G0 X0 Y0 Z2\nG81 X0 Y0 Z-5 R2 F100\nM2\n", 0, 0}});
}

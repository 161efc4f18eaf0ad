#include <cmath>

#include <catch2/catch.hpp>

#include "jobs/compensate/compensate_file.hpp"
#include "jobs/diff/diff.hpp"
#include "settings/options.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using jobs::DiffSummary;

TEST_CASE("where nobody says whether F counts turns, what the correction turns is not taken for a change of time") {
  settings::Options options;
  options.paths.model = testing::source_file("models/pm600-like.toml");
  options.program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  options.dialect = "okuma";
  const std::string head = "G17 G90 G94\nG15 H1\nG0 X0 Y0 Z50. A0 B0 C0\n";
  for (const char* const cuts : {"G18 G2 X10. Z50. I5. K0 F100\nG17\n", "G3 X4. Y4. I2. J2. F60\nG1 Z48.\n",
                                 "G1 X8. F90\nG2 X0 Y0 I-4. J0\nG0 Z60.\n"}) {
    const testing::Scratch scratch;
    const std::string program = scratch.file("a.min", head + cuts + "M2\n");
    jobs::compensate_file(program, scratch.path("b.min"), options);
    INFO(scratch.text("b.min"));
    const DiffSummary s = jobs::diff_files(program, scratch.path("b.min"), options);
    CHECK(s.out_of_line_a == 0);
    CHECK(s.out_of_line_b == 0);
    CHECK(std::abs(s.seconds_b / s.seconds_a - 1) < 2e-3);
  }
}

TEST_CASE("a label that a program written out bears the first time alone does not put passes out of line") {
  settings::Options options;
  options.paths.model = testing::source_file("models/pm600-like.toml");
  options.program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  options.program.feed_rule = nc::FeedRule::xyz_first;
  options.dialect = "okuma";
  const std::string head = "G17 G90 G94\nG15 H1\nG0 X3 Y3 Z20 A0 B0 C0\n";
  for (const char* const cuts :
       {"CALL O2 Q3\nM2\nO2\nN1 G2 I4. F500\nRTS\n", "CALL O2 Q2\nM2\nO2\nN1 G2 I4. F500\nN2 G1 X9\nN3 X3\nRTS\n",
        "VC1=0\nN1 G1 X9 F300\nX3\nVC1=VC1+1\nIF [VC1 LT 3] N1\nN5 G1 X9\nM2\n",
        "CALL O2\nCALL O2\nM2\nO2\nN7 G3 X3 Y3 J1 F200\nRTS\n"}) {
    const testing::Scratch scratch;
    const std::string program = scratch.file("a.min", head + cuts);
    jobs::compensate_file(program, scratch.path("b.min"), options);
    INFO(cuts);
    const DiffSummary s = jobs::diff_files(program, scratch.path("b.min"), options);
    CHECK(s.out_of_line_a == 0);
    CHECK(s.out_of_line_b == 0);
    CHECK(s.matched == s.moves_a);
  }
}

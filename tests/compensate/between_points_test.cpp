// What the summary says is left at the tip, against a dense play of the output.
#include <catch2/catch.hpp>

#include "compensate/dense_play.hpp"
#include "compensate/random_program.hpp"

using namespace plumbline;

namespace {

// The figure of the summary is within a tenth of what 20 points of every piece find.
void check_honest(const std::string& text, const Job& job) {
  INFO(text);
  const Result result = run(text, job);
  const DensePlay played = dense_play(text, result.text, job, 20);
  const double said_um = result.summary.residual_mm.value * 1e3;
  INFO(played.tip_um << " um at line " << played.line << ", said " << said_um);
  CHECK(said_um >= 0.9 * played.tip_um);
  CHECK(said_um <= 1.1 * played.tip_um);
}

}  // namespace

TEST_CASE("what is left between the points is found on arcs, lines, turns and splines, at coarse steps too") {
  const std::string head = "G21 G90 G94 G17\nG0 X0 Y0 Z20 A0 B0 C0\nG1 Z0 F1000\n";
  for (const char* const move : {"G2 X20 Y0 I10 J0\n", "G3 X12 Y0 Z4 I6 J0 A5\n", "G1 X30 Y17 Z-5\nX34 Y2\n",
                                 "G1 A9 B-4\nC6\n", "G5.1 X16 Y0 I8 J12\n"}) {
    for (const double step : {2.0, 10.0}) {
      for (const bool friction : {true, false}) {
        Job job;
        job.settings.step.length_mm = step;
        job.settings.step.angle_deg = step;
        job.settings.friction = friction;
        check_honest(head + move + "M2\n", job);
      }
    }
  }
}

TEST_CASE("what is left between the points of drawn programs is found", "[.long]") {
  int off = 0;
  double worst = 1;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Job job;
    job.settings.friction = seed % 3 != 0;
    job.settings.step.angle_deg = seed % 4 == 0 ? 5 : 0.5;
    job.settings.step.length_mm = seed % 5 == 0 ? 20 : 2;
    const std::string text = RandomProgram(seed).text(8);
    const Result result = run(text, job);
    const DensePlay played = dense_play(text, result.text, job, 20);
    const double said = result.summary.residual_mm.value * 1e3;
    worst = std::min(worst, said / played.tip_um);
    if (std::abs(said / played.tip_um - 1) <= 0.1) continue;
    ++off;
    WARN("seed " << seed << ": " << played.tip_um << " um at line " << played.line << ", said " << said << " at line "
                 << result.summary.residual_mm.line);
  }
  WARN(off << " of 60 off by more than a tenth; at worst " << worst << " of what is left was said");
  CHECK(worst >= 0.9);
}

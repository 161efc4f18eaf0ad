// Corrections that turn where no source says which speed F is: they wait, and the time is the same under every rule.
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

Job osp() {
  Job job = job_of_control("okuma");
  job.settings.friction = true;
  return job;
}

const std::string kBegin = "G15 H1\nG0 X0 Y0 Z5 A0 B0 C0\nS500 M3\n";

// How long the cuts of a program take where F follows this rule, s.
double seconds(const std::string& text, Job job, nc::FeedRule rule) {
  job.program.feed_rule = rule;
  double sum = 0;
  for_each_step(text, job.program, job.dialect, [&](const nc::Step& step) {
    for (const nc::Motion& motion : step.motions)
      sum += path::duration(motion, path::Curve(motion), nc::dialect(job.dialect)).value_or(0);
  });
  return sum;
}

void check_program(const std::string& cuts, const Job& job) {
  const std::string text = kBegin + cuts + "M2\n";
  INFO(text);
  const Result result = run(text, job);
  CHECK(result.summary.changed_blocks > 0);
  CHECK(result.summary.time_change.value < 1e-3);
  CHECK(result.summary.residual_deg.value < 0.015);
  Job known = job;
  known.program.feed_rule = nc::FeedRule::xyz_first;
  CHECK(result.summary.residual_mm.value < run(text, known).summary.residual_mm.value + 0.0005);
  const double meant = seconds(text, job, nc::FeedRule::xyz_first);
  for (const nc::FeedRule rule : {nc::FeedRule::xyz_first, nc::FeedRule::all_axes_as_mm}) {
    CHECK(std::abs(seconds(result.text, job, rule) / meant - 1) < 1.6e-3);
  }
}

}  // namespace

TEST_CASE("small corner radii, short chords and lead-ins need no feed rule on an OSP") {
  for (const char* const cuts : {
           "G1 Z0 F500\nG1 X10 F1000\nG3 X12.5 Y2.5 J2.5\nG1 Y20\n",
           "G1 Z0 F500\nX10 F1000\nG3 X10.5 Y0.5 J0.5\nG1 Y20\n",
           "G1 Z0 F500\nX10 F1000\nG3 X11 Y1 J1\nG1 Y20\nG3 X10.7 Y20.3 I-0.3\nG1 X0\n",
           "G1 Z0 F300\nG2 X2 Y2 J2 F700\nG1 X30\nG2 X32 Y0 J-2\n",
           "G1 Z0 F500\nX.1 F1000\nX.2 Y.01\nX.3 Y.03\nX.4 Y.06\nX.5 Y.1\nX.58 Y.2\nX.6 Y.3\nX.6 Y.4\nX.5 Y.5\n",
           "G1 Z0 F500\nX.04 F1000\nX.06 Y.03\nX.05 Y.07\nX.01 Y.09\nX-.04 Y.08\nX-.05 Y.04\nX-.02 Y0\n",
       }) {
    check_program(cuts, osp());
  }
}

TEST_CASE("small arcs by a tolerance need no feed rule on an OSP") {
  Job job = osp();
  job.settings.bound.tolerance_mm = 0.003;
  for (const char* const cuts :
       {"G1 Z0 F500\nX10 F1000\nG3 X13 Y3 J3\nG1 Y20\n", "G1 Z0 F500\nX10 F1000\nG3 X12 Y2 J2\nG1 Y20\n",
        "G1 Z0 F500\nX10 F1000\nG3 X11.2 Y1.2 J1.2\nG1 Y20\n"}) {
    check_program(cuts, job);
  }
}

TEST_CASE("A, B and C that waited follow in the moves after") {
  Job known = osp();
  known.program.feed_rule = nc::FeedRule::xyz_first;
  const auto end_of = [](const std::string& text, const Job& job) {
    AxisWords end;
    for_each_step(text, job.program, job.dialect, [&](const nc::Step& step) { end = step.position; });
    return end;
  };
  for (const char* const arc : {"G3 X10.5 Y.5 J.5\n", "G3 X10.3 Y.3 J.3\n", "G3 X10.2 Y.2 J.2\n"}) {
    const std::string text = kBegin + "G1 Z0 F500\nX10 F1000\n" + arc + "G1 Y8\nY20\nM2\n";
    INFO(text);
    const AxisWords at = end_of(run(text, osp()).text, osp());
    const AxisWords wanted = end_of(run(text, known).text, known);
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) CHECK(std::abs(at[axis] - wanted[axis]) < 1e-9);
  }
}

TEST_CASE("a move that turns itself is refused as before") {
  for (const char* const cuts : {"G1 X1 A1 F500\n", "G1 X.1 B.02 F500\n", "G1 A1 F500\n"}) {
    CHECK(code_of(kBegin + cuts + "M2\n", osp()) == "emit-feed-rule");
  }
}

namespace {

// A program with tiny moves under a rule that counts X, Y and Z alone: its times are kept. Where friction turns the tip
// jumps, by more than ten micrometres for all struts together.
void check_joined(const std::string& text, const Job& job) {
  INFO(text);
  const Result result = run(text, job);
  CHECK(result.summary.changed_blocks > 0);
  CHECK(result.summary.time_change.value < 1e-3);
  CHECK(result.summary.residual_deg.value < 0.015);
  CHECK(result.summary.residual_mm.value < 0.022);
}

Job by_path_group() {
  Job job = job_of_control("siemens");
  job.settings.friction = true;
  return job;
}

}  // namespace

TEST_CASE("where F is the speed of X, Y and Z, a turn without a way goes with the piece beside it") {
  const std::string head = "G90 G17 G54 G64 FGROUP(X,Y,Z)\n";
  for (const char* const cuts : {
           "G710 G94\nG0 X0 Y0 Z60 A0 B0 C0\nG1 X10 F600\nG3 X10.05 Y.05 I0 J.05\nG1 Y5\n",
           "G710 G94\nG0 X0 Y0 Z60 A0 B0 C0\nG1 X.1 F20\nG91 G3 X.4 Y.4 I0 J.4\nG1 Y5\n",
           "G710 G94\nG0 X0 Y0 Z60 A0 B0 C0\nG1 X.1 F20\nG91 G2 X.25 Y-.25 I0 J-.25\nG1 X.1\nG3 X.1 Y.1 J.1\n",
           "G700 G94\nG0 X0 Y0 Z2 A0 B0 C0\nG1 X.1 F20\nG91 G3 X.04 Y.04 I0 J.04\nG1 Y.5\n",
           "G710 G94\nG0 X0 Y0 Z60 A0 B0 C0\nG1 X1 F500\nX1.001 A2\nX3\n",
           "G710 G94\nG0 X0 Y0 Z60 A0 B0 C0\nG1 X1 F500\nG91 X.001 B.2\nX.002 C-.3\nX5\n",
       }) {
    check_joined(head + cuts + "M30\n", by_path_group());
  }
  check_joined(head + "G710 G95 S1000 M3\nG0 X0 Y0 Z60 A0 B0 C0\nG1 X.1 F.1\nG91 G2 X.2 Y.2 I.2 J0\nG1 Y5\nM30\n",
               by_path_group());
}

TEST_CASE("the speed of a tool's tip is kept on tiny arcs under G43.4") {
  Job job = fanuc_job();
  job.settings.friction = true;
  job.program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  const std::string head = "%\nO1\nG17 G21 G90 G94 G54\nG0 X0. Y0. Z20. A0. B0. C0.\nG43.4 H1 Z20.\n";
  for (const char* const cuts : {
           "G1 X10. F600.\nG3 X10.05 Y.05 I0. J.05\nG1 Y5.\n",
           "G1 X1. F500.\nG3 X1.02 Y.02 I0. J.02\nG1 Y2.\n",
           "G1 X1. F500.\nX1.001 A2.\nX1.002 Y.001 A1.\nX4.\n",
       }) {
    check_joined(head + cuts + "M30\n%\n", job);
  }
}

TEST_CASE("where no X, Y or Z word is left a correction's turn waits, and a turn of the program's own is refused") {
  Job job = by_path_group();
  job.settings.friction = false;
  const std::string head = "G90 G17 G54 G710 G94 FGROUP(X,Y,Z)\nG0 X0 Y0 Z60 A0 B0 C0\nG1 X1 F500\nG91\n";
  for (const char* const cut : {"X.0003\n", "X.0002 Y-.0002\n", "Z.0004\n"}) {
    INFO(cut);
    CHECK(code_of(head + cut + "X5\nM30\n", job).empty());
  }
  CHECK(code_of(head + "C.02\nX5\nM30\n", job) == "emit-feed-rule");
}

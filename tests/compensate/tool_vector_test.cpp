// Programs that give the direction of the tool as a vector: the output says it in A, B and C, and the tool of the
// deformed machine stands along it.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "compensate/heavy_tool.hpp"
#include "nc/control/state/tilt.hpp"

using namespace plumbline;

namespace {

Job vector_job(const std::string& dialect, nc::FreeRotation free = nc::FreeRotation::c_zero) {
  Job job = heavy_tool_job(dialect, free);
  if (dialect == "fanuc") job.emit.digits_mm = job.emit.digits_deg = 3;
  return job;
}

using Direction = std::array<double, 3>;
using Ends = std::vector<std::pair<std::array<double, 3>, Direction>>;

// Of the programs that turn the tool block by block, in both dialects.
const Ends kEnds{{{10, 5, 20}, {0.1, 0, 1}},
                 {{20, 8, 0}, {0.12, 0.02, 1}},
                 {{25, 9, 0}, {0.13, 0.05, 1}},
                 {{35, 19, 0}, {0.13, 0.05, 1}},
                 {{40, 19, 0}, {0.15, 0.07, 1.02}}};

double angle_deg(const Direction& a, const Direction& b) {
  const auto size = [](const Direction& v) { return std::hypot(v[0], v[1], v[2]); };
  double dot = 0;
  for (std::size_t i = 0; i < 3; ++i) dot += a[i] * b[i];
  return std::acos(std::min(1.0, dot / size(a) / size(b))) / kDeg;
}

// The worst angle between these directions and the tool of the deformed machine where the output comes nearest to the
// points that they belong to, deg.
double worst_deg(const std::string& output, const Job& job, const Ends& ends) {
  compensate::Corrector machine(job.model, job.settings);
  machine.set_tool(kHeavyTool);
  const std::vector<Move> moves = moves_of(output, job.program, job.dialect);
  double worst = 0;
  for (const auto& [point, direction] : ends) {
    const AxisWords wanted{{point[0], point[1], point[2] - 1008, 0, 0, 0}};
    double nearest = 1e9;
    double angle = 0;
    for (const Move& move : moves) {
      const AxisWords stands = move.to_W + machine.error({move.to_W, {}, {}, std::nullopt}).value();
      if (tip_distance(stands, wanted) >= nearest) continue;
      nearest = tip_distance(stands, wanted);
      angle = angle_deg(direction, nc::direction_of(job.program.rotation_order, stands));
    }
    CHECK(nearest < 0.01);
    worst = std::max(worst, angle);
  }
  return worst;
}

bool contains_text(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string kSiemensVectors =
    "G54 G17 G90 G710 G94\nTRAORI\nORIWKS\nD1\nFGROUP(X,Y,Z)\nG0 X0 Y0 Z60 A0 B0 C0\n"
    "N10 G0 X10 Y5 A3=0.1 B3=0 C3=1\nZ20\nG1 Z0 F500\nN20 X20 Y8 A3=0.12 B3=0.02 C3=1 ; turn\n"
    "X25 Y9 A3=0.13 B3=0.05 C3=1\nM30\n";

}  // namespace

TEST_CASE("Siemens: directions of the tool become A, B and C, and the deformed tool stands along them") {
  const Job job = vector_job("siemens");
  const std::string text =
      "G54 G17 G90 G710 G94\nTRAORI\nD1\nFGROUP(X,Y,Z)\nG0 X0 Y0 Z60 A0 B0 C0\nN10 G0 X10 Y5 A3=0.1 B3=0 C3=1\nZ20\n"
      "G1 Z0 F500\nN20 X20 Y8 A3=0.12 B3=0.02 C3=1 ; turn\nX25 Y9 B3=0.1 A3=0.26 C3=2 M8\nG2 X35 Y19 CR=10\n"
      "G1 X40 A3=0.15 B3=0.07 C3=1.02 F800\nG0 Z60\nM30\n";
  const Result result = run(text, job);
  INFO(result.text);
  CHECK_FALSE(contains_text(result.text, "A3="));
  CHECK(contains_text(result.text, "; turn\n"));
  const Played played = play(text, result.text, job, kHeavyTool);
  CHECK(played.at_points_um < 0.2);
  CHECK(played.time_change < 1.5e-3);
  CHECK(worst_deg(result.text, job, kEnds) < 2e-5);
}

TEST_CASE("Fanuc: G43.5 becomes G43.4, with no more decimals than the control keeps") {
  const Job job = vector_job("fanuc");
  const std::string text =
      "O0001\nG21 G17 G90 G54 G94\nM3 S1000\nG0 X0. Y0. Z60. A0. B0. C0.\nG43.5 H1 Z60.\nG0 X10. Y5. I0.1 J0. "
      "K1.\nZ20.\n"
      "G1 Z0. F500.\nN20 X20. Y8. I.12 J.02 K1. (TURN)\nX25. Y9. I26. J10. K200.\nG2 X35. Y19. R10.\n"
      "G1 X40. I0.15 J0.07 K1.02 F800.\nG0 Z60.\nG49\nM30\n";
  const Result result = run(text, job);
  INFO(result.text);
  CHECK(contains_text(result.text, "G43.4 H1 Z60"));
  CHECK_FALSE(contains_text(result.text, "G43.5"));
  for (const char* const letter : {" I", " J", " K"})
    CHECK_FALSE(contains_text(result.text.substr(result.text.find("G43.4")), letter));
  const Played played = play(text, result.text, job, kHeavyTool);
  CHECK(played.at_points_um < 1.8);  // the control keeps 1 um of each axis and 0.001 deg
  CHECK(worst_deg(result.text, job, kEnds) < 1.5e-3);
}

TEST_CASE("C goes on where it stands, or to zero, as the control was said to do") {
  const std::string text =
      "G54 G17 G90 G710 G94\nD1\nFGROUP(X,Y,Z)\nG0 X0 Y0 Z40 A0 B0 C20\nG0 X10 A3=0.1 B3=-0.05 C3=1\nG1 Z0 F500\n"
      "X20 A3=0.12 B3=-0.05 C3=1\nM30\n";
  for (const nc::FreeRotation free : {nc::FreeRotation::c_stays, nc::FreeRotation::c_zero}) {
    const Job job = vector_job("siemens", free);
    const Result result = run(text, job);
    INFO(result.text);
    CHECK(play(text, result.text, job, kHeavyTool).at_points_um < 0.2);
    CHECK(worst_deg(result.text, job, {{{10, 0, 0}, {0.1, -0.05, 1}}, {{20, 0, 0}, {0.12, -0.05, 1}}}) < 2e-5);
    const double c = moves_of(result.text, job.program, "siemens").back().to_W[Axis::C];
    CHECK(c == Approx(free == nc::FreeRotation::c_stays ? 20 : 0).margin(0.05));
  }
}

TEST_CASE("the direction is the machine's: the order of A, B and C is that of the model") {
  Job job = vector_job("siemens");
  job.model.rotation = machine::rotation_order("XYZ").value();
  job.program.rotation_order = job.model.rotation.axes;
  const std::string text =
      "G54 G90 G94\nD1\nFGROUP(X,Y,Z)\nG0 X0 Y0 Z40 A0 B0 C0\nG0 X10 A3=0.2 B3=-0.15 C3=1\nG1 Z0 F500\nX20\nM30\n";
  const Result result = run(text, job);
  CHECK(worst_deg(result.text, job, {{{10, 0, 0}, {0.2, -0.15, 1}}, {{20, 0, 0}, {0.2, -0.15, 1}}}) < 2e-5);
}

TEST_CASE("directions in loops and subprograms are written out, pass by pass") {
  const std::string siemens =
      "G54 G90 G94\nD1\nFGROUP(X,Y,Z)\nG0 X0 Y0 Z40 A0 B0 C0\nG0 X10 A3=0 B3=0 C3=1\nG1 Z0 F500\nR1=0\nREPEAT\n"
      "R1=R1+1\nX=10+5*R1 A3=0.02*R1 B3=0 C3=1\nUNTIL R1>=3\nG0 Z40\nM30\n";
  const Job job = vector_job("siemens");
  const Result first = run(siemens, job);
  INFO(first.text);
  CHECK_FALSE(contains_text(first.text, "REPEAT"));
  CHECK_FALSE(contains_text(first.text, "A3="));
  CHECK(play(siemens, first.text, job, kHeavyTool).at_points_um < 0.2);
  CHECK(worst_deg(first.text, job, {{{15, 0, 0}, {0.02, 0, 1}}, {{25, 0, 0}, {0.06, 0, 1}}}) < 2e-5);

  const std::string fanuc =
      "O0001\nG21 G17 G90 G54 G94\nG0 X0. Y0. Z40. A0. B0. C0.\nG43.5 H1 Z40.\nG1 Z0. F500.\n#1=1\nWHILE [#1 LE 3] DO "
      "1\nX[10+5*#1] I[0.02*#1] J0. K1.\n#1=#1+1\nEND 1\nM98 P7\nG49\nM30\nO0007\nX30. J0.1 K1.\nM99\n";
  const Job other = vector_job("fanuc");
  const Result second = run(fanuc, other);
  INFO(second.text);
  CHECK_FALSE(contains_text(second.text, "WHILE"));
  CHECK_FALSE(contains_text(second.text, "G43.5"));
  CHECK(worst_deg(second.text, other, {{{25, 0, 0}, {0.06, 0, 1}}, {{30, 0, 0}, {0, 0.1, 1}}}) < 1.5e-3);
}

TEST_CASE("a direction beside a call is written out before it") {
  const std::string text =
      "O0001\nG21 G17 G90 G54 G94\nG0 X0. Y0. Z40. A0. B0. C0.\nG43.5 H1 Z40.\nG1 Z0. F500.\nX10. I.05 K1. M98 P7\n"
      "X30. I0. K1.\nG49\nM30\nO0007\nX20. J0.1 K1.\nM99\n";
  const Job job = vector_job("fanuc");
  const Result result = run(text, job);
  INFO(result.text);
  CHECK_FALSE(contains_text(result.text, "M98"));
  CHECK(worst_deg(result.text, job, {{{10, 0, 0}, {0.05, 0, 1}}, {{20, 0, 0}, {0, 0.1, 1}}, {{30, 0, 0}, {0, 0, 1}}}) <
        1.5e-3);
}

TEST_CASE("in inches a direction is the same") {
  const std::string text =
      "O0001\nG20 G17 G90 G54 G94\nG0 X0. Y0. Z1. A0. B0. C0.\nG43.5 H1 Z1.\nG0 X.5 I.1 K1.\nG1 Z0. F20.\n"
      "X1. I.12 K1.\nG49\nM30\n";
  const Job job = vector_job("fanuc");
  const Result result = run(text, job);
  INFO(result.text);
  CHECK(worst_deg(result.text, job, {{{12.7, 0, 0}, {0.1, 0, 1}}, {{25.4, 0, 0}, {0.12, 0, 1}}}) < 1.5e-3);
}

TEST_CASE("a direction beside X, Y or Z that nobody knows goes through as it stands, and after a change as A, B, C") {
  Job job = vector_job("siemens");
  const std::string text =
      "G54 G90 G94\nD1\nFGROUP(X,Y,Z)\nG0 Z40 A3=0 B3=0 C3=1\nG0 X0 Y0\nG1 X10 A3=0.02 B3=0 C3=1 F500\nM0\n"
      "G0 Z50 A3=0.1 B3=0 C3=1\nG0 X10 Y0\nM30\n";
  const Result result = run(text, job);
  INFO(result.text);
  CHECK(contains_text(result.text, "G0 Z40 A3=0 B3=0 C3=1\n"));
  CHECK(contains_text(result.text, "G0 Z50 A0 B5.71059 C0\n"));
  CHECK(worst_deg(result.text, job, {{{10, 0, 40}, {0.02, 0, 1}}, {{10, 0, 50}, {0.1, 0, 1}}}) < 2e-5);
}

TEST_CASE("a program whose directions need no change keeps them; G43.5 is written as G43.4 all the same") {
  Job job = vector_job("siemens");
  job.model.gravity = Vector3<double>::Zero();
  CHECK(run(kSiemensVectors, job).text == kSiemensVectors);

  Job other = vector_job("fanuc");
  other.model.gravity = Vector3<double>::Zero();
  const std::string fanuc =
      "O0001\nG21 G17 G90 G54 G94\nG0 X0. Y0. Z40. A0. B0. C0.\nG43.5 H1 Z40.\nG0 X10. I0.1 J0. K1.\n"
      "G1 X20. I0.12 K1. F500.\nM30\n";
  const Result result = run(fanuc, other);
  INFO(result.text);
  CHECK(result.summary.changed_blocks == 0);
  CHECK(contains_text(result.text, "G43.4 H1 Z40.\nG0 X10. A0. B5.711 C0.\nG1 X20. A0. B6.843 C0. F500.\nM30\n"));
}

TEST_CASE("a direction rounded to A, B and C makes a short move longer or shorter: it gets an F of its own") {
  Job job = vector_job("fanuc");
  job.model.gravity = Vector3<double>::Zero();
  job.program.feed_rule = nc::FeedRule::all_axes_as_mm;
  const std::string begin =
      "O0001\nG21 G17 G90 G54 G94\nG0 X0. Y0. Z40. A0. B0. C0.\nG43.5 H1 Z40.\nG1 X10. I0. J0. K1. F500.\n";
  // 0.6 to 1.4 thousandths of a degree beside 0.1 to 0.5 mm
  for (const char* const move : {"X10.01 I.0001 K9.\n", "Y.01 I-.0002 K8.\n", "X10.004 Y.002 J.00007 K5.\n"}) {
    const Result result = run(begin + move + "M30\n", job);
    INFO(move << result.text);
    CHECK(std::count(result.text.begin(), result.text.end(), 'F') == 2);
    CHECK(result.summary.time_change.value < 1e-3);
    const std::string loop = "#1=2\nWHILE [#1 GT 0] DO 1\n#1=#1-1\nEND 1\n";
    const Result written_out = run(begin + move + loop + "M30\n", job);
    INFO(written_out.text);
    const std::size_t own_feed = result.text.find('F', result.text.find("F500.") + 1);
    CHECK(contains_text(written_out.text, result.text.substr(own_feed, result.text.find('\n', own_feed) - own_feed)));
    CHECK(written_out.summary.time_change.value < 1e-3);
  }
  // Where it makes no difference, F stands.
  const Result long_one = run(begin + "X90. I.1 K9.\nM30\n", job);
  CHECK(contains_text(long_one.text, "G1 X10. A0. B0. C0. F500.\nX90. A0. B0.637 C0.\n"));
}

TEST_CASE("how long a turn alone lasts under G43.5 no program says") {
  Job job = vector_job("fanuc");
  const std::string text =
      "O0001\nG21 G17 G90 G54 G94\nG0 X0. Y0. Z40. A0. B0. C0.\nG43.5 H1 Z40.\nG1 X10. F500.\nI.03 J0. K1.\nM30\n";
  std::size_t line = 0;
  CHECK(code_of(text, job, &line) == "emit-feed-rule");
  CHECK(line == 6);
  job.program.feed_rule = nc::FeedRule::xyz_first;
  CHECK(code_of(text, job).empty());
}

TEST_CASE("a direction beyond the tilt of the machine breaks its limit") {
  std::size_t line = 0;
  const std::string text = "G54 G90 G94\nD1\nG0 X0 Y0 Z40 A0 B0 C0\nG0 X10 A3=1 B3=0 C3=1\nM30\n";
  CHECK(code_of(text, vector_job("siemens"), &line) == "limit-tilt");
  CHECK(line == 4);
}

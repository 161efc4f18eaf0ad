// Programs on tilted planes: the deformed machine's tip is where the program says, though A, B and C get no words.
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "compensate/heavy_tool.hpp"
#include "machine/axis_words.hpp"

using namespace plumbline;

namespace {

// Where the last pieces of blocks that cut end, in W.
std::vector<Move> cuts_of(const std::string& text, const Job& job) {
  std::vector<Move> cuts;
  for (const Move& move : moves_of(text, job.program, job.dialect)) {
    if (move.motion.kind == nc::MotionKind::feed || move.motion.kind == nc::MotionKind::arc) cuts.push_back(move);
  }
  return cuts;
}

// How far the deformed tip is from the end that the original gives, um; the ends of the output that come nearest.
double left_um(const std::string& text, const std::string& output, const Job& job) {
  compensate::Settings settings = job.settings;
  compensate::Corrector corrector(job.model, settings);
  corrector.set_tool(kHeavyTool);
  const std::vector<Move> written = cuts_of(output, job);
  double worst = 0;
  for (const Move& original : cuts_of(text, job)) {
    double least = 1e9;
    for (const Move& move : written) {
      if (tip_distance(move.to_W, original.to_W) > 3) continue;
      const auto off = corrector.tip_distance_mm({original.to_W, {}, {}, std::nullopt}, move.to_W);
      if (off) least = std::min(least, *off * 1000);
    }
    worst = std::max(worst, least);
  }
  return worst;
}

// Rotary words, if some stand between the plane's begin and its end.
bool turns_in_plane(const std::string& output, const std::string& begin, const std::string& end) {
  const std::size_t from = output.find(begin) + begin.size();
  const std::string plane = output.substr(from, output.find(end, from) - from);
  return plane.find_first_of("ABC") != std::string::npos;
}

const std::string kFanucHead = "O0001\nG21 G17 G90 G54 G94\nG43 H1\nG0 X0. Y0. Z50. A0. B0. C0.\n";

}  // namespace

TEST_CASE("Fanuc: a plane by Euler angles, lines and arcs on it, is corrected in X, Y and Z") {
  const Job job = heavy_tool_job("fanuc", nc::FreeRotation::c_stays);
  const std::string text = kFanucHead +
                           "G68.2 X10. Y5. Z0. I30. J15. K-20.\nG53.1\nG0 X0. Y0. Z20.\nG1 Z-2. F500.\nX30.\n"
                           "G3 X20. Y10. I-10. J0.\nG91 G1 X-5. Y5.\nG90\nG0 Z50.\nG69\nG0 X0. Y0. Z60.\n"
                           "G1 X5. A1. B1. C1. F400.\nM30\n";
  Job with_rule = job;
  with_rule.program.feed_rule = nc::FeedRule::xyz_first;
  const Result result = run(text, with_rule);
  INFO(result.text);
  CHECK(result.summary.changed_blocks >= 6);
  CHECK_FALSE(turns_in_plane(result.text, "G53.1\n", "G69"));
  CHECK(left_um(text, result.text, with_rule) < 1.5);  // the control keeps 1 um of each axis
  CHECK(left_um(text, text, with_rule) > 50);
}

TEST_CASE("Fanuc: planes one after the other, drilling and tapping on them") {
  const Job job = heavy_tool_job("fanuc", nc::FreeRotation::c_zero);
  const std::string text =
      "O0001\nG21 G17 G90 G54 G94\nT1 M6\nM3 S1000\nG68.2 X0. Y0. Z0. I0. J12. K0.\nG53.1\nG0 X10. Y0.\nG43 H1 Z30.\n"
      "G81 X10. Y0. Z-5. R2. F200.\nX20.\nG80\nG0 Z50.\nG69\nG68.2 X0. Y0. Z0. I90. J10. K-90.\nG53.1\n"
      "G0 X-10. Y5. Z30.\nG1 Z1. F300.\nG0 Z40.\nM29 S500\nG84 X-10. Y5. Z-4. R3. F500.\nG80\nG69\nG91 G28 Z0.\nM30\n";
  const Result result = run(text, job);
  INFO(result.text);
  CHECK_FALSE(turns_in_plane(result.text, "G53.1\n", "G69"));
  CHECK(left_um(text, result.text, job) < 6);  // a tap is shifted as a whole
}

TEST_CASE("Siemens: CYCLE800 turns the tool, and what follows is corrected on its plane") {
  const Job job = heavy_tool_job("siemens", nc::FreeRotation::c_stays);
  const std::string text =
      "G54 G17 G90 G71 G94\nD1\nG0 X0 Y0 Z60 A0 B0 C0\nCYCLE800(1,\"TABLE\",0,57,0,0,0,8,-10,0,0,0,0,-1)\nG0 X5 Y5 "
      "Z20\n"
      "G1 Z-1 F600\nX=IC(20)\nG2 X35 Y-5 CR=10\nG0 Z40\nCYCLE800()\nG0 X0 Y0 Z60 A0 B0 C0\nM30\n";
  const Result result = run(text, job);
  INFO(result.text);
  CHECK_FALSE(turns_in_plane(result.text, "-1)\n", "CYCLE800()"));
  CHECK(left_um(text, result.text, job) < 0.5);
}

TEST_CASE("Siemens: CYCLE800 with zeros and a direction turns the tool upright, and A, B and C are corrected there") {
  const std::string text =
      "G54 G17 G90 G71 G94\nD1\nG0 X0 Y0 Z60 A0 B0 C0\nCYCLE800(1,\"TABLE\",0,57,0,0,0,8,-10,0,0,0,0,-1)\nG0 X5 Y5 "
      "Z20\nG1 Z-1 F600\nG0 Z40\nCYCLE800(1,\"TABLE\",0,57,0,0,0,0,0,0,0,0,0,-1)\nG0 X0 Y0\nZ40\nG1 X20 F600\nG0 Z60\n"
      "CYCLE800()\nM30\n";
  for (const nc::FreeRotation free : {nc::FreeRotation::c_stays, nc::FreeRotation::c_zero}) {
    const Job job = heavy_tool_job("siemens", free);
    const Result result = run(text, job);
    INFO(result.text);
    CHECK_FALSE(turns_in_plane(result.text, "8,-10,0,0,0,0,-1)\n", "CYCLE800(1,\"TABLE\",0,57,0,0,0,0"));
    CHECK(turns_in_plane(result.text, "0,0,0,0,0,0,0,0,0,-1)\n", "CYCLE800()"));
    CHECK(left_um(text, result.text, job) < 0.5);
  }
  const Diagnostic refused =
      testing::refusal_of([&] { run(text, heavy_tool_job("siemens", nc::FreeRotation::unknown)); });
  CHECK(refused.code == "nc-tilted-plane");
}

TEST_CASE("where a stop lost C, the help names the option that says that it stays") {
  const std::string plane = "G68.2 X0. Y0. Z0. I0. J10. K0.\nG53.1\nG0 X0. Y0. Z20.\nG1 Z0. F500.\nG69\nM30\n";
  Job job = heavy_tool_job("fanuc", nc::FreeRotation::c_stays);
  for (const std::string stop : {"M0\n", "M1\n", "G0 Z50.\nM01 (LOOK)\nG0 X0. Y0.\n"}) {
    const Diagnostic refused = testing::refusal_of([&] { run(kFanucHead + stop + plane, job); });
    CHECK(refused.code == "nc-tilted-plane");
    CHECK(refused.help.find("--keeps-position M1") != std::string::npos);
  }
  job.program.keeps_position = {1};
  CHECK_FALSE(run(kFanucHead + "M1\n" + plane, job).text.empty());
}

TEST_CASE("the direction of a plane is the machine's: the order of A, B and C is that of the model") {
  Job job = heavy_tool_job("fanuc", nc::FreeRotation::c_stays);
  job.model.rotation = machine::rotation_order("XYZ").value();
  job.program.rotation_order = job.model.rotation.axes;
  const std::string text =
      kFanucHead + "G68.2 X0. Y0. Z0. I40. J14. K10.\nG53.1\nG0 X0. Y0. Z20.\nG1 Z-2. F500.\nX10.\nG69\nM30\n";
  const Result result = run(text, job);
  CHECK(left_um(text, result.text, job) < 1.5);
  const std::vector<Move> cuts = cuts_of(text, job);
  const Vector3<double> tool = machine::pose_of(job.model.rotation, cuts.back().to_W).R_WP.col(2);
  CHECK(tool.x() == Approx(std::sin(40 * kDeg) * std::sin(14 * kDeg)));
  CHECK(tool.y() == Approx(-std::cos(40 * kDeg) * std::sin(14 * kDeg)));
  CHECK(tool.z() == Approx(std::cos(14 * kDeg)));
}

TEST_CASE("loops and expressions on a tilted plane are unrolled") {
  const Job job = heavy_tool_job("fanuc", nc::FreeRotation::c_zero);
  const std::string text =
      kFanucHead +
      "#1=10\nG68.2 X0. Y0. Z0. I0. J#1 K0.\nG53.1\nG0 X0. Y0. Z20.\nG1 Z0. F500.\nWHILE [#1 LT 13] DO 1\n"
      "X[#1*2]\n#1=#1+1\nEND 1\nG0 Z30.\nG69\nM30\n";
  const Result result = run(text, job);
  INFO(result.text);
  CHECK(result.text.find("WHILE") == std::string::npos);
  CHECK(left_um(text, result.text, job) < 1.5);
}

TEST_CASE("Fanuc: holes of one drilling cycle lie on a tilted plane") {
  const Job job = heavy_tool_job("fanuc", nc::FreeRotation::c_stays);
  for (const std::string holes :
       {"G98 G81 X5. Y5. Z-8. R2. F100.\nX12.\nY20.\n", "G99 G83 X5. Y5. Z-8. R2. Q3. F100.\nX12. Y-4.\n",
        "G98 G85 X5. Y5. Z-8. R2. F100.\nX1.\nX9. Z-9.\n"}) {
    const std::string text = kFanucHead + "G68.2 X10. Y5. Z0. I30. J15. K-20.\nG53.1\nG0 X0. Y0. Z20.\n" + holes +
                             "G80\nG0 Z50.\nG69\nG0 X0. Y0. Z60.\nM30\n";
    INFO(text);
    const std::string output = run(text, job).text;
    INFO(output);
    CHECK(left_um(text, output, job) <= 3);
    CHECK_FALSE(turns_in_plane(output, "G53.1", "G69"));
  }
}

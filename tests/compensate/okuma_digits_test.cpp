// Programs for an OSP come out with no more digits than the control keeps, and their increments add up.
#include <regex>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

constexpr double kKeptUm = 10;  // half a thousandth of mm and deg, on a platform of half a metre

}  // namespace

TEST_CASE("OSP: no word has more decimals than the control keeps, and increments end where the block does") {
  Job job = job_of_control("okuma");
  job.program.feed_rule = nc::FeedRule::xyz_first;
  const std::string head = "$DIGITS.MIN%\nG15 H1\nG17 G90 G94\nG0 X-90 Y-50 Z50 A0 B0 C0\n";
  for (const char* const moves :
       {"G91 G1 X299.7 Y100.3 A5 F3000\nG90\n", "G91 G1 X-33.333 Y66.667 Z-10.001 B-3.333 F800\nX-1\nG90\n",
        "G91 G2 X20 Y20 I20 J0 F500\nG1 Z-3\nG90\n", "G1 X1.0001 Y2.12345 F100\nA2.55555\n",
        "VC1=7\nG1 X=VC1/3 Y=VC1*1.2345 F100\nVC1=VC1+1\nX=VC1/3\n",
        "G71 Z50\nG82 X40 Y0 Z-5 R2 F100 M53\nX50\nG0 Z50\n"}) {
    const std::string text = head + moves + "G0 X0 Y0 Z50 A0 B0\nM2\n";
    const Result result = run(text, job);
    INFO(result.text);
    CHECK_FALSE(std::regex_search(
        result.text, std::regex("^[^(\n]*[XYZABCIJKR]-?[0-9]*\\.[0-9]{4}[0-9]*( |$)", std::regex::multiline)));
    CHECK(play(text, result.text, job).at_points_um <= kKeptUm);
    CHECK(result.summary.rounding_mm.value <= 0.0009);
  }
}

TEST_CASE("OSP: a feed that is worked out is written with the decimals that the control keeps") {
  Job job = job_of_control("okuma");
  job.program.feed_rule = nc::FeedRule::xyz_first;
  const std::string head = "G15 H1\nG17 G90 G94\nG0 X-30 Y-50 Z50 A0 B0 C0\n";
  for (const char* const moves :
       {"VC1=7\nG1 X5 F=1000/VC1\nVC1=VC1+1\nX10\n", "FEED=700\nG1 X5 F=FEED/3\nFEED=FEED+1\nX7 F=FEED*1.00001\n",
        "VC1=3\nG71 Z50\nG85 X5 Z-5 R2 F100 FA=1000/VC1 M53\nVC1=4\nX9\nG0 Z50\n"}) {
    const Result result = run(head + moves + "G0 X0\nM2\n", job);
    INFO(result.text);
    CHECK_FALSE(std::regex_search(result.text, std::regex("FA?=?[0-9]+\\.[0-9]{4}")));
  }
}

TEST_CASE("OSP: the F of a smoothing code is no feed, and keeps the digits that it is worth") {
  Job job = job_of_control("okuma");
  job.program.feed_rule = nc::FeedRule::xyz_first;
  const std::string text =
      "G15 H1\nG17 G90 G94\nG0 X-30 Y-50 Z50 A0 B0 C0\nGOTO N5\nN5 G131 F=1000/3 J1 E0.01\nG1 X5 F100\nM2\n";
  CHECK(run(text, job).text.find("F333.333333333 J1") != std::string::npos);
}

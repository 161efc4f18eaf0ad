// F and S after cycles of a SINUMERIK that have feeds and speeds of their own.
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "nc/siemens_cases.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

std::string last_feed(const std::vector<Motion>& motions) {
  double feed = 0;
  for (const Motion& motion : motions) feed = motion.feed > 0 ? motion.feed : feed;
  return fmt::format("F{:g}", feed);
}

std::string strokes(const std::vector<Motion>& motions) {
  std::string told;
  for (const Motion& motion : motions) {
    if (motion.kind == MotionKind::dwell) told += fmt::format("wait {:g}, ", motion.dwell_s);
    if (motion.kind != MotionKind::feed) continue;
    told += fmt::format("Z{:g} F{:g}{}, ", motion.to[Axis::Z], motion.feed, motion.unknown_strokes ? " ?" : "");
  }
  return told;
}

void check_feeds(const std::string& expected, const std::vector<std::string>& programs) {
  check_siemens("G54 G17 G90 G94 G710\nG0 X0 Y0 Z50 A0 B0 C0 S1000 M3 F500\n", last_feed, expected, programs);
}

const std::string kReam = "CYCLE85(60,0,2,-5,,0,80,160)\n", kTap = "CYCLE84(60,0,2,-5,,0,3,,1,0,300,600)\n",
                  kShared = "CYCLE83(60,0,2,-5,,-9,,0,0,0,0.5,1)\n", kFloating = "CYCLE840(60,0,2,-5,,0,0,3,0,0,1.5)\n";

}  // namespace

TEST_CASE("after a cycle with feeds of its own a cut needs an F") {
  check_feeds("nc-feed-missing", {kReam + "G1 X10\n", kTap + "G1 X10\n", kShared + "G2 X10 Y0 I5 J0\n",
                                  kFloating + "G1 Y5\n", kReam + "CYCLE81(60,0,2,-5)\n",
                                  "MCALL " + kTap + "X10\nMCALL\nG1 X20\n", "G1\nMCALL " + kReam + "X10\nX20\n"});
  check_feeds("F200", {kReam + "G1 X10 F200\n", kTap + "F200\nG1 X10\n", kShared + "G2 X10 Y0 I5 J0 F200\n",
                       kFloating + "X3\nG1 F200 Y5\n", kReam + "F200\nCYCLE81(60,0,2,-5)\n",
                       "MCALL " + kTap + "X10\nX20\nMCALL\nG1 X20 F200\n"});
  check_feeds("F500", {"CYCLE81(60,0,2,-5)\nG1 X10\n", "CYCLE85(60,0,2,-5,,0,500,500)\nG1 X10\n",
                       "CYCLE83(60,0,2,-5,,-2,,0,0,0,0.5,1)\nG1 X10\n", "CYCLE840(60,0,2,-5,,0,0,3,1)\nG1 X10\n",
                       "MCALL CYCLE83(60,0,2,-5,,-2,,0,0,0,0.5,1)\nX10\nX20\nMCALL\nG1 X10\n"});
  check_feeds("F500",
              {"MCALL CYCLE83(50,0,1,-30,,,5,90,0,0.6,90,0,0,3,1.4,0,1.4,0,1,11221112)\nX5\nX10\nMCALL\nG1 X20\n",
               "CYCLE83(50,0,3,-12,,,5,0.8,0,0,0.7,0)\nG1 X20\n", "CYCLE83(5,0,2,-10,,-3,,1,0.1,0,0.5,1)\nG1 X20\n"});
  check_feeds("F160", {"MCALL " + kReam + "X10\nX20\nMCALL\n", kReam + "G0 X10\n" + kReam});
}

TEST_CASE("after a tap with a speed of its own G95 needs an S") {
  check_feeds("nc-feed-missing", {kTap + "G95 F0.1 X10 G1\n", kTap + "M3\nG95\nG1 X10 F0.1\n",
                                  "CYCLE84(60,0,2,-5,,0,3,,1,0,1000,600)\nG95 F0.1 X10 G1\n"});
  check_feeds("F0.1", {kTap + "S800\nG95 F0.1 X10 G1\n", "CYCLE84(60,0,2,-5,,0,3,,1,0,1000)\nG95 F0.1 X10 G1\n",
                       kTap + "G95 F0.1 X10 G1 S500\n"});
}

TEST_CASE("values of cycles that no source covers") {
  check_feeds("nc-not-interpreted",
              {"CYCLE84(60,0,2,-5,,0,3,,1,0)\n", "CYCLE84(60,0,2,-5,,0,3,,1,0,0,600)\n", "CYCLE84(60,0,2,-5,,0,3,8)\n",
               "CYCLE83(60,0,2,-20,,4,,0,0,0,1,1)\n", "CYCLE83(60,5,2,-20,,6,,0,0,0,1,1)\n",
               "MCALL CYCLE83(60,-10,2,-20,,-9,,0,0,0,1,1)\nX5\n", "CYCLE83(60,0,2,-20,,-4,,-2,0,0,1,1)\n",
               "CYCLE83(60,0,2,-20,,-4,,-1.5,0,0,1,1)\n", "CYCLE83(60,0,2,-20,,-4,,-100,0,0,1,1)\n"});
  check_feeds("F500", {"CYCLE83(60,0,2,-20,,-4,,-0.5,0,0,1,1)\n", "CYCLE83(60,0,2,-20,,-40,,0,0,0,1,1)\n",
                       "CYCLE83(60,0,2,-20,,-4,,2,0,0,1,1)\n"});
}

TEST_CASE("feeds and depths of cycles that are left out or 0") {
  check_feeds("nc-not-interpreted", {"CYCLE85(60,0,2,-5)\n", "CYCLE85(60,0,2,-5,,0,0,160)\n",
                                     "CYCLE85(60,0,2,-5,,1,80)\n", "MCALL CYCLE85(60,0,2,-5,,0,80,0)\nX5\n",
                                     "CYCLE83(60,0,2,-20,,-4)\n", "CYCLE83(60,0,2,-20,,,4,,0,0,0,1)\n",
                                     "CYCLE83(60,0,2,-20,,,,,0,0,1,1)\n", "CYCLE83(60,0,2,-20,,0,0,2,0,0,1,1)\n"});
  check_feeds("F500", {"CYCLE83(60,0,2,-20,,-4,,,,,1)\n", "CYCLE83(60,0,2,-20,,,4,,,,1,1)\n"});
}

// [X p. 2-86]
TEST_CASE("a floating tap has its feed from its pitch, or from F where no encoder counts") {
  check_feeds("nc-not-interpreted", {"CYCLE840(60,0,2,-5)\n", "CYCLE840(60,0,2,-5,,0,4,3)\n",
                                     "CYCLE840(60,0,2,-5,,0,4,3,1,,1.5)\n", "CYCLE840(60,0,2,-5,,0,0,3,11,8)\n"});
  check_feeds("nc-feed-missing", {"G95\nCYCLE840(60,0,2,-5,,0,0,3,1)\n"});
  check_feeds("F500", {"CYCLE840(60,0,2,-5,,0,4,3,1)\n", "CYCLE840(60,0,2,-5,,0,0,3,1,3)\n",
                       "CYCLE840(60,0,2,-5,,0,4,3,0,,0.5)\n", "F300\nCYCLE840(60,0,2,-5,,0,0,,0,3)\n"});
  check_feeds("F0.5", {"G95 F0.5\nCYCLE840(60,0,2,-5,,0,4,3,1,,0.5)\n"});
}

TEST_CASE("a tap leaves the spindle as SDAC says") {
  check_feeds("nc-feed-missing", {"G1\nCYCLE84(60,0,2,-5,,0,,,1,0,300)\nG95 F0.1 S300 X10\n",
                                  "G1\nCYCLE84(60,0,2,-5,,0,0,,1,0,300)\nG95 F0.1 S300 X10\n",
                                  "G1\nCYCLE840(60,0,2,-5,,0,4,,0,,1)\nG95 F0.1 X10\n",
                                  "G1\nCYCLE840(60,0,2,-5,,0,3,5,0,,1)\nG95 F0.1 X10\n"});
  check_feeds("F0.1", {"G1\nCYCLE84(60,0,2,-5,,0,3,,1,0,300)\nG95 F0.1 S300 X10\n",
                       "G1\nCYCLE840(60,0,2,-5,,0,0,,0,,1)\nG95 F0.1 X10\n",
                       "G1\nCYCLE84(60,0,2,-5,,0,,,1,0,300)\nM3 G95 F0.1 S300 X10\n"});
}

TEST_CASE("the pitch of a tap is in the unit that _PITA says") {
  check_feeds("F300", {"G700\nCYCLE84(2,0,0.1,-0.2,,0,3,,1.5,0,200,200,0,1)\n",
                       "G700\nCYCLE840(2,0,0.1,-0.2,,0,0,3,0,,0.3,0,1)\n",
                       "CYCLE84(60,0,2,-5,,0,3,,1.5,0,200,200,0,1)\n", "CYCLE84(60,0,2,-5,,0,3,,1.5,0,200,200,0,0)\n",
                       "G700\nCYCLE84(2,0,0.1,-0.2,,0,3,10,1.5,0,200,200,3,1)\n"});
  check_feeds(
      "F254",
      {"CYCLE84(60,0,2,-5,,0,3,,0.05,0,200,200,0,3)\n", "G700\nCYCLE84(2,0,0.1,-0.2,,0,3,,0.05,0,200,200,0,3)\n",
       "G700\nCYCLE84(2,0,0.1,-0.2,,0,3,,0.05,0,200,200)\n", "G700\nCYCLE840(2,0,0.1,-0.2,,0,0,3,0,,0.01,0,0)\n"});
  check_feeds("nc-not-interpreted",
              {"CYCLE84(60,0,2,-5,,0,3,,20,0,200,200,0,2)\n", "CYCLE84(60,0,2,-5,,0,3,,1,0,200,200,0,4)\n",
               "G700\nCYCLE840(2,0,0.1,-0.2,,0,0,3,0,,20,0,2)\n", "CYCLE84(60,0,2,-5,,0,3,8,1.5,0,200,200,0,1)\n"});
}

TEST_CASE("strokes of CYCLE83 that get smaller are not known behind the first") {
  const auto check = [](const std::string& expected, const std::vector<std::string>& programs) {
    check_siemens("G54 G17 G90 G94 G710\nG0 X0 Y0 Z50 A0 B0 C0 S1000 M3 F500\n", strokes, expected, programs);
  };
  check("Z-4 F250, wait 0.5, Z-20 F500 ?, wait 0.5, ",
        {"CYCLE83(60,0,2,-20,,-4,,1,0.5,0,0.5,1)\n", "CYCLE83(60,0,2,,20,,4,-0.8,0.5,0,0.5,1)\n",
         "MCALL CYCLE83(60,0,2,-20,,-4,,0.5,0.5,0,0.5,1,0,2)\nX5\n"});
  check("Z-4 F250, wait 0.5, Z-3 F500, Z-20 F500 ?, wait 2, ", {"CYCLE83(60,0,2,-20,,-4,,1,0.5,0,0.5,0,0,0,0,2)\n"});
  check("Z-20 F250, wait 0.5, ",
        {"CYCLE83(60,0,2,-20,,-20,,1,0.5,0,0.5,1)\n", "CYCLE83(60,0,2,-20,,-30,,-0.5,0.5,1,0.5,0)\n"});
  check("Z-10 F250, wait 0.5, Z-20 F500, wait 0.5, ", {"CYCLE83(60,0,2,-20,,-10,,0,0.5,0,0.5,1)\n"});
}

TEST_CASE("two first depths of CYCLE83 that contradict each other") {
  check_feeds(
      "nc-not-interpreted",
      {"CYCLE83(60,0,2,-30,,-10,20,0,0,0,1,1)\n", "CYCLE83(60,0,2,-30,,-10,20,0,0,0,1,1,,,,0,0,0,1,11112)\n",
       "CYCLE83(60,0,2,-30,,-10,20,0,0,0,1,1,,,,0,0,0,1,21112)\n", "MCALL CYCLE83(60,5,2,-30,,-10,10,1,0,0,1,0)\nX5\n",
       "G700\nCYCLE83(2,0,0.1,-1,,-0.2,5.08,0,0,0,1,1)\n"});
  check_feeds("F500", {"CYCLE83(60,0,2,-30,,-10,10,0,0,0,1,1)\n", "CYCLE83(60,5,2,-30,,-10,-15,0,0,0,1,1)\n",
                       "MCALL CYCLE83(60,0,2,-30,,0,10,0,0,0,1,1)\nX5\n"});
}

TEST_CASE("CYCLE83 with another kind of work") {
  check_feeds("nc-not-interpreted", {"CYCLE83(60,0,2,-30,,-10,,0,0,0,1,2)\n", "CYCLE83(60,0,2,-30,,-10,,0,0,0,1,-1)\n",
                                     "MCALL CYCLE83(60,0,2,-30,,-10,,0,0,0,1,0.5)\nX5\n"});
  check_feeds("F500", {"CYCLE83(60,0,2,-30,,-10,,0,0,0,1,0)\n", "CYCLE83(60,0,2,-30,,-10,,0,0,0,1,1)\n"});
}

TEST_CASE("CYCLE86 with another mode of lifting") {
  check_feeds("nc-not-interpreted",
              {"CYCLE86(60,0,2,-5,,0,3,-1,0,0,0,1)\n", "CYCLE86(60,0,2,-5,,0,3,0,0,1,0,1,0,10)\n"});
  check_feeds("F500", {"CYCLE86(60,0,2,-5,,0,3,-1,0,1,0,0)\n", "CYCLE86(60,0,2,-5,,0,3,0,0,0,0,1,0,10)\n"});
}

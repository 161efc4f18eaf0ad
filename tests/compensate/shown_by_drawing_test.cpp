// Programs that drawn ones have shown to be misread or refused once, made small; others of the same cause beside them.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

Job for_dialect(const std::string& dialect) {
  Job job;
  job.dialect = dialect;
  job.settings.cycle_tolerance_mm = 0.02;
  job.settings.step.length_mm = 5;
  job.settings.step.angle_deg = 5;
  return job;
}

// Accepted, with the read-back on: "" or the code of the refusal.
void check_taken(const std::string& dialect, const std::vector<std::string>& programs) {
  for (const std::string& program : programs) {
    INFO(program);
    CHECK(code_of(program, for_dialect(dialect)).empty());
  }
}

}  // namespace

TEST_CASE("fanuc: R, I, J and K are cut to what the control keeps, as X, Y and Z are") {
  check_taken("fanuc", {"O1\nG20\nG0 X0 Y0 Z.0428\nM3 S500\nG84 X1.5513 Y-1.3517 Z-.1363 R-.009855 F29.59\nG80\nM30\n",
                        "O1\nG21\nG0 X0 Y0 Z10.\nM3 S500\nG99 G86 X3.0017 Y-1.0009 Z-5.0005 R2.00049 F100.\nG80\nM30\n",
                        "O1\nG21\nG0 X0 Y0 Z10.\nG2 X20.0009 Y0 I10.00049 J0.00049 F500.\nM30\n"});
  const auto moves =
      moves_of("O1\nG21\nG0 X0 Y0 Z0\nG2 X20. Y0 I10.0009 J-.0009 F500.\nM30\n", for_dialect("fanuc").program, "fanuc");
  REQUIRE_FALSE(moves.empty());
  CHECK(moves.back().motion.arc.centre_mm[0] == 10.0);
  CHECK(moves.back().motion.arc.centre_mm[1] == 0.0);
}

TEST_CASE("fanuc: G80 and G0 end a cycle with its P") {
  check_taken("fanuc", {"O1\nG0 X0 Y0 Z20.\nG82 X1. Y1. Z5. R10. P760 F400.\nG0\nG84 Z4. R9.\nG80\nM30\n",
                        "O1\nG0 X0 Y0 Z20.\nG89 X1. Y1. Z5. R10. P760 F400.\nG80\nG86 X5. Z4. R9.\nG80\nM30\n"});
  const auto dwells =
      dwells_of("O1\nG0 X0 Y0 Z20.\nG82 X1. Y1. Z5. R10. P760 F400.\nG80\nG84 Z4. R9.\nM30\n", for_dialect("fanuc"));
  CHECK(std::count(dwells.begin(), dwells.end(), 0.76) == 1);
}

TEST_CASE("okuma: a cycle that stays one goes back to the level of G71, whatever the correction") {
  check_taken(
      "okuma",
      {"G15 H1\nG0 X-19.984 Y-38.526 Z14.741\nG71 Z14.741\nG82 X-19.984 Z12.397 R13.785 P1 F900 M53\nG80\nM2\n",
       "G15 H1\nG0 X0 Y0 Z14.741\nG71 Z14.741\nG82 X-2.015 Y9.26 Z12.397 R13.785 P1 F900 M53\nX5.\nY2.\nG80\nM2\n",
       "G15 H1\nG0 X9. Y0 Z20.\nM3 S500\nG71 Z20.\nG89 X1. Y9.26 Z12. R13. P1 F900 M53\nNCYL X5.\nG80\nM2\n"});
}

TEST_CASE("siemens: TURN= beside G64 is no tolerance of the path") {
  check_taken("siemens", {"G54\nG0 X0 Y0 Z10\nG2 X1 Y1 CR=1.0623 TURN=3 G64 F500\nG1 X5\nM30\n",
                          "G54\nG0 X0 Y0 Z10\nG642 G3 X1 Y1 I1 J0 TURN=2 F500\nG1 X5\nM30\n",
                          "G54\nG0 X0 Y0 Z10 F400\nG17 G3 G641 I2 J0 Z5 TURN=1\nG60\nG1 X5\nM30\n"});
  double tolerance = -1;
  for_each_step("G54\nG0 X0 Y0 Z10\nG2 X1 Y1 CR=1.0623 TURN=3 G64 F500\nM30\n", for_dialect("siemens").program,
                "siemens", [&](const nc::Step& step) { tolerance = step.after->switches.path_tolerance; });
  CHECK(tolerance == 0);
}

TEST_CASE("linuxcnc: a tap goes back to where the tool came in, at the feed of its hole") {
  check_taken("linuxcnc", {"G0 X-1.14343 Y-1.02906 Z.23296\nM3 S500\nF102.6\nG98 G84 Z.40908 R1\nG80\nM2\n",
                           "G0 X5 Y-1 Z1\nM3 S500\nF300\nG98 G84 X7 Z1.2 R1.5\nG80\nM2\n",
                           "G20\nG0 X.2 Y-.1 Z.1\nM3 S500\nF5\nG98 G84 X.3 Z.09 R.12\nG80\nM2\n"});
}

TEST_CASE("linuxcnc: after a hole that the tool came to from below R it stands on the higher of two levels") {
  check_taken("linuxcnc",
              {"G0 X5 Y-1 Z1\nM3 S500\nF300\nG98 G84 X7 Z1.2 R1.5\nX9\nG80\nM2\n",
               "G0 X5 Y-1 Z1.4 A0 B2 C0\nM3 S500\nF300\nG98 G84 X7 Z-1.2 R1.5\nX7.01\nX7.02 Y-1.01\nG80\nM2\n",
               "G0 X5 Y-1 Z0.3 A3 B2 C0\nM3 S500\nF300\nG98 G86 X7 Z-1.2 R1.5 P0.1\nX7.01\nG80\nM2\n",
               "G0 X5 Y-1 Z1.5 A-4 B2 C0\nM4 S500\nF300\nG98 G74 X7 Z-1.2 R1.5\nX7.01\nG99 X3\nX5\nG80\nM2\n"});
}

TEST_CASE("linuxcnc: on its way down to a hole the tool may pass the height that it goes back to") {
  for (const char* const options : {"", "A2 B-3 C1", "A-4"}) {
    const std::string head = "F100 S300 M3\nG0 X6 Y-7 Z-0.5595 " + std::string(options) + "\n";
    check_taken("linuxcnc", {head + "G99 G87 Y-3 Z-4.27 R1.3 I0.78 J8.95 K5.14\nX-2.3201 Y-0.1 G98\nM2\n",
                             head + "G98 G87 X9 Y9 Z-3 R1 I1 J1 K-1\nX-12 Y3\nX-12 Y4 R2\nG80\nM2\n",
                             head + "G18 G99 G87 X3 Z-4.27 Y-5 R-1.3 I0.78 K8.95 J1.14\nX-20.3201 Z-0.1 G98\nG80\nM2\n",
                             head + "G20 G99 G87 X.3 Y-.2 Z-.4 R.1 I.05 J.03 K.05\nG98 X-.5 L2\nG80\nM2\n"});
  }
}

TEST_CASE("increments that go through as they stand keep what rounding left of the place before them") {
  for (const char* const place : {"X-39.2461 Y-10.271 Z-20.2 A-3.6147", "X1 Y2 Z3 B2", "X-7.1 Y8.33 Z-5.55 C4 A1"}) {
    const std::string head = "G0 " + std::string(place) + "\nG91\n";
    check_taken("linuxcnc", {head + "G30 Z0.38841\nM2\n", head + "G28 X1.123456 Y0.000001 Z0.100001\nM2\n",
                             head + "G0 Z-1.5\nG30 X0.123456 Z0.38841\nM2\n", head + "G20 G28 Z0.0123456\nM2\n"});
  }
}

TEST_CASE("siemens: axes that a called cycle does not name stand where increments left them") {
  Job job = for_dialect("siemens");
  job.settings.friction = false;
  for (const double step : {0.8, 1.5, 3.0, 6.0}) {
    job.settings.step = {step, step};
    for (const char* const hole : {"CYCLE83(-11.244,-16.009,1.000,-21.697,,-17.009,,1.000,0,0,1,0)\n",
                                   "CYCLE81(-11.244,-16.009,1.000,-21.697)\nG0 X30\n",
                                   "MCALL CYCLE82(-11.244,-16.009,1.000,-21.697,,0.2)\nX30 Y-20\nX31\nMCALL\n"}) {
      const std::string program =
          "G54\nG0 X36.7391 Y-30.9592 Z-20.5391 A0 B0 C-3.3892\nG91\nG1 Z-15 F2132.2\nG90\nG0\n" + std::string(hole) +
          "M30\n";
      INFO(program);
      CHECK(code_of(program, job).empty());
    }
  }
}

TEST_CASE("fanuc: an offset that the control could not keep is refused, and one that it keeps is not") {
  const Job job = for_dialect("fanuc");
  for (const std::string part :
       {"G00 X-20.744 Y-8.009 Z14.\nG20\nG92 X-0.8975\n", "G0 X3.001 Y1. Z7.003\nG20\nG92 Z-.8404\n",
        "G0 X3. Y9.007 Z7.\nG1 X5.003 F100.\nG20\nG92 X1. Y2.\n"}) {
    INFO(part);
    CHECK(code_of("O1\nG21\n" + part + "M30\n", job) == "emit-stores-position");
  }
  check_taken("fanuc", {"O1\nG21\nG0 X-20.744 Y-8.009 Z14.\nG92 X-0.8975\nG20\nM30\n",
                        "O1\nG20\nG0 X1.0449 Y-.8009 Z1.4\nG92 X-0.8975\nM30\n"});
}

TEST_CASE("okuma: a cycle whose R the correction puts elsewhere than the tool is refused as such") {
  for (const std::string part : {"Z142.261 G0 B-18.826\nG89 X-194.703 Y135.633 Z138.850 R142.261 P1 F118 M54\n",
                                 "G00 Z129.443 A12.977\nG82 X-213.808 Y-281.758 Z122.885 R129.443 P1 F138 M54\n"}) {
    INFO(part);
    CHECK(code_of("G15 H1\n" + part + "G80\nM2\n", for_dialect("okuma")) == "compensate-cycle");
  }
  check_taken("okuma", {"G15 H1\nG0 X1 Y2 Z20 A5 B-8 C0\nG82 X9. Y4. Z12. R20. P1 F138 M54\nG80\nM2\n"});
}

TEST_CASE("okuma: a cycle whose tool the correction puts elsewhere than the level of G71 is refused as such") {
  for (const std::string part :
       {"G00 X-45.19 Y38.248 Z47.908 A-13.026 B15.738\nM3 S500\nG71 Z47.908\nG86 X-45.19 Z42.101 R46.721 P1 F102 M53\n",
        "G0 X95.923 Y-61.891 Z-44.4 A-16.653 B-14.133\nG71 Z-44.4\nG89 X95.923 Z-52.374 R-48.177 P1 F495 M53\n",
        "G0 X1 Y2 Z20 A5 B-8 C0\nG71 Z30\nG82 X1 Y2 Z12. R18. P1 F138 M53\n"}) {
    INFO(part);
    CHECK(code_of("G15 H1\n" + part + "G80\nM2\n", for_dialect("okuma")) == "compensate-cycle");
  }
  check_taken("okuma", {"G15 H1\nG0 X1 Y2 Z20 A5 B-8 C0\nG71 Z20\nG82 X9. Y4. Z12. R18. P1 F138 M53\nX3\nG80\nM2\n"});
}

TEST_CASE("okuma: a level of G71 that the corrected R lies above is refused as such") {
  for (const std::string hole :
       {"M3 S500\nG84 X10 Y10 Z-10 R5 F500 M53\n", "G82 X10 Y10 Z-10 R5 P1 F500 M53\n",
        "G83 X10 Y10 Z-10 R5 I3 J3 F500 M53\n", "M3 S500\nG85 X10 Y10 Z-10 R5 F500 FA=700 M53\n"}) {
    INFO(hole);
    const Diagnostic refused = testing::refusal_of(
        [&] { run("G15 H1\nG0 X10 Y10 Z5 A0 B0 C0\nG71 Z5\n" + hole + "G80\nM2\n", for_dialect("okuma")); });
    CHECK(refused.code == "compensate-cycle");
    CHECK(refused.message.find("above the level of G71, Z5") != std::string::npos);
  }
  check_taken("okuma", {"G15 H1\nG0 X10 Y10 Z5 A0 B0 C0\nG71 Z5\nM3 S500\nG84 X10 Y10 Z-10 R5 F500 M54\nG80\nM2\n",
                        "G15 H1\nG0 X10 Y10 Z6 A0 B0 C0\nG71 Z6\nM3 S500\nG84 X10 Y10 Z-10 R5 F500 M53\nG80\nM2\n"});
}

TEST_CASE("okuma: the message on a cycle that begins off its level tells of the original, not of the correction") {
  const std::map<std::string, std::string> levels_of{{"G71 Z30\nG82 X1 Y2 Z12. R18. P1 F138 M53\n", "30"},
                                                     {"G71 Z15\nM3 S500\nG84 X1 Z-9. R12. F120 M53\n", "15"},
                                                     {"G71 Z25.5\nG89 X1 Z12. R18. P1 F138 M53\n", "25.5"}};
  for (const auto& holes : levels_of) {
    INFO(holes.first);
    const Diagnostic refused = testing::refusal_of(
        [&] { run("G15 H1\nG0 X1 Y2 Z20 A5 B-8 C0\n" + holes.first + "G80\nM2\n", for_dialect("okuma")); });
    CHECK(refused.code == "compensate-cycle");
    CHECK(refused.message.find("the tool stands at Z20 and not on the level of G71, Z" + holes.second) !=
          std::string::npos);
    CHECK(refused.help == "move to Z" + holes.second + " with G0 before the cycle");
  }
}

TEST_CASE("fanuc: axes that a block does not name stand where another unit wrote them") {
  check_taken("fanuc", {"O1\nG20\nG0 X-.1888 Y1.3046 Z-.7805\nG21\nG53 G0 Z-998.\nM30\n",
                        "O1\nG20\nG0 X.1887 Y-1.3043 Z-.7805\nG21\nG1 Z-19. F200.\nX3.\nM30\n",
                        "O1\nG21\nG0 X3.001 Y7.003 Z-9.999\nG20\nG1 X.5 F20.\nG53 G0 Z-30.\nM30\n"});
}

TEST_CASE("fanuc: a hole after a change of units begins and ends at a height that the other unit wrote") {
  check_taken(
      "fanuc",
      {"O1\nG20\nG0 X-.0946 Y0.1885 Z-.2747 A0 B3.866 C0\nG21\nG84 Z-22.3 R-14.21 Y4.788 X-3.161 F281.\nG80\nM30\n",
       "O1\nG20\nG00 X1.4450 Y0.1833 Z-1.04 A0 B0 C4.979\nG21\nG86 Z-39.5 R-35.314 F863.1\nG80\nM30\n",
       "O1\nG20\nG0 X1.1357 Y-1.2349 Z.7713 A1. B-2. C3.\nG21\nM3 S500\nG98 G84 X11.23 Y7.77 Z-5.5 R3. "
       "F300.\nX14.5\nY9.1\nG80\nM30\n",
       "O1\nG21\nG0 X20.123 Y-8.777 Z21.111 A1. B-2. C3.\nG20\nM3 S500\nG98 G86 X.5 Y.25 Z-.2 R.4 "
       "F12.\nX.75\nG80\nM30\n"});
}

TEST_CASE("linuxcnc: F under G95 counts degrees as it counts millimetres, in inches as well") {
  const std::vector<std::string> programs{
      "G20\nG0 X0 Y0 Z0 A0 B0 C0\nG95 S1000\nG1 B-1.0416 F.0148\nA-6.7155\nB-0.4381\nM2\n",
      "G20 G95\nM3 S500\nG0 X0 Y0 Z0 A0 B0 C0\nG1 A5 B-3 F.2\nX1\nC4\nM2\n",
      "G21\nM3 S500\nG0 X0 Y0 Z0 A0 B0 C0\nG95\nG1 A4 F.3\nG20\nA-4 F.3\nG21\nA2\nM2\n"};
  check_taken("linuxcnc", programs);
  const auto moves = moves_of(programs[0], for_dialect("linuxcnc").program, "linuxcnc");
  REQUIRE(moves.size() >= 3);
  CHECK(moves.back().motion.feed == Approx(.0148 * 25.4));
}

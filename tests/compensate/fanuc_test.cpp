// What a Fanuc control keeps, takes and refuses, in what is written for it.
#include <regex>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

bool has(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex(pattern, std::regex::multiline));
}

int count(const std::string& text, const std::string& pattern) {
  const std::regex what(pattern, std::regex::multiline);
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), what), {}));
}

const std::string kHead = "O0001\nG21 G17 G90 G54 G94\nG0 X0. Y0. Z50. A0. B0. C0.\n";

AxisWords end_of(const std::string& text, const Job& job) {
  return moves_of(text, job.program, job.dialect).back().motion.to;
}

}  // namespace

TEST_CASE("a rigid tap keeps its words, its blocks and its mode at every hole") {
  const Job job = fanuc_job();
  const std::string text =
      kHead + "M29 S500\nG99 G84 X0. Y0. Z-10. R2. Q2. F500.\nX20.\nG98 Y20. (last)\nG80\nG0 Z60.\nM30\n";
  const std::string out = run(text, job).text;
  INFO(out);
  CHECK(has(out,
            "^M29 S500\nG99 G84 X-?[0-9.]+ Y-?[0-9.]+ Z-9\\.9[0-9]+ R2\\.0[0-9]* Q2\\. F500\\.\n"
            "X[-0-9. YZR]+\nG98 Y[-0-9. XZR]+ \\(last\\)\nG80$"));
}

TEST_CASE("a cut before the program says in which unit is warned of, and read in the unit that the control is in") {
  for (const std::string control : {"fanuc", "linuxcnc", "siemens"}) {
    INFO(control);
    Job job = job_of_control(control);
    const auto warns = [&](const std::string& text) {
      return warnings_of(run(text, job).summary, "compensate-unit-unstated");
    };
    const std::string start = "G17 G90 G54 G94\nG0 X0. Y0. Z1. A0. B0. C0.\n";
    const std::string cut = "G1 X.5 F10.\nX1.\nM30\n";
    const bool stays = control != "siemens";
    CHECK(warns(start + cut) == (stays ? 1 : 0));
    CHECK(warns(start + "M30\n") == 0);
    if (!stays) continue;
    CHECK(warns("G21\n" + start + cut) == 0);
    CHECK(warns("G20\n" + start + cut) == 0);
    CHECK(end_of(start + cut, job)[Axis::X] == Approx(1));
    job.program.inches = true;
    CHECK(warns(start + cut) == 0);
    CHECK(end_of(start + cut, job)[Axis::X] == Approx(25.4));
    const std::string moves = run(start + cut, job).text;
    CHECK(run("G20\n" + start + cut, job).text.ends_with(moves.substr(moves.find("G1 X"))));
    job.program.inches = false;
    CHECK(warns(start + cut) == 0);
    CHECK(end_of(start + cut, job)[Axis::X] == Approx(1));
  }
}

TEST_CASE("after a cycle that became moves, the G0 that goes on is in force again") {
  const Job job = fanuc_job();
  for (const std::string cycle :
       {"G81 X5. Y5. Z-8. R1. F200.", "G85 X5. Y5. Z-8. R1. F200.", "G83 X5. Z-8. R1. Q3. F9."}) {
    for (const std::string behind : {"Z60.", "X9. Y9.", "M8\nY3.\nZ60."}) {
      const std::string text = kHead + "G99 " + cycle + "\nX25.\nG80\n" + behind + "\nG1 X8. F100.\nM30\n";
      const std::string out = run(text, job).text;
      INFO(out);
      CHECK(play(text, out, job).at_points_um <= 2);
      // G85 comes back at feed, the others at rapid.
      CHECK(has(out, "^G80\n(M8\n)?G0 [XYZ]") == cycle.starts_with("G85"));
    }
    const std::string beside = kHead + "G98 " + cycle + "\nG80 Z60.\nX9.\nM30\n";
    CHECK(play(beside, run(beside, job).text, job).at_points_um <= 2);
  }
}

TEST_CASE("a stop with a message stays, at each pass of a loop") {
  const Job job = fanuc_job();
  const std::string text = kHead +
                           "#1=2\nWHILE[#1 GT 0]DO1\n#3006=1(TURN IT)\nG0 X[#1*10] Y5. Z5. A0. B0. C0.\n"
                           "G1 X3. F200.\n#1=#1-1\nEND1\nM30\n";
  const std::string out = run(text, job).text;
  INFO(out);
  CHECK(count(out, "^#3006=1\\(TURN IT\\)$") == 2);
  const std::string asks = kHead + "#1=2\nIF[#1 GT 0]THEN #3006=1(TURN IT)\nG0 X0. Y5. Z5. A0. B0. C0.\nM30\n";
  CHECK(code_of(asks, job) == "compensate-flow");
}

TEST_CASE("left-hand taps and bores that work the spindle stay one block a hole, other words in it") {
  const Job job = fanuc_job();
  for (const char* const cycle : {"G74", "G86", "G84"}) {
    const std::string text =
        kHead + "N5 G98 " + std::string(cycle) + " X5. Y5. Z-8. R1. P500 F200. M8\nN6 X25. M9\nG80\nG0 Z60.\nM30\n";
    const std::string out = run(text, job).text;
    INFO(out);
    CHECK(has(out, "^N5 G98 " + std::string(cycle) +
                       " X[-0-9.]+ Y[-0-9.]+ Z[-0-9.]+ R[-0-9.]+ P500 F200\\. M8\nN6 X[-0-9.]+ M9 "));
    CHECK(count(out, cycle) == 1);
  }
}

TEST_CASE("taps that cannot be shifted hole by hole are refused") {
  const Job job = fanuc_job();
  std::size_t line = 0;
  CHECK(code_of(kHead + "M29 S500\nG91 G84 X5. Y5. Z-8. R-40. F500.\nG80\nM30\n", job, &line) == "compensate-cycle");
  CHECK(line == 5);
  CHECK(code_of(kHead + "M29 S500\nG99 G84 X5. Y5. Z-8. R2. F500. K3\nG80\nM30\n", job) == "compensate-cycle");
  CHECK(code_of(kHead + "G99 G81 X5. Y5. Z-8. R2. F500.\nX10.\nG84 X20. F200.\nG80\nM30\n", job) == "compensate-cycle");
}

TEST_CASE("no word has more decimals than the control keeps, and increments end where the block does") {
  const Job job = fanuc_job();
  for (const char* const moves :
       {"G91 G1 X299.7 Y100.3 A5. F3000.\nG90\n", "G91 G1 X-33.333 Y66.667 Z-10.001 B-3.333 F800.\nX-1.\nG90\n",
        "G91 G2 X20. Y20. I20. J0. F500.\nG1 Z-3.\nG90\n", "G1 X1.0001 Y2.12345 F100.\n"}) {
    const std::string text = kHead + "G0 X-90. Y-50.\n" + moves + "G0 X0. Y0. Z50. A0. B0.\nM30\n";
    const Result result = run(text, job);
    INFO(result.text);
    CHECK_FALSE(has(result.text, "^[^(\n]*[XYZABCIJKR]-?[0-9]*\\.[0-9]{4}.*(?!\\))$"));
    const Played played = play(text, result.text, job);
    CHECK(played.at_points_um <= 9);  // half a thousandth of mm and deg, on a platform of half a metre
    CHECK(result.summary.rounding_mm.value <= 0.0009);
  }
}

TEST_CASE("a finer or coarser increment system keeps other decimals") {
  const std::string text = kHead + "G91 G1 X20. Y10. A1. F900.\nM30\n";
  Job job = fanuc_job();
  job.program.input_increment = 1e-4;
  job.emit.increment_ratio = 0.1;
  const std::string fine = run(text, job).text;
  INFO(fine);
  CHECK(has(fine, "[XYZ]-?[0-9]*\\.[0-9]{4}( |$)"));
  CHECK_FALSE(has(fine, "[XYZABC]-?[0-9]*\\.[0-9]{5}"));
  job.program.input_increment = 0.01;
  job.emit.increment_ratio = 10;
  const std::string coarse = run(text, job).text;
  INFO(coarse);
  CHECK_FALSE(has(coarse, "[XYZABC]-?[0-9]*\\.[0-9]{3}"));
}

TEST_CASE("in inches four decimals are kept, of cycles written out and of offsets alike") {
  Job job = fanuc_job();
  const std::string text =
      "O0001\nG21 G17 G90 G54 G94\nG0 X0. Y0. Z50. A0. B0. C0.\nG20\nG1 X1. Y.5 F100.\n"
      "G83 X.5 Y.25 Z-.4 R.1 Q.15 F20.\nX1.\nG80\nG92 X0 Y0\nG1 X.3 F10.\nM30\n";
  const std::string out = run(text, job).text;
  INFO(out);
  CHECK(has(out, "[XYZ]-?[0-9]*\\.[0-9]{4}( |$)"));
  CHECK_FALSE(has(out, "^[^(\n]*[XYZR]-?[0-9]*\\.[0-9]{5}"));
}

TEST_CASE("whole numbers have no point, and no number more than eight digits") {
  const Job job = fanuc_job();
  const std::string text = kHead + "#2=1000\n#3=3\n#5=1.5\nG#5 X5. F[100/3]\nM98 P7\nM30\n";
  CHECK(code_of(text, job) == "nc-unknown-code");
  const std::string called = kHead +
                             "#2=1000\n#3=3\n#5=54\nM98 P7\nM30\nO7\nG#5 S#2 M#3\nG1 X20. Y#3 F[100/3]\n"
                             "G82 X5. Z-3. R2. P[#2/2]\nG80\nG04 P#2\nG1 X0. F[393.7007874/100]\nM99\n";
  const std::string out = run(called, job).text;
  INFO(out);
  CHECK(has(out, "^G54 S1000 M3$"));
  CHECK(has(out, "^G0?4 P500$"));
  CHECK(has(out, "^G0?4 P1000$"));
  CHECK_FALSE(has(out, "[GMTSHPDNOL][0-9]+\\.( |$)"));
  CHECK_FALSE(has(out, "^[^(\n]*[0-9]{1,8}\\.[0-9]{8}"));
  CHECK(has(out, "F3\\.9370079$|F3\\.93701"));
}

TEST_CASE("under G43.4 a block that turns alone is refused unless its time is known") {
  Job job = fanuc_job();
  const std::string start = kHead + "G43.4 H1 Z50.\n";
  std::size_t line = 0;
  CHECK(code_of(start + "G1 A5. B3. F500.\nM30\n", job, &line) == "emit-feed-rule");
  CHECK(line == 5);
  CHECK(code_of(start + "G1 X5. F500.\nC-8.\nM30\n", job) == "emit-feed-rule");
  CHECK(code_of(start + "G95 S100 M3\nG1 B-4. F.1\nM30\n", job) == "emit-feed-rule");
  CHECK(code_of(start + "G93 G1 A5. F10.\nM30\n", job).empty());
  CHECK(code_of(start + "G1 X30. A5. F500.\nM30\n", job).empty());
  CHECK(code_of(start + "G49\nG43 H1\nG0 Z50.\nG1 A5. F500.\nM30\n", job).empty());
  job.program.feed_rule = nc::FeedRule::xyz_first;
  CHECK(code_of(start + "G1 A5. B3. F500.\nM30\n", job).empty());
}

TEST_CASE("the speed of the tip is kept where it moves and turns under G43.4") {
  Job job = fanuc_job();
  const std::string text = kHead + "G43.4 H1 Z50.\nG1 X40. A8. F500.\nX40.5 B-5.\nG3 X0.5 Y0. I-20. J0. A0.\nM30\n";
  const Result result = run(text, job);
  INFO(result.text);
  CHECK(play(text, result.text, job).time_change <= 2e-3);
}

TEST_CASE("M5, M9 and M19 stand after the last piece, codes of the builder beside a cut are refused") {
  Job job = fanuc_job();
  job.program.passed_m_codes = {88, 51};
  const std::string out = run(kHead + "G1 X40. Y10. Z0. F500. M3 M8\nX0. Y0. M5 M9\nX5. M19\nM30\n", job).text;
  INFO(out);
  CHECK(has(out, "^G1 X[0-9.]+ Y[0-9.]+ Z[0-9.]+ .*M3 M8"));
  CHECK(has(out, "^X[-0-9.]+ .*M5 M9$"));
  CHECK(has(out, "^X[-0-9.]+ .*M19$"));
  CHECK(count(out, "M5|M19|M9") == 3);
  CHECK(code_of(kHead + "G1 X40. F500. M88\nM30\n", job) == "emit-m-code");
  CHECK(code_of(kHead + "M51\nG1 X40. F500.\nX10. M51\nM30\n", job) == "emit-m-code");
  job.program.keeps_position = {6};
  CHECK(code_of(kHead + "G1 X40. F500. T1 M6\nM30\n", job) == "emit-m-code");
  CHECK(code_of(kHead + "G1 X.2 F500. M88\nM30\n", job).empty());  // one block in its place
}

TEST_CASE("a code of the builder beside an arc, a move in a subprogram or a loop is refused where that is cut up") {
  Job job = fanuc_job();
  job.program.passed_m_codes = {88, 121, 200};
  CHECK(code_of(kHead + "G2 X10. Y0. I5. J0. F300. M121\nM30\n", job) == "emit-m-code");
  CHECK(code_of(kHead + "M98 P2\nM30\nO2\nG1 X9. F300. M88\nM99\n", job) == "emit-m-code");
  CHECK(code_of(kHead + "WHILE [#1 LT 2] DO 1\n#1=#1+1\nG91 G1 X5. A1. F300. M200\nEND 1\nM30\n", job) ==
        "emit-m-code");
  CHECK(code_of(kHead + "G0 X50. M88\nM200 G0 Z60.\nM30\n", job).empty());  // a rapid is one block
}

TEST_CASE("F of an arc under G93 is feed over radius") {
  Job job = fanuc_job();
  for (const auto& [arc, minutes] : {std::pair<std::string, double>{"G3 X-10. Y0. I-10. J0. F2.", std::acos(-1.0) / 2},
                                     {"G2 I-5. J0. F10.", 2 * std::acos(-1.0) / 10},
                                     {"G3 X0. Y10. R10. Z-5. F4.", std::acos(-1.0) / 2 / 4},
                                     {"G1 X0. F2.", 0.5}}) {
    const std::string text = "O0001\nG21 G17 G90 G54\nG0 X10. Y0. Z0. A0. B0. C0.\nG93 " + arc + "\nM30\n";
    const Result result = run(text, job);
    INFO(text);
    CHECK(result.summary.seconds_before == Approx(minutes * 60));
    CHECK(result.summary.seconds_after == Approx(minutes * 60).epsilon(2e-3));
  }
}

TEST_CASE("F of an arc beside which another axis moves is the speed along its circle") {
  const double pi = std::acos(-1.0);
  const std::string head = "O0001\nG21 G17 G90 G54 G94\nG0 X10. Y0. Z0. A0. B0. C0.\n";
  for (const auto& [arc, minutes] : {std::pair<std::string, double>{"G3 X10. Y0. I-10. Z-20. F600.", 2 * pi * 10 / 600},
                                     {"G2 X-10. Y0. R10. Z9. F200.", pi * 10 / 200},
                                     {"G18 G3 X20. Z10. R10. Y-8. F100.", pi / 2 * 10 / 100},
                                     {"G91 G19 G2 Y10. Z10. R10. X6. F100.", pi / 2 * 10 / 100},
                                     {"G3 X0. Y10. R10. A5. F300.", pi / 2 * 10 / 300},
                                     {"G3 X0. Y10. R10. F300.", pi / 2 * 10 / 300}}) {
    const Job job = fanuc_job();
    const std::string text = head + arc + "\nM30\n";
    INFO(text);
    const Result result = run(text, job);
    CHECK(result.summary.seconds_before == Approx(minutes * 60));
    CHECK(result.summary.seconds_after == Approx(minutes * 60).epsilon(2e-3));
  }
}

TEST_CASE("where the control says so, F of a helix is the speed along its path") {
  Job job = fanuc_job();
  const double circle = 2 * std::acos(-1.0) * 10;
  const std::string text = "O0001\nG21 G17 G90 G54 G94\nG0 X10. Y0. Z0. A0. B0. C0.\nG3 X10. I-10. Z-20. F600.\nM30\n";
  job.program.helix_feed_along_circle = false;
  CHECK(run(text, job).summary.seconds_before == Approx(std::hypot(circle, 20) / 600 * 60));
  job.dialect = "linuxcnc";
  job.program.helix_feed_along_circle.reset();
  const std::string plain = "G21 G17 G90 G54 G94\nG0 X10 Y0 Z0 A0 B0 C0\nG3 X10 Y0 I-10 Z-20 F600\nM2\n";
  CHECK(run(plain, job).summary.seconds_before == Approx(std::hypot(circle, 20) / 600 * 60));
  job.program.helix_feed_along_circle = true;
  CHECK(run(plain, job).summary.seconds_before == Approx(circle / 600 * 60));
}

TEST_CASE("a speed that is worked out is rounded, as the control does") {
  const Job job = fanuc_job();
  const std::string text = kHead + "#1=1\nWHILE[#1 LE 3]DO1\nS[#1*100.4] M3\nG1 X#1 F100.\n#1=#1+1\nEND1\nM30\n";
  const std::string out = run(text, job).text;
  INFO(out);
  for (const char* const speed : {"S100 M3", "S201 M3", "S301 M3"}) CHECK(out.find(speed) != std::string::npos);
}

TEST_CASE("a tap that begins on R and goes back to where it began is refused where the correction parts the two") {
  const Job job = fanuc_job();
  const std::string before = kHead + "G99 G82 X10. Y0. Z-4. R2. P200 F100.\nX12.\nG80\n";
  CHECK(code_of(before + "G98 G84 X10. Z-4. R2. F100.\nG80\nM30\n", job) == "compensate-cycle");
  CHECK(code_of(before + "G98 G86 X10. Z-4. R2. F100.\nG80\nM30\n", job) == "compensate-cycle");
  CHECK(code_of(kHead + "G1 Z-4. F100.\nX12.\nG98 G86 X10. Z-4. R2.\nG80\nM30\n", job) == "compensate-cycle");
  CHECK(code_of(before + "G99 G84 X10. Z-4. R2. F100.\nG80\nM30\n", job).empty());
  CHECK(code_of(before + "G98 G84 X10. Z-4. R1.5 F100.\nG80\nM30\n", job).empty());
}

TEST_CASE("M codes that wait for a move are refused beside a cycle that is written out") {
  const Job job = fanuc_job();
  for (const char* const code : {"M9", "M5", "M19", "M0", "M30"}) {
    CHECK(code_of(kHead + "G81 X5. Y5. Z-8. R1. F200. " + code + "\nG80\nM30\n", job) == "emit-m-code");
  }
  CHECK(code_of(kHead + "G83 X5. Y5. Z-8. R1. Q3. F200.\nX9. M9\nG80\nM30\n", job) == "emit-m-code");
  CHECK(code_of(kHead + "G81 X5. Y5. Z-8. R1. F200. M98 P2\nG80\nM30\nO2\nX9.\nM99\n", job) == "nc-not-interpreted");
  const std::string out = run(kHead + "G81 X5. Y5. Z-8. R1. F200. M8\nG80\nM30\n", job).text;
  CHECK(has(out, "^(F200\\. )?M8\n(.*\n)*G1 Z"));
}

TEST_CASE("after a change of tools beside a move nobody knows where the axes stand") {
  Job job = fanuc_job();
  CHECK(code_of(kHead + "T1\nX5. M6\nG1 X9. F100.\nM30\n", job) == "compensate-position-unknown");
  CHECK(code_of(kHead + "G1 X9. F100. T1 M6\nY9.\nM30\n", job) == "compensate-position-unknown");
  const std::string out = run(kHead + "T1\nX5. Y5. M6\nG0 X9.\nM30\n", job).text;
  CHECK(has(out, "\nG0 X9\\.\n"));  // goes through as it stands
  job.program.keeps_position = {6};
  CHECK_FALSE(has(run(kHead + "T1\nX5. Y5. M6\nG0 X9.\nM30\n", job).text, "\nG0 X9\\.\n"));
}

TEST_CASE("in inches a degree counts as an inch, and a turn alone in degrees a minute") {
  Job job = fanuc_job();
  for (const auto& [move, minutes] : {std::pair<std::string, double>{"G1 A5. F10.", 0.5},
                                      {"G1 X3. A4. F10.", 0.5},
                                      {"G1 X.3 B-.4 F1.", 0.5},
                                      {"G1 X1. F2.", 0.5}}) {
    const std::string text = kHead + "G20\n" + move + "\nM30\n";
    const Result result = run(text, job);
    INFO(result.text);
    CHECK(result.summary.seconds_before == Approx(minutes * 60));
    const Played played = play(text, result.text, job);
    CHECK(played.time_change <= 2e-3);
  }
}

TEST_CASE("increments that were cut into pieces end where the program said") {
  const Job job = fanuc_job();
  const std::string text = kHead + "G91 G1 X99.7 Y33.3 A1. F3000.\nX-99.7 Y-33.3 A-1.\nG90 G53 G0 Z0.\nM30\n";
  const AxisWords original = end_of(text, job);
  const AxisWords end = end_of(run(text, job).text, job);
  for (const Axis axis : {Axis::X, Axis::Y}) CHECK(std::abs(end[axis] - original[axis]) <= 0.05);
}

TEST_CASE("F under G93 that the control does not take is named as such, not as too short a piece") {
  for (const std::string move : {"G93 G1 X10. A1. F60000.", "G93\nG1 A.5 F10000.", "G93 G2 X10. I5. F123456."}) {
    INFO(move);
    try {
      run(kHead + move + "\nM30\n", fanuc_job());
      FAIL("it was taken");
    } catch (const Refusal& refusal) {
      CHECK(refusal.diagnostic().code == "emit-feed-range");
      CHECK(refusal.diagnostic().message.starts_with("this block has F"));
      CHECK(refusal.diagnostic().help.find("G94") != std::string::npos);
    }
  }
  CHECK(code_of(kHead + "G93 G1 X.001 F9999.999\nM30\n", fanuc_job()).empty());
}

TEST_CASE("an F that has too few digits for the time of a slow turn is refused") {
  Job job = fanuc_job();
  job.program.feed_rule = nc::FeedRule::xyz_first;
  const std::string begin = kHead + "G0 X-5.8 Y-9.844 Z12.834 A.94 B-4.9 C-3.704\nG1 C5.868 F";
  CHECK(code_of(begin + ".001\nM30\n", job) == "emit-feed-range");
  CHECK(code_of(begin + "70.\nM30\n", job).empty());
}

TEST_CASE("a cycle that waits is not written out where nobody knows what G4 counts") {
  const Job job = fanuc_job();
  const std::string turning = kHead + "S1000 M3\n";
  for (const std::string cycle :
       {"G95 G82 X5. Y5. Z-8. R1. P200 F.2", "G95 G89 X5. Z-8. R1. P50 F.1", "G95 F.1\nG82 X5. Z-8. R1. P100"}) {
    INFO(cycle);
    CHECK(code_of(turning + cycle + "\nG80\nM30\n", job) == "nc-not-interpreted");
  }
  CHECK(has(run(turning + "G95 G81 X5. Y5. Z-8. R1. F.2\nG80\nM30\n", job).text, "^G1 ?Z"));
  CHECK(has(run(turning + "G95 G84 X5. Y5. Z-8. R1. P200 F1.\nG80\nM30\n", job).text, "^G95 G84 X.* P200 "));
}

TEST_CASE("a statement behind / that is executed, before anything else stands in the output, is no line of it") {
  Job job = fanuc_job();
  job.program.block_delete = false;
  job.program.start.fill(0);
  const std::string cut = "G90 G54 G1 X2. F100.\n";
  for (const std::string& begin :
       {"/IF [1 EQ 1] GOTO 5\nG0 X9.\nN5 " + cut, "#1=2.\n/WHILE [#1 LT 3] DO 1\n#1=#1+1\n" + cut + "END 1\n",
        "/#1=2.\n(A)\n/GOTO 5\n(B)\nG0 X9.\nN5 " + cut, "/WHILE [#1 LT 1] DO 1\n#1=1\nEND 1\n" + cut}) {
    const std::string out = run("O1\n" + begin + "M30\n", job).text;
    INFO(out);
    CHECK(count(out, "PLUMBLINE") == 1);
    CHECK(end_of(out, job)[Axis::X] == Approx(2).margin(0.02));
  }
}

TEST_CASE("a hole whose P some controls wait for and others do not stays a cycle") {
  const Job job = fanuc_job();
  for (const std::string cycle : {"G81 X5. Y5. Z-8. R1. P500 F200.", "G83 X5. Y5. Z-8. R1. Q3. P500 F200.",
                                  "G73 X5. Y5. Z-8. R1. Q3. P500 F200.", "G85 X5. Y5. Z-8. R1. P500 F200."}) {
    const std::string out = run(kHead + cycle + "\nX9.\nG80\nM30\n", job).text;
    INFO(out);
    CHECK(has(out, std::string(cycle, 0, 3).append(" X.* P500 F200\\.$")));
    CHECK(count(out, "^G1") == 0);
  }
  CHECK(has(run(kHead + "G83 X5. Y5. Z-8. R1. Q3. P0 F200.\nG80\nM30\n", job).text, "^G1 ?Z"));
}

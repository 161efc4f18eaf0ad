// Corrections of an axis whose words count within a turn must never send it all the way round.
#include <algorithm>
#include <regex>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

Job job_for(const std::string& dialect, nc::RotaryRule rule) {
  Job job = job_of_control(dialect);
  job.program.rotary.fill(rule);
  job.program.start.fill(0);
  return job;
}

double largest_turn(const std::string& text, const Job& job) {
  double largest = 0;
  for (const Move& move : moves_of(text, job.program, job.dialect)) {
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
      largest = std::max(largest, std::abs(move.to_W[axis] - move.from_W[axis]));
    }
  }
  return largest;
}

// `kept_um`: where the control keeps thousandths, which no correction can take away.
void check_small_turns(const std::string& text, const Job& job, double kept_um = 0) {
  const Result result = run(text, job);
  INFO(result.text);
  const Played played = play(text, result.text, job);
  CHECK(played.at_points_um <= 0.15 + kept_um);
  CHECK(played.between_points_um <= 0.5 + kept_um);
  CHECK(played.time_change <= 2e-3);
  CHECK(result.summary.changed_blocks > 5);
  CHECK(largest_turn(result.text, job) < 20);
}

bool matches(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex(pattern, std::regex::multiline));
}

}  // namespace

TEST_CASE("words whose sign says the way round stay small turns") {
  const Job job = job_for("linuxcnc", nc::RotaryRule::sign);
  const std::string text =
      "G21 G90 G94\nG0 X0 Y0 Z20 A0 B0 C0\nG1 X30 Y10 Z0 A10 B-355 C-352 F900\nX35 C-352\nX40 Y-20 A-2 B5 C4\n"
      "G0 X0 Y0 A-355 B-0 C-0\nG1 X10 Y10 C0\nG91 X5 C-1\nG90 X20 C0 A-354\nG3 X-20 Y10 I-20 J15 A-350 C8\nM2\n";
  check_small_turns(text, job);
  const std::string out = run(text, job).text;
  INFO(out);
  CHECK(matches(out, " C-35[0-9.]+"));
  CHECK_FALSE(matches(out, "[ABC]-0(\\.0*)?( |$)"));
}

TEST_CASE("C-0 after a correction that left C below 0 is written as what turns upwards") {
  const Job job = job_for("linuxcnc", nc::RotaryRule::sign);
  for (const std::string text : {"G21 G90 G54 F200\nG0 X0 Y0 Z20 A0 B0 C0\nG1 Y3\nG0 C-0\nM2\n",
                                 "G21 G90 G54 F200\nG0 X30 Y0 Z20 A0 B0 C0\nG2 I-3 J0 A0.57\nG0 C-0\nM2\n",
                                 "G21 G90 G54 F200\nG0 X0 Y0 Z20 A0 B0 C0\nG1 X9 Y3\nX2 B-0 C-0\nM2\n"}) {
    const Result result = run(text, job);
    INFO(result.text);
    CHECK(largest_turn(result.text, job) < 5);
  }
}

TEST_CASE("words that go the shorter way stay small turns") {
  check_small_turns(
      "O1\nG21 G90 G94 G54\nG0 X0. Y0. Z20. A0. B0. C0.\nG1 X30. Y10. A10. B355. C-8. F900.\nX40. Y-20. A-2. B5. "
      "C364.\n"
      "G91 G1 X5. C-5.\nG90 X0. C0. A0.\nG93 X10. B358. F20.\nG94 G1 X0. B0. F800.\nM30\n",
      [] {
        Job job = job_for("fanuc", nc::RotaryRule::shortest);
        job.program.feed_rule = nc::FeedRule::xyz_first;
        return job;
      }(),
      1.5);
}

TEST_CASE("words of a modulo axis are written with DC") {
  const Job job = job_for("siemens", nc::RotaryRule::linear);
  const std::string text =
      "G54 G90 G94\nG0 X0 Y0 Z20 A0 B0 C0\nFGROUP(X,Y,Z)\nG1 X30 Y10 A=DC(352) B=ACP(5) C=ACN(352) F900\nX35 A350\n"
      "X40 A=IC(12) C=DC(4)\nX45 A3 C5\nG91 X-5 A-4\nG90 G1 X0 A=AC(358) B0\nM30\n";
  check_small_turns(text, job, 1.5);
  const std::string out = run(text, job).text;
  INFO(out);
  CHECK(matches(out, "A=DC\\(35[0-9.]+\\)"));
  CHECK_FALSE(matches(out, "ACP|ACN|IC\\("));
}

TEST_CASE("the first word that says a way round stays, though its axis stands there already") {
  Job job = job_for("siemens", nc::RotaryRule::linear);
  job.settings.friction = false;
  for (const char* const word : {"C=DC(10)", "C=ACP(10)", "C=ACN(10)"}) {
    const std::string text = std::string("G54 G90 G94\nG0 X30 Y20 Z5 A3 B2 C10\nG0 Z5.0001 ") + word +
                             "\nG1 X31 F500\nG0 X40 Y-10 C20\nM30\n";
    const std::string out = run(text, job).text;
    INFO(out);
    CHECK(matches(out, "^G0 Z5[0-9.]*.* C=DC\\("));
  }
}

TEST_CASE("a move that no word says is refused") {
  Job job = job_for("linuxcnc", nc::RotaryRule::sign);
  for (auto& start : job.program.start) start.reset();
  // Where C stands is not known, and the correction turns it below 0: all the way round, or hardly at all?
  const std::string there = "G0 X30 Y40 Z0 A0 B0 C0\nM2\n";
  const std::string other = "G0 X-30 Y-40 Z0 A0 B0 C0\nM2\n";
  CHECK((code_of(there, job) == "emit-rotary-word" || code_of(other, job) == "emit-rotary-word"));
  job.program.start.fill(0);
  CHECK(code_of(there, job).empty());
  CHECK(code_of(other, job).empty());
  // G53 is not corrected, and counts from where the correction has left the axis.
  CHECK(code_of("G0 X30 Y40 Z0 A3 B2 C5\nG53 G0 C5\nM2\n", job) == "emit-rotary-word");
}

TEST_CASE("a block whose axes all stand already says so instead of being empty") {
  Job job = job_for("linuxcnc", nc::RotaryRule::sign);
  const std::string text =
      "G21 G90 G94\nG0 X0 Y0 Z20 A0 B0 C0\nG1 X30 Y10 Z0 C10 F900\nC10\nN7 C10\nC10 (there)\nC20\nM2\n";
  const Result result = run(text, job);
  INFO(result.text);
  CHECK(result.text.find("\n\n") == std::string::npos);
  CHECK(matches(result.text, "^\\(every axis of this block stands there already\\)$"));
  CHECK(matches(result.text, "^N7$"));
  CHECK(matches(result.text, "^ ?\\(there\\)$"));
  CHECK(largest_turn(result.text, job) < 11);
}

TEST_CASE("where nobody knows in which turn an axis stands, its words end in the first") {
  Job job = job_for("siemens", nc::RotaryRule::linear);
  const std::string head = "G54\nG0 X0 Y0 Z20 A0 B0 C=DC(350)\n";
  for (const char* const tail : {"M0\nG0 X1 Y1 Z20 A0 B0 C20\nG1 X5 F500\nFGROUP(X,Y,Z)\nX7 C30\nM30\n",
                                 "C=DC(20)\nM00\nG0 X30 Y-40 Z10 A0 B0 C=DC(350)\nG1 X5 F500\nM30\n",
                                 "C=ACP(20)\nM1\nG0 X30 Y40 Z10 A0 B0 C0\nG1 X5 F500\nM30\n",
                                 "C-20\nM0\nG0 X30 Y40 Z10 A0 B0 C=ACN(180)\nG1 X5 F500\nG0 C180\nM30\n"}) {
    INFO(tail);
    CHECK(code_of(head + tail, job).empty());
  }
  // Corrected, it would begin another turn.
  int refused = 0;
  for (const char* const c : {"322.4999", "322.5001"}) {
    for (const char* const x : {"X30 Y40", "X-30 Y-40"}) {
      const std::string code = code_of(head + "M0\nG0 " + x + " Z10 A0 B0 C" + c + "\nM30\n", job);
      CHECK((code.empty() || code == "emit-rotary-word"));
      if (!code.empty()) ++refused;
    }
  }
  CHECK(refused > 0);
}

TEST_CASE("a word with a sign names its place after a stop, too") {
  const Job job = job_for("linuxcnc", nc::RotaryRule::sign);
  for (const char* const moves : {"A-10 B5 C-3", "A-0.5 B-7 C12", "A10 B-5 C-1"}) {
    const std::string text =
        std::string("G0 X0 Y0 Z0 A20 B0 C0\nM60\nG0 X0 Y0 Z0 ").append(moves).append("\nG1 X20 F500\nM2\n");
    INFO(text);
    const Played played = play(text, run(text, job).text, job);
    CHECK(played.blocks > 0);
    CHECK(played.at_points_um <= 0.3);
  }
}

TEST_CASE("where an axis may still stand after a stop, no corrected word turns it all the way round") {
  const Job job = job_for("linuxcnc", nc::RotaryRule::sign);
  int refused = 0;
  for (const char* const stop : {"M60", "M6"}) {
    for (const char* const c : {"10", "0", "250"}) {
      const std::string there = std::string(" A0 B0 C").append(c).append("\n");
      const std::string text = "T1\nG0 X5 Y0 Z9" + there + "G1 X4 F100\n" + stop + "\nG0 X-40 Y30 Z9" + there +
                               "G1 X1\nG0 X5 Y0 Z9" + there + stop + "\nG0 X5 Y0 Z9" + there + "M2\n";
      INFO(text);
      const std::string code = code_of(text, job);
      CHECK((code.empty() || code == "emit-rotary-word"));
      if (code.empty()) {
        CHECK(largest_turn(run(text, job).text, job) < 350);
      } else {
        ++refused;
      }
    }
  }
  CHECK(refused > 0);
}

TEST_CASE("a word that counts within a turn says DC though its number stays") {
  Job job = job_for("siemens", nc::RotaryRule::linear);
  job.program.start.fill({});
  for (const char* const moves :
       {"G1 C=DC(2.321) F100\nG0 X-3.378 Y19.546 Z13.848 A0 B0 C0\nG0 X-3.378 Y19.546 Z13.848 A0 B0 C0\n",
        "G1 C=DC(1) F100\nG0 X1 Y1 Z9 A0 B0 C0\nM0\nG0 X0 Y0 Z50 A0 B0 C0\n"}) {
    const std::string text = std::string("G54 G0 X0 Y0 Z20 A0 B0 C0\n").append(moves).append("M30\n");
    const Result result = run(text, job);
    INFO(result.text);
    CHECK(largest_turn(result.text, job) < 5);
    CHECK_FALSE(matches(result.text.substr(result.text.find("DC(")), "C0$"));
  }
}

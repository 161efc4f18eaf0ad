// Whole programs, so that pipeline.cpp is tested here as well: what it does shows in an output alone.
#include "compensate/stream.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "base/files/files.hpp"
#include "compensate/play.hpp"
#include "compensate/random_program.hpp"

using namespace plumbline;

namespace {

const std::string kFiveMoves =
    "G21 G90 G94 G17\n"
    "G0 X0 Y0 Z20 A0 B0 C0\n"
    "G1 X20 Y10 Z0 A-12 B5 C3 F900\n"
    "G3 X-20 Y10 I-20 J15 A-5\n"
    "G1 A3 B-4\n"
    "G93 G1 X0 Y0 F12\n"
    "C-3 B2 F30\n"
    "G94 G1 X5 F500\n"
    "G91 G1 X1.5 Y-2\n"
    "A1.5\n"
    "G90 G0 Z30\n"
    "M2\n";

}  // namespace

TEST_CASE("a compensated program puts the deformed tip on the programmed path, in the programmed time") {
  Job job;
  job.settings.friction = false;
  const Result result = run(kFiveMoves, job);
  const Played played = play(kFiveMoves, result.text, job);
  CHECK(played.blocks == 10);
  CHECK(played.at_points_um <= 0.15);
  CHECK(played.between_points_um <= 0.5);
  CHECK(played.time_change <= 1e-3);
  CHECK(result.summary.points > 400);
  CHECK(result.summary.correction_mm.value > 0.005);
  CHECK(result.summary.residual_mm.value < 2e-4);

  CHECK(result.summary.time_change.value <= 1e-3);
  CHECK(result.summary.seconds_after == Approx(result.summary.seconds_before).epsilon(1e-3));
}

TEST_CASE("programs drawn at random keep path and time in every mode") {
  Job job;
  job.settings.friction = false;
  for (unsigned seed = 1; seed <= 25; ++seed) {
    const std::string text = RandomProgram(seed).text(40);
    INFO("seed " << seed << "\n" << text);
    const Played played = play(text, run(text, job).text, job);
    CHECK(played.at_points_um <= 0.15);
    CHECK(played.time_change <= 1e-3);
  }
}

TEST_CASE("programs drawn at random with loops, branches, subprograms and cycles keep path and time") {
  Job job;
  job.settings.friction = false;
  Job perfect = job;
  perfect.model.gravity.setZero();
  int unrolled = 0;
  for (unsigned seed = 1; seed <= 25; ++seed) {
    const std::string text = RandomProgram(seed, true).text(40);
    INFO("seed " << seed << "\n" << text);
    const Result result = run(text, job);
    unrolled += result.summary.unrolled ? 1 : 0;
    const Played played = play(text, result.text, job);
    CHECK(played.at_points_um <= 0.15);
    CHECK(played.time_change <= 1e-3);
    CHECK(run(text, perfect).text == text);
  }
  CHECK(unrolled >= 20);
}

TEST_CASE("a dwell in the block of a move waits once, and the move is corrected") {
  Job job;
  job.settings.friction = false;
  const std::string head = "G21 G90 G17 F600 S500 M3\nG0 X10 Y0 Z10 A0 B0 C0\nG1 X2\n";
  for (const char* const block : {"G4 P1 X5", "X5 G4 P1 A1", "G4 P1 G0 X5", "G4 P1 @5 ^3", "G3 I0.5\nI1 G4 P1",
                                  "G4 P1 G5.1 X5 Y5 I1 J1", "G61\nG4 P1 G82 X5 Z-3 R2"}) {
    const std::string text = head + block + "\nG80\nM2\n";
    INFO(text);
    const Result result = run(text, job);
    INFO(result.text);
    const Played played = play(text, result.text, job);
    CHECK(played.at_points_um <= 0.15);
    CHECK(dwells_of(result.text, job) == dwells_of(text, job));
  }
  const std::string tapped = head + "G61\nG4 P1 G84 X5 Z-3 R2\nG80\nM2\n";
  CHECK(dwells_of(run(tapped, job).text, job) == dwells_of(tapped, job));
  // Behind an arc that was divided, the words of the next one need its code again.
  const std::string arcs = head + "G3 I-2\nG4 P2 X-2 I-2\nG1 X0\nM2\n";
  CHECK(play(arcs, run(arcs, job).text, job).at_points_um <= 0.15);
}

TEST_CASE("the turns of an arc that are the seconds of a wait as well are refused where the arc becomes several") {
  Job job;
  job.settings.friction = false;
  job.settings.bound.tolerance_mm = 0.0005;
  const std::string head = "G21 G90 G17 F600 S500 M3\nG0 X10 Y0 Z10 A0 B0 C0\nG1 X2\nG2 I1\n";
  for (const char* const block : {"G4 P2 J-3", "G4 P3 J-30", "X2 Y6 J3 G4 P2"}) {
    CAPTURE(block);
    const Diagnostic refused = testing::refusal_of([&] { run(head + block + "\nM2\n", job); });
    CHECK(refused.code == "emit-shared-words");
    CHECK(refused.place.line == 5);
  }
  const std::string once = head + "G4 P1 J-30\nM2\n";
  CHECK(dwells_of(run(once, job).text, job) == dwells_of(once, job));
}

TEST_CASE("G80 gives way to the other motion code of its block") {
  Job job;
  job.settings.friction = false;
  for (const char* const block : {"G3 I-2 G80", "G80 G3 I-2", "G80 G1 X5", "G0 X5 G80"}) {
    const std::string text = std::string("G21 G90 G17 F600\nG0 X10 Y0 Z10 A0 B0 C0\n") + block + "\nM2\n";
    const Result result = run(text, job);
    INFO(result.text);
    CHECK(play(text, result.text, job).at_points_um <= 0.15);
  }
}

TEST_CASE("inch programs come out as well") {
  Job job;
  job.settings.friction = false;
  const std::string text =
      "G20 G90 G94\nG0 X0 Y0 Z1 A0 B0 C0\nG1 X1 Y.5 Z0 A-5 F30\nG2 X2 Y.5 I.5 J0\nG1 B3\nG93 X1.5 C1 F20\nA2 F60\n";
  const Played played = play(text, run(text, job).text, job);
  CHECK(played.at_points_um <= 0.15);
  CHECK(played.time_change <= 1e-3);
}

TEST_CASE("F in a block that changes the units counts in those before it") {
  Job job;
  job.settings.friction = false;
  const std::string start = "G20 G17 G90 G94\nG0 X0 Y0 Z.5 A0 B0 C0\n";
  for (const std::string& moves :
       {std::string("G1 X.1 F10\nG21 X20 F500\nX30\n"), std::string("G21 G1 X20 F20\nG20 X1.2 F300\nX1.3 F12\n"),
        std::string("G93 G1 X.1 F60\nG94 G21 X20 F20\nG93 X30 F12\nG20 X1.2 F30\n"),
        std::string("G1 X.1 F10\nG21 G3 X20 Y3 R15 F30\nG20 G2 X1 Y1 R2 F200\n"),
        std::string("G94 G21 G1 A5 F100\nA6\nG20 A7\nA8 F50\nG21 G1 Y3\nG20 G1 A9\nX.5\n"),
        std::string("G1 X.1 F10\nG21\nF600\nX20\nG20 G91 G1 Y.1\nG90 A1\nF20 X.9\n")}) {
    const std::string text = start + moves + "M2\n";
    const Result result = run(text, job);
    INFO(text << result.text);
    const Played played = play(text, result.text, job);
    CHECK(played.at_points_um <= 0.15);
    CHECK(played.time_change <= 1e-3);
  }
}

TEST_CASE("a word F that keeps the time of its block stays as it was written") {
  Job job;
  job.model.gravity.setZero();
  job.settings.friction = false;
  const std::string text = "G20 G94\nG0 X0 Y0 Z0 A0 B0 C0\nG1 X.1 F10\nG21 X20 F500\nG20 X1.2 F12345.678\nM2\n";
  CHECK(run(text, job).text == text);
  job.model.gravity = Job().model.gravity;
  const std::string output = run(text, job).text;
  CHECK(output.find(" F500") != std::string::npos);
  CHECK(output.find(" F12345.678") != std::string::npos);
}

TEST_CASE("offsets with a rotation, G92 and a second system hold") {
  Job job;
  job.settings.friction = false;
  job.program.work_offsets[1] = nc::WorkOffset{{{10, 20, -1000, 0, 0, 5}}, 0};
  const std::string text =
      "G10 L2 P1 X0 Y0 Z-1008 A0 B0 C0 R30\nG0 X10 Y0 Z0 A-5 B0 C0\nG1 X20 F600\nG92 X0 Z5\nG1 X5 Y5\nG92.1\n"
      "G55 G1 X0 Y0\nG1 C2 X3\n";
  const Played played = play(text, run(text, job).text, job);
  CHECK(played.at_points_um <= 0.15);
  CHECK(played.time_change <= 1e-3);
}

TEST_CASE("a model without errors gives back its input") {
  Job job;
  job.model.gravity.setZero();
  job.settings.friction = false;
  const Result result = run(kFiveMoves, job);
  CHECK(result.text == kFiveMoves);
  CHECK(result.summary.identical);
}

TEST_CASE("a program that never names A B C is corrected at the tip, and no rotary word appears") {
  Job job;
  job.settings.friction = false;
  const std::string text = "G21 G90 G94\nG0 X0 Y0 Z5\nG1 Z-1 F300\nX40\nG2 X60 Y20 I0 J20\n";
  const Result result = run(text, job);
  const std::string body = result.text.substr(result.text.find("G21"));
  CHECK(body.find_first_of("ABC") == std::string::npos);
  CHECK(result.summary.assumed_at_zero == AxisSet::rotary());
  CHECK(play(text, result.text, job).at_points_um <= 0.15);
}

TEST_CASE("cutting with an unknown position is refused, a rapid goes through as it stands") {
  std::size_t line = 0;
  CHECK(code_of("G21 G90 G94\nG1 X5 F100\n", {}, &line) == "compensate-position-unknown");
  CHECK(line == 2);
  CHECK(code_of("G0 X0 Y0\nG1 X5 F100\nZ5\n", {}) == "compensate-position-unknown");
  CHECK(code_of("G0 X0 Y0 Z0\nG1 X5 F100\nA5\n", {}, &line) == "compensate-position-unknown");  // A is named later
  CHECK(line == 2);
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\nT1 M6\nG1 X5 F100\n", {}) == "compensate-position-unknown");
  Job kept;
  kept.program.keeps_position = {6};
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\nT1 M6\nG1 X5 F100\n", kept).empty());
  const Result result = run("G0 Z9\nG0 X0 Y0 Z0 A0 B0 C0\n", {});
  CHECK(result.text.find(")\nG0 Z9\nG0 X") != std::string::npos);
  CHECK_FALSE(result.summary.identical);
}

TEST_CASE("the first rapid is corrected as at rest: nobody knows which way friction acts") {
  Job still;
  still.settings.friction = false;
  const std::string text = "G0 X30 Y20 Z5 A-3 B0 C0\n";
  CHECK(run(text, {}).text == run(text, still).text);
  const std::string twice = text + "G0 X0\n";
  CHECK(run(twice, {}).text != run(twice, still).text);
}

TEST_CASE("limits are refused by block, axis or strut, and by how much") {
  std::size_t line = 0;
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\nG1 A30 F500\n", {}, &line) == "limit-tilt");
  CHECK(line == 2);
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\nG0 X400\n", {}) == "limit-travel");
  // Both ends are inside, the chord leaves the length of a strut.
  Job short_strut;
  short_strut.model.limits.length_min.setConstant(1.2);
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\nG1 Z150 F500\n", short_strut) == "limit-strut");
  Job stiff;
  stiff.model.limits.condition_max = 2;
  CHECK(code_of("G0 X0 Y0 Z0 A0 B0 C0\n", stiff) == "limit-condition");
}

TEST_CASE("an axis that stands beyond its limit is refused at the block that goes through and left it there") {
  const std::string begin = "G0 X0 Y0 Z0 A0 B0 C0\n";
  const auto line_of = [&](const std::string& text) {
    std::size_t line = 0;
    CHECK(code_of(begin + text, {}, &line) == "limit-travel");
    return line;
  };
  CHECK(line_of("G53 G0 Z0\nG0 X10 Y20\n") == 2);
  CHECK(line_of("G53 G0 X0 Z0\nG0 X10\nG1 Y5 F500\n") == 2);    // X is the program's again, Z is not
  CHECK(line_of("G53 G0 Z0\nG0 Z300\n") == 3);                  // said by the block itself
  CHECK(line_of("G53 G0 Z-1000\nG53 G0 Y400\nG0 X10\n") == 3);  // Z is left inside its limits
  CHECK(line_of("G53 G0 Z0\nG0 Z0\n") == 2);                    // the way back begins there
}

TEST_CASE("offsets that nobody gave are refused") {
  CHECK(code_of("G55\nG0 X0 Y0 Z0 A0 B0 C0\n", {}) == "nc-work-offset-unknown");
}

TEST_CASE("at the touch-off pose nothing is left to correct") {
  Job job;
  job.settings.friction = false;
  job.settings.touch_off = AxisWords{{30, 40, -1008, -10, 5, 0}};
  const std::string text = "G0 X30 Y40 Z0 A-10 B5 C0\n";
  CHECK(run(text, job).text == text);
}

TEST_CASE("the summary says how far the zero is off and what a shift of the offset costs") {
  const compensate::Summary summary = run(kFiveMoves, {}).summary;
  REQUIRE(summary.zero_error.has_value());
  CHECK(summary.zero_error_line == 3);
  CHECK(tip_distance(*summary.zero_error, {}) > 0.005);
  CHECK(summary.offset_shift_for_1um_mm > 0.5);
  CHECK(summary.offset_shift_for_1um_mm < 500);
  CHECK(summary.blocks == 12);
}

TEST_CASE("a control that needs time for each block gets longer pieces") {
  Job job;
  job.settings.step.least_time_s = 0.5;
  const compensate::Summary summary = run(kFiveMoves, job).summary;
  CHECK(summary.widened_blocks > 0);
  CHECK(summary.points < 200);
  CHECK(summary.widening_mm.value > 1e-4);  // the arc of 25 mm radius alone leaves its chords by more
  CHECK(summary.widening_mm.value < 1);
  CHECK(run(kFiveMoves, {}).summary.widening_mm.value == 0);
}

TEST_CASE("a tool without a mass is warned of, with the error per kg") {
  Job job;
  nc::Tool tool;
  tool.number = 1;
  tool.length_mm = 80;
  job.program.tools = nc::ToolTable({tool});
  const std::string text = "G21\nT1 M6\nG43 H1\nG0 X0 Y0 Z0 A0 B0 C0\nG1 X5 F100\nM2\n";
  const compensate::Summary summary = run(text, job).summary;
  REQUIRE(summary.warnings.size() == 1);
  CHECK(summary.warnings[0].code == "compensate-tool-mass");
  CHECK(summary.warnings[0].message.find("um") != std::string::npos);
  job.settings.friction = false;
  CHECK(play(text, run(text, job).text, job, {.length = 0.08}).at_points_um <= 0.15);
}

TEST_CASE("what the model has and the correction leaves out is warned of") {
  const std::string text = read_text(PLUMBLINE_SOURCE_DIR "/models/pm600-like.toml");
  Job job;
  job.model = machine::parse_model(text +
                                       "\n[[effect]]\nname = \"servo-lag\"\nlag_ms = 5\n"
                                       "\n[[effect]]\nname = \"thermal-drift\"\nrate_K_h = [1, 1, 1, 1, 1, 1]\n",
                                   "model.toml");
  const std::string program = "G21 G0 X0 Y0 Z0 A0 B0 C0\nG1 X5 F100\nM2\n";
  const auto codes = [&] {
    std::vector<std::string> found;
    for (const Diagnostic& warning : run(program, job).summary.warnings) found.push_back(warning.code);
    return found;
  };
  CHECK(codes() == std::vector<std::string>{"compensate-dynamic", "compensate-time"});
  job.settings.dynamic = true;
  CHECK(codes() == std::vector<std::string>{"compensate-time"});
  job.settings.time_s = 60;
  CHECK(codes().empty());
}

TEST_CASE("a program without an end is warned of") {
  const auto codes = [](const std::string& text) {
    std::vector<std::string> found;
    for (const Diagnostic& warning : run(text, Job{}).summary.warnings) found.push_back(warning.code);
    return found;
  };
  const std::string moves = "G21 G0 X0 Y0 Z0 A0 B0 C0\nG1 X5 F100\n";
  CHECK(codes(moves + "M2\n").empty());
  CHECK(codes(moves + "m30 (done)\n\n(more)\n").empty());
  CHECK(codes("%\n" + moves + "%\n").empty());
  CHECK(codes("o1 sub\n" + moves + "o1 endsub\no1 call\no1 call\nM2\n").empty());
  CHECK(codes(moves) == std::vector<std::string>{"compensate-no-end"});
  CHECK(codes("%\n" + moves) == std::vector<std::string>{"compensate-no-end"});
}

TEST_CASE("pieces that a control may not read fast enough are counted, and warned of") {
  const std::string head = "G21 G90 G94 G17\nG0 X0 Y0 Z0 A0 B0 C0\n";
  const auto found = [&](const std::string& moves, double step_mm, double block_time) {
    Job job;
    job.settings.step.length_mm = step_mm;
    job.settings.step.least_time_s = block_time;
    return run(head + moves + "M2\n", job).summary;
  };
  const auto warned = [](const compensate::Summary& summary) {
    return std::count_if(summary.warnings.begin(), summary.warnings.end(),
                         [](const Diagnostic& w) { return w.code == "compensate-short-pieces" && w.place.line > 0; });
  };
  const compensate::Summary fine = found("G1 X10 F6000\n", 0.05, 0);  // 0.5 ms each
  CHECK(fine.short_pieces.below_1_ms == 200);
  CHECK(fine.short_pieces.below_block_time == 0);
  CHECK(fine.short_pieces.whole_blocks == 0);
  CHECK(fine.short_pieces.least_s == Approx(5e-4));
  CHECK(fine.short_pieces.line == 3);
  CHECK(warned(fine) == 1);
  const compensate::Summary coarse = found("G1 X10 F6000\n", 1, 0);
  CHECK(coarse.short_pieces.below_1_ms == 0);
  CHECK(warned(coarse) == 0);
  const compensate::Summary widened = found("G1 X10 F6000\n", 0.05, 2e-3);  // pieces of 2 ms instead
  CHECK(widened.widened_blocks == 1);
  CHECK(widened.short_pieces.below_block_time == 0);
  CHECK(warned(widened) == 0);
  const compensate::Summary own = found("G1 X0.1 F6000\nX0.2\nG1 Y9 F300\n", 1, 3e-3);  // blocks of 1 ms
  CHECK(own.short_pieces.below_block_time == 2);
  CHECK(own.short_pieces.whole_blocks == 2);
  CHECK(warned(own) == 1);
  const compensate::Summary quick = found("G1 X10 F6000\n", 0.05, 4e-4);  // a control that takes 0.4 ms
  CHECK(quick.short_pieces.below_1_ms == 200);
  CHECK(warned(quick) == 0);
}

TEST_CASE("moves no longer than what rounding shifts them keep their time") {
  for (const char* const moves :
       {"G1 Y-0.18901 Z-0.2794 F157.8\nG1 Y-0.189 F61.5\nG1 X3\n",
        "G1 X8.20301 Y1.0131 A-0.30518 F14.4\nG1 X8.203 Z0.00047 F63.5\n",
        "G1 X3.81896 Y14.12308 Z-0.9321 F4000\nX3.819 Y14.123 A0.00011\nX3.819 Z-0.93265\n"}) {
    for (const bool friction : {true, false}) {
      Job job;
      job.settings.friction = friction;
      const std::string text = "G21 G90 G94 G17\nG0 X0 Y0 Z0.79 A0 B0 C0\n" + std::string(moves) + "M2\n";
      const Result result = run(text, job);  // reads back
      INFO(result.text);
      REQUIRE(result.summary.read_back.has_value());
      CHECK(result.summary.time_change.value <= 1.001e-3);
    }
  }
}

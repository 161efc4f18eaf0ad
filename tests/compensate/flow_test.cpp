// Programs that loop, branch, call subprograms, drill in cycles or count in polar words.
#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;

namespace {

const std::string kStart = "G21 G90 G94 G17\nG0 X0 Y0 Z5 A0 B0 C0\n";

Job without_gravity() {
  Job job = without_friction();
  job.model.gravity.setZero();
  return job;
}

// The output holds no parameter, no O word, and plays as the original does.
std::string check_unrolled(const std::string& text) {
  INFO(text);
  const Result result = run(text, without_friction());
  INFO(result.text);
  CHECK(result.summary.unrolled);
  std::string code;
  for (std::size_t i = 0, depth = 0; i < result.text.size(); ++i) {
    if (result.text[i] == '(') ++depth;
    if (depth == 0) code += result.text[i];
    if (result.text[i] == ')') --depth;
  }
  CHECK(code.find_first_of("#oO[@^") == std::string::npos);
  const Played played = play(text, result.text, without_friction());
  CHECK(played.at_points_um <= 0.15);
  CHECK(played.time_change <= 1e-3);
  CHECK(run(text, without_gravity()).text == text);
  return result.text;
}

}  // namespace

TEST_CASE("loops and subprograms are written out pass by pass, with a comment at each entry") {
  const std::string text =
      "(a part)\no100 sub\n#2=[#1*2]\nG1 X[#1] Y#2 F500 (to the side)\no100 endsub\n" + kStart +
      "#<i>=0\no1 while [#<i> lt 3]\no100 call [#<i>*5]\nG1 Z[#<i>]\n#<i>=[#<i>+1]\no1 endwhile\nM2\n";
  const std::string output = check_unrolled(text);
  CHECK(output.starts_with("(a part)\n(plumbline 0 compensated this program)\nG21"));
  CHECK(output.find("(pass 1 of the loop in line 9)\n(o100 called in line 10)\n") != std::string::npos);
  CHECK(output.find("(pass 3 of the loop in line 9)\n(o100 called in line 10)\n") != std::string::npos);
  CHECK(output.find("pass 4") == std::string::npos);
}

TEST_CASE("where the control stands is read from the original, and written as a value") {
  check_unrolled(kStart + "G1 X5 F100\n#1=#5420\nG1 Y[#1+2]\nG1 Z[#5422-1]\nM2\n");
  check_unrolled(kStart +
                 "o1 if [#<_z> LT 8]\nG0 Z8\no1 endif\nG1 X5 F100\no2 while [#<_x> GT 1]\nG1 X[#<_x>-2]\n"
                 "o2 endwhile\nM2\n");
  check_unrolled(kStart + "G20\nG1 X[#<_x>+.5] F10\nG21\nG91\nG1 Y[#5420/2]\nM2\n");
  check_unrolled(kStart + "G92 X2\nG1 Y[#<_abs_z>+1010] X#<_x> F100\nG1 X[#<_abs_x>-1]\nM2\n");
  // The first of two blocks has been written already when the position is read.
  check_unrolled(kStart + "G1 X5 F100\nG2 X9 I2\n(MSG, at #<_x>)\nG1 Z-#<_x>\nM2\n");
}

TEST_CASE("every kind of loop and call is unrolled") {
  check_unrolled(kStart + "o1 repeat [2]\nG91 G1 X5 F100\nG90\no1 endrepeat\n");
  check_unrolled(kStart + "#1=0\no1 do\n#1=[#1+1]\nG1 X#1 F100\no1 while [#1 lt 4]\nM2\n");
  check_unrolled(kStart + "o1 if [1 gt 2]\nG1 X5 F100\no1 else\nG1 X7 F100\no1 endif\n");
  check_unrolled("%\n" + kStart + "M98 P7 L3\nG1 X1 F50\nM2\nO7\nG91 G1 X5 F100\nG90 G3 X0 Y0 R9\nM99\n%\n");
  check_unrolled(kStart + "#1=3\nG2 X[#1/7] Y1 R[#1*2] F200\no1 repeat [2]\nG3 I[#1/9] J0\no1 endrepeat\n");
  check_unrolled(
      "G20 G90 G94\nG0 X0 Y0 Z.2 A0 B0 C0\no1 repeat [2]\nG1 X[1/3] F20\nG1 Y[2/3] A1\nG1 X0 Y0 A0\n"
      "o1 endrepeat\nM2\n");
}

TEST_CASE("comments that show variables show nothing where it is written out, and a warning says so") {
  const auto warned_at = [](const std::string& text) -> std::size_t {
    for (const Diagnostic& warning : run(text, without_friction()).summary.warnings)
      if (warning.code == "compensate-message") return warning.place.line;
    return 0;
  };
  const std::string loop = "#<z>=0\no1 repeat [2]\n#<z>=[#<z>-1]\n", rest = "G1 Z#<z> F100\no1 endrepeat\nM2\n";
  CHECK(warned_at(kStart + loop + "(DEBUG, depth #<z>)\n" + rest) == 6);
  CHECK(warned_at(kStart + loop + "G1 X#<z> F50 (print, at #5420)\n(LOG, #1)\n" + rest) == 6);
  CHECK(warned_at(kStart + loop + "G1 X1 F50\n( Log , level #<z>)\n" + rest) == 7);
  CHECK(warned_at(kStart + loop + "(MSG, depth #<z>)\n(DEBUG, a pass)\n(#<z>)\n" + rest) == 0);
}

TEST_CASE("comments that do nothing beside an O word do nothing where it is written out") {
  const std::string output = check_unrolled("o100 sub (PRINT, a)\nG1 X#1 F500\no100 endsub (LOGOPEN,a.txt)\n" + kStart +
                                            "o1 repeat [2] (MSG, again)\no100 call [5] (debug, b) (note)\n"
                                            "(MSG, here)\nG1 X0\no1 endrepeat (PROBEOPEN a.txt)\nM2\n");
  CHECK(output.find("(was MSG, again)") != std::string::npos);
  CHECK(output.find("(was debug, b) (note)") != std::string::npos);
  CHECK(output.find("\n(MSG, here)") != std::string::npos);
  for (const char* const acts : {"(PRINT", "(LOGOPEN", "(MSG, again", "(debug", "(PROBEOPEN"}) {
    CHECK(output.find(acts) == std::string::npos);
  }
}

TEST_CASE("parameters that are set beside a move are not written out") {
  for (const std::string block : {"#1=5 G1 X3 F100", "G1 #1=[#2 * 2]X#1 #<ab> = 4 F100", "G1 X#1 F100 #[1+1]=7#1=6"}) {
    const std::string output =
        check_unrolled(kStart + "#1=1\n#2=2\no1 repeat [2]\n" + block + "\nG1 Y#1\no1 endrepeat\n");
    CHECK(output.find('=') == std::string::npos);
    CHECK(output.find("\n ") == std::string::npos);
  }
}

TEST_CASE("modes that come back are written as codes") {
  const std::string output = check_unrolled(kStart +
                                            "F300 S1000 M3\nM70\nG91 G20 G93 M8\nG1 X.1 F10\nM72\nG1 X9\n"
                                            "o1 sub\nM73\nG18 G90.1 F200\nG1 X3\no1 endsub\no1 call\nG1 Y4\nM2\n");
  CHECK(output.find("G21 G90 G94\nF300\nM9\n") != std::string::npos);
  CHECK(output.find("G17 G91.1\nF300\n") != std::string::npos);
}

TEST_CASE("modes come back after each pass of a call") {
  for (const std::string inside : {"G91\nG1 X1 Z-2\n", "G20 F9\nG1 X.1\nG91 Y.1\n", "G18 G90.1 G64 P1\nG1 X7\n"}) {
    for (const std::string end : {"M99\n", "N5 M99 (again)\n", "M9\nM99\n"}) {
      check_unrolled(kStart + "F300\nM98 P7 L3\nG1 X5\nG0 Z40\nM2\nO7\nM73\n" + inside + end);
    }
  }
  const std::string output =
      check_unrolled(kStart + "F300\nM98 P7 L2\nG1 X5\nM2\nO7\nM73\nG91\nG1 X1 F99\nG1 Y1\nM99\n");
  CHECK(output.find("G90\nF300\nG91") != std::string::npos);
}

TEST_CASE("overrides come back as the control brings them back, which looks at that of the feed alone") {
  const auto restored = [](const std::string& before, const std::string& inside) {
    const std::string output = check_unrolled(kStart + "F300\n" + before + "o1 sub\nM73\n" + inside +
                                              "G1 X3\no1 endsub\no1 call\nG1 Y4\nM2\n");
    return output.substr(output.find(inside) + inside.size());
  };
  CHECK(restored("", "M51 P0\n").find("M51") == std::string::npos);
  CHECK(restored("M48\n", "M50 P0\n").find("\nM50 P1\n") != std::string::npos);
  CHECK(restored("M49\nM51 P1\n", "M50 P1\nM51 P0\n").find("\nM51 P1\n") != std::string::npos);
  CHECK(restored("M49\n", "M48\nM51 P0\n").find("\nM51 P1\n") != std::string::npos);
  CHECK(restored("M49\nM51 P1\n", "M51 P0\n").find("M51") == std::string::npos);
}

TEST_CASE("lengths, feeds and shifts that come back are written as the control brings them back") {
  const std::string shifted = check_unrolled(kStart +
                                             "G92.1\nF123.456\nM70\nG92 X3 Y4\nF5\nG1 X9 Y8\nM72\nG1 X2 Y1\n"
                                             "M70\nG52 X-4\nM72\nG1 X3\no1 repeat [2]\nG1 X4\no1 endrepeat\nM2\n");
  CHECK(shifted.find("F123.5\nG92.2\n") != std::string::npos);
  const std::string restored = check_unrolled(kStart +
                                              "F50\nG92 X1\nM70\nG92.2\nG1 X9 Y8 F77\nM72\nG1 X2 Y1\n"
                                              "o1 sub\nM73\nG92.2\nG1 X3 F99\no1 endsub\no1 call\nG1 X4\nM2\n");
  CHECK(restored.find("G92.3\n") != std::string::npos);
}

TEST_CASE("a program that jumps stays as it is where nothing must change") {
  const std::string text = kStart +
                           "#1=0 (counts)\no1 while [#1 lt 9]\n#1=[#1+1]\nG1 @[#1] ^30 F100\no1 endwhile\n"
                           "G81 X1 Y1 Z-3 R1\nX5\nG80\nM2\nbehind the end\n";
  const Result result = run(text, without_gravity());
  CHECK(result.text == text);
  CHECK(result.summary.identical);
  CHECK_FALSE(result.summary.unrolled);
}

TEST_CASE("unrolling stops at its bound") {
  Job job = without_friction();
  job.program.max_blocks = 100;
  CHECK(code_of(kStart + "o1 while [1]\nG1 X5 F100\no1 endwhile\n", job) == "nc-too-many-blocks");
}

TEST_CASE("an M99 that ends the program is one pass, kept") {
  const Result result = run(kStart + "G1 X5 F100\nM99\n", without_friction());
  CHECK_FALSE(result.summary.unrolled);
  CHECK(result.text.ends_with("M99\n"));
  // The control begins it again, in what is then in force.
  Job job = without_friction();
  for (const std::string end : {"G91 G1 X5\n", "G92 X3\n", "G20\n", "G18\n"}) {
    INFO(end);
    CHECK(code_of("F100\nG0 X0 Y0 Z5 A0 B0 C0\nG1 X5\n" + end + "M99\n", job) == "nc-not-interpreted");
    const bool stated = end.find("92") == std::string::npos;
    CHECK(code_of(kStart + "F100\nG1 X5\n" + end + "M99\n", job).empty() == stated);
  }
  job.program.variables = {{1, 0.0}, {100, 0.0}};
  for (const std::string count : {"#1=[#1+1]\n", "#100=[#100+1]\n"})
    CHECK(code_of(kStart + "F100\n" + count + "G1 X5\nM99\n", job) == "nc-not-interpreted");
}

TEST_CASE("a second pass finds the state that the first one asked for") {
  Job job = without_friction();
  job.program.start = {0.0, 0.0, 5.0, 0.0, 0.0, 0.0};
  job.program.tool_in_spindle = 1;
  job.program.tools =
      nc::ToolTable({{.number = 1, .length_mm = 81, .mass_kg = 1}, {.number = 2, .length_mm = 82, .mass_kg = 1}});
  const auto code = [&](const std::string& asks, const std::string& changes) {
    const std::string text = kStart + "F100\n" + asks + "G1 X5\n" + changes + "M99\n";
    INFO(text);
    return code_of(text, job);
  };
  const auto asks_if = [](const std::string& what) { return "o1 if [" + what + "]\nG1 X2\no1 endif\n"; };
  for (const auto& [asks, changes] :
       std::vector<std::pair<std::string, std::string>>{{"#<_spindle_on>", "S100 M3\n"},
                                                        {"#<_flood> EQ 1", "M8\n"},
                                                        {"#<_spindle_css_mode>", "S100 M3\nG96 S50\n"},
                                                        {"#<_rpm> GT 5", "S700\n"},
                                                        {"#<_feed_override>", "M49\n"},
                                                        {"#5220 EQ 2", "G55\n"},
                                                        {"#5400 EQ 2", "M61 Q2\n"},
                                                        {"#<_current_tool> EQ 2", "M61 Q2\n"},
                                                        {"#<_abs_z> GT 900", "G0 Z20\n"}}) {
    INFO(asks);
    const bool before_start = asks.find("abs") != std::string::npos;
    const std::string text = asks_if(asks);
    const std::string begin = before_start ? text + kStart + "F100\n" : kStart + "F100\n" + text;
    CHECK(code_of(begin + "G1 X5\n" + changes + "M99\n", job) == "nc-not-interpreted");
    CHECK(code_of(begin + "G1 X5\nM99\n", job).empty());
    CHECK(code_of(begin + "G1 X5\n" + changes + "M2\n", job).empty());
  }
  // What it stated itself, and finds again.
  CHECK(code("S100 M3\n" + asks_if("#<_spindle_on>"), "G0 Z9\n").empty());
  CHECK(code(asks_if("#<_spindle_on>"), "S100 M3\nG1 X7\nM5\nS0\n").empty());
  // The next pass finds the tool of the end in the spindle, and G90.1.
  CHECK(code("", "M61 Q2\n") == "nc-not-interpreted");
  CHECK(code("G3 X3 I1.5 J0\n", "G90.1\n") == "nc-not-interpreted");
}

TEST_CASE("cycles that work the spindle go back to where the first of them began") {
  Job job = without_friction();
  job.program.tools =
      nc::ToolTable({{.number = 1, .length_mm = 100, .mass_kg = 1}, {.number = 7, .length_mm = 80, .mass_kg = 1}});
  const std::string begin = "G21 G90 G94 G17 G54\nG43 H1\nG0 X0 Y0 Z5 A0 B0 C0\nS900 M3\n";
  for (const std::string text :
       {"G98 G86 P.5 X1 Y2 Z-3 R1 F100\nG18\nG43 H7 Z5\n", "G98 G86 P.5 X1 Y2 Z-3 R1 F100\nG18 G86 P.5 X1 Y-3 Z5 R1\n",
        "G98 G86 P.5 X1 Y2 Z-30 R-19 F100\nG43 H7\nX8\nG43 H1\nX7\n",
        "G98 G86 P.5 X1 Y2 Z-30 R-9 F100\nG92 Z8\nX8\nG99 X9\nG98 X7\n",
        "G98 G86 P.5 X1 Y2 Z-3 R1 F100\nG19\nG43 H7 Z5\n"}) {
    const std::string whole = begin + text + "G80\nM2\n";
    INFO(whole);
    const Result result = run(whole, job);
    INFO(result.text);
    std::vector<Move> meant = moves_of(whole, job.program, job.dialect);
    std::vector<Move> made = moves_of(result.text, job.program, job.dialect);
    for (std::vector<Move>* const moves : {&meant, &made}) {
      std::erase_if(*moves, [](const Move& move) { return move.motion.kind == nc::MotionKind::rapid; });
    }
    REQUIRE(made.size() == meant.size());
    for (std::size_t i = 0; i < made.size(); ++i) CHECK(tip_distance(made[i].to_W, meant[i].to_W) < 0.1);
    CHECK(result.summary.read_back);  // where the tool goes back to, too
  }
}

TEST_CASE("drilling cycles become moves, each corrected") {
  for (const std::string text :
       {"G81 X10 Y5 Z-8 R2 F200\nX20\nG80\nG0 Z9\n", "G99 G82 X10 Y5 Z-8 R2 P0.5 F200 (hole)\nG98 X20 Y1\nG1 X0 F99\n",
        "N7 G83 X1 Y2 Z-10 R1 Q3 F200 L2\n", "G73 X1 Y2 Z-10 R1 Q3 F200\nG85 X9 Z-9 R1\nG89 P1 Y4 Z-8 R1 M0\n",
        "G91 G81 X3 Y1 Z-6 R-2 L4 F150\nG90 G0 X0 Y0\n", "G18 G81 X3 Z1 Y-6 R2 F150\n",
        "G81 @10 ^45 Z-3 R1 F100\n^60\n"}) {
    const std::string whole = kStart + text + "M2\n";
    INFO(whole);
    const Result result = run(whole, without_friction());
    INFO(result.text);
    CHECK(result.text.find("G8", result.text.find("G0")) == result.text.find("G80"));
    const Played played = play(whole, result.text, without_friction());
    CHECK(played.at_points_um <= 0.15);
    CHECK(played.time_change <= 1e-3);
    CHECK(run(whole, without_gravity()).text == whole);
  }
}

TEST_CASE("polar words become X and Y where the block must change") {
  const std::string text = kStart + "G1 @20 ^30 F100\n^60 (turns)\nG0 @5\nG91 G1 @3 ^20\nG90 G3 @10 ^0 R8\n";
  const Result result = run(text, without_friction());
  CHECK(result.text.find_first_of("@^") == std::string::npos);
  CHECK(result.text.find("(turns)") != std::string::npos);
  CHECK(play(text, result.text, without_friction()).at_points_um <= 0.15);
  CHECK(run(text, without_gravity()).text == text);
}

TEST_CASE("cycles that work the spindle keep their form, their hole shifted") {
  Job job = without_friction();
  for (const std::string text :
       {"S300 M3\nG84 X10 Y5 Z-8 R2 F200\nX20\nG80\n", "S300 M3 G98 G86 X10 Y5 Z-8 R2 P1 F200\nX20\nG80\n",
        "S300 M3 G91 G84 X3 Y1 Z-6 R-2 L2 F150\nG90\n", "S300 M4 G87 X9 Y9 Z-3 R1 I1 J1 K-1 F99\n",
        "S300 M4 G99 G74 X10 Y5 Z-8 R2 F200 P.5\n"}) {
    const std::string whole = kStart + text + "G0 X1 Y1 Z9\nM2\n";
    INFO(whole);
    const Result result = run(whole, job);
    INFO(result.text);
    const std::vector<Move> before = moves_of(whole, job.program);
    const std::vector<Move> after = moves_of(result.text, job.program);
    REQUIRE(before.size() == after.size());
    compensate::Corrector machine(job.model, job.settings);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const AxisWords stands = after[i].to_W + machine.error({after[i].to_W, {}, {}, std::nullopt}).value();
      CHECK(tip_distance(stands, before[i].to_W) <= job.settings.cycle_tolerance_mm);
      CHECK(tip_distance(after[i].to_W, before[i].to_W) > 1e-3);
    }
    CHECK(run(whole, without_gravity()).text == whole);
  }
  job.settings.cycle_tolerance_mm = 1e-5;
  CHECK(code_of(kStart + "S300 M3 G84 X10 Y5 Z-80 R2 F200\n", job) == "compensate-cycle");
}

TEST_CASE("splines become straight moves, each corrected") {
  for (const std::string text :
       {"G5 I0 J30 P0 Q-30 X20 Y10 F500\nG5 P5 Q-3 X30 Y0 (goes on)\nG1 Z1\n",
        "G91 G5.1 X20 Y5 I5 J20 F500\nG90 G1 X0\n", "G95 S99 M3 G5.1 X20 Y5 I5 J20 F5\nG94 G1 X0 F99\n"}) {
    const std::string whole = kStart + text + "M2\n";
    INFO(whole);
    const Result result = run(whole, without_friction());
    CHECK_FALSE(result.summary.unrolled);
    const Played played = play(whole, result.text, without_friction());
    CHECK(played.at_points_um <= 0.15);
    CHECK(played.time_change <= 1e-3);
    CHECK(run(whole, without_gravity()).text == whole);
  }
  // Its points stand in blocks that were written before anybody knew that the curve must change.
  check_unrolled(kStart + "G5.2 X10 Y20 P1 L3 F500\nX20 Y20 P.5\nX20 Y0 P1\nG5.3\nG1 Z3\nM2\n");
}

TEST_CASE("probes go through as they stand, and nothing is known after them") {
  const std::string probe = kStart + "G1 X5 F100\nG38.2 Z-9 F30\n";
  const Result result = run(probe + "G0 X1 Y1 Z9 A0 B0 C0\nG1 X2\n", without_friction());
  CHECK(result.text.find("\nG38.2 Z-9 F30\n") != std::string::npos);
  CHECK(code_of(probe + "G1 X2\n", without_friction()) == "compensate-position-unknown");
  CHECK(code_of(probe + "G0 Z#5063\n", without_friction()) == "nc-value-unknown");
}

TEST_CASE("moves that the spindle leads go through only where nothing must change") {
  const std::string text = kStart + "S100 M3\nG33 Z-5 K1\nG33.1 Z-9 K1\n";
  std::size_t line = 0;
  CHECK(code_of(text, without_friction(), &line) == "compensate-synchronised");
  CHECK(line == 4);
  CHECK(run(text, without_gravity()).text == text);
}

TEST_CASE("what only the machine knows may not be written as a value") {
  const std::string text = kStart + "M66 P0\nS#5399 M3\n";
  CHECK(run(text + "G1 X5 F100\n", without_friction()).text.find("S#5399") != std::string::npos);
  CHECK(code_of(text + "o1 repeat [2]\nG1 X5 F100\no1 endrepeat\n", without_friction()) == "emit-value-unknown");
}

TEST_CASE("a move that only the last digits of an expression make needs no feed of its own") {
  const std::string text = kStart + "#1=0.1\nG1 X0.3 F100\nG1 X[#1*3]\nX5\n";
  CHECK(play(text, run(text, without_friction()).text, without_friction()).at_points_um <= 0.15);
  CHECK(code_of(text, {}).empty());
  check_unrolled(text + "o1 repeat [2]\nX[#1*3]\nX0.3\nX9\no1 endrepeat\n");
}

TEST_CASE("modes kept in a block that does more are refused") {
  CHECK(code_of(kStart + "o1 repeat [2]\nM70 S100\nG1 X5 F100\no1 endrepeat\n", without_friction()) == "emit-modes");
}

TEST_CASE("subprograms of files beside the program stand in the output, with their hash") {
  const Folder folder;
  write_text(folder / "side.ngc", "o<side> sub\nG1 X#1 A[#1/10] F500\no<side> endsub\n");
  write_text(folder / "in.ngc", "G21 G90 G94\nG0 X0 Y0 Z5\no<side> call [7]\nM2\n");
  const InputFile source(folder / "in.ngc");
  CHECK(nc::named_axes(source, nc::dialect("linuxcnc")).contains(Axis::A));
  const Job job = without_friction();
  const auto compensate_with = [&](const nc::ProgramSettings& settings) {
    OutputFile out(folder / "out.ngc");
    compensate::Summary summary =
        compensate::Stream(source, surveyed(source, job), settings, job.model, job.settings, job.emit, out).run();
    out.commit();
    return summary;
  };
  CHECK_THROWS_AS(compensate_with(job.program), Refusal);  // nobody said where A stands
  nc::ProgramSettings settings = job.program;
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) settings.start[index(axis)] = 0;
  const compensate::Summary summary = compensate_with(settings);
  REQUIRE(summary.inlined_files.size() == 1);
  const std::string hash = to_hex(nc::hash_of(InputFile(folder / "side.ngc")));
  CHECK(to_hex(summary.inlined_files[0].hash) == hash);
  const std::string output = read_text(folder / "out.ngc");
  CHECK(output.find("(o<side> called in line 3, from side.ngc, hash " + hash + ")\nG1 ") != std::string::npos);
}

TEST_CASE("a program number alone steers nothing, and stands before the stamp") {
  const Result result = run("%\nO1234 (PART)\nG21 G90 G94\nG0 X9 Y0 Z0 A0 B0 C0\nG1 X5 F100\n%\n", {});
  CHECK(result.text.starts_with("%\nO1234 (PART)\n("));
}

TEST_CASE("a program may begin with what steers it") {
  Job job = without_friction();
  job.program.start.fill(0);
  for (auto& offset : job.program.work_offsets) offset = job.program.work_offsets[0];
  const auto check = [&](const char* dialect, const std::string& text, double kept_um = 0) {
    INFO(text);
    job.dialect = dialect;
    const Result result = run(text, job);
    INFO(result.text);
    CHECK(result.summary.unrolled);
    CHECK(play(text, result.text, job).at_points_um <= 0.15 + kept_um);
  };
  check("siemens", "FOR R11=1 TO 2\nG54 G0 X0 Y0 Z20 A0 B0 C0\nG1 X5 F100\nENDFOR\nM30\n");
  check("siemens", "; HEAD\nR1=0\nFOR R11=1 TO 2\nG54 G0 X0 Y0 Z20 A0 B0 C0\nG1 X5 F100\nENDFOR\nM30\n");
  check("fanuc", "O1\n#1=5\nIF[#1EQ5]THEN#1=6\nG90 G54 G21 G0 X0 Y0 Z50. A0 B0 C0\nGOTO5\nN5 G1 X#1 F100.\nM30\n", 0.5);
}

TEST_CASE("a point of a NURBS does not go on in the mode of a spline that was written as G1") {
  const std::string open = kStart + "F100\nG5.2 X1 Y1 P1 L3\nX2 Y2 P1\nG5.1 X3 Y3 I1 J1\n";
  std::size_t line = 0;
  CHECK(code_of(open + "X3 Y1 P1\nG1 X5\nM2\n", without_friction(), &line) == "nc-not-interpreted");
  CHECK(line == 7);
}

// What is read back: an output as it was written is what was meant, and every kind of fault in it is found.
// block_effects.cpp, effect_check.cpp, intention.cpp, move_check.cpp, output_check.cpp and time_check.cpp are tested
// here as well: each fault goes through all of them, and it counts that one of them finds it.
#include "compensate/read_back/read_back.hpp"

#include <filesystem>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "compensate/play.hpp"
#include "compensate/read_back/meant.hpp"
#include "compensate/read_back/output_check.hpp"

using namespace plumbline;

namespace {

Job still() {
  Job job;
  job.settings.friction = false;
  job.program.passed_m_codes = {101};
  job.program.keeps_position = {101, 0, 6};
  nc::Tool tool;
  tool.number = 3;
  tool.length_mm = 80;
  job.program.tools = nc::ToolTable({tool});
  return job;
}

const std::string kProgram =
    "(part)\nG21 G17 G90 G94 G54\nT3 M6\nG43 H3\nS1200 M3\nG0 X0 Y0 Z20 A0 B0 C0\nM8\n(slot)\nN50 G1 X10 Y5 Z0 F600\n"
    "N60 X20 A-5\nG4 P0.5\nM101 P1 Q2\nG2 X20 Y5 I5 J0\nN70 G1 X5 M9\nG0 Z30\nG61.1 G1 Z29\nG64\nS900\nM0\nG55\nG0 "
    "X0 Y0 Z10 A0 B0 C0\nG18\nG20\nG1 X1 F20\nM5\nM2\n";

Job with_second_system() {
  Job job = still();
  job.program.work_offsets[1] = nc::WorkOffset{{{5, 6, -1000, 0, 0, 0}}, 0};
  return job;
}

}  // namespace

TEST_CASE("an output is what was meant, and its figures come from the reading") {
  const Job job = with_second_system();
  const Meant meant = compensated(kProgram, job);
  CHECK(found(meant, job, 0, 0, "").empty());
  const compensate::Summary summary = run(kProgram, job).summary;
  REQUIRE(summary.read_back.has_value());
  CHECK(summary.read_back->blocks == 26);
  CHECK(summary.read_back->output_blocks > summary.points);
  CHECK(summary.points == summary.read_back->points);
  CHECK(summary.seconds_after == Approx(summary.seconds_before).epsilon(1e-3));
  CHECK(summary.rounding_mm.value > 1e-6);
  CHECK(summary.rounding_mm.value < 1e-4);
  Job unread = job;
  unread.settings.read_back = false;
  const compensate::Summary other = run(kProgram, unread).summary;
  CHECK_FALSE(other.read_back.has_value());
  CHECK(other.seconds_after == Approx(summary.seconds_after).epsilon(1e-9));
  CHECK(other.rounding_mm.value == Approx(summary.rounding_mm.value).margin(1e-6));
}

TEST_CASE("every kind of fault in an output is found") {
  const Job job = with_second_system();
  const Meant meant = compensated(kProgram, job);
  const auto finds = [&](const std::string& behind, const std::string& what, const std::string& by,
                         const std::string& says) {
    INFO(behind << ": " << what << " -> " << by);
    const std::string message = found(meant, job, behind, what, by);
    INFO(message);
    CHECK_FALSE(message.empty());
    CHECK(message.find(says) != std::string::npos);
  };
  finds("N60", " F", " F1", "takes");                    // a feed
  finds("S1200 M3", "\nM8", "\n(M8)", "M8");             // coolant
  finds("(part)", "T3", "T4", "T3");                     // another tool
  finds("T3 ", "M6", "", "M6");                          // no tool change
  finds("T3", "\nG43 H3", "\n", "G43");                  // no tool length
  finds("G43 H3", "S1200", "S1201", "S1200");            // a speed
  finds("G43 H3", "M3", "M4", "M3");                     // the other way round
  finds("M8\n", "(slot)", "(slit)", "(slot)");           // a comment
  finds("M8\n", "(slot)\n", "\n", "(slot)");             // none
  finds("N60", "G4 P0.5", "G4 P0.6", "waits");           // a dwell
  finds("N60", "\nG4 P0.5", "\n", "dwell");              // none
  finds("G4 P0.5", "M101 P1 Q2", "M101 P1 Q3", "M101");  // words of a user code
  finds("G4 P0.5", "M101 P1 Q2", "", "M101");            // the code itself
  finds("N70", "M9", "", "M9");                          // coolant beside a move
  finds("N70", "\nG0 Z", "\nG1 Z", "rapid");             // a rapid as a cut
  finds("N70", "\nM0", "\nM1", "M0");                    // another stop
  finds("N70", "\nG55", "\nG54", "work system");         // another work system
  finds("N70", "\nG18", "\nG17", "plane");               // another plane
  finds("G18", "\nG20", "\nG21", "unit");                // another unit
  finds("N70", "G61.1", "G61", "exact stop");            // no stop
  finds("G20", "\nM5", "\nM4", "M5");                    // the spindle left on
  finds("\nM5", "\nM2", "\n", "M2");                     // no end
  finds("N70", "S900\nM0", "M0\nS900", "S900");          // another order
  finds("M8\n", "N50", "N51", "number");                 // a number
  finds("M8\n", "N50", "", "number");                    // none
  finds("M8\n", "\nX", "\n(X", "");                      // a piece lost
  finds("(part)", "\n", "\nG0 X1\n", "more than");       // a move that nobody asked for
  finds("(part)", "\n", "\nQ9=\n", "cannot be read");    // text that no control takes
  const std::size_t retract = meant.output.find("\nG0 Z3");
  const std::size_t end = meant.output.find('\n', retract + 1);
  CHECK_FALSE(found(meant, job, retract, end - retract, "").empty());               // a retract dropped
  CHECK_FALSE(found(meant, job, meant.output.find("(plumbline"), 1, ";").empty());  // the stamp
}

TEST_CASE("a digit more or less anywhere in a corrected move is found") {
  const Job job = with_second_system();
  const Meant meant = compensated(kProgram, job);
  std::size_t changed = 0;
  for (std::size_t at = meant.output.find("N50"); at < meant.output.find("G4 P0.5"); ++at) {
    const char c = meant.output[at];
    if (c < '0' || c > '9') continue;
    const std::size_t word = meant.output.find_last_of("XYZABCF", at);
    if (meant.output[word] == 'F') {  // digits of F that its tolerance does not see
      const std::size_t digits = at - word;
      if (digits > 3) continue;
    }
    const std::string other(1, c == '9' ? '8' : static_cast<char>(c + 1));
    if (meant.output.find_first_of("NG", meant.output.find_last_of(" \n", at)) ==
        meant.output.find_last_of(" \n", at) + 1)
      continue;
    ++changed;
    INFO(meant.output.substr(at - 10, 20) << " -> " << other);
    CHECK_FALSE(found(meant, job, at, 1, other).empty());
    if (changed > 120) break;
  }
  CHECK(changed > 100);
}

TEST_CASE("an unrolled program with loops, modes that come back and parameters is read back") {
  const Job job = still();
  const std::string text =
      "o<a> sub\nM73\nG20\nG91 G1 X[#1/25.4] F[#2]\nM8\n(inside)\nG90\no<a> endsub\n#5=3 (depth)\nG21 G90 G17 G94 G54\n"
      "G0 X0 Y0 Z20 A0 B0 C0\nM3 S500\no<a> call [5] [20]\no1 repeat [2]\nG91 G1 X-2 F300\no1 endrepeat\nG90\nM9\nG1 "
      "X#5\nM2\n";
  const Meant meant = compensated(text, job);
  REQUIRE(meant.unrolled);
  INFO(meant.output);
  CHECK(found(meant, job, 0, 0, "").empty());
  CHECK(found(meant, job, "(inside)", "G21", "G20").find("unit") != std::string::npos);
  CHECK(found(meant, job, "M3 S500", "M8", "M7").find("M8") != std::string::npos);
  CHECK(found(meant, job, "(inside)", "\nM9\n", "\n\n").find("coolant") != std::string::npos);
}

TEST_CASE("a cycle that stays one, and one that is written out, are read back") {
  const Job job = still();
  const std::string text =
      "G21 G90 G17 G94 G54 S500 M3\nG0 X0 Y0 Z20 A0 B0 C0\nF100\nG98 G84 X5 Y5 Z-3 R2\nX10\nG80\nG82 X5 Y5 Z-3 R2 "
      "P0.5 M8\nX10\nG80\nG28.1\nM2\n";
  const std::string plain = text.substr(0, text.find("G28.1")) + "M2\n";
  const Meant meant = compensated(plain, job);
  INFO(meant.output);
  CHECK(found(meant, job, 0, 0, "").empty());
  CHECK_FALSE(found(meant, job, "G84", "R", "R1").empty());
  CHECK_FALSE(found(meant, job, "G84", "Z-", "Z-1").empty());
  CHECK_FALSE(found(meant, job, "G84", "X", "X1").empty());
  CHECK_FALSE(found(meant, job, "M8", "P0.5", "P0.4").empty());
}

TEST_CASE("the rounding of a hole's ends is no change of its time, however shallow it is") {
  const Job job = still();
  for (int i = 1; i <= 40; ++i) {
    const double depth = 0.05 + 0.0137131 * i;
    const std::string text = fmt::format(
        "G21 G90 G17 G94 G54 S500 M3\nG0 X{0} Y{0} Z2 A{1} B-3 C0\nF851\nG99 G84 X{0} Y{0} Z{2:.6f} "
        "R{3:.6f}\nG80\nM2\n",
        2 * i, 0.37 * i, 1.234567 - depth, 1.234567);
    const Meant meant = compensated(text, job);
    INFO(meant.output);
    CHECK(found(meant, job, 0, 0, "").empty());
    CHECK_FALSE(found(meant, job, "G0 ", "F851", "F860").empty());
  }
}

TEST_CASE("the guard is left out of the reading, and counted") {
  Job job = still();
  job.emit.guard = {"#<x>=1", "o<g> if [#<_abs_x> GT 1]", "M2", "o<g> endif"};
  const compensate::Summary summary = run(kProgram.substr(0, kProgram.find("G55")) + "M2\n", job).summary;
  REQUIRE(summary.read_back.has_value());
  CHECK(summary.read_back->guard_lines == 4);
}

TEST_CASE("digits that the control does not keep are found, though the end is the same") {
  struct Case {
    Job job;
    std::string text, word;
  };
  Job steps = still();
  steps.emit.increment_mm = 0.002;
  Job fanuc = still();
  fanuc.dialect = "fanuc";
  const std::string fanuc_text = "O1\nG21 G90 G94 G54\nG0 X0. Y0. Z20. A0. B0. C0.\nN50 G1 X10. Y5. Z1. F600.\nM30\n";
  const std::string plain = kProgram.substr(0, kProgram.find("M101")) + "M2\n";
  const std::string turned = "G21 G90 G94 G54\nG0 X0 Y0 Z20 A0 B0 C0\nN50 G1 A4 F300\nM2\n";
  for (const Case& c : {Case{still(), plain, " X"}, Case{still(), turned, " A"}, Case{fanuc, fanuc_text, " Y"}}) {
    const Meant meant = compensated(c.text, c.job);
    const std::size_t begin = meant.output.find(c.word, meant.output.find("N50"));
    REQUIRE(begin != std::string::npos);
    const std::size_t end = meant.output.find_first_of(" \n", begin + 1);
    INFO(meant.output);
    CHECK(found(meant, c.job, 0, 0, "").empty());
    const std::string message = found(meant, c.job, end, 0, "001");
    INFO(message);
    CHECK(message.find("the control keeps steps of") != std::string::npos);
  }
  const Meant meant = compensated(plain, steps);
  CHECK(found(meant, steps, 0, 0, "").empty());
  const std::size_t begin = meant.output.find(" X", meant.output.find("N50"));
  const std::size_t end = meant.output.find_first_of(" \n", begin + 1);
  CHECK_FALSE(found(meant, steps, end, 0, "1").empty());
}

TEST_CASE("what stands beside a call is done before it, in an unrolled program too") {
  const std::string start = "G21 G90 G94 G54\nG0 X0. Y0. Z20. A0. B0. C0.\nS900 M3\n";
  Job fanuc = still();
  fanuc.dialect = "fanuc";
  struct Case {
    Job job;
    std::string text, effect, damage;
  };
  for (const Case& c :
       {Case{fanuc, "O1\n" + start + "M98 P7 M8\nM9\nM30\nO7\nG1 X5. F300.\nM99\n", "\nM8\n", "\nM7\n"},
        Case{fanuc, "O1\n" + start + "S500 M98 P7 L2\nM9\nM30\nO7\nG91 G1 X5. F300.\nG90\nM99\n", "\nS500", "\nS501"},
        Case{fanuc, "O1\n" + start + "M98 P7 M101\nM9\nM30\nO7\nG1 X5. F300.\nM99\n", "\nM101\n", "\n\n"},
        Case{fanuc, "O1\n" + start + "#1=7\nM98 P#1 M8 (WET)\nM9\nM30\nO7\nG1 X5. F300.\nM99\n", "\nM8 (WET)\n",
             "\n(WET)\n"}}) {
    const Meant meant = compensated(c.text, c.job);
    INFO(meant.output);
    REQUIRE(meant.unrolled);
    CHECK(found(meant, c.job, 0, 0, "").empty());
    const std::size_t at = meant.output.find(c.effect);
    REQUIRE(at != std::string::npos);
    CHECK(meant.output.find(c.effect, at + 1) == std::string::npos);
    CHECK(at < meant.output.find("G1 X"));
    CHECK_FALSE(found(meant, c.job, at, c.effect.size(), c.damage).empty());
  }
}

TEST_CASE("comments beside lines that steer stay, and their loss is found") {
  const std::string text =
      "o<a> sub (drills)\nG91 G1 X5 F500\nG90\no<a> endsub (done)\nG21 G90 G94 G54\nG0 X0 Y0 Z20 A0 B0 C0\no<a> call "
      "(MSG, first)\no1 repeat [2] (twice)\nG1 Y-2\no1 endrepeat\nM73 (kept)\n#1=3\no2 if [#1 GT 2] (DEBUG, #1)\nG1 "
      "X0\n"
      "o2 endif\nM2\n";
  const Job job = still();
  const Meant meant = compensated(text.substr(0, text.find("M73")) + text.substr(text.find("#1=3")), job);
  INFO(meant.output);
  REQUIRE(meant.unrolled);
  CHECK(found(meant, job, 0, 0, "").empty());
  for (const char* const comment : {"(drills)", "(was MSG, first)", "(twice)", "(done)", "(was DEBUG, #1)"}) {
    INFO(comment);
    const std::size_t at = meant.output.find(comment);
    REQUIRE(at != std::string::npos);
    CHECK(found(meant, job, at, std::string(comment).size(), "").find("missing") != std::string::npos);
  }
}

TEST_CASE("a difference names both lines, and nothing is written") {
  const Folder folder;
  write_text(folder / "program.in", kProgram);
  const InputFile source(folder / "program.in");
  const Job job = with_second_system();
  {
    OutputFile out(folder / "program.out");
    const compensate::ProgramSurvey survey = surveyed(source, job);
    compensate::Stream stream(source, survey, job.program, job.model, job.settings, job.emit, out);
    stream.show(
        [](const compensate::IntendedBatch& batch) {  // as if the emitter had written another end than was meant
          auto& points = const_cast<compensate::IntendedBatch&>(batch).points;
          if (points.size() > 20) points[20][Axis::X] += 0.01;
        });
    try {
      stream.run();
      FAIL("it went through");
    } catch (const Refusal& refusal) {
      const Diagnostic& said = refusal.diagnostic();
      INFO(refusal.what());
      CHECK(said.code == "compensate-read-back");
      CHECK(said.place.file == source.name());
      CHECK(said.place.line > 0);
      CHECK_FALSE(said.place.text.empty());
      CHECK(said.message.find("of the output:") != std::string::npos);
      CHECK(said.help.find("nothing was written") != std::string::npos);
    }
  }
  CHECK_FALSE(std::filesystem::exists(folder / "program.out"));
}

TEST_CASE("called cycles, splines, blocks left out and machine moves of a SINUMERIK are read back") {
  Job job = still();
  job.dialect = "siemens";
  job.program.block_delete = true;
  const std::string head = "G71 G90 G94 G17 G54\nT3 D1\nG0 X0 Y0 Z20 A0 B0 C0\nS900 M3 F200\n";
  for (const char* const body :
       {"MCALL CYCLE81(10,0,2,-8)\nX5 Y5\nX15 M8\nMCALL\nG1 X0 F300\n", "/ G1 X3 F200\nG1 X5 F300\n/ M8\nY6\n",
        "G1 X5 F300\nSUPA G0 Z-950 D0\nM5\nT3 D1\nG0 X0 Y0 Z20 A0 B0 C0\nG1 Y3 F200\n"}) {
    const std::string text = head + body + "M30\n";
    INFO(text);
    const Meant meant = compensated(text, job);
    INFO(meant.output);
    CHECK(meant.output.find("plumbline") != std::string::npos);
    CHECK(found(meant, job, 0, 0, "").empty());
    CHECK_FALSE(found(meant, job, "M3", "\nM30", "\nM0").empty());
  }
  job.dialect = "linuxcnc";
  for (const char* const body :
       {"G5 X8 Y4 I2 J3 P-1 Q2 F400\n", "G5.1 X16 Y0 I8 J12 F300\n", "G1 X3 F300\nG53 G0 Z0\nM5\n"}) {
    const std::string text = "G21 G90 G94 G17 G54\nG0 X0 Y0 Z20 A0 B0 C0\n" + std::string(body) + "M2\n";
    const Meant meant = compensated(text, job);
    INFO(meant.output);
    CHECK(found(meant, job, 0, 0, "").empty());
    CHECK_FALSE(found(meant, job, "plumbline", "\nM2", "\nM0").empty());
  }
}

TEST_CASE("a program that is refused in its middle leaves nothing, whatever was read back by then") {
  for (const char* const end : {"G1 X#99\n", "G0 X1 M999\n", "G1 A89 F100\n", "G33 Z-5 K1\n"}) {
    std::string text = "G21 G90 G94 G17 G54\nG0 X0 Y0 Z20 A0 B0 C0\nF500\n";
    for (int i = 0; i < 1500; ++i) text += fmt::format("G1 X{} Y{}\n", i % 7, i % 5);
    const Folder folder;
    write_text(folder / "program.in", text + end + "M2\n");
    const InputFile source(folder / "program.in");
    const Job job = still();
    {
      OutputFile out(folder / "program.out");
      const compensate::ProgramSurvey survey = surveyed(source, job);
      compensate::Stream stream(source, survey, job.program, job.model, job.settings, job.emit, out);
      std::string code;
      try {
        stream.run();
      } catch (const Refusal& refusal) {
        code = refusal.diagnostic().code;
      }
      INFO(end);
      CHECK_FALSE(code.empty());
      CHECK(code != "compensate-read-back");
    }
    CHECK_FALSE(std::filesystem::exists(folder / "program.out"));
  }
}

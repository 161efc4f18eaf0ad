// What is read back: an output as it was written is what was meant, and every kind of fault in it is found.
#include "compensate/read_back.hpp"

#include <catch2/catch.hpp>

#include "compensate/output_check.hpp"
#include "compensate/play.hpp"

using namespace plumbline;

namespace {

struct Meant {
  std::string source, output;
  std::vector<compensate::IntendedBatch> batches;
  bool unrolled = false;
};

Meant compensated(const std::string& text, const Job& job) {
  const Folder folder;
  write_text(folder / "program.in", text);
  const InputFile source(folder / "program.in");
  OutputFile out(folder / "program.out");
  compensate::Stream stream(source, nc::dialect(job.dialect), job.program, job.model, job.settings, job.emit, out);
  Meant meant;
  stream.show([&](const compensate::IntendedBatch& batch) { meant.batches.push_back(batch); });
  meant.unrolled = stream.run().unrolled;
  out.commit();
  meant.source = text;
  meant.output = read_text(folder / "program.out");
  return meant;
}

// What reading `output` says, which was made from the one that was meant by exchanging bytes at `at`.
std::string found(Meant meant, const Job& job, std::size_t at, std::size_t size, const std::string& by) {
  meant.output.replace(at, size, by);
  for (compensate::IntendedBatch& batch : meant.batches) {
    for (compensate::IntendedBlock& block : batch.blocks) {
      if (block.output_end > at) block.output_end += by.size() - size;
    }
  }
  const Folder folder;
  write_text(folder / "source", meant.source);
  write_text(folder / "output", meant.output);
  const InputFile source(folder / "source");
  const InputFile output(folder / "output");
  compensate::OutputCheck check(source, output, nc::dialect(job.dialect), job.program, job.emit, meant.unrolled);
  try {
    for (const compensate::IntendedBatch& batch : meant.batches) check.take(batch);
    check.finish();
  } catch (const Refusal& refusal) {
    CHECK(refusal.diagnostic().code == "compensate-read-back");
    CHECK(refusal.diagnostic().place.line > 0);
    return refusal.what();
  }
  return {};
}

// The same with the first `what` behind `behind` exchanged.
std::string found(const Meant& meant, const Job& job, const std::string& behind, const std::string& what,
                  const std::string& by) {
  const std::size_t begin = meant.output.find(behind);
  REQUIRE(begin != std::string::npos);
  const std::size_t at = meant.output.find(what, begin + behind.size());
  INFO(behind << " ... " << what << " in\n" << meant.output);
  REQUIRE(at != std::string::npos);
  return found(meant, job, at, what.size(), by);
}

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

TEST_CASE("the guard is left out of the reading, and counted") {
  Job job = still();
  job.emit.guard = {"#<x>=1", "o<g> if [#<_abs_x> GT 1]", "M2", "o<g> endif"};
  const compensate::Summary summary = run(kProgram.substr(0, kProgram.find("G55")) + "M2\n", job).summary;
  REQUIRE(summary.read_back.has_value());
  CHECK(summary.read_back->guard_lines == 4);
}

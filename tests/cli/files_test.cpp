// What is read, what is written, and what never is.
#include <vector>

#include <catch2/catch.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;
namespace fs = std::filesystem;

namespace {

std::string compensate(const std::string& rest) { return "compensate " + rest + " " + kModel + kOffset; }

}  // namespace

TEST_CASE("standard input and output serve as files") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  CHECK(run(scratch, compensate("p.ngc -o out.ngc")).code == 0);
  const Outcome piped = run(scratch, compensate("- -o -") + "<p.ngc");
  CHECK(piped.code == 0);
  CHECK(piped.out == scratch.text("out.ngc"));
  CHECK(contains(piped.err, "largest correction"));
  const Outcome from_pipe = run(scratch, compensate("- -o -"), "cat p.ngc |");
  CHECK(from_pipe.out == piped.out);
}

TEST_CASE("standard output gets nothing from work that fails") {
  const Scratch scratch;
  scratch.file("p.ngc", std::string(kPart).replace(std::string(kPart).find("M2"), 2, "G1 A60"));
  const Outcome outcome = run(scratch, compensate("- -o -") + "<p.ngc");
  CHECK(outcome.code == 1);
  CHECK(outcome.out.empty());
  CHECK(contains(outcome.err, "<stdin>:7:1: error: tilt would be"));
}

TEST_CASE("an output is not written, and an old one not touched, by work that fails") {
  const Scratch scratch;
  scratch.file("bad.ngc", "G0 X0 Y0 Z0 A0 B0 C0\nG1 A60 F100\n");
  CHECK(run(scratch, compensate("bad.ngc -o out.ngc --json sum.json")).code == 1);
  CHECK_FALSE(scratch.has("out.ngc"));
  CHECK_FALSE(scratch.has("sum.json"));
  scratch.file("out.ngc", "old");
  CHECK(run(scratch, compensate("bad.ngc -o out.ngc")).code == 1);
  CHECK(scratch.text("out.ngc") == "old");
  for (const auto& entry : fs::directory_iterator(scratch.path(""))) {
    INFO(entry.path());
    CHECK(entry.path().filename().string().find("out.ngc.") == std::string::npos);
  }
}

TEST_CASE("an input is never overwritten, whatever it is called") {
  const Scratch scratch;
  const std::string model = plumbline::read_text(source_file("models/pm600-like.toml"));
  scratch.file("p.ngc", kPart);
  scratch.file("m.toml", model);
  scratch.file("sub", "");
  fs::create_symlink("p.ngc", scratch.path("link.ngc"));
  fs::create_hard_link(scratch.path("p.ngc"), scratch.path("hard.ngc"));
  const std::string rest = std::string(" -m m.toml") + kOffset;
  for (const std::string& arguments : std::vector<std::string>{
           "compensate p.ngc -o p.ngc", "compensate p.ngc -o ./p.ngc", "compensate link.ngc -o p.ngc",
           "compensate p.ngc -o link.ngc", "compensate p.ngc -o hard.ngc", "compensate p.ngc -o m.toml",
           "compensate p.ngc -o out.ngc --json p.ngc", "compensate - -o p.ngc", "check p.ngc --json p.ngc",
           "simulate p.ngc -o p.ngc"}) {
    INFO(arguments);
    const Outcome outcome = run(scratch, arguments + rest + (contains(arguments, " - ") ? "<p.ngc" : ""));
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "would overwrite the input"));
    CHECK(scratch.text("p.ngc") == kPart);
    CHECK(scratch.text("m.toml") == model);
    CHECK_FALSE(scratch.has("out.ngc"));
  }
  CHECK(run(scratch, "trace p.ngc -o p.ngc").code == 1);
  CHECK(run(scratch, "trace p.ngc >>p.ngc").code == 1);
  CHECK(run(scratch, "diff p.ngc link.ngc --json hard.ngc").code == 1);
  CHECK(run(scratch, "error p.ngc -m m.toml -o p.ngc").code == 1);
  CHECK(scratch.text("p.ngc") == kPart);
}

TEST_CASE("two outputs do not share a file") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  CHECK(run(scratch, compensate("p.ngc -o x --json x")).code == 1);
  CHECK(run(scratch, compensate("p.ngc -o - --json -")).code == 1);
  CHECK_FALSE(scratch.has("x"));
  CHECK(run(scratch, compensate("p.ngc -o x --json ./x")).code == 1);
  CHECK(run(scratch, compensate("p.ngc -o x.undo --undo --json x.undo.undo")).code == 1);
  CHECK(run(scratch, compensate("p.ngc -o x --json '" + scratch.path("x") + "'")).code == 1);
  CHECK_FALSE(scratch.has("x"));
}

TEST_CASE("a pattern that gives the program its own name says so") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  const Outcome outcome = run(scratch, compensate("p.ngc --output-name '{name}{ext}'"));
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "--output-name gives the output the name of the program p.ngc"));
  CHECK(scratch.text("p.ngc") == kPart);
}

TEST_CASE("standard input can be one file only") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  const Outcome outcome = run(scratch, "compensate - -m - -o out.ngc" + kOffset + "<p.ngc");
  CHECK(outcome.code == 2);
  CHECK(contains(outcome.err, "standard input"));
  CHECK_FALSE(scratch.has("out.ngc"));
}

TEST_CASE("results that cannot be written are a failure, and no bug") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  for (const std::string& arguments :
       std::vector<std::string>{"diff p.ngc p.ngc", "diff p.ngc p.ngc --json -", "explain", "trace p.ngc",
                                "check p.ngc " + kModel + kOffset}) {
    for (const char* const stream : {" >/dev/full", " >&-"}) {
      INFO(arguments << stream);
      const Outcome outcome = run(scratch, arguments + stream);
      CHECK(outcome.code == 1);
      CHECK(contains(outcome.err, "[file-unwritable]"));
    }
  }
}

TEST_CASE("messages do not end up in files where standard error is closed") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  const std::string arguments = "simulate p.ngc " + kModel + kOffset;
  const std::string expected = run(scratch, arguments).out;
  CHECK(run(scratch, arguments + "-o s.csv <&- >&- 2>&-").code == 0);
  CHECK(scratch.text("s.csv") == expected);
  const Outcome closed = run(scratch, "trace - -o t.jsonl <&-");
  CHECK(closed.code == 1);
  CHECK(contains(closed.err, "is closed"));
  CHECK(contains(closed.err, "or name its file"));
  CHECK_FALSE(scratch.has("t.jsonl"));
}

TEST_CASE("files that cannot be read or written are named") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  const Outcome missing = run(scratch, compensate("missing.ngc -o out.ngc"));
  CHECK(missing.code == 1);
  CHECK(missing.err.starts_with("missing.ngc: error: "));
  CHECK(contains(run(scratch, compensate("p.ngc -o no/where.ngc")).err, "no/where.ngc: error: "));
  CHECK(contains(run(scratch, compensate(". -o out.ngc")).err, "is a folder"));
  CHECK(run(scratch, compensate("p.ngc -o .")).code == 1);
}

TEST_CASE("the settings file beside the program counts, and the command line counts more") {
  const Scratch scratch;
  fs::create_directory(scratch.path("part"));
  scratch.file("part/p.ngc", kPart);
  scratch.file("part/plumbline.toml", "plumbline = \"settings 1\"\nmodel = \"" + source_file("models/pm600-like.toml") +
                                          "\"\nstep_length = 0.5\n[work_offset]\nG54 = [0, 0, -1008, 0, 0, 0]\n");
  const Outcome outcome = run(scratch, "compensate part/p.ngc -o half.ngc");
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.err, "settings from         part/plumbline.toml"));
  CHECK(contains(scratch.text("half.ngc"), "(settings file part/plumbline.toml)"));
  CHECK(contains(scratch.text("half.ngc"), "step 0.1 deg or 0.5 mm"));
  CHECK(run(scratch, "compensate part/p.ngc -o whole.ngc --step-length 1").code == 0);
  CHECK(contains(scratch.text("whole.ngc"), "step 0.1 deg or 1 mm"));
  const Outcome bound = run(scratch, "compensate part/p.ngc -o bound.ngc --tolerance 0.5um");
  CHECK(bound.code == 0);  // the steps of the file give way
  CHECK(contains(bound.err, "bound                 0.5 um and 0.000286 deg asked for"));
  CHECK(contains(scratch.text("bound.ngc"), "tolerance 0.5 um"));
  CHECK(run(scratch, "compensate part/p.ngc -o out.ngc --no-settings").code == 2);
  CHECK(run(scratch, "compensate part/p.ngc -o out.ngc --no-settings " + kModel).code == 1);
  scratch.file("part/plumbline.toml", "plumbline = \"settings 1\"\nsteplength = 1\n");
  const Outcome wrong = run(scratch, "trace part/p.ngc");
  CHECK(wrong.code == 1);
  CHECK(wrong.err.starts_with("part/plumbline.toml:2:1: error: "));
}

TEST_CASE("where too many files are open that is said, and not that a folder is missing") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  for (const int most : {3, 4, 5}) {
    INFO(most);
    const Outcome outcome = run(scratch, "trace p.ngc -o t.jsonl", "ulimit -n " + std::to_string(most) + ";");
    if (outcome.code == 0) continue;
    CHECK_FALSE(contains(outcome.err, "check that"));
    CHECK_FALSE(contains(outcome.err, "check the path"));
  }
}

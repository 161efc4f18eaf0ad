// How outputs appear, what signals leave, and what a terminal gets to see.
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>
#include <sys/stat.h>

#include "cli/program.hpp"

using namespace plumbline::testing;
namespace fs = std::filesystem;

namespace {

std::string compensation(const std::string& rest) { return "compensate " + rest + " " + kModel + kOffset; }

std::vector<std::string> temporary_files(const Scratch& scratch) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(scratch.folder())) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".plumbline-")) names.push_back(name);
  }
  return names;
}

// A program whose output is more than a pipe holds.
std::string long_program() {
  std::string text = "G21 G90 G94\nG0 X0 Y0 Z5 A0 B0 C0\nG1 Z0 F500\n";
  for (int i = 0; i < 20; ++i) text += i % 2 == 0 ? "G1 X100 Y50 A5\n" : "G1 X0 Y0 A0\n";
  return text + "M2\n";
}

// Waits until the temporary file of the summary is there, then sends the signal; the exit status of the program stands
// in the file "status".
std::string interrupted(const std::string& signal) {
  return "p.ngc -o pipe --json sum.json " + kModel + kOffset +
         " & pid=$!; until ls -A | grep -q '^.plumbline-'; do sleep 0.01; done; kill -" + signal +
         " $pid; wait $pid; echo $? >status";
}

}  // namespace

TEST_CASE("a signal ends the program as it always does, and no temporary file is left") {
  const std::vector<std::pair<std::string, std::string>> signals{
      {"INT", "130"}, {"HUP", "129"}, {"TERM", "143"}, {"PIPE", "141"}, {"XFSZ", "153"}};
  for (const auto& [signal, status] : signals) {
    INFO(signal);
    const Scratch scratch;
    scratch.file("p.ngc", kPart);
    REQUIRE(mkfifo(scratch.path("pipe").c_str(), 0600) == 0);  // nobody reads it: the program waits when all is written
    // Shells have background processes ignore SIGINT, and what is ignored stays so.
    run(scratch, "compensate " + interrupted(signal), "env --default-signal=" + signal);
    CHECK(scratch.text("status") == status + "\n");
    CHECK(temporary_files(scratch).empty());
    CHECK_FALSE(scratch.has("sum.json"));
  }
}

TEST_CASE("what kill -9 leaves is swept by the next run") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  REQUIRE(mkfifo(scratch.path("pipe").c_str(), 0600) == 0);
  run(scratch, "compensate " + interrupted("KILL"));
  CHECK(temporary_files(scratch).size() == 1);
  CHECK(run(scratch, "trace p.ngc -o moves.jsonl").code == 0);
  CHECK(temporary_files(scratch).empty());
}

TEST_CASE("whoever stops reading ends the program, and nothing else appears") {
  const Scratch scratch;
  scratch.file("p.ngc", long_program());
  run(scratch, compensation("p.ngc -o - --json sum.json") + " | head -n 1 >first");
  CHECK(contains(scratch.text("first"), "plumbline"));
  CHECK_FALSE(scratch.has("sum.json"));
  CHECK(temporary_files(scratch).empty());
}

TEST_CASE("a limit of file size leaves nothing, as a signal or as an error") {
  for (const char* const trap : {"", "trap '' XFSZ; "}) {
    const Scratch scratch;
    scratch.file("p.ngc", long_program());
    scratch.file("out.ngc", "old");
    const Outcome outcome = run(scratch, compensation("p.ngc -o out.ngc --undo"), std::string(trap) + "ulimit -f 8;");
    CHECK(outcome.code != 0);
    CHECK(scratch.text("out.ngc") == "old");
    CHECK_FALSE(scratch.has("out.ngc.undo"));
    CHECK(temporary_files(scratch).empty());
  }
}

TEST_CASE("an undo file serves the program that stands beside it") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  scratch.file("q.ngc", long_program());
  REQUIRE(run(scratch, compensation("p.ngc -o a.ngc --undo")).code == 0);
  REQUIRE(run(scratch, compensation("q.ngc -o b.ngc --undo")).code == 0);
  // As they are between the two renames: one undo file after the other serves both.
  scratch.file("a.ngc.undo", scratch.text("b.ngc.undo") + scratch.text("a.ngc.undo"));
  CHECK(run(scratch, "restore a.ngc -o -").out == kPart);
  CHECK(run(scratch, "restore b.ngc --undo a.ngc.undo -o -").out == long_program());
  // The next run keeps no more than it needs.
  REQUIRE(run(scratch, compensation("q.ngc -o a.ngc --undo")).code == 0);
  CHECK(scratch.text("a.ngc.undo") == scratch.text("b.ngc.undo"));
  CHECK(run(scratch, "restore a.ngc -o -").out == long_program());
  // A program that was replaced without --undo is not taken for the one before.
  REQUIRE(run(scratch, compensation("p.ngc -o a.ngc")).code == 0);
  const Outcome mismatch = run(scratch, "restore a.ngc -o -");
  CHECK(mismatch.code == 1);
  CHECK(contains(mismatch.err, "[undo-mismatch]"));
}

TEST_CASE("an undo file that would write more than it and its program hold is refused before it writes") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  REQUIRE(run(scratch, compensation("p.ngc -o a.ngc --undo")).code == 0);
  const std::size_t size = scratch.text("a.ngc").size();
  std::string undo = "plumbline undo 1\n";
  const std::string back = std::to_string(0 - size);  // the sum of offset and size is 0 again
  for (int i = 0; i < 1000; ++i) undo += "replaced " + std::to_string(size) + " " + back + " 0\n\n";
  undo += "end " + std::to_string(1000 * size) + " " + std::to_string(size) + " 0000000000000000 0000000000000000\n";
  scratch.file("a.ngc.undo", undo);
  const Outcome outcome = run(scratch, "restore a.ngc -o back.ngc");
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "[undo-format]"));
  CHECK_FALSE(scratch.has("back.ngc"));
}

TEST_CASE("streams that are files are written to, never replaced") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  REQUIRE(run(scratch, compensation("p.ngc -o out.ngc")).code == 0);
  scratch.file("log", "begin\n");
  CHECK(run(scratch, compensation("p.ngc -o /dev/stdout") + ">>log").code == 0);
  CHECK(scratch.text("log") == "begin\n" + scratch.text("out.ngc"));
  CHECK(run(scratch, compensation("p.ngc -o /dev/fd/3") + "3>third").code == 0);
  CHECK(scratch.text("third") == scratch.text("out.ngc"));
  CHECK(contains(run(scratch, compensation("p.ngc -o /dev/fd/3") + "3>&-").err, "is no open file"));
  CHECK(run(scratch, compensation("p.ngc -o /dev/stdout --undo")).code == 2);  // beside what?
}

TEST_CASE("a full standard error loses messages, no work; a full standard output is a failure") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  CHECK(run(scratch, compensation("p.ngc -o out.ngc") + "2>/dev/full").code == 0);
  CHECK(scratch.has("out.ngc"));
  for (const char* const asked : {"--help", "--version", "compensate --help"}) {
    INFO(asked);
    const Outcome outcome = run(scratch, std::string(asked) + " >/dev/full");
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "[file-unwritable]"));
  }
}

TEST_CASE("offsets, touch-off and start that no machine has are wrong usage") {
  const Scratch scratch;
  scratch.file("p.ngc", kPart);
  for (const char* const given : {"--work-offset G54=1e7,0,0,0,0,0", "--work-offset G55=0,0,0,0,0,-2e15",
                                  "--touch-off 0,1e7,0,0,0,0", "--start 1e300,0,0,0,0,0", "--start A=1e8"}) {
    INFO(given);
    const Outcome outcome = run(scratch, compensation("p.ngc -o out.ngc") + given);
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "1000000 at most"));
  }
}

#ifndef __SANITIZE_ADDRESS__  // whose shadow takes more memory than any limit leaves
TEST_CASE("no more memory than there is: said as such") {
  const Scratch scratch;
  scratch.file("poses.csv", "");
  fs::resize_file(scratch.path("poses.csv"), 900'000'000);  // takes no room: nothing is written
  const Outcome outcome = run(scratch, "error poses.csv -o out.csv " + kModel, "ulimit -v 400000;");
  CHECK(outcome.code == 1);
  CHECK(contains(outcome.err, "[out-of-memory]"));
  CHECK_FALSE(scratch.has("out.csv"));
  CHECK(temporary_files(scratch).empty());
}
#endif

TEST_CASE("a program reads no file outside of its folder") {
  const Scratch scratch;
  fs::create_directory(scratch.path("in"));
  fs::create_directory(scratch.path("in/lib"));
  fs::create_directory(scratch.path("out"));
  const std::string subprogram = "o<NAME> sub\nG1 X7 F100\no<NAME> endsub\n";
  const auto with = [&](const std::string& name) {
    std::string text = subprogram;
    for (std::size_t at = text.find("NAME"); at != std::string::npos; at = text.find("NAME")) text.replace(at, 4, name);
    return text;
  };
  const std::string outside = scratch.path("out/leak");
  scratch.file("out/leak.ngc", with("../out/leak"));
  scratch.file("in/lib/near.ngc", with("near"));
  for (const std::string& name : std::vector<std::string>{"../out/leak", "lib/../../out/leak", outside}) {
    INFO(name);
    scratch.file("in/p.ngc", "G21 G90 G94\nG0 X0 Y0 Z5 A0 B0 C0\no<" + name + "> call\nM2\n");
    const Outcome outcome = run(scratch, "trace in/p.ngc");
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.err, "[nc-flow-open]"));
  }
  scratch.file("in/p.ngc", "G21 G90 G94\nG0 X0 Y0 Z5 A0 B0 C0\no<lib/near> call\nM2\n");
  CHECK(contains(run(scratch, "trace in/p.ngc").out, "\"to\": [7, "));
}

TEST_CASE("names of files cannot command the terminal") {
  const Scratch scratch;
  scratch.file("bad\x1b[31m.ngc", "G1 Xq\n");
  scratch.file("good\x1b[31m.ngc", kPart);
  scratch.file("plumbline.toml", "plumbline = \"settings 1\"\n");
  for (const std::string& arguments :
       std::vector<std::string>{"trace 'bad\x1b[31m.ngc'", compensation("'good\x1b[31m.ngc' -o 'good\x1b[31m.ngc'"),
                                "trace 'none\x1b]0;x\x07'", "'no\x1b[1mcommand'", "explain 'no\x1b[1mcode'"}) {
    INFO(arguments);
    const Outcome outcome = run(scratch, arguments);
    CHECK(outcome.code != 0);
    CHECK(contains(outcome.err, "\\x1b"));
    CHECK_FALSE(contains(outcome.err + outcome.out, "\x1b"));
  }
}

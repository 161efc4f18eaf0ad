#include <filesystem>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;
using nlohmann::json;

namespace {

void write_parts(const Scratch& scratch) {
  std::filesystem::create_directories(scratch.path("parts/inner"));
  scratch.file("parts/a.nc", kPart);
  scratch.file("parts/inner/b.nc", kPart);
  scratch.file("parts/readme.txt", "no program\n");
}

const std::string kMachine = kModel + kOffset + "--no-settings ";

std::vector<json> lines_of(const std::string& text) {
  std::vector<json> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(json::parse(text.substr(at, end - at)));
    at = end + 1;
  }
  return lines;
}

}  // namespace

TEST_CASE("batch: the outputs are those of compensate, byte for byte") {
  const Scratch scratch;
  write_parts(scratch);
  const Outcome batch = run(scratch, "batch parts -o out --guard --step-length 0.5 " + kMachine);
  INFO(batch.err);
  CHECK(batch.code == 0);
  CHECK(run(scratch, "compensate parts/a.nc -o one.nc --guard --step-length 0.5 " + kMachine).code == 0);
  CHECK(scratch.text("out/a.nc") == scratch.text("one.nc"));
  CHECK(contains(batch.out, "correction"));
  CHECK(contains(batch.out, "  out/inner/b.nc\n"));
  CHECK(contains(batch.err, "2 compensated in "));
  CHECK(contains(batch.err, "; 1 file passed over\n"));
  CHECK(run(scratch, "batch parts -o out2 -q " + kMachine).err.empty());
}

TEST_CASE("batch: a second run has nothing to do, and says so") {
  const Scratch scratch;
  write_parts(scratch);
  REQUIRE(run(scratch, "batch parts -o out " + kMachine).code == 0);
  const Outcome again = run(scratch, "batch parts -o out " + kMachine);
  CHECK(again.code == 0);
  CHECK(again.out.empty());
  CHECK(contains(again.err, "2 unchanged"));
  const Outcome verbose = run(scratch, "batch parts -o out -v " + kMachine);
  CHECK(contains(verbose.out, "out/a.nc"));
  CHECK(contains(verbose.err, "parts/readme.txt: no program, passed over"));
}

TEST_CASE("batch: what is wrong with the settings of all is said once") {
  const Scratch scratch;
  write_parts(scratch);
  const Outcome batch = run(scratch, "batch parts -o out --json all.jsonl --machine hex-9 -m x.toml");
  CHECK(batch.code == 1);
  CHECK(batch.err.find("settings-no-machine") == batch.err.rfind("settings-no-machine"));
  CHECK(contains(batch.err, "[settings-no-machine]"));
  CHECK(contains(batch.out, "refused  parts/a.nc\n"));
  CHECK(contains(batch.out, "refused  parts/inner/b.nc\n"));
  CHECK(lines_of(scratch.text("all.jsonl"))[1]["diagnostics"][0]["code"] == "settings-no-machine");
}

TEST_CASE("batch: one that is refused has its message, and the exit code is 1") {
  const Scratch scratch;
  write_parts(scratch);
  scratch.file("parts/bad.nc", "G0 X0 Y0 Z5 A0 B0 C0\nG1 X1 X2 F100\n");
  const Outcome batch = run(scratch, "batch parts -o out --json out/all.jsonl " + kMachine);
  CHECK(batch.code == 1);
  CHECK(contains(batch.err, "parts/bad.nc:2:7: error: two X words in one block [nc-word-twice]"));
  CHECK(contains(batch.out, "refused  parts/bad.nc\n"));
  CHECK(contains(batch.err, "2 compensated, 1 refused"));
  const auto lines = lines_of(scratch.text("out/all.jsonl"));
  REQUIRE(lines.size() == 4);
  CHECK(lines[0]["program"] == "parts/a.nc");
  CHECK(lines[0]["summary"]["made_of"]["work_offsets"]["G54"]["z_mm"] == -1008);
  CHECK(lines[2]["state"] == "refused");
  CHECK(lines[2]["diagnostics"][0]["line"] == 2);
  CHECK(lines[3]["refused"] == 1);
  CHECK(lines_of(run(scratch, "batch parts -o out --json - " + kMachine).out).size() == 4);
}

TEST_CASE("batch: where settings are refused the outputs of before are named") {
  const Scratch scratch;
  write_parts(scratch);
  scratch.file("parts/plumbline.toml", "plumbline = \"settings 1\"\n[work_offset]\nG54 = [0, 0, -1008, 0, 0, 0]\n");
  REQUIRE(run(scratch, "batch parts -o out " + kModel).code == 0);
  scratch.file("parts/plumbline.toml", "plumbline = \"settings 1\"\nno_such_key = 1\n");
  scratch.file("parts/new.nc", kPart);
  const Outcome again = run(scratch, "batch parts -o out " + kModel);
  INFO(again.err);
  CHECK(again.code == 1);
  CHECK(contains(again.err, "3 refused"));
  CHECK(contains(again.err, "out/a.nc: warning: was made in an earlier run"));
  CHECK(contains(again.err, "out/inner/b.nc: warning: was made in an earlier run"));
  CHECK_FALSE(contains(again.err, "out/new.nc: warning"));
}

TEST_CASE("batch: undo files, lists, names and another record") {
  const Scratch scratch;
  write_parts(scratch);
  const Outcome undo =
      run(scratch, "batch --list - -o out --undo --output-name '{folder}/{name}_x{ext}' --record r " + kMachine,
          "echo parts/a.nc |");
  INFO(undo.err);
  REQUIRE(undo.code == 0);
  CHECK(scratch.has("r"));
  CHECK_FALSE(scratch.has("out/parts/inner"));
  CHECK(run(scratch, "restore out/parts/a_x.nc -o back.nc").code == 0);
  CHECK(scratch.text("back.nc") == kPart);
}

TEST_CASE("batch: what cannot be meant is wrong usage") {
  const Scratch scratch;
  write_parts(scratch);
  for (const char* const words :
       {"batch -o out", "batch parts", "batch parts/a.nc -o out", "batch --watch --list x -o out",
        "batch parts -o out --poll 2", "batch parts -o out --watch --json x", "batch parts -o out --watch --depfile x",
        "batch parts -o out --jobs 0"}) {
    INFO(words);
    CHECK(run(scratch, words).code == 2);
  }
  CHECK(contains(run(scratch, "batch none -o out " + kMachine).err, "[batch-folder]"));
  CHECK_FALSE(scratch.has("out"));
  CHECK(contains(run(scratch, "batch parts -o parts " + kMachine).err, "[file-overwrites-input]"));
}

TEST_CASE("batch: no report takes the place of what is read or made") {
  const Scratch scratch;
  write_parts(scratch);
  const std::string model = plumbline::read_text(PLUMBLINE_SOURCE_DIR "/models/pm600-like.toml");
  scratch.file("hex.toml", model);
  const std::string start = "batch parts -o out -m hex.toml --no-settings " + kOffset;
  for (const char* const report : {"parts/a.nc", "parts/inner/b.nc", "hex.toml", "out/a.nc"}) {
    for (const char* const option : {"--json ", "--depfile "}) {
      INFO(option << report);
      const Outcome outcome = run(scratch, start + option + report);
      CHECK(outcome.code == 1);
      CHECK(contains(outcome.err, "[file-"));
      CHECK(scratch.text("parts/a.nc") == kPart);
      CHECK(scratch.text("parts/inner/b.nc") == kPart);
      CHECK(scratch.text("hex.toml") == model);
    }
  }
  scratch.file("old.json", "{}\n");
  CHECK(run(scratch, start + "--json old.json").code == 0);
}

TEST_CASE("a depfile names the program, what it calls and what it is made with") {
  const Scratch scratch;
  scratch.file("a.nc", "O1\nG90 G21 G94\nG0 X0. Y0. Z0. A0. B0. C0.\nM98 P1000\nM30\n");
  scratch.file("O1000.nc", "O1000\nG1 X5. F500.\nM99\n");
  const Outcome outcome = run(scratch, "compensate a.nc -o out.nc --depfile out.d " + kMachine + "--dialect fanuc");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const std::string text = scratch.text("out.d");
  CHECK(text.starts_with("out.nc: \\\n  a.nc \\\n"));
  CHECK(contains(text, "  O1000.nc\n"));
  CHECK(contains(text, "pm600-like.toml"));
  CHECK(run(scratch, "compensate a.nc -o - --depfile out.d " + kMachine).code == 2);
}

TEST_CASE("batch: a file that is no record stays, and another is to be named") {
  const Scratch scratch;
  write_parts(scratch);
  scratch.file("notes.txt", std::string(200, 'n') + "\n");
  scratch.file("short", "G0\n");
  for (const std::string record : {"parts/a.nc", "notes.txt", "short"}) {
    INFO(record);
    const std::string before = scratch.text(record);
    const Outcome refused = run(scratch, "batch parts -o out --record " + record + " " + kMachine);
    CHECK(refused.code == 1);
    CHECK(contains(refused.err, "name another file with --record"));
    CHECK_FALSE(contains(refused.err, "remove"));
    CHECK(scratch.text(record) == before);
  }
}

TEST_CASE("batch: a folder in --output-name is wrong usage, since -o says it") {
  const Scratch scratch;
  write_parts(scratch);
  for (const char* const pattern : {"x/{name}{ext}", "{folder}/x/{name}{ext}", "../{name}{ext}", "/tmp/{name}{ext}"}) {
    INFO(pattern);
    const Outcome refused = run(scratch, std::string("batch parts -o out --output-name '") + pattern + "' " + kMachine);
    CHECK(refused.code == 2);
    CHECK(contains(refused.err, "-o in which folder"));
  }
  CHECK(run(scratch, "batch parts -o out --output-name '{folder}/{name}_x{ext}' " + kMachine).code == 0);
  CHECK(run(scratch, "batch parts -o out --output-name '{name}_y{ext}' " + kMachine).code == 0);
}

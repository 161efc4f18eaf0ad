// What is said on standard error, for machines; and what the codes mean.
#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"

using namespace plumbline::testing;
using nlohmann::json;

namespace {

std::vector<json> messages(const Outcome& outcome) {
  std::vector<json> messages;
  std::istringstream lines(outcome.err);
  for (std::string line; std::getline(lines, line);) messages.push_back(json::parse(line));
  return messages;
}

// All that there are.
std::vector<std::string> commands(const Scratch& scratch) {
  std::vector<std::string> names;
  const json description = json::parse(run(scratch, "--description").out);
  for (const json& command : description.at("commands")) {
    names.push_back(command.at("name").get<std::string>());
  }
  return names;
}

// Arguments that each command refuses.
const std::map<std::string, std::string> kRefused{
    {"compensate", "compensate bad.ngc -o out.ngc " + kModel + kOffset},
    {"restore", "restore bad.ngc -o out.ngc"},
    {"error", "error bad.csv " + kModel},
    {"explain", "explain nc-word-twise"},
    {"trace", "trace bad.ngc"},
    {"check", "check bad.ngc " + kModel + kOffset},
    {"simulate", "simulate bad.ngc " + kModel + kOffset},
    {"batch", "batch missing -o out " + kModel + kOffset},
    {"diff", "diff bad.ngc bad.ngc"},
    {"compare", "compare -d missing.toml " + kModel},
    {"inspect", "inspect -d missing.toml " + kModel},
    {"import", "import missing.csv -o out --map missing.toml"},
    {"circularity", "circularity -d missing.toml"},
    {"identify", "identify -d missing.toml -o out.toml " + kModel},
    {"calibrate", "calibrate -d missing.toml -o out.toml " + kModel},
    {"plan", "plan --for backlash.witdh_um " + kModel},
    {"diagnose", "diagnose -d missing.toml -o out " + kModel},
    {"new-model", "new-model --ini missing.ini -o out.toml"},
    {"map", "map -m missing.toml"},
    {"settings", "settings part.ngc --settings missing.toml"},
    {"control", "control linuxcnc -o out --work-offset G54.1P1=0,0,0,0,0,0 " + kModel},
};

}  // namespace

TEST_CASE("each command says what it refuses as one object a line, if asked") {
  const Scratch scratch;
  scratch.file("bad.ngc", "G0 X1\nG0 X1 X2\n");
  scratch.file("bad.csv", "x\n");
  const std::vector<std::string> names = commands(scratch);
  CHECK(names.size() >= 10);
  for (const std::string& name : names) {
    INFO(name << ": a new command gets a row in kRefused");
    const auto row = kRefused.find(name);
    CHECK(row != kRefused.end());
    if (row == kRefused.end()) continue;
    const Outcome outcome = run(scratch, row->second + " --diagnostics=json");
    INFO(outcome.err);
    CHECK(outcome.code == 1);
    CHECK(outcome.out.empty());
    const std::vector<json> said = messages(outcome);
    REQUIRE(said.size() == 1);
    for (const char* key : {"code", "severity", "message", "help", "file", "line", "column", "length", "text"}) {
      CHECK(said[0].contains(key));
    }
    CHECK(said[0].at("severity") == "error");
    CHECK_FALSE(said[0].at("help").get<std::string>().empty());
    CHECK(run(scratch, "explain " + said[0].at("code").get<std::string>()).code == 0);
    CHECK(run(scratch, "--diagnostics json " + row->second).err == outcome.err);
  }
}

TEST_CASE("each command stands in the README and in the formats") {
  const Scratch scratch;
  for (const char* const page : {"README.md", "docs/formats.md"}) {
    const std::string text = plumbline::read_text(source_file(page));
    for (const std::string& name : commands(scratch)) {
      INFO(page << ": a new command gets a line");
      CHECK(contains(text, '`' + std::string(page == std::string("README.md") ? "" : "plumbline ") + name + ' '));
    }
  }
}

TEST_CASE("a place is file, line, column, length and the text of the line") {
  const Scratch scratch;
  scratch.file("bad.ngc", "G0 X1\nG0 X1 X2\n");
  const json said = messages(run(scratch, "trace bad.ngc --diagnostics json")).at(0);
  CHECK(said.at("code") == "nc-word-twice");
  CHECK(said.at("file") == "bad.ngc");
  CHECK(said.at("line") == 2);
  CHECK(said.at("column") == 7);
  CHECK(said.at("length") == 2);
  CHECK(said.at("text") == "G0 X1 X2");
}

TEST_CASE("wrong usage, warnings and notes are objects as well") {
  const Scratch scratch;
  scratch.file("p.ngc", "T1 M6\nG43\n" + std::string(kPart) + "M2\n");
  scratch.file("tools.toml", "plumbline = \"tools 1\"\n[[tool]]\nnumber = 1\nlength_mm = 5\n");
  for (const std::string& name : commands(scratch)) {
    INFO(name);
    const Outcome outcome = run(scratch, name + " --nonsense --diagnostics=json");
    CHECK(outcome.code == 2);
    CHECK(messages(outcome).at(0).at("code") == "usage-wrong");
  }
  const Outcome outcome =
      run(scratch, "compensate p.ngc -o out.ngc --tools tools.toml --diagnostics=json " + kModel + kOffset);
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  const std::vector<json> said = messages(outcome);
  REQUIRE(said.size() == 2);
  CHECK(said[0].at("severity") == "warning");
  CHECK(said[0].at("code") == "compensate-tool-mass");
  CHECK(said[0].at("line") == 1);
  CHECK(said[1].at("severity") == "note");
  CHECK(contains(said[1].at("message"), "largest correction"));
  CHECK(run(scratch, "trace p.ngc --diagnostics=xml").code == 2);
}

TEST_CASE("explain says what a code means, and lists them all") {
  const Scratch scratch;
  const Outcome page = run(scratch, "explain nc-word-twice");
  CHECK(page.code == 0);
  CHECK(page.err.empty());
  CHECK(contains(page.out, "A letter stands twice in one block"));
  CHECK(contains(run(scratch, "explain").out, "nc-word-twice "));
  const Outcome unknown = run(scratch, "explain nc-word-twise");
  CHECK(unknown.code == 1);
  CHECK(contains(unknown.err, "did you mean nc-word-twice?"));
  scratch.file("bad.ngc", "G0 X1 X2\n");
  CHECK(contains(run(scratch, "trace bad.ngc").err, "\nplumbline explain nc-word-twice says more\n"));
}

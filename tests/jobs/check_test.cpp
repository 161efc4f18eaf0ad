#include "jobs/check.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/program/check_text.hpp"
#include "settings/options.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

jobs::CheckSummary check_of(const std::string& program) {
  const testing::Scratch scratch;
  settings::Options options;
  options.paths.model = testing::source_file("models/pm600-like.toml");
  options.program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  return jobs::check_file(scratch.file("p.ngc", program), options);
}

}  // namespace

TEST_CASE("a program inside the limits keeps them") {
  const jobs::CheckSummary s = check_of("G0 X0 Y0 Z0 A0 B0 C0\nG1 X50 A10 F1000\n");
  CHECK(s.violations == 0);
  CHECK(s.points > 50);
  CHECK(s.blocks == 2);
}

TEST_CASE("each limit that a block breaks is found with its worst value") {
  const jobs::CheckSummary s = check_of("G0 X0 Y0 Z0 A0 B0 C0\nG1 A26.5 F1000\nG1 A0\nG1 X310\nG0 X0\n");
  CHECK(s.kinds.at("tilt") == 2);
  CHECK(s.kinds.at("X") == 1);
  REQUIRE_FALSE(s.findings.empty());
  CHECK(s.findings[0].line == 2);
  CHECK(s.findings[0].violation.what == "tilt");
  CHECK(s.findings[0].violation.value == Approx(26.5).epsilon(1e-3));
  CHECK(s.findings[0].violation.by_how_much == Approx(1.5).epsilon(0.05));
}

TEST_CASE("a pose that no command reaches is found") {
  const jobs::CheckSummary s = check_of("G0 X0 Y0 Z0 A0 B0 C0\nG1 C90 F1000\n");
  CHECK(s.kinds.at("reach") == 1);
  CHECK(report::check_text(s).find("p.ngc:2: no command puts the tool there") != std::string::npos);
}

TEST_CASE("a rapid is checked along its chord") {
  const jobs::CheckSummary s = check_of("G0 X0 Y0 Z0 A24 B0 C0\nG0 X1 A-24 B0 C0\nG0 X0 A24 B24\n");
  CHECK(s.kinds.at("tilt") == 1);
}

TEST_CASE("what a block in machine coordinates left beyond its limit is told with that block") {
  const jobs::CheckSummary s = check_of("G0 X0 Y0 Z0 A0 B0 C0\nG53 G0 Z0\nG0 X10\nG0 Z300\n");
  REQUIRE(s.findings.size() == 2);
  CHECK(s.findings[0].line == 3);
  CHECK(s.findings[0].left_by == 2);
  CHECK(s.findings[1].left_by == 0);
  CHECK(report::check_text(s).find("beyond its limit of -800 mm, where line 2 left it") != std::string::npos);
  CHECK(nlohmann::json::parse(report::check_json(s))["findings"][0]["left_by"] == 2);
}

TEST_CASE("many violations are counted, the first are listed") {
  std::string program = "G0 X0 Y0 Z0 A26 B0 C0\nG1 F1000\n";
  for (int i = 0; i < 1500; ++i) program += fmt::format("X{:.2f}\n", (i % 100) * 0.01);
  const jobs::CheckSummary s = check_of(program);
  CHECK(s.violations > 1400);
  CHECK(s.findings.size() == jobs::CheckSummary::kMostFindings);
  const std::string text = report::check_text(s);
  CHECK(std::count(text.begin(), text.end(), '\n') < 30);
  CHECK(text.find("and 1,") != std::string::npos);
  const auto json = nlohmann::json::parse(report::check_json(s));
  CHECK(json.at("plumbline") == "check 1");
  CHECK(json.at("blocks_by_kind").at("tilt") == s.kinds.at("tilt"));
}

TEST_CASE("a violation in a subprogram of another file is found there") {
  const testing::Scratch scratch;
  settings::Options options;
  options.paths.model = testing::source_file("models/pm600-like.toml");
  options.program.work_offsets[0] = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  const std::string sub = scratch.file("tilt.ngc", "o<tilt> sub\nG1 A26.5 F1000\nG1 A0\no<tilt> endsub\n");
  const std::string main = scratch.file("p.ngc", "G0 X0 Y0 Z0 A0 B0 C0\no<tilt> call\nM2\n");
  const jobs::CheckSummary s = jobs::check_file(main, options);
  REQUIRE(s.findings.size() == 2);
  CHECK(s.findings[0].file == sub);
  CHECK(s.findings[0].line == 2);
  CHECK(nlohmann::json::parse(report::check_json(s)).at("findings")[0].at("file") == sub);
  CHECK(report::check_text(s).starts_with(sub + ":2: tilt would be "));
}

TEST_CASE("check says what compensate would refuse when it writes, and nothing where it would not") {
  struct Case {
    std::string program, code;
    std::size_t line;
  };
  const std::string head = "G0 X0 Y0 Z0 A0 B0 C0\n";
  for (const Case& c :
       {Case{head + "G1 X50 A10 F1000\nM2\n", "", 0}, Case{head + "G1 X50 F1000\nX60 M100\nM2\n", "nc-user-code", 3},
        Case{head + "G1 X50 F1000\nG28.1\nM2\n", "emit-stores-position", 3},
        Case{head + "G1 X50 F1000\nG33 Z-5 K1 S100 M3\nM2\n", "compensate-synchronised", 3},
        Case{head + "F100\nG1 X150 Y90\nG30.1\nM2\n", "emit-stores-position", 4}}) {
    INFO(c.program);
    std::optional<Diagnostic> refused;
    try {
      refused = check_of(c.program).refusal;
    } catch (const Refusal& refusal) {
      refused = refusal.diagnostic();
    }
    CHECK((refused ? refused->code : "") == c.code);
    if (refused) CHECK(refused->place.line == c.line);
  }
  const jobs::CheckSummary s = check_of(head + "G1 X50 F1000\nG28.1\nM2\n");
  CHECK(s.violations == 0);
  CHECK(nlohmann::json::parse(report::check_json(s)).at("refusal").at("code") == "emit-stores-position");
  CHECK(nlohmann::json::parse(report::check_json(check_of(head))).at("refusal").is_null());
}

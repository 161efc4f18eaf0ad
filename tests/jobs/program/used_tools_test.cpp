// Tools of names, of the spindle and of subprograms are in compensate/stamp_test.cpp, as a stamp lists them.
#include "jobs/program/used_tools.hpp"

#include <filesystem>

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

namespace {

std::vector<int> tools_used_by(std::string_view program) {
  const testing::Scratch scratch;
  const InputFile file(scratch.file("p.ngc", program));
  const nc::ToolTable table({{1, 10, {}, {}, {}}, {12, 20, {}, {}, {}}, {123, 30, {}, {}, {}}});
  std::vector<int> numbers;
  for (const nc::Tool& tool : jobs::used_tools(file, table, {})) numbers.push_back(tool.number);
  return numbers;
}

}  // namespace

TEST_CASE("a number is read as a control reads it: zeros in front, a sign, blanks in between") {
  CHECK(tools_used_by("T0012 M6\n") == std::vector{12});
  CHECK(tools_used_by("T+1 M6\n") == std::vector{1});
  CHECK(tools_used_by("t 1 2 m6\n") == std::vector{12});
  CHECK(tools_used_by("T1 M6\nG43 H123\n") == std::vector{1, 123});
  CHECK(tools_used_by("T99999999999999999999 M6\n").empty());
}

TEST_CASE("comments use no tools, and after them the line goes on") {
  CHECK(tools_used_by("(T1) G43 H12\n") == std::vector{12});
  CHECK(tools_used_by("G0 X1 ; T1\n").empty());
  CHECK(tools_used_by("G0 X1 (T1\nT12\n") == std::vector{12});
}

TEST_CASE("an expression may be any tool of the table") {
  CHECK(tools_used_by("#1=12\nT#1 M6\n").size() == 3);
  CHECK(tools_used_by("T[1+11] M6\n").size() == 3);
  CHECK(tools_used_by("T=R5\n").size() == 3);
  CHECK(tools_used_by("X#1 Y[1]\n").empty());
}

TEST_CASE("of an empty table no tool is used") {
  const testing::Scratch scratch;
  const InputFile file(scratch.file("p.ngc", "T1 M6\n"));
  CHECK(jobs::used_tools(file, {}, 1).empty());
}

TEST_CASE("a subprogram in a folder that is called by name uses tools and may restore G92 too") {
  const testing::Scratch scratch;
  std::filesystem::create_directories(scratch.path("subs/more"));
  scratch.file("subs/deep.ngc", "o<deep> sub\nG43 H12\no<more/far> call\no<deep> endsub\n");
  scratch.file("subs/more/far.ngc", "o<far> sub\nT123 M6\nG 92.3\no<far> endsub\n");
  const nc::ToolTable table({{1, 10, {}, {}, {}}, {12, 20, {}, {}, {}}, {123, 30, {}, {}, {}}});
  const auto used = [&](const char* text) {
    return jobs::used_tools(InputFile(scratch.file("p.ngc", text)), table, {}).size();
  };
  const auto restores = [&](const char* text) { return jobs::may_restore_g92(InputFile(scratch.file("p.ngc", text))); };
  CHECK(used("o<subs/deep> call\nM2\n") == 2);
  CHECK(used("G0 X1\nM2\n") == 0);
  CHECK(restores("o<subs/deep> call\nM2\n"));
  CHECK(restores("G92.3 (back)\nM2\n"));
  CHECK(restores("G[92.3]\nM2\n"));
  CHECK_FALSE(restores("G92.2\nG92 X3\n(G92.3)\nM2\n"));
}

// Every diagnostic of the reader has a program in tests/nc/bad; its first line says what is expected where.
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "base/files/files.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/recognise.hpp"
#include "nc/language/tool_table.hpp"
#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;
namespace fs = std::filesystem;

namespace {

struct Expected {
  std::string code;
  std::size_t line = 0;
  std::size_t column = 0;
  std::string dialect = "linuxcnc";
  FreeRotation free_rotation = FreeRotation::unknown;
};

Expected read_expected(const fs::path& path) {
  std::ifstream in(path);
  std::string first;
  std::getline(in, first);
  std::smatch match;
  REQUIRE(std::regex_search(first, match, std::regex(R"(expect: (\S+) (\d+) (\d+))")));
  Expected expected{match[1], std::stoul(match[2]), std::stoul(match[3])};
  if (std::regex_search(first, match, std::regex(R"(dialect: (\w+))"))) expected.dialect = match[1];
  if (std::regex_search(first, match, std::regex(R"(free-rotation: c-(\w+))"))) {
    expected.free_rotation = match[1] == "zero" ? FreeRotation::c_zero : FreeRotation::c_stays;
  }
  return expected;
}

void check(const Expected& expected, const Diagnostic& diagnostic) {
  INFO(to_text(diagnostic));
  CHECK(diagnostic.code == expected.code);
  CHECK(diagnostic.place.line == expected.line);
  CHECK(diagnostic.place.column == expected.column);
  CHECK_FALSE(diagnostic.help.empty());
  CHECK_FALSE(diagnostic.message.empty());
  CHECK(diagnostic.message.back() != '.');
  if (expected.line == 0) return;
  CHECK(diagnostic.place.length >= 1);
  CHECK(diagnostic.place.column <= diagnostic.place.text.size() + 1);
}

}  // namespace

TEST_CASE("programs that make no sense are refused where they stop making sense") {
  std::set<std::string> seen;
  for (const auto& entry : fs::directory_iterator(folder("bad"))) {
    INFO(entry.path());
    const Expected expected = read_expected(entry.path());
    seen.insert(expected.code);
    std::optional<Diagnostic> diagnostic;
    try {
      const InputFile file(entry.path().string());
      const Dialect& known = expected.dialect == "recognise" ? *recognise(file).dialect : dialect(expected.dialect);
      ProgramSettings settings = at_zero();
      settings.free_rotation = expected.free_rotation;
      Program program(file, known, settings);
      while (program.next() != nullptr) continue;
    } catch (const Refusal& refusal) {
      diagnostic = refusal.diagnostic();
    }
    CHECK(diagnostic.has_value());
    if (diagnostic) check(expected, *diagnostic);
  }
  for (const std::string_view code : codes::kAll) {
    INFO("no program in tests/nc/bad for " << code);
    CHECK(seen.contains(std::string(code)));
  }
  CHECK(seen.size() == codes::kAll.size());
}

TEST_CASE("tool tables that make no sense are refused where they stop making sense") {
  for (const auto& entry : fs::directory_iterator(folder("bad_tools"))) {
    INFO(entry.path());
    std::optional<Diagnostic> diagnostic;
    try {
      read_tool_table(entry.path().string());
    } catch (const Refusal& refusal) {
      diagnostic = refusal.diagnostic();
    }
    CHECK(diagnostic.has_value());
    if (diagnostic) check(read_expected(entry.path()), *diagnostic);
  }
}

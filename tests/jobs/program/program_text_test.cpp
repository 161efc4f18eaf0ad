#include "jobs/program/program_text.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using plumbline::testing::Scratch;

namespace {

std::string code_of(const std::string& bytes) {
  const Scratch scratch;
  scratch.file("p.ngc", bytes);
  try {
    jobs::refuse_unless_program_text(InputFile(scratch.path("p.ngc")));
  } catch (const Refusal& refusal) {
    CHECK(refusal.diagnostic().place.file == scratch.path("p.ngc"));
    CHECK_FALSE(refusal.diagnostic().help.empty());
    return refusal.diagnostic().code;
  }
  return {};
}

}  // namespace

TEST_CASE("what is no text is no program") {
  CHECK(code_of(std::string("\x1F\x8B\x08\x08 part.ngc", 13)) == "file-not-text");
  CHECK(code_of("PK\x03\x04" + std::string(100, 'x')) == "file-not-text");
  CHECK(code_of(std::string("\xFF\xFEG\0001\0\n\0", 8)) == "file-not-text");
  CHECK(code_of("%PDF-1.4\n1 0 obj\n") == "file-not-text");
  CHECK(code_of(std::string(64, '\0') + "G0 X1") == "file-not-text");
}

TEST_CASE("an empty file is no program") {
  CHECK(code_of("") == "file-empty");
  CHECK(code_of("\r\n  \t\n") == "file-empty");
  CHECK(code_of("\xEF\xBB\xBF\n") == "file-empty");
}

TEST_CASE("a text is a program, whatever it says") {
  CHECK(code_of("%\nO1234\nG0 X1\n%\n").empty());
  CHECK(code_of("(caf\xC3\xA9)\nG0 X1\n").empty());
  CHECK(code_of("\n").empty() == false);
  CHECK(code_of("G0 X1\n" + std::string(1, '\0') + std::string(60, 'x')).empty());
  CHECK(code_of(std::string(5000, '\n') + "G0 X1\n").empty());
}

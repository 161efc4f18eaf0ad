#include "nc/syntax/reading/block_reading.hpp"

#include <catch2/catch.hpp>

#include "nc/syntax/parsed.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

namespace {

Diagnostic refusal_to_parse(const std::string& line, std::string_view dialect_name) {
  return testing::refusal_of([&] { Parsed(line, dialect_name); });
}

}  // namespace

TEST_CASE("a comment in a line of names ends with its bracket, on the line where it begins") {
  const Parsed noted("G0 (a note) X1", "okuma");
  REQUIRE(noted.block.comments.size() == 1);
  CHECK(noted.at(noted.block.comments.front().span) == "(a note)");
  CHECK(noted.block.words.size() == 2);
  const Diagnostic open = refusal_to_parse("G0 X1 (a note", "okuma");
  CHECK(open.code == "nc-comment-open");
  CHECK(open.place.column == 7);
}

TEST_CASE("nothing but comments stands after a statement") {
  CHECK(Parsed("GOTO 10 (a note)", "fanuc").block.comments.size() == 1);
  CHECK(Parsed("GOTOF MARK ; a note", "siemens").block.comments.size() == 1);
  const Diagnostic words = refusal_to_parse("GOTO 10 X5.", "fanuc");
  CHECK(words.code == "nc-flow-control");
  CHECK(words.place.column == 9);
  CHECK(refusal_to_parse("GOTO 10", "fanuc").code.empty());
}

TEST_CASE("a second sign is refused where the control takes one") {
  const Diagnostic signs = refusal_to_parse("G0 X- -5.", "fanuc");
  CHECK(signs.code == "nc-bad-number");
  CHECK(signs.place.column == 7);
  CHECK(refusal_to_parse("G0 X-5.", "fanuc").code.empty());
}

TEST_CASE("the switch after / is a part of it where the control has several") {
  const Parsed second("/2 G0 X1.", "fanuc");
  CHECK(second.block.block_delete);
  CHECK(second.at(second.block.slash) == "/2");
  CHECK(second.block.words.size() == 2);
  CHECK(Parsed("/G0 X1").at(Parsed("/G0 X1").block.slash) == "/");
  CHECK_FALSE(Parsed("G0 X1").block.block_delete);
}

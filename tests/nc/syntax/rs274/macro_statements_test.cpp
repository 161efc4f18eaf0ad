#include "nc/syntax/rs274/macro_statements.hpp"

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/syntax/parsed.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

namespace {

FlowWord word_of(const char* line) { return Parsed(line, "fanuc").block.flow.word; }

}  // namespace

TEST_CASE("statements of macro B are found after the number of their line") {
  const Parsed jump("N10 IF [#1 GT 5] GOTO 100 (on)", "fanuc");
  CHECK(jump.block.flow.word == FlowWord::go_to);
  CHECK(jump.block.flow.values.size() == 1);
  CHECK(jump.block.flow.label != kLiteral);
  CHECK(word_of("GOTO #3") == FlowWord::go_to);
  CHECK(word_of("WHILE [#1 LT 5] DO 1") == FlowWord::begin_while);
  CHECK(word_of("DO 2") == FlowWord::begin_do);
  CHECK(word_of("END 2") == FlowWord::end_while);
  CHECK(word_of("G0 X1") == FlowWord::none);
  CHECK_THROWS_AS(word_of("IF [#1 GT 5] X3"), Refusal);
  CHECK_THROWS_AS(word_of("IF GOTO 3"), Refusal);
  CHECK_THROWS_AS(word_of("GOTO 3 X1"), Refusal);
  CHECK_THROWS_AS(word_of("DPRNT[X]"), Refusal);
}

TEST_CASE("THEN takes assignments and nothing else") {
  const Parsed then("IF [#1 GT 5] THEN #2=3", "fanuc");
  CHECK(then.block.flow.word == FlowWord::if_then);
  CHECK(then.block.settings.size() == 1);
  CHECK_THROWS_AS(word_of("IF [#1 GT 5] THEN #2=3 X1"), Refusal);
}

TEST_CASE("a program's name is written in three ways") {
  CHECK(word_of("O1234 (NAME)") == FlowWord::program);
  CHECK(word_of(":1234") == FlowWord::program);
  CHECK(word_of("<PART-1>(NAME)") == FlowWord::program);
  CHECK_THROWS_AS(word_of("<PART-1> G0"), Refusal);
}

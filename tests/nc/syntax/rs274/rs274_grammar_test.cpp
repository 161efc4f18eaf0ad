// Also o_words.cpp, whose lines are a production of this grammar.
#include "nc/syntax/rs274/rs274_grammar.hpp"

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/syntax/parsed.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

TEST_CASE("% may have text after it where the control passes over it") {
  CHECK_THROWS_AS(Parsed("% 3"), Refusal);
  CHECK(Parsed("% 3", "fanuc").block.kind == LineKind::percent);
}

TEST_CASE("switches of block skip are part of it where the control has them") {
  const Parsed skip("/2 G0", "fanuc");
  CHECK(skip.at(skip.block.slash) == "/2");
  CHECK_THROWS_AS(Parsed("/2 G0"), Refusal);
}

TEST_CASE("an O word has a label, a keyword and what the keyword takes") {
  const Parsed call("O<Pocket> CALL [1] (deep) [2+3] (end)");
  CHECK(call.block.flow.word == FlowWord::call);
  CHECK(call.at(call.block.flow.name) == "Pocket");
  CHECK(call.block.flow.values.size() == 2);
  CHECK(call.block.comments.size() == 2);
  const Parsed loop("N10 O[#1] WHILE [#2 LT 3]");
  CHECK(loop.block.flow.label != kLiteral);
  CHECK(loop.block.has_number());
  CHECK(loop.block.flow.values.size() == 1);
  CHECK(Parsed("O100").block.flow.word == FlowWord::program);
  CHECK_THROWS_AS(Parsed("O1 WHILE"), Refusal);
  CHECK_THROWS_AS(Parsed("O1 SUB G0"), Refusal);
}

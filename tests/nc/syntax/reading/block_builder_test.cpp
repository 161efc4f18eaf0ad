#include "nc/syntax/reading/block_builder.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"

using namespace plumbline;
using namespace plumbline::nc;

TEST_CASE("a letter stands once in a block, a code as often as it likes") {
  Syntax syntax;
  Block block;
  const std::string text = "X1 X2";
  block.text = text;
  BlockBuilder builder(syntax);
  builder.begin(block);
  builder.see('G', {0, 2});
  builder.see('G', {0, 2});
  builder.see('X', {0, 2});
  CHECK_THROWS_AS(builder.see('X', {3, 5}), Refusal);
  CHECK_THROWS_AS(builder.see('N', {3, 5}), Refusal);
  CHECK_THROWS_AS(builder.see('O', {3, 5}), Refusal);
  builder.see('I', {0, 2});
  CHECK_THROWS_AS(builder.see('I', {3, 5}), Refusal);
  syntax.repeated_ijk = true;
  builder.see('I', {3, 5});
  builder.begin(block);
  builder.see('X', {0, 2});
}

TEST_CASE("@ and ^ are words of the controls that have them") {
  Syntax syntax;
  Block block;
  const std::string text = "@1 ^2";
  block.text = text;
  BlockBuilder builder(syntax);
  builder.begin(block);
  CHECK_THROWS_AS(builder.see('@', {0, 2}), Refusal);
  CHECK_THROWS_AS(builder.see('^', {3, 5}), Refusal);
  syntax.polar_words = true;
  builder.see('@', {0, 2});
  builder.see('^', {3, 5});
}

TEST_CASE("what is after a ; that ends the block is a comment, or refused") {
  Syntax syntax;
  syntax.semicolon_ends = true;
  BlockBuilder builder(syntax);
  Block block;
  const auto add = [&](std::string_view text) {
    block.text = text;
    builder.begin(block);
    builder.add_comment({0, static_cast<std::uint32_t>(text.size())});
  };
  add("; (note) ;; (note)");
  CHECK(block.comments.size() == 1);
  CHECK_THROWS_AS(add("; M3"), Refusal);
  CHECK_THROWS_AS(add("; (note) M3"), Refusal);
  syntax.semicolon_ends = false;
  add("; M3");
  CHECK(block.comments.size() == 1);
}

TEST_CASE("a number has code of its own, and a declared variable is worth 0") {
  const Syntax syntax;
  Block block;
  const std::string text = "DEF INT A";
  block.text = text;
  BlockBuilder builder(syntax);
  builder.begin(block);
  CHECK(builder.add_number(7, {0, 1}) == 0);
  CHECK(block.code[0].number == 7);
  CHECK(block.code[1].operation == Operation::end);
  builder.declare({8, 9}, VariableType::whole);
  REQUIRE(block.settings.size() == 1);
  CHECK(block.settings[0].value == 2);
  CHECK(block.settings[0].type == VariableType::whole);
  CHECK(block.at(block.names[block.settings[0].name]) == "A");
  CHECK(block.code[2].number == 0);
}

#include "nc/syntax/parser.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "nc/syntax/parsed.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using nc::tests::Parsed;

TEST_CASE("words come in the order of the text, with their places and decimals") {
  const Parsed p("N10 G1X-1.250 y+.5 F 1 0 0(note)Z[#1+2];end");
  REQUIRE(p.block.words.size() == 5);
  CHECK(p.at(p.block.number) == "N10");
  CHECK(p.block.words[0].letter == 'G');
  CHECK(p.block.words[1].letter == 'X');
  CHECK(p.block.words[1].value == -1.25);
  CHECK(p.block.words[1].decimals == 3);
  CHECK(p.at(p.block.words[1].span) == "X-1.250");
  CHECK(p.block.words[2].letter == 'Y');
  CHECK(p.block.words[2].value == 0.5);
  CHECK(p.block.words[3].value == 100);
  CHECK(p.at(p.block.words[3].span) == "F 1 0 0");
  CHECK(p.block.words[4].expression != kLiteral);
  CHECK(p.at(p.block.words[4].span) == "Z[#1+2]");
  REQUIRE(p.block.comments.size() == 2);
  CHECK(p.at(p.block.comments[0].span) == "(note)");
  CHECK(p.at(p.block.comments[1].span) == ";end");
}

TEST_CASE("numbers are rounded as std::from_chars rounds them") {
  for (const char* number : {"0.1", "123456.789012345", "9007199254740993", "0.30000000000000004", "-1008", "33.353",
                             "12345678901234567890.5", "1.7976931348623157", "00000000000000000000000000001.5",
                             "0.000000000000000000000000123456789"}) {
    INFO(number);
    std::string word(number);
    word.insert(word.begin(), 'X');
    const Parsed p(word);
    CHECK(p.block.words[0].value == std::stod(number));
  }
}

TEST_CASE("% is alone on its line; / comes first") {
  CHECK(Parsed("  % ").block.kind == LineKind::percent);
  const Parsed p(" / N5 G0");
  CHECK(p.block.block_delete);
  CHECK(p.at(p.block.slash) == "/");
  CHECK(p.at(p.block.number) == "N5");
  CHECK_FALSE(Parsed("G0 X1").block.has_number());
}

TEST_CASE("settings are kept apart from words") {
  const Parsed p("#5 = [1+2] #<depth of cut> = -3 X#5");
  REQUIRE(p.block.settings.size() == 2);
  CHECK(p.at(p.block.settings[0].span) == "#5");
  CHECK(p.block.settings[1].target == kLiteral);
  CHECK(p.at(p.block.names[p.block.settings[1].name]) == "depth of cut");
  CHECK(p.block.words.size() == 1);
}

TEST_CASE("a byte order mark is allowed at the begin of the file alone") {
  CHECK(Parsed("\xEF\xBB\xBFG0 X1", "linuxcnc", 0).block.words.size() == 2);
  CHECK_THROWS_AS(Parsed("\xEF\xBB\xBFG0 X1", "linuxcnc", 100), Refusal);
}

TEST_CASE("comments may hold any byte, a block's rest not") {
  CHECK(Parsed("(M\xFC\xDF"
               "e; [#!) G0")
            .block.words.size() == 1);
  CHECK(Parsed("G0 ; \xC3\xA4 ( ( )").block.comments.size() == 1);
}

TEST_CASE("a block parsed again forgets the one before") {
  std::string text = "N1 G1 X[1] #1=2 (c)";
  Block block;
  Parser parser(dialect("linuxcnc"));
  block.text = text;
  parser.parse(block);
  const std::string other = "/";
  block.text = other;
  parser.parse(block);
  CHECK(block.words.empty());
  CHECK(block.settings.empty());
  CHECK(block.comments.empty());
  CHECK(block.code.empty());
  CHECK_FALSE(block.has_number());
  CHECK(block.block_delete);
}

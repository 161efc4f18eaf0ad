#include "nc/syntax/reading/token_cursor.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"

using namespace plumbline;
using namespace plumbline::nc;

namespace {

std::string code_of_token(const std::string& text, char goes_on = '\0') {
  Syntax syntax;
  syntax.goes_on = goes_on;
  Block block;
  block.text = text;
  TokenCursor cursor(syntax);
  cursor.begin(block, 0);
  cursor.take(lex_item);
  try {
    cursor.refuse_token("a word");
  } catch (const Refusal& refusal) {
    return refusal.diagnostic().code;
  }
}

}  // namespace

TEST_CASE("looking and peeking leave the cursor where it is, taking and passing move it on") {
  const Syntax syntax;
  const std::string text = "G1 X2";
  Block block;
  block.text = text;
  TokenCursor cursor(syntax);
  cursor.begin(block, 0);
  CHECK(cursor.peek(lex_item).letter == 'G');
  CHECK(cursor.here() == 0);
  cursor.take(lex_item);
  CHECK(cursor.is_letter(TokenKind::word, 'G'));
  CHECK(cursor.here() == 2);
  cursor.look(lex_item);
  CHECK(cursor.token().letter == 'X');
  CHECK(cursor.here() == 2);
  cursor.pass();
  CHECK(cursor.here() == 5);
  CHECK(block.at(cursor.span()) == "X2");
  cursor.take(lex_item);
  CHECK(cursor.is_at_end_of_block());
  cursor.go_to(0);
  cursor.accept(cursor.peek(lex_item));
  CHECK(cursor.token().letter == 'G');
}

TEST_CASE("a token after a line end belongs to the block where the line goes on") {
  Syntax syntax;
  const std::string text = "G1\n$X2";
  Block block;
  block.text = text;
  for (const bool goes_on : {false, true}) {
    syntax.goes_on = goes_on ? '$' : '\0';
    TokenCursor cursor(syntax);
    cursor.begin(block, 2);
    cursor.take(lex_item);
    CHECK(cursor.is_letter(TokenKind::word, 'X') == goes_on);
    CHECK(cursor.is(TokenKind::end) != goes_on);
  }
}

TEST_CASE("what cannot stand is refused for the reason that its bytes show") {
  CHECK(code_of_token("(open") == "nc-comment-open");
  CHECK(code_of_token("(a (b)") == "nc-comment-nested");
  CHECK(code_of_token(std::string("\0", 1)) == "nc-nul-byte");
  CHECK(code_of_token("\xC3") == "nc-not-ascii");
  CHECK(code_of_token(".") == "nc-bad-number");
  CHECK(code_of_token("!") == "nc-bad-character");
}

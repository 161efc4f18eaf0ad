// Tokens of a block; grammar/tokens.re says what they look like. Blanks may stand anywhere, in numbers and names too,
// except in the languages whose words may be names.
#pragma once

#include <cstdint>

namespace plumbline::nc {

enum class TokenKind : std::uint8_t {
  end,     // of the line
  word,    // letter and number
  letter,  // a letter whose value is no plain number
  number,
  comment,  // ( ) or ;
  open_comment,
  nested_comment,
  percent,
  slash,
  hash,
  equals,
  open,   // [
  close,  // ]
  name,   // < ... >
  sign,   // + or -
  operation,
  function,
  exists,
  flow,        // a keyword after O
  identifier,  // a name of two letters or more
  string,      // "text" or 'text'
  parenthesis,
  closing_parenthesis,
  comma,
  colon,
  bad,  // anything else, one byte
};

struct Token {
  TokenKind kind = TokenKind::end;
  char letter = 0;             // word, letter: upper case; sign: + or -
  std::uint8_t decimals = 0;   // word, number: digits after the point
  bool point = false;          // word, number: written with a decimal point
  std::uint8_t operation = 0;  // operation, function: an Operation; flow: a FlowWord
  double value = 0;            // word, number
  const char* begin = nullptr;
  const char* end = nullptr;
};

/// The places in a block; a letter means something else in each. A lexer reads up to a line end or a NUL, which
/// must stand after the text.
void lex_item(const char* cursor, Token& token);       // where a word begins
void lex_value(const char* cursor, Token& token);      // where a value begins
void lex_operation(const char* cursor, Token& token);  // after a value, inside brackets
void lex_flow(const char* cursor, Token& token);       // after the label of an O word
void lex_statement(const char* cursor, Token& token);  // where a line of macro B may begin with IF, WHILE, GOTO...

/// The same for languages in which words, values and codes may be names (X=LENGTH, TRAORI).
void lex_named_item(const char* cursor, Token& token);
void lex_named_value(const char* cursor, Token& token);
void lex_named_operation(const char* cursor, Token& token);

}  // namespace plumbline::nc

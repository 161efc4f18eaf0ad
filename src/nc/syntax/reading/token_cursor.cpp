#include "nc/syntax/reading/token_cursor.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {

std::string shown(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte > 0x20 && byte < 0x7F ? fmt::format("'{}'", c) : fmt::format("byte {:#04x}", byte);
}

void TokenCursor::begin(const Block& block, std::size_t at) {
  block_ = &block;
  at_ = block.text.data() + at;
}

// A line that begins with $ is more of the same block.
void TokenCursor::read(Lexer lex, Token& token) const {
  lex(at_, token);
  const char* const end = block_->text.data() + block_->text.size();
  while (syntax_->goes_on != '\0' && token.kind == TokenKind::end && token.begin < end && *token.begin == '\n') {
    lex(token.begin + 2, token);
  }
}

// Blanks that a token runs over may belong to the line end: a lone CR is a blank.
Span TokenCursor::span_of(const Token& token) const {
  const char* const begin = block_->text.data();
  const auto offset = [&](const char* at) {
    return static_cast<std::uint32_t>(std::min(static_cast<std::size_t>(at - begin), block_->text.size()));
  };
  return {offset(token.begin), offset(token.end)};
}

void TokenCursor::pass_digits() {
  while (is_digit(*at_)) ++at_;
}

void TokenCursor::refuse(Span span, std::string_view code, std::string message, std::string help) const {
  refuse_at(*block_, span, code, std::move(message), std::move(help));
}

void TokenCursor::refuse_token(std::string_view expected) const {
  const Span place = span();
  const char c = is(TokenKind::end) ? '\0' : *token_.begin;
  refuse_damage(place);
  refuse_byte(place, c);
  if (c == '\'' && syntax_->word_modes) {
    refuse(place, codes::kNotInterpreted,
           "numbers in hexadecimal and binary digits ('HFF', 'B101') are not interpreted",
           "write it in decimal digits, as in R6=255");
  }
  if (expected == "a value" && syntax_->statements == Statements::o_words) refuse_macro_statement(place);
  if (expected == "a value" && plumbline::lower(c) == 'n' && syntax_->statements == Statements::macro_b) {
    const std::string before = upper(without_blanks(block_->text.substr(0, place.begin)));
    if (before.ends_with("GOTO")) {
      refuse(place, codes::kValueMissing, "GOTO takes the number of the block, and not its word",
             "write it without the N, as in GOTO 10");
    }
  }
  if (expected == "a value" && c != '.' && c != '<') {
    refuse(place, codes::kValueMissing,
           plumbline::is_letter(c) ? "this is no value, and no function that is known here" : "a value is missing here",
           !syntax_->names        ? "write a number, [expression], #parameter or function"
           : syntax_->open == '(' ? "write a number, or = and a number, a variable, a function or (expression)"
                                  : "write a number, or = and a number, a variable, a function or [expression]");
  }
  if (is_at_end_of_block())
    refuse(place, codes::kBadCharacter, "the block ends where something is missing",
           fmt::format("expected {}", expected));
  if (c == '/' && expected == "a word") {
    refuse(place, codes::kBadCharacter, "/ leaves a block out where it begins the line, and this one does not",
           "write it before the N, as in /N10 X5.; what is to be left out is a block of its own");
  }
  if (c == ':' && expected == "a word" && syntax_->labels == Labels::names) {
    refuse(place, codes::kBadCharacter, "this is no label: their names begin with two letters",
           "rename it, as in LABEL1:, also where the program goes to it");
  }
  if (c == '.') refuse(place, codes::kBadNumber, "this is no number", "write digits before or after one point");
  refuse(place, codes::kBadCharacter, fmt::format("{} cannot stand here", shown(c)),
         fmt::format("expected {}", expected));
}

// IF [#1 EQ 1] GOTO 10, WHILE [#1 LT 3] DO 1, in a program for LinuxCNC.
void TokenCursor::refuse_macro_statement(Span span) const {
  std::string text = upper(without_blanks(block_->text));
  const std::size_t at = text.starts_with('N') ? text.find_first_not_of("0123456789", 1) : 0;
  text = at == std::string::npos ? std::string() : text.substr(at);
  for (const std::string_view keyword : {"IF[", "WHILE[", "GOTO", "DO", "END"}) {
    if (!text.starts_with(keyword)) continue;
    refuse(span, codes::kValueMissing, "LinuxCNC branches and loops by O words, and not by IF, WHILE and GOTO",
           "write it as in o1 if [#1 EQ 1], or name the control that the program is for: --dialect fanuc");
  }
}

void TokenCursor::refuse_damage(Span span) const {
  const std::string_view text = block_->text;
  const std::size_t nul = text.find('\0', std::min<std::size_t>(span.begin, text.size()));
  if (nul != std::string_view::npos) {
    const auto at = static_cast<std::uint32_t>(nul);
    refuse({at, at + 1}, codes::kNulByte, "a NUL byte in the program",
           "the file is damaged or no text; fetch it again from where it came");
  }
  if (is(TokenKind::open_comment)) {
    refuse(span, codes::kCommentOpen, "the comment ( is not closed", "add the missing )");
  }
  if (is(TokenKind::nested_comment)) {
    refuse(span, codes::kCommentNested, "a comment inside a comment",
           "comments in ( ) do not nest; take out the inner (");
  }
}

// Bytes that say what was meant.
void TokenCursor::refuse_byte(Span span, char c) const {
  if (c == ',' && syntax_->comma_corners) {
    refuse(span, codes::kNotInterpreted,
           "a comma begins what the control works out itself: a chamfer (,C), a rounding (,R) or an angle (,A)",
           "let the CAM system write the corner in G1, G2 and G3");
  }
  if (static_cast<unsigned char>(c) >= 0x80) {
    refuse(span, codes::kNotAscii, fmt::format("{} outside a comment", shown(c)),
           "only comments may hold anything but ASCII characters");
  }
  if (c == '$' && syntax_->names) {
    refuse(span, codes::kNotInterpreted,
           "names that begin with $ are variables of the control itself, which are not interpreted",
           "they read or set what only this machine has; write the values themselves");
  }
}

}  // namespace plumbline::nc

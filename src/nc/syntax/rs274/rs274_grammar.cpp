#include "nc/syntax/rs274/rs274_grammar.hpp"

#include <algorithm>

#include "nc/language/codes.hpp"
#include "nc/syntax/rs274/macro_statements.hpp"
#include "nc/syntax/rs274/o_words.hpp"
#include "nc/syntax/rs274/rs274_values.hpp"

namespace plumbline::nc {
namespace {

// G0 15. would be G15: more likely a letter is missing than a blank too many (macro B).
void refuse_blank_in_number(const BlockReading& in) {
  if (in.syntax->statements != Statements::macro_b) return;
  const std::string_view text = in.out.at(in.cursor.span());
  if (text.find_first_of(" \t") == std::string_view::npos) return;
  const std::size_t first = text.find_first_of("+-.0123456789");
  const std::size_t blank = text.find_first_of(" \t", std::min(first, text.size()));
  if (blank == std::string_view::npos || text.find_first_of(".0123456789", blank) == std::string_view::npos) return;
  const auto at = in.cursor.span().begin + static_cast<std::uint32_t>(blank);
  in.cursor.refuse({at, at + 1}, codes::kBadNumber, "a blank inside a number",
                   "take it out, or add the letter that is missing behind it");
}

// X1.y5. would be X1.5.
void refuse_small_letters(const BlockReading& in) {
  const std::string_view text = in.out.block().text;
  for (std::size_t at = 0; at < text.size() && text[at] != ';'; ++at) {
    if (text[at] == '(') at = text.find(')', at);
    if (at == std::string_view::npos) return;
    if (text[at] < 'a' || text[at] > 'z') continue;
    const auto begin = static_cast<std::uint32_t>(at);
    in.cursor.refuse(
        {begin, begin + 1}, codes::kBadCharacter,
        "the control drops small letters where it reads a program in, and what is left is another block",
        "write it in capital letters (comments may have any), or name the control that it is for: --dialect");
  }
}

void line_number(BlockReading& in) {
  const Token& token = in.cursor.token();
  const Span span = in.cursor.span();
  in.out.set_number(span);
  if (token.kind == TokenKind::letter || token.begin[1] == '-' || token.begin[1] == '+') {
    in.cursor.refuse(span, codes::kLineNumber, "N without a line number", "write digits after the N, or leave it out");
  }
  if (token.point && in.syntax->statements != Statements::o_words) {
    in.cursor.refuse(span, codes::kLineNumber, "the number of a block has no point", "write N and digits alone");
  }
}

// word = letter , real value
void word(BlockReading& in) {
  const Span span = in.cursor.span();
  const char letter = in.cursor.token().letter;
  in.out.see(letter, span);
  const std::uint32_t code = read_value(in);
  in.out.add({letter, 0, code, {span.begin, in.cursor.here()}, 0, false, false, false, WordMode::modal});
}

// setting = "#" , ( name | real value ) , "=" , real value
void setting(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  Setting setting;
  setting.span = cursor.span();
  cursor.look(lex_value);
  if (cursor.is(TokenKind::name)) {
    cursor.pass();
    setting.name = read_name(in);
  } else {
    setting.target = read_value(in);
  }
  setting.span.end = cursor.here();
  cursor.take(lex_item);
  if (!cursor.is(TokenKind::equals)) {
    cursor.refuse(setting.span, codes::kAssignment, "a parameter stands here without a word or a value",
                  "set it as in #5 = 3, or write the letter that its value is for");
  }
  setting.value = in.syntax->open_assignment ? read_open_value(in) : read_value(in);
  setting.whole = {setting.span.begin, cursor.here()};
  in.out.add_setting(setting);
}

// M98 <NAME> and G65 <NAME> call a program by its name.
[[noreturn]] void refuse_item(BlockReading& in) {
  const std::string_view rest = in.out.block().text.substr(in.cursor.span().begin);
  if (in.syntax->statements == Statements::macro_b && rest.starts_with('<')) {
    in.cursor.refuse(in.cursor.span(), codes::kNotInterpreted,
                     "a program is called by its name here, which is not interpreted",
                     "give it a number, as O1234, and call it with M98 P1234 or G65 P1234");
  }
  in.cursor.refuse_token("a word");
}

// items = { word | setting | comment }; token() is the first
void items(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  for (;; cursor.take(lex_item)) {
    switch (cursor.token().kind) {
      case TokenKind::word:
        refuse_blank_in_number(in);
        in.out.add_literal(cursor.token(), cursor.span());
        break;
      case TokenKind::letter:
        word(in);
        break;
      case TokenKind::comment:
        in.out.add_comment(cursor.span());
        break;
      case TokenKind::hash:
        setting(in);
        break;
      case TokenKind::end:
        if (!cursor.is_at_end_of_block()) cursor.refuse_token("a word");
        return;
      default:
        refuse_item(in);
    }
  }
}

}  // namespace

void read_rs274_block(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  const auto begins_with = [&](char letter) {
    return cursor.token().letter == letter && (cursor.is(TokenKind::word) || cursor.is(TokenKind::letter));
  };
  cursor.take(lex_item);
  if (cursor.is(TokenKind::percent)) return read_percent(in);
  if (in.syntax->capitals) refuse_small_letters(in);
  if (cursor.is(TokenKind::slash)) {
    read_block_skip(in);
    cursor.take(lex_item);
  }
  if (begins_with('N')) {
    line_number(in);
    cursor.take(lex_item);
  }
  const bool macro_b = in.syntax->statements == Statements::macro_b;
  const MacroLine line = macro_b ? read_macro_statement(in) : MacroLine::words;
  if (line == MacroLine::whole) return;
  if (line == MacroLine::words && begins_with('O')) return read_o_word(in);
  items(in);
  if (macro_b) check_assignment_alone(in, line == MacroLine::assignments);
}

}  // namespace plumbline::nc

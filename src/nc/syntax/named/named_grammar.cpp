#include "nc/syntax/named/named_grammar.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/syntax/named/named_calls.hpp"
#include "nc/syntax/named/named_statements.hpp"
#include "nc/syntax/named/named_values.hpp"
#include "nc/syntax/named/named_words.hpp"
#include "nc/syntax/reading/archive_head.hpp"

namespace plumbline::nc {
namespace {

using Kind = NameMeaning::Kind;

bool means(const NameMeaning* meaning, Kind kind) { return meaning != nullptr && meaning->kind == kind; }

[[noreturn]] void refuse_goes_on(const BlockReading& in, std::uint32_t at) {
  const char goes_on = in.syntax->goes_on;
  in.cursor.refuse({at, at + 1}, codes::kBadCharacter,
                   fmt::format("{} goes on with the block of the line before, and there is none", goes_on),
                   fmt::format("take the {} away, or end the head of the program with %", goes_on));
}

// $NAME.MIN%
void header(BlockReading& in) {
  const std::string_view text = in.out.block().text;
  if (text[text.find_last_not_of(" \t\r")] != '%') refuse_goes_on(in, 0);
  in.out.set_kind(LineKind::percent);
}

// /$ Y5
void refuse_skipped_rest(const BlockReading& in) {
  const std::string_view text = in.out.block().text;
  const std::size_t at = text.find_first_not_of(" \t/0123456789");
  if (in.syntax->goes_on == '\0' || at == std::string_view::npos || text[at] != in.syntax->goes_on) return;
  in.cursor.refuse({0, static_cast<std::uint32_t>(at + 1)}, codes::kNotInterpreted,
                   "whether a part of a block can be left out was found in no source",
                   "write the block on one line, and the / before it");
}

// A line that goes on needs words before it to go on with.
void check_goes_on(const BlockReading& in) {
  const std::string_view text = in.out.block().text;
  const std::size_t next = in.syntax->goes_on == '\0' ? std::string_view::npos : text.find('\n');
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (next != std::string_view::npos && (first == next || text[first] == '(')) {
    refuse_goes_on(in, static_cast<std::uint32_t>(next + 1));
  }
}

// NCYL and NOEX are codes, whatever else begins with N a label.
bool is_code_by_name(const BlockReading& in) {
  return means(in.dialect->meaning(in.out.at(in.cursor.span())), Kind::code);
}

// number = "N" , ( number | name ) | ":" , number; token() is what stands after it
// NG0Z50: a name has one to four characters behind N, and a blank behind it [G 3.1].
void check_sequence_name(const BlockReading& in, Span name) {
  constexpr std::uint32_t kMost = 5;
  const std::string text = upper(in.out.at(name));
  const bool is_code = text.size() > 2 && (text[1] == 'G' || text[1] == 'M') && is_digit(text[2]);
  if (text.size() <= kMost && !is_code) return;
  in.cursor.refuse(
      name, codes::kLineNumber,
      fmt::format("{} is the name of this line, as whatever begins with N at its begin, and such a name has "
                  "up to four characters behind the N",
                  in.out.at(name)),
      "write a blank behind the name where words follow, or a shorter name, here and where the program "
      "goes to it");
}

void block_number(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  const bool may_be_name = in.syntax->labels == Labels::sequence_names;
  Span number = cursor.span();
  if (cursor.is_letter(TokenKind::word, 'N')) {
    if (cursor.token().begin[1] == '-' || cursor.token().begin[1] == '+') {
      cursor.refuse(number, codes::kLineNumber, "N without a line number", "write digits after the N");
    }
    if (cursor.token().point) {
      cursor.refuse(number, codes::kLineNumber, "the number of a block has no point", "write N and digits alone");
    }
  } else if (cursor.is(TokenKind::colon) && is_digit(cursor.next_byte())) {
    if (may_be_name) {
      cursor.refuse(number, codes::kBadCharacter, ": before the number of a block was found in no source",
                    "write N and the number");
    }
    cursor.pass_digits();
    number.end = cursor.here();
  } else if (!may_be_name || !cursor.is(TokenKind::identifier) || upper(*cursor.token().begin) != 'N' ||
             is_code_by_name(in)) {
    return;
  }
  if (cursor.is(TokenKind::identifier)) check_sequence_name(in, number);
  in.out.set_number(number);
  cursor.take(lex_named_item);
  if (!may_be_name || !cursor.is(TokenKind::equals)) return;
  cursor.refuse(number, codes::kAssignment,
                fmt::format("{} is the name of this line, as whatever begins with N at its begin, and no variable",
                            in.out.at(number)),
                "give the variable a name that does not begin with N");
}

// The line is the name of a program: O1000; OMIT belongs to a pattern of holes.
bool program_name(BlockReading& in) {
  const char letter = in.syntax->program_letter;
  const bool is_name = in.cursor.is(TokenKind::identifier) || in.cursor.is(TokenKind::word);
  if (letter == '\0' || !is_name || upper(*in.cursor.token().begin) != letter || is_code_by_name(in)) {
    return false;
  }
  const Span name = in.cursor.span();
  in.out.begin_flow(FlowWord::program, name).name = name;
  end_of_statement(in);
  return true;
}

// label = name , ":"
void block_label(BlockReading& in) {
  if (in.syntax->labels != Labels::names || !in.cursor.is(TokenKind::identifier)) return;
  if (!item_follows(in, TokenKind::colon)) return;
  in.out.add_name(in.cursor.span());
  in.cursor.take(lex_named_item);
  in.cursor.take(lex_named_item);
}

// word = letter , number | letter , number , "=" , value
void named_word(BlockReading& in) {
  const Span span = in.cursor.span();
  if (item_follows(in, TokenKind::equals)) {
    const NameMeaning* const meaning = in.dialect->meaning(in.out.at(span));
    if (means(meaning, Kind::code)) return read_named_code(in, span, meaning->which);
    if (means(meaning, Kind::address)) return read_address(in, *meaning, span);
    return read_assigned_variable(in, span, meaning);
  }
  const char letter = in.cursor.token().letter;
  if (letter == in.syntax->call_letter) return read_call_by_name(in, span);
  if (means(in.dialect->meaning({&letter, 1}), Kind::variable)) {
    in.cursor.refuse(span, codes::kAssignment, "a variable stands here without a word or a value",
                     fmt::format("set it as in {}1=3, or write the word that its value is for", letter));
  }
  in.out.add_literal(in.cursor.token(), span);
}

// word = letter , "=" , value
void named_letter(BlockReading& in) {
  const Span span = in.cursor.span();
  const char letter = in.cursor.token().letter;
  const NameMeaning* const meaning = in.dialect->meaning({&letter, 1});
  if (means(meaning, Kind::variable)) return read_assigned_variable(in, span, meaning);
  in.cursor.look(lex_named_item);
  if (in.cursor.is(TokenKind::open) && in.syntax->word_modes) {  // G[1]=2, F[X]=100
    in.cursor.refuse(span, codes::kNotInterpreted,
                     fmt::format("{}[..] chooses by what stands in its brackets, which is not interpreted", letter),
                     letter == 'G' ? "write the code itself, as in G17" : "write the word itself, without brackets");
  }
  if (!in.cursor.is(TokenKind::equals)) in.cursor.refuse_token("a value");
  const bool takes_none = letter == 'G' || letter == 'N' || letter == in.syntax->call_letter;
  if (takes_none && in.syntax->statements == Statements::high_level) {
    in.cursor.refuse(span, codes::kAssignment, fmt::format("{} takes no value behind =, as N, G and L do", letter),
                     "write the code itself, and choose between codes by IF");
  }
  if (letter == 'G' && in.syntax->statements == Statements::user_task) {
    in.cursor.refuse(span, codes::kNotInterpreted, "whether G takes a value behind = was found in no source",
                     "write the code itself, as in G1, and choose between codes by IF");
  }
  in.cursor.pass();
  read_assigned_word(in, letter, span);
}

void identifier(BlockReading& in) {
  const Span span = in.cursor.span();
  const NameMeaning* const meaning = in.dialect->meaning(in.out.at(span));
  if (means(meaning, Kind::code)) return read_named_code(in, span, meaning->which);
  if (means(meaning, Kind::keyword)) return read_named_statement(in, static_cast<FlowWord>(meaning->which));
  if (means(meaning, Kind::address)) return read_address(in, *meaning, span);
  const bool assigns = item_follows(in, TokenKind::equals) || item_follows(in, TokenKind::open);
  if (!assigns && in.syntax->calls_by_name) return read_call_by_name(in, span);
  read_assigned_variable(in, span, meaning);
}

// item = word | setting | code | comment | statement; false: it is the end of the block
bool named_item(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  switch (cursor.token().kind) {
    case TokenKind::word:
      named_word(in);
      return true;
    case TokenKind::letter:
      named_letter(in);
      return true;
    case TokenKind::identifier:
      identifier(in);
      return true;
    case TokenKind::comment:
      in.out.add_comment(cursor.span());
      return true;
    case TokenKind::parenthesis:
      if (in.syntax->open == '(') break;
      pass_comment(in);
      return true;
    case TokenKind::end:
      if (!cursor.is_at_end_of_block()) break;
      return false;
    default:
      break;
  }
  cursor.refuse_token("a word");
}

[[noreturn]] void refuse_drawing_skipped(const BlockReading& in) {
  const std::string_view text = in.out.block().text;
  in.cursor.refuse(
      {0, static_cast<std::uint32_t>(text.size())}, codes::kNotInterpreted,
      "whether the shape that is drawn (DEF WORK to END) is left out with this line was found in no source",
      "take the / away: the shape moves nothing");
}

[[noreturn]] void refuse_drawing_open(const BlockReading& in) {
  const std::string_view text = in.out.block().text;
  in.cursor.refuse({0, static_cast<std::uint32_t>(text.size())}, codes::kFlowOpen,
                   "DEF WORK begins a shape that is drawn, which has not ended before this line",
                   "write END behind the last line of the shape, as in PS LC,[0,0,0],[100,100,50]");
}

// PS LC,[0,0,0],[100,100,50]: two letters that mean nothing else, and no value is set.
bool is_shape(const BlockReading& in, std::string_view statement) {
  const std::size_t end = std::min(statement.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), statement.size());
  if (end < 2 || end == statement.size() || statement[end] == '=' || is_digit(statement[end])) return false;
  for (std::size_t length = 2; length <= end; ++length) {
    if (in.dialect->meaning(statement.substr(0, length)) != nullptr) return false;
  }
  return statement.front() != in.syntax->program_letter;
}

}  // namespace

// DEF WORK ... END: the shape that the control draws.
bool NamedGrammar::draws(const BlockReading& in) {
  const std::string_view text = in.out.block().text;
  std::string words;
  for (const char c : text.substr(0, text.find('('))) {
    if (!is_blank(c)) words += upper(c);
  }
  std::size_t at = words.starts_with('N') ? words.find_first_not_of("0123456789", 1) : 0;
  at = at == 1 ? 0 : std::min(at, words.size());  // NEND is a name
  const std::string_view statement = std::string_view(words).substr(at);
  if (!drawing_) {
    if (words.starts_with('/') && words.find("DEFWORK") != std::string::npos) refuse_drawing_skipped(in);
    return drawing_ = statement == "DEFWORK";
  }
  if (!statement.empty() && statement != "END" && !is_shape(in, statement)) refuse_drawing_open(in);
  drawing_ = statement != "END";
  return true;
}

void NamedGrammar::read(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  const std::string_view text = in.out.block().text;
  if (in.syntax->goes_on != '\0' && text.starts_with(in.syntax->goes_on)) return header(in);
  check_goes_on(in);
  if (in.syntax->draws && draws(in)) return in.out.set_kind(LineKind::ignored);
  cursor.take(lex_named_item);
  if (cursor.is(TokenKind::percent)) {
    if (!in.syntax->archive_heads || !is_archive_head(text.substr(cursor.span().begin))) return read_percent(in);
    const Span name{cursor.span().begin, static_cast<std::uint32_t>(text.size())};  // %_N_NAME_MPF
    in.out.begin_flow(FlowWord::program, name).name = name;
    return;
  }
  const auto read_slash = [&] {
    if (!cursor.is(TokenKind::slash)) return;
    refuse_skipped_rest(in);
    read_block_skip(in);
    cursor.take(lex_named_item);
  };
  read_slash();
  block_number(in);
  // "only at the start of the block or directly after the sequence name" [G 3.1]
  const bool behind_name = in.syntax->labels == Labels::sequence_names && in.out.block().has_number();
  if (behind_name && !in.out.block().block_delete) read_slash();
  if (program_name(in)) return;
  block_label(in);
  while (named_item(in) && in.out.flow().word == FlowWord::none) cursor.take(lex_named_item);
}

}  // namespace plumbline::nc

#include "nc/syntax/reading/block_reading.hpp"

#include <fmt/format.h>

#include "nc/language/codes.hpp"

namespace plumbline::nc {

void pass_comment(BlockReading& in) {
  const Span open = in.cursor.span();
  const std::string_view text = in.out.block().text;
  const std::size_t close = text.find_first_of(")\n", open.begin);
  if (close == std::string_view::npos || text[close] == '\n') {
    in.cursor.refuse(open, codes::kCommentOpen, "the comment ( is not closed", "add the missing )");
  }
  in.out.add_any_comment({open.begin, static_cast<std::uint32_t>(close + 1)});
  in.cursor.go_to(close + 1);
}

void end_of_statement(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  const auto lex = in.syntax->names ? lex_named_item : lex_item;
  const bool in_brackets = in.syntax->open != '(';  // else RET("LABEL") is no comment
  for (cursor.take(lex);; cursor.take(lex)) {
    if (cursor.is(TokenKind::comment)) {
      in.out.add_comment(cursor.span());
    } else if (in_brackets && cursor.is(TokenKind::parenthesis)) {
      pass_comment(in);
    } else {
      break;
    }
  }
  if (cursor.is_at_end_of_block()) return;
  cursor.refuse_damage(cursor.span());
  cursor.refuse(cursor.span(), codes::kFlowControl, "nothing but a comment stands after this",
                "write words into a block of their own");
}

void read_percent(BlockReading& in) {
  in.out.set_kind(LineKind::percent);
  in.cursor.take(lex_item);
  if (in.cursor.is(TokenKind::end) || in.syntax->percent_text) return;
  in.cursor.refuse(in.cursor.span(), codes::kPercentText, "text after %",
                   "leave % alone on its line; the control refuses anything else there");
}

// X--5
void refuse_second_sign(const BlockReading& in) {
  if (!in.syntax->one_sign) return;
  const std::string_view text = in.out.block().text;
  const std::size_t next = text.find_first_not_of(" \t\r", in.cursor.here());
  if (next == std::string_view::npos || (text[next] != '-' && text[next] != '+')) return;
  const auto begin = static_cast<std::uint32_t>(next);
  in.cursor.refuse({begin, begin + 1}, codes::kBadNumber, "two signs in a row", "leave one of them");
}

// block skip = "/" , [ digits ]: the numbers are switches of the control, which here are one
void read_block_skip(BlockReading& in) {
  Span slash = in.cursor.span();
  if (in.syntax->skip_switches) {
    in.cursor.pass_digits();
    slash.end = in.cursor.here();
    if (slash.end - slash.begin > 2) {
      in.cursor.refuse(slash, codes::kNotInterpreted, "a switch of block skip has one digit",
                       "write a blank behind it where a value follows, or / alone");
    }
  }
  in.out.set_slash(slash);
}

namespace {

bool tells_conditions(const Syntax& syntax) { return syntax.statements == Statements::macro_b || syntax.truths_only; }

}  // namespace

void need_number(const BlockReading& in, ValueKind kind, Span span) {
  if (kind == ValueKind::number || !tells_conditions(*in.syntax)) return;
  in.cursor.refuse(span, codes::kOperator, "a condition stands here where a number is needed",
                   "a condition stands behind IF (or WHILE) alone: jump by it, and set the value in a line of its own");
}

void need_condition(const BlockReading& in, ValueKind kind, Span span) {
  if (kind == ValueKind::condition || !tells_conditions(*in.syntax)) return;
  const bool macro_b = in.syntax->statements == Statements::macro_b;
  in.cursor.refuse(
      span, codes::kFlowControl, "a number stands here, and no condition",
      fmt::format("write what it is compared with, as in {}",
                  macro_b ? "IF [#1 NE 0] GOTO 100"
                          : "IF [VC1 NE 0] N100; whether a name was set is asked by IF [NAME NE EMPTY] N100"));
}

ValueKind joined_kind(const BlockReading& in, Operation operation, Span span, ValueKind left, ValueKind right) {
  const bool of_bits = operation >= Operation::bit_and && operation <= Operation::bit_exclusive_or;
  const bool joins = of_bits || operation == Operation::logical_and || operation == Operation::logical_or ||
                     operation == Operation::exclusive_or;
  if (joins && left == ValueKind::condition && right == ValueKind::condition) return left;
  need_number(in, left, span);
  need_number(in, right, span);
  return is_relation(operation) ? ValueKind::condition : ValueKind::number;
}

}  // namespace plumbline::nc

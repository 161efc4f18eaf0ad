#include "nc/syntax/named/named_statements.hpp"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/syntax/named/named_calls.hpp"
#include "nc/syntax/named/named_values.hpp"
#include "nc/syntax/named/named_words.hpp"

namespace plumbline::nc {
namespace {

// GOTOF, GOTOB; a label after the condition itself may stand anywhere
Direction direction_of(std::string_view keyword) {
  if (keyword.empty()) return Direction::both;
  const char last = upper(keyword.back());
  return last == 'F' ? Direction::forward : last == 'B' ? Direction::backward : Direction::both;
}

Span jump_label(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  cursor.take(lex_named_item);
  const bool sequence_names = in.syntax->labels == Labels::sequence_names;
  const bool is_number = cursor.is_letter(TokenKind::word, 'N');
  const bool is_name = cursor.is(TokenKind::identifier) && (!sequence_names || upper(*cursor.token().begin) == 'N');
  if (cursor.is(TokenKind::string)) {
    cursor.refuse(cursor.span(), codes::kNotInterpreted, "a label that is given as a text is not interpreted",
                  "write the label itself, without quotes; between several choose by CASE, or by an IF for each");
  }
  if (cursor.is(TokenKind::word) && !is_number && !sequence_names) {
    cursor.refuse(cursor.span(), codes::kFlowControl,
                  fmt::format("{} is no label: their names begin with two letters", in.out.at(cursor.span())),
                  "rename it, as in GOTOF LABEL1");
  }
  if (!is_number && !is_name) {
    cursor.refuse(in.out.flow().span, codes::kFlowControl, "the label to go on at is missing after this",
                  sequence_names
                      ? "write it as in IF [VC1 GT 5] N100, or GOTO NEND: behind a condition stands where to "
                        "go on, and nothing else"
                      : "write it as in GOTOF ENDE, or GOTOB N100");
  }
  return cursor.span();
}

bool goto_follows(BlockReading& in) {
  const Token next = in.cursor.peek(lex_named_item);
  if (next.kind != TokenKind::identifier) return false;
  const NameMeaning* const meaning = in.dialect->meaning({next.begin, static_cast<std::size_t>(next.end - next.begin)});
  if (meaning == nullptr || meaning->kind != NameMeaning::Kind::keyword) return false;
  if (static_cast<FlowWord>(meaning->which) != FlowWord::go_to) return false;
  in.cursor.accept(next);
  return true;
}

// IF [PB EQ EMPTY] NE: the label is read as an operation.
void refuse_label_of_operation(const BlockReading& in) {
  if (in.syntax->labels != Labels::sequence_names) return;
  const std::string_view text = in.out.block().text.substr(0, in.out.block().text.find('('));
  const std::size_t end = text.find_last_not_of(" \t\r;") + 1;
  if (end < 3 || upper(text.substr(end - 2, 2)) != "NE" || text.find_last_not_of(" \t", end - 3) == std::string::npos ||
      text[text.find_last_not_of(" \t", end - 3)] != ']') {
    return;
  }
  in.cursor.refuse({static_cast<std::uint32_t>(end - 2), static_cast<std::uint32_t>(end)}, codes::kFlowControl,
                   "NE compares two values, and is read as no label here", "give the label another name, as in NEND");
}

// IF R1==1 GOTOF LABEL1 IF R1==2 GOTOF LABEL2
void refuse_second_condition(const BlockReading& in) {
  const Token next = in.cursor.peek(lex_named_item);
  if (next.kind != TokenKind::identifier || upper({next.begin, next.end}) != "IF") return;
  in.cursor.refuse(in.cursor.span_of(next), codes::kNotInterpreted,
                   "several conditions in one block are not interpreted",
                   "write each IF with its jump into a block of its own");
}

// IF R1=1 GOTOF LABEL1; IF R1==1 THEN, as other languages have it
void refuse_other_language(const BlockReading& in) {
  const Token next = in.cursor.peek(lex_named_item);
  if (in.syntax->statements != Statements::high_level) return;
  if (next.kind == TokenKind::equals) {
    in.cursor.refuse(in.cursor.span_of(next), codes::kFlowControl, "a single = sets a value, and compares none",
                     "write == to compare, <> for other values, >= and <= with the = behind");
  }
  if (next.kind != TokenKind::identifier || upper({next.begin, next.end}) != "THEN") return;
  in.cursor.refuse(in.cursor.span_of(next), codes::kFlowControl, "the control has no THEN",
                   "leave it out: GOTOF and a label stand in the block of IF, all else in blocks of their own before "
                   "ENDIF");
}

// IF VC1 EQ 1 N5: all that is known of an OSP has the condition in brackets [K].
void need_bracket(BlockReading& in) {
  if (in.syntax->open != '[' || item_follows(in, TokenKind::open)) return;
  in.cursor.refuse(in.out.flow().span, codes::kFlowControl, "the condition behind IF stands in no brackets",
                   "write it as in IF [VC1 EQ 1] N100");
}

// jump = [ "IF" , value ] , ( "GOTO" , label | label | ) ; without either it begins a branch
void named_jump(BlockReading& in, bool conditional) {
  Flow& flow = in.out.flow();
  Span keyword = flow.span;
  if (conditional) {
    refuse_label_of_operation(in);
    need_bracket(in);
    flow.values.push_back(read_named_condition(in));
    refuse_other_language(in);
    if (in.syntax->branches) refuse_unread_keyword(in, in.cursor.span_of(in.cursor.peek(lex_named_item)));
    const bool jumps = goto_follows(in);
    if (!jumps && in.syntax->branches) return;
    keyword = jumps ? in.cursor.span() : Span{};
  }
  flow.word = FlowWord::go_to;
  flow.direction = direction_of(in.out.at(keyword));
  flow.name = jump_label(in);
  if (conditional) refuse_second_condition(in);
}

// for = "FOR" , variable , "=" , value , "TO" , value
void for_statement(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  cursor.take(lex_named_item);
  const bool is_variable =
      cursor.is(TokenKind::identifier) || cursor.is(TokenKind::word) || cursor.is(TokenKind::letter);
  if (!is_variable) cursor.refuse_token("a variable");
  const Span name = cursor.span();
  read_assigned_variable(in, name, in.dialect->meaning(in.out.at(name)));
  if (read_keyword(in) != "TO") {
    cursor.refuse(in.out.flow().span, codes::kFlowControl, "TO is missing in this loop",
                  "write it as in FOR R1=1 TO 10");
  }
  in.out.flow().values.push_back(read_named_value(in));
}

// choice = ( constant | "DEFAULT" ) , jump
Choice choice(BlockReading& in, const Token& next) {
  Choice choice;
  if (next.kind == TokenKind::identifier && upper({next.begin, next.end}) == "DEFAULT") {
    in.cursor.go_after(next);
  } else {
    choice.value = read_named_value(in);
  }
  const std::string jump = read_keyword(in);
  if (jump != "GOTO" && jump != "GOTOF" && jump != "GOTOB") {
    in.cursor.refuse(in.out.flow().span, codes::kFlowControl, "a choice goes nowhere",
                     "write GOTOF or GOTOB and a label after each constant");
  }
  choice.direction = direction_of(jump);
  choice.label = in.out.flow().name = jump_label(in);
  return choice;
}

// case = "CASE" , value , "OF" , { choice }
void case_statement(BlockReading& in) {
  Flow& flow = in.out.flow();
  flow.values.push_back(read_named_value(in));
  if (read_keyword(in) != "OF") {
    in.cursor.refuse(flow.span, codes::kFlowControl, "OF is missing in this choice",
                     "write it as in CASE R1 OF 1 GOTOF ONE 2 GOTOF TWO DEFAULT GOTOF REST");
  }
  while (true) {
    const Token next = in.cursor.peek(lex_named_item);
    if (next.kind == TokenKind::end || next.kind == TokenKind::comment) return;
    if (!flow.choices.empty() && flow.choices.back().value == kLiteral) {
      in.cursor.refuse(in.cursor.span_of(next), codes::kFlowControl, "a choice stands after DEFAULT",
                       "write DEFAULT as the last one");
    }
    flow.choices.push_back(choice(in, next));
  }
}

// repeat = "REPEAT" , [ label , [ label ] , [ "P" , [ "=" ] , count ] ] | "REPEATB" , label , [ "P" , ... ]
void repeat_statement(BlockReading& in, bool block_alone) {
  TokenCursor& cursor = in.cursor;
  Flow& flow = in.out.flow();
  Token next = cursor.peek(lex_named_item);
  for (; next.kind == TokenKind::identifier; next = cursor.peek(lex_named_item)) {
    flow.choices.push_back({.label = cursor.span_of(next), .direction = Direction::backward});
    cursor.go_after(next);
  }
  if (flow.choices.empty() && !block_alone) return;
  if (flow.choices.empty() || flow.choices.size() > (block_alone ? 1U : 2U)) {
    cursor.refuse(flow.span, codes::kFlowControl,
                  "this repeats a part of the program, whose labels are missing or too many",
                  "write it as in REPEAT BEGIN P=3, REPEAT BEGIN LAST P=3 or REPEATB HOLE P=3");
  }
  flow.word = block_alone ? FlowWord::repeat_line : FlowWord::repeat_section;
  read_passes(in);
}

// "EXTERN" , name , [ "(" , types , ")" ]: what a program elsewhere takes; its own head says so again
void declared_elsewhere(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  cursor.take(lex_named_item);
  if (!cursor.is(TokenKind::identifier) && !cursor.is(TokenKind::word)) cursor.refuse_token("a name");
  if (!item_follows(in, TokenKind::parenthesis)) return;
  do {
    cursor.take(lex_named_item);
  } while (!cursor.is(TokenKind::closing_parenthesis) && !cursor.is(TokenKind::end));
  if (cursor.is(TokenKind::end)) {
    cursor.refuse(in.out.flow().span, codes::kBracketOpen, "the bracket ( is not closed", "add the missing )");
  }
}

// definition = "DEF" , type , variable , [ "=" , value ] , { "," , variable , [ "=" , value ] }
void define_statement(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  if (upper(in.out.at(in.out.flow().span)) == "EXTERN") return declared_elsewhere(in);
  cursor.take(lex_named_item);
  const VariableType type = variable_type(in, "variables");
  do {
    cursor.take(lex_named_item);
    if (!cursor.is(TokenKind::identifier)) cursor.refuse_token("a name, which begins with two letters");
    const Span name = cursor.span();
    check_name_is_free(in, name);
    if (item_follows(in, TokenKind::equals)) {
      read_assigned_variable(in, name, nullptr);
      in.out.last_setting().type = type;
    } else {
      if (item_follows(in, TokenKind::open)) {
        cursor.refuse(name, codes::kNotInterpreted, "fields are not interpreted",
                      "write a variable for each of its elements");
      }
      in.out.declare(name, type);
    }
    cursor.take(lex_named_operation);
  } while (cursor.is(TokenKind::comma));
  cursor.go_before(cursor.token());
}

}  // namespace

void read_named_statement(BlockReading& in, FlowWord word) {
  Flow& flow = in.out.begin_flow(word, in.cursor.span());
  if (!in.out.block().words.empty() || !in.out.block().settings.empty()) {
    in.cursor.refuse(flow.span, codes::kFlowControl, fmt::format("{} stands after other words", in.out.at(flow.span)),
                     "put it into a block of its own");
  }
  switch (word) {
    case FlowWord::else_if:
      in.cursor.refuse(flow.span, codes::kFlowControl, fmt::format("the control has no {}", in.out.at(flow.span)),
                       "write ELSE, and IF with its ENDIF in the lines behind it");
    case FlowWord::begin_if:
    case FlowWord::go_to:
      named_jump(in, word == FlowWord::begin_if);
      break;
    case FlowWord::begin_while:
    case FlowWord::until:
      flow.values.push_back(read_named_value(in));
      refuse_other_language(in);
      break;
    case FlowWord::begin_for:
      for_statement(in);
      break;
    case FlowWord::choose:
      case_statement(in);
      break;
    case FlowWord::begin_repeat:
    case FlowWord::repeat_line:
      repeat_statement(in, word == FlowWord::repeat_line);
      break;
    case FlowWord::external_call:
      read_external_call(in);
      break;
    case FlowWord::define:
      define_statement(in);
      break;
    case FlowWord::sub:
      read_subprogram_head(in);
      break;
    case FlowWord::call:
      read_call_statement(in);
      return;
    default:
      break;
  }
  end_of_statement(in);
}

}  // namespace plumbline::nc

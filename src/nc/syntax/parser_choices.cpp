// The productions of CASE, of parts of a program that are repeated by their labels, of EXTCALL, and of values in
// brackets.
#include <fmt/format.h>

#include "base/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::nc {

std::string Parser::keyword() {
  take(lex_named_item);
  return token_.kind == TokenKind::identifier ? upper({token_.begin, token_.end}) : std::string();
}

// case = "CASE" , value , "OF" , { constant , jump } , [ "DEFAULT" , jump ]
void Parser::case_statement() {
  Flow& flow = block_->flow;
  flow.values.push_back(named_value_code());
  if (keyword() != "OF") {
    refuse_at(*block_, flow.span, codes::kFlowControl, "OF is missing in this choice",
              "write it as in CASE R1 OF 1 GOTOF ONE 2 GOTOF TWO DEFAULT GOTOF REST");
  }
  while (true) {
    Token next;
    look(lex_named_item, next);
    if (next.kind == TokenKind::end || next.kind == TokenKind::comment) break;
    Choice choice;
    const bool is_default = next.kind == TokenKind::identifier && upper({next.begin, next.end}) == "DEFAULT";
    if (is_default) {
      at_ = next.end;
    } else {
      choice.value = named_value_code();
    }
    const std::string jump = keyword();
    if (jump != "GOTO" && jump != "GOTOF" && jump != "GOTOB") {
      refuse_at(*block_, flow.span, codes::kFlowControl, "a choice goes nowhere",
                "write GOTOF or GOTOB and a label behind each constant");
    }
    choice.direction = jump.back() == 'F'   ? Direction::forward
                       : jump.back() == 'B' ? Direction::backward
                                            : Direction::both;
    jump_label();
    choice.label = flow.name;
    flow.choices.push_back(choice);
  }
}

// repeat = "REPEAT" , [ label , [ label ] , [ "P" , [ "=" ] , count ] ] | "REPEATB" , label , [ "P" , ... ]
void Parser::repeat_statement(bool block_alone) {
  Flow& flow = block_->flow;
  Token next;
  for (look(lex_named_item, next); next.kind == TokenKind::identifier; look(lex_named_item, next)) {
    Choice choice;
    choice.label = span_of(next);
    flow.choices.push_back(choice);
    at_ = next.end;
  }
  if (flow.choices.empty() && !block_alone) return;
  if (flow.choices.empty() || flow.choices.size() > (block_alone ? 1U : 2U)) {
    refuse_at(*block_, flow.span, codes::kFlowControl,
              "this repeats a part of the program, whose labels are missing or too many",
              "write it as in REPEAT BEGIN P=3, REPEAT BEGIN LAST P=3 or REPEATB HOLE P=3");
  }
  flow.word = block_alone ? FlowWord::repeat_line : FlowWord::repeat_section;
  const bool with_value = next.kind == TokenKind::letter && next.letter == 'P';
  if (next.kind == TokenKind::word && next.letter == 'P') {
    at_ = next.end;
    flow.count = static_cast<std::uint32_t>(block_->code.size());
    push(Operation::number, span_of(next), next.value);
    push(Operation::end, {});
  } else if (with_value) {
    at_ = next.end;
    expect_equals(span_of(next));
    flow.count = named_value_code();
  }
}

// arguments = "(" , [ value | text ] , { "," , [ value | text ] } , ")"
void Parser::value_arguments(Span name) {
  if (!next_is(TokenKind::parenthesis)) return;
  take(lex_named_item);
  if (!block_->arguments.empty()) {
    refuse_at(*block_, name, codes::kFlowControl, "two codes with values in brackets stand in one block",
              "put them into blocks of their own");
  }
  do {
    Token next;
    lex_named_operation(at_, next);
    Argument argument;
    const std::uint32_t begin = here();
    if (next.kind != TokenKind::comma && next.kind != TokenKind::closing_parenthesis) {
      if (next_is(TokenKind::string)) {
        take(lex_named_item);
      } else {
        argument.expression = named_value_code();
        const Instruction* const code = &block_->code[argument.expression];
        const bool negative = code[1].operation == Operation::negate;
        argument.plain = code->operation == Operation::number && code[negative ? 2 : 1].operation == Operation::end;
      }
    }
    argument.span = {begin, here()};
    block_->arguments.push_back(argument);
    take(lex_named_operation);
  } while (token_.kind == TokenKind::comma);
  if (token_.kind != TokenKind::closing_parenthesis) {
    refuse_at(*block_, name, codes::kBracketOpen, "the bracket ( is not closed", "add the missing )");
  }
}

// external call = "EXTCALL" , [ "(" ] , '"' , [ path ] , name , [ ".SPF" ] , '"' , [ ")" ]
void Parser::external_call() {
  Flow& flow = block_->flow;
  const bool bracket = next_is(TokenKind::parenthesis);
  if (bracket) take(lex_named_item);
  take(lex_named_item);
  if (token_.kind != TokenKind::string) {
    refuse_at(*block_, flow.span, codes::kNotInterpreted, "the name of the program that this calls is no text here",
              "write it as in EXTCALL(\"POCKET\")");
  }
  Span name = span_of(token_);
  ++name.begin;
  --name.end;
  const std::string_view path = block_->at(name);
  const std::size_t folder = path.find_last_of("/\\:");
  if (folder != std::string_view::npos) name.begin += static_cast<std::uint32_t>(folder + 1);
  const std::string file = upper(block_->at(name));
  if (file.ends_with(".SPF") || file.ends_with(".MPF")) name.end -= 4;
  if (name.end <= name.begin) {
    refuse_at(*block_, flow.span, codes::kFlowControl, "the name of the program that this calls is empty",
              "write it as in EXTCALL(\"POCKET\")");
  }
  flow.word = FlowWord::call;
  flow.name = name;
  if (bracket) expect(TokenKind::closing_parenthesis, ")");
}

}  // namespace plumbline::nc

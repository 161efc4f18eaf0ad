// The productions of macro B: statements, and values that need no brackets.
#include <fmt/format.h>

#include "base/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::nc {

// Block skip with a number: /2. The numbers are switches of the control, which here are one.
void Parser::skip_level() {
  while (is_digit(*at_)) ++at_;
  block_->slash.end = here();
}

// <PART-1>: the name of a program, where O1234 may stand.
bool Parser::program_name() {
  if (*token_.begin != '<') return false;
  const Span open = span_of(token_);
  const std::size_t close = block_->text.find('>', open.begin);
  if (close == std::string_view::npos) return false;
  block_->flow = Flow{};
  block_->flow.word = FlowWord::program;
  block_->flow.span = {open.begin, static_cast<std::uint32_t>(close + 1)};
  at_ = block_->text.data() + close + 1;
  end_of_statement();
  return true;
}

// :1234 in place of O1234, as ISO tapes have it.
bool Parser::iso_program_number() {
  if (*token_.begin != ':') return false;
  const std::size_t begin = span_of(token_).begin;
  std::size_t end = begin + 1;
  while (end < block_->text.size() && is_digit(block_->text[end])) ++end;
  if (end == begin + 1) return false;
  block_->flow = Flow{};
  block_->flow.word = FlowWord::program;
  block_->flow.span = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  at_ = block_->text.data() + end;
  end_of_statement();
  return true;
}

// POPEN, DPRNT[..], PCLOS: what the program sends to somebody else.
void Parser::refuse_output() {
  const std::string_view rest = block_->text.substr(span_of(token_).begin);
  for (const std::string_view command : {"POPEN", "PCLOS", "DPRNT", "BPRNT"}) {
    if (upper(rest.substr(0, command.size())) != command) continue;
    const std::uint32_t begin = span_of(token_).begin;
    refuse_at(*block_, {begin, begin + static_cast<std::uint32_t>(command.size())}, codes::kNotInterpreted,
              fmt::format("{} sends values out of the control, which is not interpreted", command),
              "leave it out, or send the values from a program that does not move");
  }
}

// open value = real value , operations
std::uint32_t Parser::open_value_code() {
  const auto begin = static_cast<std::uint32_t>(block_->code.size());
  real_value();
  lex_operation(at_, token_);
  operations(1);
  push(Operation::end, {});
  return begin;
}

// statement = "IF" , expression , ( "GOTO" , value | "THEN" , { setting } ) | "WHILE" , expression , "DO" , value
//           | "DO" , value | "END" , value | "GOTO" , value
bool Parser::macro_statement() {
  Token keyword;
  lex_statement(token_.begin, keyword);
  if (keyword.kind != TokenKind::flow) return false;
  Flow& flow = block_->flow;
  flow = Flow{};
  flow.word = static_cast<FlowWord>(keyword.operation);
  flow.span = span_of(keyword);
  at_ = keyword.end;
  const auto second = [&](FlowWord wanted) {
    lex_statement(at_, keyword);
    const bool found = keyword.kind == TokenKind::flow && static_cast<FlowWord>(keyword.operation) == wanted;
    if (found) at_ = keyword.end;
    return found;
  };
  if (flow.word == FlowWord::begin_if) {
    macro_condition();
    if (second(FlowWord::if_then)) {
      flow.word = FlowWord::if_then;
      take(lex_item);
      items();
      if (block_->words.empty()) return true;
      refuse_at(*block_, block_->words.front().span, codes::kFlowControl, "THEN takes nothing but an assignment",
                "write IF [..] GOTO, and the words into blocks of their own");
    }
    if (!second(FlowWord::go_to)) {
      refuse_at(*block_, flow.span, codes::kFlowControl, "GOTO or THEN is missing behind this condition",
                "write it as in IF [#1 GT 5] GOTO 100");
    }
    flow.word = FlowWord::go_to;
  } else if (flow.word == FlowWord::begin_while) {
    macro_condition();
    if (!second(FlowWord::begin_do)) {
      refuse_at(*block_, flow.span, codes::kFlowControl, "DO is missing behind this condition",
                "write it as in WHILE [#1 LT 5] DO 1");
    }
  } else if (flow.word == FlowWord::if_then) {
    refuse_token("a word");
  }
  macro_label();
  end_of_statement();
  return true;
}

void Parser::macro_condition() {
  take(lex_value);
  if (token_.kind != TokenKind::open) {
    refuse_at(*block_, block_->flow.span, codes::kFlowControl, "a condition in brackets is missing behind this",
              "write it as in IF [#1 GT 5] GOTO 100");
  }
  block_->flow.values.push_back(static_cast<std::uint32_t>(block_->code.size()));
  expression();
  push(Operation::end, {});
}

void Parser::macro_label() {
  block_->flow.label = value_code();
  block_->flow.span.end = here();
}

void Parser::end_of_statement() {
  const auto lex = syntax_->names ? lex_named_item : lex_item;
  const bool in_brackets = syntax_->statements != Statements::high_level;  // there RET("LABEL") is no comment
  const auto is_comment = [&] {
    return token_.kind == TokenKind::comment || (in_brackets && token_.kind == TokenKind::parenthesis);
  };
  for (take(lex); is_comment(); take(lex)) {
    if (token_.kind == TokenKind::parenthesis) {
      pass_comment();
    } else {
      comment(span_of(token_));
    }
  }
  if (token_.kind == TokenKind::end && token_.begin >= block_->text.data() + block_->text.size()) return;
  refuse_at(*block_, span_of(token_), codes::kFlowControl, "nothing but a comment stands behind this",
            "write words into a block of their own");
}

// ATAN[y]/[x], ATAN[y,x] or ATAN[y]
void Parser::macro_arc_tangent(Span span) {
  take(lex_value);
  if (token_.kind != TokenKind::open) {
    refuse_at(*block_, span, codes::kFunction, "a function needs its argument in brackets", "write ATAN[y]/[x]");
  }
  const Span open = span_of(token_);
  real_value();
  lex_operation(at_, token_);
  operations(1);
  if (token_.kind == TokenKind::bad && *token_.begin == ',') {
    at_ = token_.end;
    real_value();
    lex_operation(at_, token_);
    operations(1);
    if (token_.kind != TokenKind::close) {
      refuse_at(*block_, open, codes::kBracketOpen, "the bracket [ is not closed", "add the missing ]");
    }
    at_ = token_.end;
    return push(Operation::arc_tangent_turn, span);
  }
  if (token_.kind != TokenKind::close) {
    refuse_at(*block_, open, codes::kBracketOpen, "the bracket [ is not closed", "add the missing ]");
  }
  at_ = token_.end;
  lex_operation(at_, token_);
  if (token_.kind != TokenKind::operation || static_cast<Operation>(token_.operation) != Operation::divide) {
    return push(Operation::arc_tangent_of_one, span);
  }
  Token next;
  lex_value(token_.end, next);
  if (next.kind != TokenKind::open) return push(Operation::arc_tangent_of_one, span);
  token_ = next;
  at_ = next.end;
  expression();
  push(Operation::arc_tangent_turn, span);
}

}  // namespace plumbline::nc

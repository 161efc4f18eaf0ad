// The production of lines that steer the program: O words.
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::nc {
namespace {

bool needs_value(FlowWord word) {
  return word == FlowWord::begin_while || word == FlowWord::repeat || word == FlowWord::begin_if ||
         word == FlowWord::else_if;
}

bool may_have_value(FlowWord word) {
  return needs_value(word) || word == FlowWord::call || word == FlowWord::give_back || word == FlowWord::end_sub;
}

}  // namespace

// flow = "O" , ( name | real value ) , [ keyword , { expression } ] , { comment }
void Parser::flow() {
  Flow& flow = block_->flow;
  flow.values.clear();
  flow.name = Span{};
  flow.label = kLiteral;
  flow.span = span_of(token_);
  flow_label();
  lex_flow(at_, token_);
  flow.word = FlowWord::program;
  if (token_.kind == TokenKind::flow) {
    at_ = token_.end;
    flow.word = static_cast<FlowWord>(token_.operation);
    flow.span.end = span_of(token_).end;
    flow_values(flow.word);
  }
  take(lex_item);
  for (; token_.kind == TokenKind::comment; take(lex_item)) comment(span_of(token_));
  if (token_.kind == TokenKind::end && token_.begin >= block_->text.data() + block_->text.size()) return;
  refuse_at(*block_, span_of(token_), codes::kFlowControl, "nothing but a comment stands behind an O word",
            "write SUB, CALL, IF, WHILE or another keyword behind the label, and words into a block of their own");
}

// A word token holds its number already; a letter is followed by <name> or a value.
void Parser::flow_label() {
  Flow& flow = block_->flow;
  if (token_.kind == TokenKind::word) {
    flow.label = static_cast<std::uint32_t>(block_->code.size());
    push(Operation::number, flow.span, token_.value);
    push(Operation::end, {});
    return;
  }
  Token next;
  lex_value(at_, next);
  if (next.kind != TokenKind::name) {
    flow.label = value_code();
    return;
  }
  token_ = next;
  at_ = next.end;
  name();
  flow.name = block_->names.back();
}

// Comments may stand between the arguments of a call.
void Parser::next_value(FlowWord word) {
  lex_flow(at_, token_);
  while (word == FlowWord::call && token_.kind == TokenKind::end) {
    Token comment;
    lex_item(at_, comment);
    if (comment.kind != TokenKind::comment) return;
    block_->comments.push_back({span_of(comment)});
    at_ = comment.end;
    lex_flow(at_, token_);
  }
}

void Parser::flow_values(FlowWord word) {
  Flow& flow = block_->flow;
  if (may_have_value(word)) {
    for (next_value(word); token_.kind == TokenKind::open; next_value(word)) {
      flow.values.push_back(value_code());
      if (word != FlowWord::call) break;
    }
  }
  if (!needs_value(word) || !flow.values.empty()) return;
  refuse_at(*block_, flow.span, codes::kFlowControl, "a value in brackets is missing behind this",
            "write it as in O100 WHILE [#1 LT 5]");
}

}  // namespace plumbline::nc

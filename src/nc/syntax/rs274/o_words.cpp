#include "nc/syntax/rs274/o_words.hpp"

#include "nc/language/codes.hpp"
#include "nc/syntax/rs274/rs274_values.hpp"

namespace plumbline::nc {
namespace {

bool needs_value(FlowWord word) {
  return word == FlowWord::begin_while || word == FlowWord::repeat || word == FlowWord::begin_if ||
         word == FlowWord::else_if;
}

bool may_have_value(FlowWord word) {
  return needs_value(word) || word == FlowWord::call || word == FlowWord::give_back || word == FlowWord::end_sub;
}

// A word token holds its number already; a letter is followed by <name> or a value.
void flow_label(BlockReading& in) {
  Flow& flow = in.out.flow();
  if (in.cursor.is(TokenKind::word)) {
    flow.label = in.out.add_number(in.cursor.token().value, flow.span);
    return;
  }
  const Token next = in.cursor.peek(lex_value);
  if (next.kind != TokenKind::name) {
    flow.label = read_value(in);
    return;
  }
  in.cursor.accept(next);
  flow.name = in.out.block().names[read_name(in)];
}

// Comments may stand between the arguments of a call.
void next_value(BlockReading& in, FlowWord word) {
  in.cursor.look(lex_flow);
  while (word == FlowWord::call && in.cursor.is(TokenKind::end)) {
    const Token comment = in.cursor.peek(lex_item);
    if (comment.kind != TokenKind::comment) return;
    in.out.add_any_comment(in.cursor.span_of(comment));
    in.cursor.accept(comment);
    in.cursor.look(lex_flow);
  }
}

void flow_values(BlockReading& in, FlowWord word) {
  Flow& flow = in.out.flow();
  if (may_have_value(word)) {
    for (next_value(in, word); in.cursor.is(TokenKind::open); next_value(in, word)) {
      flow.values.push_back(read_value(in));
      if (word != FlowWord::call) break;
    }
  }
  if (!needs_value(word) || !flow.values.empty()) return;
  in.cursor.refuse(flow.span, codes::kFlowControl, "a value in brackets is missing after this",
                   "write it as in O100 WHILE [#1 LT 5]");
}

}  // namespace

// flow = "O" , ( name | real value ) , [ keyword , { expression } ] , { comment }
void read_o_word(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  Flow& flow = in.out.flow();
  flow.values.clear();
  flow.name = Span{};
  flow.label = kLiteral;
  flow.span = cursor.span();
  flow_label(in);
  cursor.look(lex_flow);
  flow.word = FlowWord::program;
  if (cursor.is(TokenKind::flow)) {
    cursor.pass();
    flow.word = static_cast<FlowWord>(cursor.token().operation);
    flow.span.end = cursor.span().end;
    flow_values(in, flow.word);
  }
  for (cursor.take(lex_item); cursor.is(TokenKind::comment); cursor.take(lex_item)) in.out.add_comment(cursor.span());
  if (cursor.is_at_end_of_block()) return;
  cursor.refuse_damage(cursor.span());
  if (in.syntax->statements == Statements::macro_b) {
    cursor.refuse(cursor.span(), codes::kFlowControl, "nothing but a comment stands after the number of a program",
                  "put the words into a block of their own");
  }
  cursor.refuse(cursor.span(), codes::kFlowControl, "nothing but a comment stands after an O word",
                "write SUB, CALL, IF, WHILE or another keyword after the label, and words into a block of their own");
}

}  // namespace plumbline::nc

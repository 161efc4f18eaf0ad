// The productions of values: expressions, parameters, functions.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/characters.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::nc {
namespace {

// Binary operators bind in this order, each from the left [RS274/NGC 3.3.2.3; LinuxCNC: relations and logic below].
int precedence(Operation operation) {
  switch (operation) {
    case Operation::power:
      return 5;
    case Operation::times:
    case Operation::divide:
    case Operation::modulo:
    case Operation::remainder:
    case Operation::bit_and:  // as multiplication, and the others as addition [B-63174EN 13.3]
      return 4;
    case Operation::plus:
    case Operation::minus:
    case Operation::bit_or:
    case Operation::bit_exclusive_or:
      return 3;
    case Operation::logical_and:
    case Operation::logical_or:
    case Operation::exclusive_or:
      return 1;
    default:
      return 2;
  }
}

bool is_relation(Operation operation) { return operation >= Operation::equal && operation <= Operation::less_equal; }

Operation of_bits(Operation operation) {
  if (operation == Operation::logical_and) return Operation::bit_and;
  if (operation == Operation::logical_or) return Operation::bit_or;
  return operation == Operation::exclusive_or ? Operation::bit_exclusive_or : operation;
}

}  // namespace

// real value = number | "[" expression "]" | parameter | sign , real value | function
void Parser::real_value() {
  take(lex_value);
  switch (token_.kind) {
    case TokenKind::number:
      return push(Operation::number, span_of(token_), token_.value);
    case TokenKind::open:
      return expression();
    case TokenKind::hash:
      return parameter();
    case TokenKind::sign:
      return signed_value();
    case TokenKind::function:
      return function();
    case TokenKind::exists:
      return exists();
    default:
      refuse_token("a value");
  }
}

void Parser::signed_value() {
  const bool negative = token_.letter == '-';
  const Span span = span_of(token_);
  refuse_second_sign();
  real_value();
  if (negative) push(Operation::negate, span);
}

// Where nothing says that a control reads two signs in a row, they are a slip.
void Parser::refuse_second_sign() const {
  const char* next = at_;
  while (is_blank(*next)) ++next;
  if (!syntax_->one_sign || (*next != '-' && *next != '+')) return;
  const auto begin = static_cast<std::uint32_t>(next - block_->text.data());
  refuse_at(*block_, {begin, begin + 1}, codes::kBadNumber, "two signs in a row", "leave one of them");
}

// expression = "[" , real value , { operation , real value } , "]"
void Parser::expression() {
  const Span open = span_of(token_);
  const bool outside = std::exchange(compares_, false);
  real_value();
  lex_operation(at_, token_);
  operations(1);
  compares_ = outside;
  if (token_.kind == TokenKind::end) {
    refuse_at(*block_, open, codes::kBracketOpen, "the bracket [ is not closed", "add the missing ]");
  }
  if (token_.kind != TokenKind::close) {
    refuse_at(*block_, span_of(token_), codes::kOperator, fmt::format("{} is no operator", shown(*token_.begin)),
              "between two values stands one of ** * / MOD + - EQ NE GT GE LT LE AND OR XOR, behind the last one ]");
  }
  at_ = token_.end;
}

// Precedence climbing; token_ is the operation behind the value just read, and again on return.
void Parser::operations(int least_precedence) {
  while (token_.kind == TokenKind::operation) {
    auto operation = static_cast<Operation>(token_.operation);
    if (syntax_->bitwise) operation = of_bits(operation);
    if (precedence(operation) < least_precedence) return;
    if (syntax_->bitwise && is_relation(operation)) {
      if (compares_) {
        refuse_at(*block_, span_of(token_), codes::kOperator, "a second comparison without brackets around each",
                  "write it as in [[#1 EQ 1] AND [#2 EQ 2]]");
      }
      compares_ = true;
    }
    if (operation == Operation::modulo && syntax_->rounds_to_zero) operation = Operation::remainder;
    const Span span = span_of(token_);
    at_ = token_.end;
    real_value();
    lex_operation(at_, token_);
    operations(precedence(operation) + 1);
    push(operation, span);
  }
}

// parameter = "#" , ( name | real value )
void Parser::parameter() {
  Span span = span_of(token_);
  lex_value(at_, token_);
  if (token_.kind == TokenKind::name) {
    at_ = token_.end;
    const std::uint32_t which = name();
    span.end = here();
    return push(Operation::name, span, 0, which);
  }
  real_value();
  span.end = here();
  push(Operation::parameter, span);
}

// function = "ATAN" , expression , "/" , expression | function name , expression
void Parser::function() {
  auto operation = static_cast<Operation>(token_.operation);
  const Span span = span_of(token_);
  if (syntax_->rounds_to_zero && operation == Operation::round_down) operation = Operation::truncate;
  if (syntax_->rounds_to_zero && operation == Operation::round_up) operation = Operation::round_away;
  if (syntax_->full_turn && operation == Operation::arc_tangent) return macro_arc_tangent(span);
  const auto argument = [&] {
    take(lex_value);
    if (token_.kind != TokenKind::open) {
      refuse_at(*block_, span, codes::kFunction, "a function needs its argument in brackets",
                operation == Operation::arc_tangent ? "write ATAN[y]/[x]" : "write it as in SIN[30]");
    }
    expression();
  };
  argument();
  if (operation == Operation::arc_tangent) {
    lex_operation(at_, token_);
    if (token_.kind != TokenKind::operation || static_cast<Operation>(token_.operation) != Operation::divide) {
      refuse_at(*block_, span, codes::kFunction, "ATAN needs two arguments", "write ATAN[y]/[x]");
    }
    at_ = token_.end;
    argument();
  }
  push(operation, span);
}

// exists = "EXISTS" , "[" , "#" , ( name | real value ) , "]"
void Parser::exists() {
  Span span = span_of(token_);
  const auto expect = [&](void (*lex)(const char*, Token&), TokenKind kind) {
    take(lex);
    if (token_.kind == kind) return;
    refuse_at(*block_, span, codes::kFunction, "EXISTS asks for a parameter", "write EXISTS[#<name>] or EXISTS[#5]");
  };
  expect(lex_value, TokenKind::open);
  expect(lex_value, TokenKind::hash);
  Token next;
  lex_value(at_, next);
  if (next.kind != TokenKind::name && syntax_->statements == Statements::o_words) {
    real_value();
    expect(lex_operation, TokenKind::close);
    return push(Operation::exists_number, span);
  }
  expect(lex_value, TokenKind::name);
  const std::uint32_t which = name();
  expect(lex_operation, TokenKind::close);
  push(Operation::exists, span, 0, which);
}

// name = "<" , { character } , ">"
std::uint32_t Parser::name() {
  const Span whole = span_of(token_);
  const Span inside{whole.begin + 1, whole.end - 1};
  const std::string_view text = block_->at(inside);
  if (std::all_of(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\t' || c == '\r'; })) {
    refuse_at(*block_, whole, codes::kName, "a parameter without a name", "write a name between < and >");
  }
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x80 && c != '(' && c != ';') continue;
    refuse_at(*block_, whole, codes::kName, fmt::format("{} in the name of a parameter", shown(c)),
              "name parameters with ASCII letters, digits and _");
  }
  block_->names.push_back(inside);
  return static_cast<std::uint32_t>(block_->names.size() - 1);
}

}  // namespace plumbline::nc

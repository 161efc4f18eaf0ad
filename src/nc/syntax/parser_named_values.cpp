// The productions of values in languages with names: variables, functions and operators by their name.
#include <utility>

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"
#include "nc/syntax/parser.hpp"

namespace plumbline::nc {

std::uint32_t Parser::named_value_code() {
  const auto begin = static_cast<std::uint32_t>(block_->code.size());
  named_value();
  push(Operation::end, {});
  return begin;
}

// value = term , { operation , term }; at_ is behind it on return
void Parser::named_value() {
  const std::optional<Operation> outside = std::exchange(joined_by_, std::nullopt);
  named_term();
  look(lex_named_operation, token_);
  named_operations(0);
  joined_by_ = outside;
}

void Parser::named_value_until(TokenKind kind) {
  const Span open = span_of(token_);
  named_value();
  take(lex_named_operation);
  if (token_.kind == kind) return;
  if (token_.kind == TokenKind::end) {
    refuse_at(*block_, open, codes::kBracketOpen, "the bracket is not closed", "add the one that closes it");
  }
  refuse_at(*block_, span_of(token_), codes::kOperator, fmt::format("{} is no operator", shown(*token_.begin)),
            "between two values stands an operator, behind the last one the closing bracket");
}

// The binding of operators: in the 840D relations bind weakest [PGA 1.8], else logic does.
bool Parser::is_logical(Operation operation) {
  return operation == Operation::logical_and || operation == Operation::logical_or ||
         operation == Operation::exclusive_or;
}

int Parser::named_precedence(Operation operation) const {
  switch (operation) {
    case Operation::times:
    case Operation::divide:
    case Operation::modulo:
    case Operation::remainder:
    case Operation::whole_quotient:
      return 8;
    case Operation::plus:
    case Operation::minus:
      return 7;
    case Operation::logical_and:
      return 5;
    case Operation::exclusive_or:
      return 4;
    case Operation::logical_or:
      return 3;
    default:
      return syntax_->relations_last ? 1 : 6;
  }
}

bool Parser::is_operation(Token& token) const {
  if (token.kind == TokenKind::operation) return true;
  if (token.kind != TokenKind::identifier) return false;
  const NameMeaning* const meaning =
      dialect_->meaning({token.begin, static_cast<std::size_t>(token.end - token.begin)});
  if (meaning == nullptr || meaning->kind != NameMeaning::Kind::operation) return false;
  token.operation = static_cast<std::uint8_t>(meaning->which);
  return true;
}

// Which of AND, OR and a comparison binds first is in no source of such a control: brackets must say it.
void Parser::refuse_unknown_binding(Operation operation) {
  const bool compares = operation >= Operation::equal && operation <= Operation::less_equal;
  if (!syntax_->truths_only || !(compares || is_logical(operation))) return;
  if (joined_by_ && (compares || *joined_by_ != operation)) {
    const Span span = span_of(token_);
    refuse_at(*block_, span, codes::kNotInterpreted,
              fmt::format("which binds first, {} or the operator before it, was found in no source", block_->at(span)),
              "write brackets around each condition, as in [[VC1 EQ 1] AND [VC2 EQ 2]]");
  }
  joined_by_ = operation;
}

// Precedence climbing; token_ is the operation behind the value just read, and again on return.
void Parser::named_operations(int least_precedence) {
  while (is_operation(token_)) {
    const auto operation = static_cast<Operation>(token_.operation);
    if (named_precedence(operation) < least_precedence) return;
    refuse_unknown_binding(operation);
    const Span span = span_of(token_);
    at_ = token_.end;
    named_term();
    look(lex_named_operation, token_);
    named_operations(named_precedence(operation) + 1);
    if (syntax_->truths_only && is_logical(operation)) push(Operation::check_truths, span);
    push(operation, span);
  }
}

// term = number | sign , term | bracketed value | variable | function
void Parser::named_term() {
  take(lex_named_value);
  const Span span = span_of(token_);
  switch (token_.kind) {
    case TokenKind::number:
      return push(Operation::number, span, token_.value);
    case TokenKind::sign: {
      const bool negative = token_.letter == '-';
      refuse_second_sign();
      named_term();
      if (negative) push(Operation::negate, span);
      return;
    }
    case TokenKind::open:
    case TokenKind::parenthesis:
      if ((token_.kind == TokenKind::open) == (syntax_->open == '[')) return named_bracket();
      break;
    case TokenKind::identifier:
      return named_identifier();
    default:
      break;
  }
  refuse_token("a value");
}

void Parser::named_bracket() {
  named_value_until(syntax_->open == '[' ? TokenKind::close : TokenKind::closing_parenthesis);
}

void Parser::named_identifier() {
  const Span span = span_of(token_);
  const std::string_view name = block_->at(span);
  const NameMeaning* const meaning = dialect_->meaning(name);
  if (meaning != nullptr && meaning->kind == NameMeaning::Kind::function) return call_function(*meaning, span);
  if (variable_place(name, span)) return push(Operation::parameter, span);
  if (!syntax_->reserved.empty() && (name.front() & ~0x20) == syntax_->reserved.front()) refuse_reserved(span);
  if (meaning != nullptr) refuse_token("a value");
  if (next_is(TokenKind::open) || next_is(TokenKind::parenthesis)) {
    refuse_at(*block_, span, codes::kNotInterpreted,
              fmt::format("{} is a field or a function that is not interpreted", name), "write its value itself");
  }
  block_->names.push_back(span);
  push(Operation::name, span, 0, static_cast<std::uint32_t>(block_->names.size() - 1));
}

void Parser::call_function(const NameMeaning& meaning, Span span) {
  const auto operation = static_cast<Operation>(meaning.which);
  if (meaning.arguments == 0) return push(operation, span, meaning.value);
  if (operation == Operation::logical_not) {  // NOT takes what follows, with brackets or without
    named_term();
    return push(operation, span);
  }
  take(lex_named_value);
  const TokenKind open = syntax_->open == '[' ? TokenKind::open : TokenKind::parenthesis;
  const TokenKind close = syntax_->open == '[' ? TokenKind::close : TokenKind::closing_parenthesis;
  if (token_.kind != open) {
    refuse_at(*block_, span, codes::kFunction, "a function needs its argument in brackets",
              fmt::format("write {} and its closing bracket around it", syntax_->open));
  }
  for (int i = 1; i < meaning.arguments; ++i) named_value_until(TokenKind::comma);
  named_value_until(close);
  push(operation, span);
}

}  // namespace plumbline::nc

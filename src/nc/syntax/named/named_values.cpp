#include "nc/syntax/named/named_values.hpp"

#include <algorithm>
#include <charconv>
#include <string>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr int kOfBound = 3;  // arguments: BOUND(minimum, maximum, value) [V 1.6]

ValueKind named_value(BlockReading& in);
ValueKind named_term(BlockReading& in);
ValueKind named_value_until(BlockReading& in, TokenKind kind);

bool is_logical(Operation operation) {
  return operation == Operation::logical_and || operation == Operation::logical_or ||
         operation == Operation::exclusive_or;
}

// The binding of operators. Where comparisons stand among AND and OR is refused (refuse_unclear_binding).
int named_precedence(Operation operation) {
  switch (operation) {
    case Operation::times:
    case Operation::divide:
    case Operation::modulo:
    case Operation::remainder:
    case Operation::whole_remainder:
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
      return 6;
  }
}

std::string_view text_of(const Token& token) {
  return {token.begin, static_cast<std::size_t>(token.end - token.begin)};
}

}  // namespace

std::optional<Operation> operator_at(const BlockReading& in) {
  if (in.cursor.is(TokenKind::operation)) return in.cursor.operation();
  if (!in.cursor.is(TokenKind::identifier)) return std::nullopt;
  const NameMeaning* const meaning = in.dialect->meaning(text_of(in.cursor.token()));
  if (meaning == nullptr || meaning->kind != NameMeaning::Kind::operation) return std::nullopt;
  return static_cast<Operation>(meaning->which);
}

namespace {

// Which of AND, OR and a comparison binds first is in no source of such a control, or the control has it otherwise than
// who wrote it will have meant: brackets must say it. `joined_by`: the comparison or the logical operator of this
// bracket so far.
void refuse_unclear_binding(const BlockReading& in, Operation operation, std::optional<Operation>& joined_by) {
  const bool weak = in.syntax->relations_last;
  if (!(in.syntax->truths_only || weak) || !(is_relation(operation) || is_logical(operation))) return;
  const bool mixes = joined_by && is_relation(*joined_by) != is_relation(operation);
  if (mixes && weak) {
    in.cursor.refuse(in.cursor.span(), codes::kNotInterpreted,
                     "AND, OR and XOR bind before a comparison, so that R1==1 AND R2==2 compares R1 with 1 AND R2",
                     "write brackets around each condition, as in (R1==1) AND (R2==2)");
  }
  if (joined_by && !weak && (is_relation(operation) || *joined_by != operation)) {
    const Span span = in.cursor.span();
    in.cursor.refuse(
        span, codes::kNotInterpreted,
        fmt::format("which binds first, {} or the operator before it, was found in no source", in.out.at(span)),
        "write brackets around each condition, as in [[VC1 EQ 1] AND [VC2 EQ 2]]");
  }
  joined_by = operation;
}

// VC1==2, as other controls write it; an OSP has EQ, NE, GT, GE, LT, LE [K].
void refuse_sign_of_relation(const BlockReading& in, Operation operation) {
  const bool by_name = in.syntax->statements == Statements::user_task;
  if (!by_name || !is_relation(operation) || !in.cursor.is(TokenKind::operation)) return;
  const Span span = in.cursor.span();
  in.cursor.refuse(span, codes::kOperator, fmt::format("{} is no operator of this control", in.out.at(span)),
                   "it compares by EQ, NE, GT, GE, LT and LE, as in IF [VC1 EQ 2] N100");
}

// Precedence climbing; token() is the operation after the value just read, `left`, and again on return.
ValueKind named_operations(BlockReading& in, ValueKind left, int least_precedence,
                           std::optional<Operation>& joined_by) {
  while (const std::optional<Operation> operation = operator_at(in)) {
    const int precedence = named_precedence(*operation);
    if (precedence < least_precedence) return left;
    refuse_unclear_binding(in, *operation, joined_by);
    const Span span = in.cursor.span();
    refuse_sign_of_relation(in, *operation);
    in.cursor.pass();
    if (*operation == Operation::minus || *operation == Operation::plus) refuse_second_sign(in);
    ValueKind right = named_term(in);
    in.cursor.look(lex_named_operation);
    right = named_operations(in, right, precedence + 1, joined_by);
    left = joined_kind(in, *operation, span, left, right);
    if (in.syntax->truths_only && is_logical(*operation)) in.out.push(Operation::check_truths, span);
    in.out.push(*operation, span);
  }
  return left;
}

TokenKind opening(const Syntax& syntax) { return syntax.open == '[' ? TokenKind::open : TokenKind::parenthesis; }
TokenKind closing(const Syntax& syntax) {
  return syntax.open == '[' ? TokenKind::close : TokenKind::closing_parenthesis;
}

// NOT R1==5 is (NOT R1)==5 [N p. 444].
void refuse_not_compared(BlockReading& in, Span span) {
  if (!in.syntax->relations_last) return;
  const std::string_view next = text_of(in.cursor.peek(lex_named_operation));
  if (next.empty() || std::string_view("=<>").find(next.front()) == std::string_view::npos) return;
  in.cursor.refuse(span, codes::kNotInterpreted,
                   "NOT binds before a comparison, so that NOT R1==5 compares NOT R1 with 5",
                   "write brackets around the condition, as in NOT (R1==5)");
}

ValueKind call_function(BlockReading& in, const NameMeaning& meaning, Span span) {
  const auto operation = static_cast<Operation>(meaning.which);
  if (meaning.arguments == 0) {
    in.out.push(operation, span, meaning.value);
    return ValueKind::number;
  }
  if (operation == Operation::logical_not) {  // NOT takes what follows, with brackets or without
    const ValueKind kind = named_term(in);
    refuse_not_compared(in, span);
    in.out.push(operation, span);
    return kind;
  }
  in.cursor.take(lex_named_value);
  if (!in.cursor.is(opening(*in.syntax))) {
    in.cursor.refuse(span, codes::kFunction, "a function needs its argument in brackets",
                     fmt::format("write {} and its closing bracket around it", in.syntax->open));
  }
  for (int i = 1; i < meaning.arguments; ++i) add_named_value_until(in, TokenKind::comma);
  add_named_value_until(in, closing(*in.syntax));
  if (meaning.arguments == kOfBound) in.out.push(Operation::smaller, span, kOfBound);
  in.out.push(operation, span);
  return ValueKind::number;
}

// R1=ISFILE("X"): a word of the control that is known, and not interpreted.
void refuse_code_in_value(const BlockReading& in, const NameMeaning& meaning, Span span) {
  const CodeRow& row = in.dialect->named_codes[static_cast<std::size_t>(meaning.which)];
  if (row.action != Action::refused) return;
  in.cursor.refuse(span, codes::kNotInterpreted, fmt::format("{} {}", in.out.at(span), row.reason()),
                   "write the value itself, as a number or a variable");
}

ValueKind named_identifier(BlockReading& in) {
  const Span span = in.cursor.span();
  const std::string_view name = in.out.at(span);
  const NameMeaning* const meaning = in.dialect->meaning(name);
  if (meaning != nullptr && meaning->kind == NameMeaning::Kind::function) return call_function(in, *meaning, span);
  if (is_numbered_variable(in, name)) {
    add_numbered_variable(in, span);
    in.out.push(Operation::parameter, span);
    return ValueKind::number;
  }
  if (is_reserved(in, name)) refuse_reserved(in, span);
  if (meaning != nullptr && meaning->kind == NameMeaning::Kind::code) refuse_code_in_value(in, *meaning, span);
  if (meaning != nullptr) in.cursor.refuse_token("a value");
  const bool is_comment = in.syntax->open == '[';  // what stands in ( ) on such a control
  if (item_follows(in, TokenKind::open) || (!is_comment && item_follows(in, TokenKind::parenthesis))) {
    in.cursor.refuse(span, codes::kNotInterpreted,
                     fmt::format("{} is a field or a function that is not interpreted", name),
                     "write its value itself");
  }
  in.out.push(Operation::name, span, 0, in.out.add_name(span));
  return ValueKind::number;
}

// number = digits , [ "EX" , [ sign ] , digits ]; the number is token()
void named_number(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  Span span = cursor.span();
  const double mantissa = cursor.token().value;
  const Token next = cursor.peek(lex_named_operation);
  const std::string name = next.kind == TokenKind::identifier ? upper(text_of(next)) : std::string();
  const bool exponent = in.syntax->exponents && name.starts_with("EX") &&
                        std::all_of(name.begin() + 2, name.end(), [](char c) { return is_digit(c); });
  if (!exponent) return in.out.push(Operation::number, span, mantissa);
  std::string digits = name.substr(2);
  cursor.accept(next);
  if (digits.empty()) {
    cursor.take(lex_named_value);
    if (cursor.is(TokenKind::sign)) {
      if (cursor.token().letter == '-') digits = "-";
      cursor.take(lex_named_value);
    }
    if (cursor.is(TokenKind::number)) digits += text_of(cursor.token());
  }
  const std::string number = fmt::format("{}e{}", mantissa, digits);
  double value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  span.end = cursor.here();
  if (digits.empty() || error != std::errc{} || end != number.data() + number.size()) {
    cursor.refuse(span, codes::kBadNumber, "this is no number with an exponent", "write it as in 8.2EX-3");
  }
  in.out.push(Operation::number, span, value);
}

ValueKind bracketed_value(BlockReading& in, Span span) {
  const ValueKind kind = named_value_until(in, closing(*in.syntax));
  if (in.syntax->empty_names && (in.out.ends_with(Operation::name) || in.out.ends_with(Operation::parameter)))
    in.out.push(Operation::bracketed, span);
  return kind;
}

// term = number | sign , term | bracketed value | variable | function
ValueKind named_term(BlockReading& in) {
  in.cursor.take(lex_named_value);
  const Span span = in.cursor.span();
  switch (in.cursor.token().kind) {
    case TokenKind::number:
      named_number(in);
      return ValueKind::number;
    case TokenKind::sign: {
      const bool negative = in.cursor.token().letter == '-';
      refuse_second_sign(in);
      need_number(in, named_term(in), span);
      if (negative) in.out.push(Operation::negate, span);
      return ValueKind::number;
    }
    case TokenKind::open:
    case TokenKind::parenthesis:
      if (in.cursor.is(opening(*in.syntax))) return bracketed_value(in, span);
      break;
    case TokenKind::identifier:
      return named_identifier(in);
    default:
      break;
  }
  in.cursor.refuse_token("a value");
}

// value = term , { operation , term }; token() is what stands after it
ValueKind named_value(BlockReading& in) {
  std::optional<Operation> joined_by;
  const ValueKind first = named_term(in);
  in.cursor.look(lex_named_operation);
  return named_operations(in, first, 0, joined_by);
}

ValueKind named_value_until(BlockReading& in, TokenKind kind) {
  const Span open = in.cursor.span();
  const ValueKind value = named_value(in);
  if (in.syntax->open == '[' && item_follows(in, TokenKind::parenthesis)) {
    in.cursor.take(lex_named_item);
    in.cursor.refuse(in.cursor.span(), codes::kNotInterpreted,
                     "a comment stands inside brackets, and whether the control takes one there was found in no source",
                     "put it behind the last word of the block");
  }
  in.cursor.take(lex_named_operation);
  if (in.cursor.is(kind)) return value;
  if (in.cursor.is(TokenKind::end)) {
    in.cursor.refuse(open, codes::kBracketOpen, "the bracket is not closed", "add the one that closes it");
  }
  const bool is_name = in.cursor.is(TokenKind::identifier);
  in.cursor.refuse(in.cursor.span(), codes::kOperator,
                   fmt::format("{} is no operator",
                               is_name ? std::string(text_of(in.cursor.token())) : shown(*in.cursor.token().begin)),
                   "between two values stands an operator, after the last one the closing bracket");
}

}  // namespace

bool item_follows(const BlockReading& in, TokenKind kind) { return in.cursor.peek(lex_named_item).kind == kind; }

std::string read_keyword(BlockReading& in) {
  in.cursor.take(lex_named_item);
  return in.cursor.is(TokenKind::identifier) ? upper(text_of(in.cursor.token())) : std::string();
}

void expect_after_value(BlockReading& in, TokenKind kind, std::string_view what) {
  in.cursor.take(lex_named_operation);
  if (in.cursor.is(kind)) return;
  in.cursor.refuse(in.cursor.span(), codes::kBracketOpen, fmt::format("{} is missing here", what), "add it");
}

void expect_equals(BlockReading& in, Span name) {
  in.cursor.take(lex_named_item);
  if (in.cursor.is(TokenKind::equals)) return;
  in.cursor.refuse(name, codes::kAssignment, fmt::format("{} stands here without a value", in.out.at(name)),
                   "write = and its value after it");
}

std::uint32_t read_named_value(BlockReading& in) {
  const std::uint32_t begin = in.out.next_code();
  const Span before = in.cursor.span();
  need_number(in, named_value(in), before);
  in.out.end_code();
  return begin;
}

std::uint32_t read_named_condition(BlockReading& in) {
  const std::uint32_t begin = in.out.next_code();
  const Span before = in.cursor.span();
  need_condition(in, named_value(in), before);
  in.out.end_code();
  return begin;
}

void add_named_value_until(BlockReading& in, TokenKind kind) {
  const Span open = in.cursor.span();
  need_number(in, named_value_until(in, kind), open);
}

namespace {

// R of R12: the name without the digits at its end.
std::string_view without_number(std::string_view name) {
  while (!name.empty() && is_digit(name.back())) name.remove_suffix(1);
  return name;
}

}  // namespace

bool is_numbered_variable(const BlockReading& in, std::string_view name) {
  const NameMeaning* const meaning = in.dialect->meaning(without_number(name));
  return meaning != nullptr && meaning->kind == NameMeaning::Kind::variable;
}

void add_numbered_variable(BlockReading& in, Span span) {
  const std::string_view name = in.out.at(span);
  const std::string_view letters = without_number(name);
  const NameMeaning* const meaning = in.dialect->meaning(letters);
  const NumberedVariables& family = in.syntax->variables[static_cast<std::size_t>(meaning->which)];
  if (letters.size() == name.size()) {
    in.cursor.take(lex_named_item);
    if (!in.cursor.is(TokenKind::open)) {
      in.cursor.refuse(span, codes::kAssignment, fmt::format("{} stands here without a number", name),
                       fmt::format("write it as in {}{}", family.name, family.first));
    }
    add_named_value_until(in, TokenKind::close);
    in.out.push(Operation::number, span, family.at - family.first);
    in.out.push(Operation::plus, span);
    return;
  }
  double number = 0;
  for (const char c : name.substr(letters.size())) number = std::min(number * 10 + (c - '0'), 1e6);
  if (number < family.first || number > family.last) {
    in.cursor.refuse(span, codes::kParameterNumber, fmt::format("there is no variable {}", name),
                     fmt::format("they have the numbers {} to {}", family.first, family.last));
  }
  in.out.push(Operation::number, span, number - family.first + family.at);
}

bool is_reserved(const BlockReading& in, std::string_view name) {
  return !in.syntax->reserved.empty() && upper(name.front()) == in.syntax->reserved.front();
}

namespace {

// VC1EQ1: the variable that begins it; empty: none does.
std::string_view glued_variable(const BlockReading& in, std::string_view name) {
  std::size_t digit = 0;
  while (digit < name.size() && !is_digit(name[digit])) ++digit;
  std::size_t end = digit;
  while (end < name.size() && is_digit(name[end])) ++end;
  const bool glued = end > digit && end < name.size() && is_numbered_variable(in, name.substr(0, end));
  return glued ? name.substr(0, end) : std::string_view{};
}

}  // namespace

void refuse_reserved(const BlockReading& in, Span span) {
  if (const std::string_view variable = glued_variable(in, in.out.at(span)); !variable.empty()) {
    in.cursor.refuse(span, codes::kOperator, fmt::format("{} is read as one name", in.out.at(span)),
                     fmt::format("put a blank behind {}, and one on each side of a comparison or an operator that is a "
                                 "word",
                                 variable));
  }
  in.cursor.refuse(
      span, codes::kNotInterpreted,
      fmt::format("{} is a variable of the control itself, which is not interpreted", in.out.at(span)),
      "it reads or sets what only this machine has: tables, counters, screens; write the values themselves");
}

}  // namespace plumbline::nc

#include "nc/syntax/rs274/rs274_values.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

ValueKind real_value(BlockReading& in);

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

Operation of_bits(Operation operation) {
  if (operation == Operation::logical_and) return Operation::bit_and;
  if (operation == Operation::logical_or) return Operation::bit_or;
  return operation == Operation::exclusive_or ? Operation::bit_exclusive_or : operation;
}

// A power, a name in < > and EXISTS are LinuxCNC's.
void check_of_dialect(const BlockReading& in, Span span, std::string_view text) {
  if (in.syntax->statements != Statements::macro_b) return;
  in.cursor.refuse(span, codes::kOperator, fmt::format("{} is no part of this control's language", text),
                   "write it with + - * / and numbered variables, or choose another dialect");
}

// Precedence climbing; token() is the operation after the value just read, and again on return. `compared`: this
// bracket has compared already. Returns what all of them make of the value that was read, which is `left`.
ValueKind operations(BlockReading& in, ValueKind left, int least_precedence, bool& compared) {
  TokenCursor& cursor = in.cursor;
  while (cursor.is(TokenKind::operation)) {
    Operation operation = cursor.operation();
    if (in.syntax->bitwise) operation = of_bits(operation);
    if (precedence(operation) < least_precedence) return left;
    if (operation == Operation::power) check_of_dialect(in, cursor.span(), "**");
    if (in.syntax->bitwise && is_relation(operation)) {
      if (compared) {
        cursor.refuse(cursor.span(), codes::kOperator, "a second comparison without brackets around each",
                      "write it as in [[#1 EQ 1] AND [#2 EQ 2]]");
      }
      compared = true;
    }
    if (operation == Operation::modulo && in.syntax->rounds_to_zero) operation = Operation::whole_remainder;
    const Span span = cursor.span();
    cursor.pass();
    ValueKind right = real_value(in);
    cursor.look(lex_operation);
    right = operations(in, right, precedence(operation) + 1, compared);
    left = joined_kind(in, operation, span, left, right);
    in.out.push(operation, span);
  }
  return left;
}

// value = real value , { operation , real value }; token() is what stands after it
ValueKind open_value(BlockReading& in) {
  bool compared = false;
  const ValueKind first = real_value(in);
  in.cursor.look(lex_operation);
  return operations(in, first, 1, compared);
}

[[noreturn]] void refuse_open_bracket(const BlockReading& in, Span open) {
  in.cursor.refuse(open, codes::kBracketOpen, "the bracket [ is not closed", "add the missing ]");
}

// More of them, those of functions among them, are alarm PS0118 of a Fanuc.
class OpenBracket {
 public:
  OpenBracket(BlockReading& in, Span open) : in_(in) {
    constexpr int kMost = 5;
    if (in.brackets >= kMost && in.syntax->statements == Statements::macro_b) {
      in.cursor.refuse(open, codes::kOperator, "the control takes brackets that are five deep, and no deeper",
                       "work out what the inner brackets hold in a block before, into a variable");
    }
    ++in.brackets;
  }
  ~OpenBracket() { --in_.brackets; }
  OpenBracket(OpenBracket&&) = delete;
  OpenBracket& operator=(OpenBracket&&) = delete;
  OpenBracket(const OpenBracket&) = delete;
  OpenBracket& operator=(const OpenBracket&) = delete;

 private:
  BlockReading& in_;
};

// expression = "[" , real value , { operation , real value } , "]"; token() is the [
ValueKind expression(BlockReading& in) {
  TokenCursor& cursor = in.cursor;
  const Span open = cursor.span();
  const OpenBracket bracket(in, open);
  const ValueKind kind = open_value(in);
  if (cursor.is(TokenKind::end)) refuse_open_bracket(in, open);
  if (!cursor.is(TokenKind::close)) {
    const bool is_word = is_letter(*cursor.token().begin);
    cursor.refuse(cursor.span(), codes::kOperator,
                  fmt::format("{} is no operator{}", shown(*cursor.token().begin),
                              is_word ? ", or a ] is missing before it" : ""),
                  fmt::format("between two values stands one of {}* / MOD + - EQ NE GT GE LT LE AND OR XOR, after the "
                              "last one ]",
                              in.syntax->statements == Statements::macro_b ? "" : "** "));
  }
  cursor.pass();
  const bool of_variable = in.out.ends_with(Operation::parameter);
  if (of_variable && in.syntax->statements == Statements::macro_b)
    in.out.push(Operation::bracketed, {open.begin, cursor.here()});
  return kind;
}

// One of them that is a number.
void number_value(BlockReading& in, Span span) { need_number(in, real_value(in), span); }

void signed_value(BlockReading& in) {
  const bool negative = in.cursor.token().letter == '-';
  const Span span = in.cursor.span();
  refuse_second_sign(in);
  number_value(in, span);
  if (negative) in.out.push(Operation::negate, span);
}

// parameter = "#" , ( name | real value )
void parameter(BlockReading& in) {
  Span span = in.cursor.span();
  in.cursor.look(lex_value);
  if (in.cursor.is(TokenKind::name)) {
    check_of_dialect(in, span, "a name in < >");
    in.cursor.pass();
    const std::uint32_t name = read_name(in);
    span.end = in.cursor.here();
    return in.out.push(Operation::name, span, 0, name);
  }
  number_value(in, span);
  span.end = in.cursor.here();
  in.out.push(Operation::parameter, span);
}

void bracketed_argument(BlockReading& in, Span function, std::string_view help) {
  in.cursor.take(lex_value);
  if (!in.cursor.is(TokenKind::open)) {
    in.cursor.refuse(function, codes::kFunction, "a function needs its argument in brackets", std::string(help));
  }
  need_number(in, expression(in), function);
}

// ATAN[y]/[x]
void arc_tangent(BlockReading& in, Span span) {
  constexpr std::string_view kHelp = "write ATAN[y]/[x]";
  bracketed_argument(in, span, kHelp);
  in.cursor.look(lex_operation);
  if (!in.cursor.is(TokenKind::operation) || in.cursor.operation() != Operation::divide) {
    in.cursor.refuse(span, codes::kFunction, "ATAN needs two arguments", std::string(kHelp));
  }
  in.cursor.pass();
  bracketed_argument(in, span, kHelp);
  in.out.push(Operation::arc_tangent, span);
}

// ATAN[y]/[x], ATAN[y,x] or ATAN[y], of a full turn
void macro_arc_tangent(BlockReading& in, Span span) {
  TokenCursor& cursor = in.cursor;
  cursor.take(lex_value);
  if (!cursor.is(TokenKind::open)) {
    cursor.refuse(span, codes::kFunction, "a function needs its argument in brackets", "write ATAN[y]/[x]");
  }
  const Span open = cursor.span();
  const OpenBracket bracket(in, open);
  need_number(in, open_value(in), span);
  if (cursor.is(TokenKind::bad) && *cursor.token().begin == ',') {
    cursor.pass();
    need_number(in, open_value(in), span);
    if (!cursor.is(TokenKind::close)) refuse_open_bracket(in, open);
    cursor.pass();
    return in.out.push(Operation::arc_tangent_turn, span);
  }
  if (!cursor.is(TokenKind::close)) refuse_open_bracket(in, open);
  cursor.pass();
  cursor.look(lex_operation);
  if (!cursor.is(TokenKind::operation) || cursor.operation() != Operation::divide) {
    return in.out.push(Operation::arc_tangent_of_one, span);
  }
  Token next;
  lex_value(cursor.token().end, next);
  if (next.kind != TokenKind::open) {
    cursor.refuse(
        span, codes::kNotInterpreted,
        "/ behind ATAN[..] is no division: it asks for a second value in brackets, and the control stops without",
        "write ATAN[1]/[2] for the angle of two sides, or [ATAN[1]]/2 to divide the angle");
  }
  cursor.accept(next);
  need_number(in, expression(in), span);
  in.out.push(Operation::arc_tangent_turn, span);
}

// function = "ATAN" , expression , "/" , expression | function name , expression
void function(BlockReading& in) {
  Operation operation = in.cursor.operation();
  const Span span = in.cursor.span();
  if (operation == Operation::arc_tangent) {
    return in.syntax->full_turn ? macro_arc_tangent(in, span) : arc_tangent(in, span);
  }
  if (in.syntax->rounds_to_zero && operation == Operation::round_down) operation = Operation::truncate;
  if (in.syntax->rounds_to_zero && operation == Operation::round_up) operation = Operation::round_away;
  if (in.syntax->full_turn && operation == Operation::arc_sine) operation = Operation::macro_arc_sine;
  bracketed_argument(in, span, "write it as in SIN[30]");
  in.out.push(operation, span);
}

// exists = "EXISTS" , "[" , "#" , ( name | real value ) , "]"
void exists(BlockReading& in) {
  const Span span = in.cursor.span();
  check_of_dialect(in, span, "EXISTS");
  const auto expect = [&](Lexer lex, TokenKind kind) {
    in.cursor.take(lex);
    if (in.cursor.is(kind)) return;
    in.cursor.refuse(span, codes::kFunction, "EXISTS asks for a parameter", "write EXISTS[#<name>] or EXISTS[#5]");
  };
  expect(lex_value, TokenKind::open);
  expect(lex_value, TokenKind::hash);
  if (in.cursor.peek(lex_value).kind != TokenKind::name && in.syntax->exists_numbers) {
    real_value(in);
    expect(lex_operation, TokenKind::close);
    return in.out.push(Operation::exists_number, span);
  }
  expect(lex_value, TokenKind::name);
  const std::uint32_t name = read_name(in);
  expect(lex_operation, TokenKind::close);
  in.out.push(Operation::exists, span, 0, name);
}

// real value = number | "[" expression "]" | parameter | sign , real value | function
ValueKind real_value(BlockReading& in) {
  in.cursor.take(lex_value);
  switch (in.cursor.token().kind) {
    case TokenKind::number:
      in.out.push(Operation::number, in.cursor.span(), in.cursor.token().value);
      break;
    case TokenKind::open:
      return expression(in);
    case TokenKind::hash:
      parameter(in);
      break;
    case TokenKind::sign:
      signed_value(in);
      break;
    case TokenKind::function:
      function(in);
      break;
    case TokenKind::exists:
      exists(in);
      break;
    default:
      in.cursor.refuse_token("a value");
  }
  return ValueKind::number;
}

}  // namespace

std::uint32_t read_value(BlockReading& in) {
  const std::uint32_t begin = in.out.next_code();
  number_value(in, in.cursor.span());
  in.out.end_code();
  return begin;
}

std::uint32_t read_open_value(BlockReading& in) {
  const std::uint32_t begin = in.out.next_code();
  const Span before = in.cursor.span();
  need_number(in, open_value(in), before);
  in.out.end_code();
  return begin;
}

std::uint32_t read_condition(BlockReading& in) {
  const std::uint32_t begin = in.out.next_code();
  const Span open = in.cursor.span();
  need_condition(in, expression(in), open);
  in.out.end_code();
  return begin;
}

// name = "<" , { character } , ">"
std::uint32_t read_name(BlockReading& in) {
  const Span whole = in.cursor.span();
  const Span inside{whole.begin + 1, whole.end - 1};
  const std::string_view text = in.out.at(inside);
  if (std::all_of(text.begin(), text.end(), [](char c) { return is_blank(c); })) {
    in.cursor.refuse(whole, codes::kName, "a parameter without a name", "write a name between < and >");
  }
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x80 && c != '(' && c != ';') continue;
    in.cursor.refuse(whole, codes::kName, fmt::format("{} in the name of a parameter", shown(c)),
                     "name parameters with ASCII letters, digits and _");
  }
  return in.out.add_name(inside);
}

}  // namespace plumbline::nc

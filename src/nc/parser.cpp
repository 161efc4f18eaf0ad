#include "nc/parser.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "nc/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Binary operators bind in this order, each from the left [RS274/NGC 3.3.2.3; LinuxCNC: relations and logic below].
int precedence(Operation operation) {
  switch (operation) {
    case Operation::power:
      return 5;
    case Operation::times:
    case Operation::divide:
    case Operation::modulo:
      return 4;
    case Operation::plus:
    case Operation::minus:
      return 3;
    case Operation::logical_and:
    case Operation::logical_or:
    case Operation::exclusive_or:
      return 1;
    default:
      return 2;
  }
}

std::string shown(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte > 0x20 && byte < 0x7F ? fmt::format("'{}'", c) : fmt::format("byte {:#04x}", byte);
}

}  // namespace

void refuse_at(const Block& block, Span span, std::string_view code, std::string message, std::string help) {
  Place place;
  place.file = block.file;
  place.line = block.line;
  place.column = std::size_t{span.begin} + 1;
  place.length = std::max<std::size_t>(span.end - span.begin, 1);
  place.text = block.text;
  refuse(code, std::move(message), std::move(help), std::move(place));
}

// block = [ "/" ] , [ "N" , line number ] , { word | setting | comment }
void Parser::parse(Block& block) {
  block_ = &block;
  block.kind = LineKind::block;
  block.block_delete = false;
  block.slash = block.number = Span{};
  block.words.clear();
  block.comments.clear();
  block.settings.clear();
  block.code.clear();
  block.names.clear();
  seen_ = 0;
  at_ = block.text.data();
  if (block.offset == 0 && block.text.starts_with(kByteOrderMark)) at_ += kByteOrderMark.size();
  take(lex_item);
  if (token_.kind == TokenKind::percent) return percent();
  if (token_.kind == TokenKind::slash) {
    block.block_delete = true;
    block.slash = span_of(token_);
    take(lex_item);
  }
  if (token_.letter == 'N' && (token_.kind == TokenKind::word || token_.kind == TokenKind::letter)) {
    block.number = span_of(token_);
    if (token_.kind == TokenKind::letter || token_.begin[1] == '-' || token_.begin[1] == '+') {
      refuse_at(block, block.number, codes::kLineNumber, "N without a line number",
                "write digits behind the N, or leave it out");
    }
    take(lex_item);
  }
  items();
}

void Parser::percent() {
  block_->kind = LineKind::percent;
  take(lex_item);
  if (token_.kind == TokenKind::end) return;
  refuse_at(*block_, span_of(token_), codes::kPercentText, "text behind %",
            "leave % alone on its line; the control refuses anything else there");
}

void Parser::items() {
  while (true) {
    switch (token_.kind) {
      case TokenKind::word:
        literal_word();
        break;
      case TokenKind::letter:
        word(token_.letter);
        break;
      case TokenKind::comment:
        block_->comments.push_back({span_of(token_)});
        break;
      case TokenKind::hash:
        setting();
        break;
      case TokenKind::end:
        if (token_.begin < block_->text.data() + block_->text.size()) refuse_token("a word");
        return;
      default:
        refuse_token("a word");
    }
    take(lex_item);
  }
}

// word = letter , real value
void Parser::literal_word() {
  const Span span = span_of(token_);
  see(token_.letter, span);
  block_->words.push_back({token_.letter, token_.value, kLiteral, span, token_.decimals, false});
}

void Parser::word(char letter) {
  const Span span = span_of(token_);
  see(letter, span);
  const std::uint32_t code = value_code();
  const auto end = static_cast<std::uint32_t>(at_ - block_->text.data());
  block_->words.push_back({letter, 0, code, {span.begin, end}, 0, false});
}

// setting = "#" , ( name | real value ) , "=" , real value
void Parser::setting() {
  Setting setting;
  setting.span = span_of(token_);
  lex_value(at_, token_);
  if (token_.kind == TokenKind::name) {
    at_ = token_.end;
    setting.name = name();
  } else {
    setting.target = value_code();
  }
  setting.span.end = static_cast<std::uint32_t>(at_ - block_->text.data());
  take(lex_item);
  if (token_.kind != TokenKind::equals) {
    refuse_at(*block_, setting.span, codes::kAssignment, "a parameter stands here without a word or a value",
              "set it as in #5 = 3, or write the letter that its value is for");
  }
  setting.value = value_code();
  block_->settings.push_back(setting);
}

std::uint32_t Parser::value_code() {
  const auto begin = static_cast<std::uint32_t>(block_->code.size());
  real_value();
  push(Operation::end, {});
  return begin;
}

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
  real_value();
  if (negative) push(Operation::negate, span);
}

// expression = "[" , real value , { operation , real value } , "]"
void Parser::expression() {
  const Span open = span_of(token_);
  real_value();
  lex_operation(at_, token_);
  operations(1);
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
    const auto operation = static_cast<Operation>(token_.operation);
    if (precedence(operation) < least_precedence) return;
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
    span.end = static_cast<std::uint32_t>(at_ - block_->text.data());
    return push(Operation::name, span, 0, which);
  }
  real_value();
  span.end = static_cast<std::uint32_t>(at_ - block_->text.data());
  push(Operation::parameter, span);
}

// function = "ATAN" , expression , "/" , expression | function name , expression
void Parser::function() {
  const auto operation = static_cast<Operation>(token_.operation);
  const Span span = span_of(token_);
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

// exists = "EXISTS" , "[" , "#" , name , "]"
void Parser::exists() {
  Span span = span_of(token_);
  const auto expect = [&](void (*lex)(const char*, Token&), TokenKind kind) {
    take(lex);
    if (token_.kind == kind) return;
    refuse_at(*block_, span, codes::kFunction, "EXISTS asks for a named parameter", "write EXISTS[#<name>]");
  };
  expect(lex_value, TokenKind::open);
  expect(lex_value, TokenKind::hash);
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

void Parser::take(void (*lex)(const char*, Token&)) {
  lex(at_, token_);
  at_ = token_.end;
}

// Blanks that a token runs over may belong to the line end: a lone CR is a blank.
Span Parser::span_of(const Token& token) const {
  const char* const begin = block_->text.data();
  const auto offset = [&](const char* at) {
    return static_cast<std::uint32_t>(std::min(static_cast<std::size_t>(at - begin), block_->text.size()));
  };
  return {offset(token.begin), offset(token.end)};
}

void Parser::push(Operation operation, Span span, double number, std::uint32_t name) {
  block_->code.push_back({operation, name, number, span});
}

void Parser::see(char letter, Span span) {
  if (letter == 'G' || letter == 'M') return;
  const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(letter - 'A');
  if (letter == 'O') {
    refuse_at(*block_, span, codes::kFlowControl, "O words (loops, branches, subprograms) are not interpreted yet",
              "unroll the program with the control's simulator or the CAM system first");
  }
  if (letter == 'N') {
    refuse_at(*block_, span, codes::kLineNumber, "N inside a block", "a line number stands at the begin of its line");
  }
  if ((seen_ & bit) != 0) {
    refuse_at(*block_, span, codes::kWordTwice, fmt::format("two {} words in one block", letter), "leave one of them");
  }
  seen_ |= bit;
}

void Parser::refuse_token(std::string_view expected) {
  const std::string_view text = block_->text;
  const Span span = span_of(token_);
  const std::size_t nul = text.find('\0', std::min<std::size_t>(span.begin, text.size()));
  if (nul != std::string_view::npos) {
    const auto at = static_cast<std::uint32_t>(nul);
    refuse_at(*block_, {at, at + 1}, codes::kNulByte, "a NUL byte in the program",
              "the file is damaged or no text; fetch it again from where it came");
  }
  if (token_.kind == TokenKind::open_comment) {
    refuse_at(*block_, span, codes::kCommentOpen, "the comment ( is not closed", "add the missing )");
  }
  if (token_.kind == TokenKind::nested_comment) {
    refuse_at(*block_, span, codes::kCommentNested, "a comment inside a comment",
              "comments in ( ) do not nest; take out the inner (");
  }
  const char c = token_.kind == TokenKind::end ? '\0' : *token_.begin;
  if (static_cast<unsigned char>(c) >= 0x80) {
    refuse_at(*block_, span, codes::kNotAscii, fmt::format("{} outside a comment", shown(c)),
              "only comments may hold anything but ASCII characters");
  }
  if (c == '@' || c == '^' || c == '$') {
    refuse_at(*block_, span, codes::kNotInterpreted, fmt::format("{} words are not interpreted yet", shown(c)),
              c == '$' ? "leave out the spindle number" : "write the end point in X and Y");
  }
  if (expected == "a value" && c != '.' && c != '<') {
    refuse_at(*block_, span, codes::kValueMissing, "a value is missing here",
              "write a number, [expression], #parameter or function");
  }
  if (c == '.')
    refuse_at(*block_, span, codes::kBadNumber, "this is no number", "write digits before or behind one point");
  refuse_at(*block_, span, codes::kBadCharacter, fmt::format("{} cannot stand here", shown(c)),
            fmt::format("expected {}", expected));
}

}  // namespace plumbline::nc

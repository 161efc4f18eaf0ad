#include "nc/syntax/parser.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "nc/language/block_words.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {

std::string Parser::shown(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte > 0x20 && byte < 0x7F ? fmt::format("'{}'", c) : fmt::format("byte {:#04x}", byte);
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
  block.left_out.clear();
  block.arguments.clear();
  block.flow.word = FlowWord::none;
  seen_ = 0;
  at_ = block.text.data() + byte_order_mark_size(block);
  if (syntax_->names) return named_block();
  take(lex_item);
  if (token_.kind == TokenKind::percent) return percent();
  if (token_.kind == TokenKind::slash) {
    block.block_delete = true;
    block.slash = span_of(token_);
    if (syntax_->statements != Statements::o_words) skip_level();
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
  const bool macro_b = syntax_->statements == Statements::macro_b;
  if (macro_b && token_.kind != TokenKind::end && (program_name() || iso_program_number())) return;
  if (token_.letter == 'O' && (token_.kind == TokenKind::word || token_.kind == TokenKind::letter)) return flow();
  if (token_.kind == TokenKind::letter && macro_b) {
    refuse_output();
    if (macro_statement()) return;
  }
  items();
}

void Parser::percent() {
  block_->kind = LineKind::percent;
  take(lex_item);
  if (token_.kind == TokenKind::end || syntax_->percent_text) return;
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
        comment(span_of(token_));
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

// A control to which ; is the end of the block would execute what stands behind it.
void Parser::comment(Span span) {
  block_->comments.push_back({span});
  if (!syntax_->semicolon_ends || block_->at(span).front() != ';') return;
  const std::string_view text = block_->text;
  std::size_t at = span.begin + 1;
  while (true) {
    at = text.find_first_not_of(" \t\r;", at);
    if (at == std::string_view::npos || at >= span.end) return;
    const std::size_t close = text[at] == '(' ? text.find(')', at) : std::string_view::npos;
    if (close == std::string_view::npos) break;
    at = close + 1;
  }
  refuse_at(*block_, {static_cast<std::uint32_t>(at), span.end}, codes::kNotInterpreted,
            "; ends the block on this control, and what stands behind it is a block of its own",
            "put it on a line of its own, or, if it is a comment, into ( )");
}

// word = letter , real value
void Parser::literal_word() {
  const Span span = span_of(token_);
  see(token_.letter, span);
  block_->words.push_back(
      {token_.letter, token_.value, kLiteral, span, token_.decimals, false, token_.point, false, WordMode::modal});
}

void Parser::word(char letter) {
  const Span span = span_of(token_);
  see(letter, span);
  const std::uint32_t code = value_code();
  const auto end = here();
  block_->words.push_back({letter, 0, code, {span.begin, end}, 0, false, false, false, WordMode::modal});
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
  setting.span.end = here();
  take(lex_item);
  if (token_.kind != TokenKind::equals) {
    refuse_at(*block_, setting.span, codes::kAssignment, "a parameter stands here without a word or a value",
              "set it as in #5 = 3, or write the letter that its value is for");
  }
  setting.value = syntax_->open_assignment ? open_value_code() : value_code();
  setting.whole = {setting.span.begin, here()};
  block_->settings.push_back(setting);
}

std::uint32_t Parser::value_code() {
  const auto begin = static_cast<std::uint32_t>(block_->code.size());
  real_value();
  push(Operation::end, {});
  return begin;
}

void Parser::take(Lexer lex) {
  look(lex, token_);
  at_ = token_.end;
}

// A line that begins with $ is more of the same block.
void Parser::look(Lexer lex, Token& token) const {
  lex(at_, token);
  const char* const end = block_->text.data() + block_->text.size();
  while (syntax_->goes_on != '\0' && token.kind == TokenKind::end && token.begin < end && *token.begin == '\n') {
    lex(token.begin + 2, token);
  }
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

// Several spindles are LinuxCNC's alone; other controls write $ for things of their own.
void Parser::check_spindle_word(Span span) const {
  if (syntax_->statements == Statements::o_words) return;
  refuse_at(*block_, span, codes::kNotInterpreted, "$ words, which choose one of several spindles, are not interpreted",
            "leave out the spindle number");
}

void Parser::see(char letter, Span span) {
  if (letter == 'G' || letter == 'M') return;
  if (letter == '$') check_spindle_word(span);
  const std::uint32_t bit = letter_bit(letter);
  if (letter == 'O') {
    refuse_at(*block_, span, codes::kFlowControl, "an O word inside a block",
              "a line with an O word holds nothing before it but a line number");
  }
  if (letter == 'N') {
    refuse_at(*block_, span, codes::kLineNumber, "N inside a block", "a line number stands at the begin of its line");
  }
  if ((seen_ & bit) != 0 && !(syntax_->repeated_ijk && letter >= 'I' && letter <= 'K')) {
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
  if (c == ',' && syntax_->statements == Statements::macro_b) {
    refuse_at(*block_, span, codes::kNotInterpreted,
              "a comma begins what the control works out itself: a chamfer (,C), a rounding (,R) or an angle (,A)",
              "let the CAM system write the corner in G1, G2 and G3");
  }
  if (static_cast<unsigned char>(c) >= 0x80) {
    refuse_at(*block_, span, codes::kNotAscii, fmt::format("{} outside a comment", shown(c)),
              "only comments may hold anything but ASCII characters");
  }
  if (c == '$' && syntax_->names) {
    refuse_at(*block_, span, codes::kNotInterpreted,
              "names that begin with $ are variables of the control itself, which are not interpreted",
              "they read or set what only this machine has; write the values themselves");
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

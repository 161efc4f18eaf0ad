// How far the text of a block is read.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "nc/language/block.hpp"
#include "nc/language/dialect.hpp"
#include "nc/syntax/reading/lexer.hpp"

namespace plumbline::nc {

using Lexer = void (*)(const char*, Token&);

/// A character as a message shows it: 'x', or "byte 0x07".
std::string shown(char c);

class TokenCursor {
 public:
  /// The syntax must outlive it.
  explicit TokenCursor(const Syntax& syntax) : syntax_(&syntax) {}
  /// Reading begins at this byte of the block's text, after which there must be a line end or a NUL.
  void begin(const Block& block, std::size_t at);

  /// The token that take(), look() or accept() came to.
  const Token& token() const { return token_; }
  bool is(TokenKind kind) const { return token_.kind == kind; }
  bool is_letter(TokenKind kind, char letter) const { return token_.kind == kind && token_.letter == letter; }
  Operation operation() const { return static_cast<Operation>(token_.operation); }
  Span span() const { return span_of(token_); }
  /// The span of a token, as far as it lies in the block.
  Span span_of(const Token& token) const;

  /// The next token; reading goes on after it.
  void take(Lexer lex) {
    look(lex);
    at_ = token_.end;
  }
  /// The next token; reading goes on before it, until pass().
  void look(Lexer lex) { read(lex, token_); }
  void pass() { at_ = token_.end; }
  /// The next token, without coming to it.
  Token peek(Lexer lex) const {
    Token next;
    read(lex, next);
    return next;
  }
  /// Comes to a token that peek() gave; reading goes on after it.
  void accept(const Token& next) {
    token_ = next;
    at_ = next.end;
  }

  void go_after(const Token& token) { at_ = token.end; }
  void go_before(const Token& token) { at_ = token.begin; }

  /// The next byte to be read; 0 may be the end of the text.
  char next_byte() const { return *at_; }
  void pass_byte() { ++at_; }
  void pass_digits();
  /// The place of the next byte.
  std::uint32_t here() const { return static_cast<std::uint32_t>(at_ - block_->text.data()); }
  /// Reading goes on at this byte.
  void go_to(std::size_t place) { at_ = block_->text.data() + place; }
  bool at_end() const { return at_ >= block_->text.data() + block_->text.size(); }
  /// Nothing is left of the block: token() is its end, and not a NUL byte inside it.
  bool is_at_end_of_block() const {
    return token_.kind == TokenKind::end && token_.begin >= block_->text.data() + block_->text.size();
  }

  [[noreturn]] void refuse(Span span, std::string_view code, std::string message, std::string help) const;
  /// Refuses token() where `expected` should stand.
  [[noreturn]] void refuse_token(std::string_view expected) const;
  /// Refuses a token that is no word because the text is damaged, or a comment open or nested.
  void refuse_damage(Span span) const;

 private:
  void read(Lexer lex, Token& token) const;
  void refuse_byte(Span span, char c) const;
  void refuse_macro_statement(Span span) const;

  const Syntax* syntax_;
  const Block* block_ = nullptr;
  const char* at_ = nullptr;
  Token token_;
};

}  // namespace plumbline::nc

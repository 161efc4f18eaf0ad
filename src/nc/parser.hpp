// Text of one line -> Block. The member functions are the productions of grammar/block.ebnf.
#pragma once

#include <string>
#include <string_view>

#include "nc/block.hpp"
#include "nc/lexer.hpp"

namespace plumbline::nc {

/// Refuses with the place of `span` in the block.
[[noreturn]] void refuse_at(const Block& block, Span span, std::string_view code, std::string message,
                            std::string help);

/// Reads block.text into the rest of the block. Behind the text there must be a line end or a NUL.
/// block.file, text, line_end, line and offset are the caller's.
class Parser {
 public:
  void parse(Block& block);

 private:
  void percent();
  void flow();
  void flow_label();
  void flow_values(FlowWord word);
  void items();
  void word(char letter);
  void literal_word();
  void setting();
  std::uint32_t value_code();
  void real_value();
  void signed_value();
  void expression();
  void operations(int least_precedence);
  void parameter();
  void function();
  void exists();
  std::uint32_t name();

  void take(void (*lex)(const char*, Token&));
  Span span_of(const Token& token) const;
  void push(Operation operation, Span span, double number = 0, std::uint32_t name = 0);
  void see(char letter, Span span);
  [[noreturn]] void refuse_token(std::string_view expected);
  static std::string shown(char c);

  Block* block_ = nullptr;
  const char* at_ = nullptr;
  Token token_;
  std::uint32_t seen_ = 0;  // letters, A is bit 0
};

}  // namespace plumbline::nc

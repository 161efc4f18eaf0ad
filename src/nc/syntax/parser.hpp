// Text of one line -> Block. The member functions are the productions of grammar/block.ebnf.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "nc/language/block.hpp"
#include "nc/language/dialect.hpp"
#include "nc/syntax/lexer.hpp"

namespace plumbline::nc {

/// Reads block.text into the rest of the block. Behind the text there must be a line end or a NUL.
/// block.file, text, line_end, line and offset are the caller's.
class Parser {
 public:
  /// The dialect must outlive it.
  explicit Parser(const Dialect& dialect) : dialect_(&dialect), syntax_(&dialect.syntax) {}
  void parse(Block& block);

 private:
  void percent();
  void flow();
  void flow_label();
  void flow_values(FlowWord word);
  void next_value(FlowWord word);
  void items();
  void word(char letter);
  void comment(Span span);
  bool compares_ = false;                    // the expression being read has compared already
  std::optional<Operation> joined_by_ = {};  // a comparison or a logical operator of the bracket being read
  void refuse_unknown_binding(Operation operation);
  void literal_word();
  void setting();
  std::uint32_t value_code();
  void real_value();
  void signed_value();
  void refuse_second_sign() const;
  void expression();
  void operations(int least_precedence);
  void parameter();
  void function();
  void exists();
  std::uint32_t name();

  // Macro B: parser_macro.cpp
  void skip_level();
  bool program_name();
  bool iso_program_number();
  void refuse_output();
  bool macro_statement();
  void macro_condition();
  void macro_label();
  void macro_arc_tangent(Span span);
  std::uint32_t open_value_code();

  // Languages with names: parser_names.cpp, parser_statements.cpp
  void named_block();
  void header();
  bool draws();
  [[noreturn]] void refuse_goes_on(std::uint32_t at) const;
  bool block_label();
  bool is_code_of_motion() const;
  void program_name(Span span);
  void named_items();
  void named_word();
  void named_letter();
  void identifier();
  void code_by_name(Span span, int row);
  void address(const NameMeaning& meaning, Span span);
  void assigned_word(char letter, Span span, bool machine_axis = false);
  void assigned_variable(Span name, const NameMeaning* meaning);
  void tool_by_name(Span span);
  bool word_mode(WordMode& mode);
  void pass_comment();
  void pass_arguments();
  void value_arguments(Span name);
  std::string keyword();
  void case_statement();
  void repeat_statement(bool block_alone);
  void external_call();
  void expect_equals(Span name);
  bool next_is(TokenKind kind);
  void expect(TokenKind kind, std::string_view what);
  [[noreturn]] void refuse_reserved(Span span) const;

  std::uint32_t named_value_code();
  void named_value();
  void named_value_until(TokenKind kind);
  void named_term();
  void named_operations(int least_precedence);
  bool is_operation(Token& token) const;
  int named_precedence(Operation operation) const;
  static bool is_logical(Operation operation);
  void named_bracket();
  void named_identifier();
  bool is_numbered(std::string_view name) const;
  bool variable_place(std::string_view name, Span span);
  void call_function(const NameMeaning& meaning, Span span);

  void statement(FlowWord word);
  void named_jump(bool conditional);
  void jump_label();
  void call_statement();
  void call_by_name(Span name);
  void subprogram_head();
  void for_statement();
  void define_statement();
  void end_of_statement();

  using Lexer = void (*)(const char*, Token&);
  void take(Lexer lex);
  void look(Lexer lex, Token& token) const;
  Span span_of(const Token& token) const;
  std::uint32_t here() const { return static_cast<std::uint32_t>(at_ - block_->text.data()); }
  void push(Operation operation, Span span, double number = 0, std::uint32_t name = 0);
  void see(char letter, Span span);
  void check_spindle_word(Span span) const;
  [[noreturn]] void refuse_token(std::string_view expected);
  static std::string shown(char c);

  const Dialect* dialect_;
  const Syntax* syntax_;
  Block* block_ = nullptr;
  const char* at_ = nullptr;
  Token token_;
  std::uint32_t seen_ = 0;  // letters, A is bit 0
  bool drawing_ = false;    // between DEF WORK and END
};

}  // namespace plumbline::nc

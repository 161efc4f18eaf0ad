// A block that is being put together from what a line says.
#pragma once

#include <cstdint>
#include <string_view>

#include "nc/language/block.hpp"
#include "nc/language/block_words.hpp"
#include "nc/language/dialect.hpp"
#include "nc/syntax/reading/lexer.hpp"

namespace plumbline::nc {

class BlockBuilder {
 public:
  /// The syntax must outlive it.
  explicit BlockBuilder(const Syntax& syntax) : syntax_(&syntax) {}
  /// Forgets what `block` held; all that is added from here on is added to it.
  void begin(Block& block);

  const Block& block() const { return *block_; }
  std::string_view at(Span span) const { return block_->at(span); }
  void set_kind(LineKind kind) { block_->kind = kind; }
  void set_number(Span span) { block_->number = span; }
  /// The block begins with /.
  void set_slash(Span span);

  /// Refuses a second word of the letter, and letters that do not stand inside a block; codes may stand again.
  void see(char letter, Span span) {
    const std::uint32_t bit = letter_bit(letter);
    if (((seen_ | kLookedAt) & bit) != 0) look_at(letter, span);
    seen_ |= bit;
  }
  /// A letter and its number, seen here.
  void add_literal(const Token& token, Span span);
  void add(const Word& word) { block_->words.push_back(word); }
  Word& last_word() { return block_->words.back(); }
  /// Refuses what stands after a ; that ends the block.
  void add_comment(Span span);
  /// One that may hold anything.
  void add_any_comment(Span span) { block_->comments.push_back({span}); }
  void add_setting(const Setting& setting) { block_->settings.push_back(setting); }
  Setting& last_setting() { return block_->settings.back(); }
  /// A variable that is declared here, and is worth 0.
  void declare(Span name, VariableType type);
  void add_argument(const Argument& argument) { block_->arguments.push_back(argument); }
  /// Its place in Block::names.
  std::uint32_t add_name(Span span);

  /// What steers the program; reset by begin_flow.
  Flow& flow() { return block_->flow; }
  const Flow& flow() const { return block_->flow; }
  Flow& begin_flow(FlowWord word, Span span);

  /// Where the code of the next expression begins.
  std::uint32_t next_code() const { return static_cast<std::uint32_t>(block_->code.size()); }
  void push(Operation operation, Span span, double number = 0, std::uint32_t name = 0) {
    block_->code.push_back({operation, name, number, span});
  }
  bool ends_with(Operation operation) const {
    return !block_->code.empty() && block_->code.back().operation == operation;
  }
  void end_code() { push(Operation::end, {}); }
  /// The code of a plain number.
  std::uint32_t add_number(double number, Span span);
  /// Takes back the code from there on.
  void take_back_code(std::uint32_t from) { block_->code.resize(from); }

 private:
  static constexpr std::uint32_t kLookedAt =
      letter_bit('N') | letter_bit('O') | letter_bit('$') | letter_bit('@') | letter_bit('^');
  void look_at(char letter, Span span) const;

  const Syntax* syntax_;
  Block* block_ = nullptr;
  std::uint32_t seen_ = 0;  // letters, A is bit 0
};

}  // namespace plumbline::nc

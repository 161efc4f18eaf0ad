#include "nc/syntax/reading/block_builder.hpp"

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {

void BlockBuilder::begin(Block& block) {
  block_ = &block;
  block.clear();
  seen_ = 0;
}

void BlockBuilder::set_slash(Span span) {
  block_->block_delete = true;
  block_->slash = span;
}

namespace {

// Several spindles are LinuxCNC's alone; other controls write $ for things of their own.
void check_spindle_word(const Block& block, Span span, const Syntax& syntax) {
  if (syntax.spindle_words) return;
  refuse_at(block, span, codes::kNotInterpreted, "$ words, which choose one of several spindles, are not interpreted",
            "leave out the spindle number");
}

// LinuxCNC alone has words for radius and angle.
void check_polar_word(const Block& block, Span span, const Syntax& syntax) {
  if (syntax.polar_words) return;
  refuse_at(block, span, codes::kBadCharacter, fmt::format("{} begins no word of this control", block.at(span).front()),
            "give the end in X and Y");
}

}  // namespace

// A letter that was seen before, or is none of an ordinary word.
void BlockBuilder::look_at(char letter, Span span) const {
  if (letter == 'G' || letter == 'M') return;
  if (letter == '$') check_spindle_word(*block_, span, *syntax_);
  if (letter == '@' || letter == '^') check_polar_word(*block_, span, *syntax_);
  if (letter == 'O') {
    refuse_at(*block_, span, codes::kFlowControl, "an O word inside a block",
              "a line with an O word holds nothing before it but a line number");
  }
  if (letter == 'N') {
    refuse_at(*block_, span, codes::kLineNumber, "N inside a block", "a line number stands at the begin of its line");
  }
  const bool seen = (seen_ & letter_bit(letter)) != 0;
  if (seen && !(syntax_->repeated_ijk && letter >= 'I' && letter <= 'K')) {
    refuse_at(*block_, span, codes::kWordTwice, fmt::format("two {} words in one block", letter), "leave one of them");
  }
}

// word = letter , number
void BlockBuilder::add_literal(const Token& token, Span span) {
  see(token.letter, span);
  block_->words.push_back(
      {token.letter, token.value, kLiteral, span, token.decimals, false, token.point, false, WordMode::modal});
}

// A control to which ; is the end of the block would execute what stands after it.
void BlockBuilder::add_comment(Span span) {
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
            "; ends the block on this control, and what stands after it is a block of its own",
            "put it on a line of its own, or, if it is a comment, into ( )");
}

void BlockBuilder::declare(Span name, VariableType type) {
  Setting setting;
  setting.span = setting.whole = name;
  setting.name = add_name(name);
  setting.value = add_number(0, name);
  setting.type = type;
  add_setting(setting);
}

std::uint32_t BlockBuilder::add_name(Span span) {
  block_->names.push_back(span);
  return static_cast<std::uint32_t>(block_->names.size() - 1);
}

Flow& BlockBuilder::begin_flow(FlowWord word, Span span) {
  block_->flow = Flow{};
  block_->flow.word = word;
  block_->flow.span = span;
  return block_->flow;
}

std::uint32_t BlockBuilder::add_number(double number, Span span) {
  const std::uint32_t begin = next_code();
  push(Operation::number, span, number);
  end_code();
  return begin;
}

}  // namespace plumbline::nc

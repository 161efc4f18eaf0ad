#include "nc/rewrite/output/emit_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text/characters.hpp"
#include "base/text/number_text.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {
namespace {

char in_case(char c, bool lower) { return lower ? plumbline::lower(c) : c; }

// A block that is rewritten stands on one line: lines that begin with a mark and go on with it are joined.
void append_joined(std::string& out, std::string_view text) {
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    out += text.substr(0, end);
    while (!out.empty() && is_blank(out.back())) out.pop_back();
    out += ' ';
    const std::size_t next = text.find_first_not_of(" \t", end + 2);
    text.remove_prefix(std::min(next, text.size()));
  }
  out += text;
}

}  // namespace

Spelling spelling_of(const Block& block, const Spelling& like) {
  if (block.words.empty()) return like;
  const Span last = block.words.back().span;
  const bool lower_case = std::islower(static_cast<unsigned char>(block.text[last.begin])) != 0;
  if (block.words.size() == 1) return {lower_case, like.spaced, like.point, like.most_digits};
  const std::string_view before = block.text.substr(0, last.begin);
  const bool first_of_line = before.size() >= 2 && before[before.size() - 2] == '\n' && before.back() != '\n';
  return {lower_case, first_of_line || is_blank(before.back()), like.point, like.most_digits};
}

void BlockEditor::start(const Block& block, const Spelling& spelling) {
  block_ = &block;
  spelling_ = spelling;
  edits_.clear();
  texts_.clear();
}

std::string& BlockEditor::add(Span span) {
  edits_.push_back({span, texts_.size()});
  return texts_;
}

std::string& BlockEditor::replace(Span span) { return add(span); }

void BlockEditor::replace(Span span, std::string_view text) {
  if (text.empty()) {
    while (span.begin > 0 && is_blank(block_->text[span.begin - 1])) --span.begin;
  }
  add(span) += text;
}

void BlockEditor::insert_before(std::uint32_t at, std::string_view word) {
  std::string& text = add({at, at});
  append_in_spelling(text, word, spelling_);
  if (spelling_.spaced) text += ' ';
}

void BlockEditor::insert_after(std::uint32_t at, std::string_view word) {
  std::string& text = add({at, at});
  const bool at_begin = at == 0 || is_blank(block_->text[at - 1]);
  if (spelling_.spaced && !at_begin) text += ' ';
  append_in_spelling(text, word, spelling_);
}

// What is put in comes before what is replaced there.
bool BlockEditor::comes_before(const Edit& a, const Edit& b) {
  if (a.span.begin != b.span.begin) return a.span.begin < b.span.begin;
  return a.span.end == a.span.begin && b.span.end != b.span.begin;
}

void BlockEditor::apply(std::string& out) {
  if (edits_.empty()) {
    out += block_->text;
    return;
  }
  for (std::size_t i = 0; i < edits_.size(); ++i) {
    edits_[i].end = i + 1 < edits_.size() ? edits_[i + 1].begin : texts_.size();
  }
  if (!std::is_sorted(edits_.begin(), edits_.end(), comes_before)) {
    std::stable_sort(edits_.begin(), edits_.end(), comes_before);
  }
  const std::string_view text = block_->text;
  if (text.find('\n') != std::string_view::npos) {
    for_each_part([&](std::string_view kept, std::string_view changed) {
      append_joined(out, kept);
      out += changed;
    });
    return;
  }
  const std::size_t size = out.size();
  out.resize(size + text.size() + texts_.size());  // at most
  char* end = out.data() + size;
  for_each_part([&](std::string_view kept, std::string_view changed) {
    end = std::copy(kept.begin(), kept.end(), end);
    end = std::copy(changed.begin(), changed.end(), end);
  });
  out.resize(static_cast<std::size_t>(end - out.data()));
}

// What stands before each change, and the change; at last what stands behind them.
template <class Take>
void BlockEditor::for_each_part(const Take& take) const {
  const std::string_view text = block_->text;
  const std::string_view texts = texts_;
  std::uint32_t at = 0;
  for (const Edit& edit : edits_) {
    const std::uint32_t begin = std::max(edit.span.begin, at);  // two removals may claim the same blank
    take(text.substr(at, begin - at), texts.substr(edit.begin, edit.end - edit.begin));
    at = std::max(at, edit.span.end);
  }
  take(text.substr(at), std::string_view());
}

void append_in_spelling(std::string& out, std::string_view code, const Spelling& spelling) {
  if (!spelling.lower_case) {
    out += code;
    return;
  }
  for (const char c : code) out += plumbline::lower(c);
}

void drop_slash(BlockEditor& editor, const Step& step) {
  if (step.block_delete != BlockDelete::executed) return;
  const Block& block = *step.block;
  const bool behind_name = block.has_number() && block.number.end <= block.slash.begin;
  editor.replace(block.slash, behind_name ? " " : "");
}

std::string in_spelling(std::string_view code, const Spelling& spelling) {
  std::string text;
  append_in_spelling(text, code, spelling);
  return text;
}

void append_code(std::string& out, std::string_view code, const Spelling& spelling) {
  if (spelling.spaced && !out.empty() && !is_blank(out.back())) out += ' ';
  append_in_spelling(out, code, spelling);
}

void append_word(std::string& out, char letter, double value, int decimals, const Spelling& spelling) {
  if (spelling.spaced && !out.empty() && !is_blank(out.back())) out += ' ';
  std::array<char, kWordRoom> word;  // NOLINT(*-member-init)
  const char* const end = write_word(word.data(), letter, value, decimals, spelling);
  out.append(word.data(), static_cast<std::size_t>(end - word.data()));
}

int decimals_within(int most_digits, double value, int decimals) {
  if (most_digits == 0) return decimals;
  int before = 1;
  for (double rest = std::abs(value); rest >= 10; rest /= 10) ++before;
  return std::clamp(most_digits - before, 0, decimals);
}

char* write_word(char* out, char letter, double value, int decimals, const Spelling& spelling) {
  *out++ = in_case(letter, spelling.lower_case);
  constexpr double kExact = 1e15;  // units of the last decimal that a double counts
  constexpr double kAlwaysExact = kExact / kPowersOfTen[kMostDecimals];
  while (decimals > 0 && std::abs(value) > kAlwaysExact && std::abs(value) > kExact * from_ticks(1, decimals)) {
    --decimals;
  }
  char* end = write_decimal(out, value, decimals_within(spelling.most_digits, value, decimals));
  if (spelling.point && std::find(out, end, '.') == end) *end++ = '.';
  return end;
}

void refuse_block(const Block& block, std::string_view code, std::string message, std::string help) {
  refuse_at(block, {0, static_cast<std::uint32_t>(block.text.size())}, code, std::move(message), std::move(help));
}

}  // namespace plumbline::nc

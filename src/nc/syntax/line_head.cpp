#include "nc/syntax/line_head.hpp"

#include <algorithm>

#include "base/text/characters.hpp"
#include "nc/syntax/reading/archive_head.hpp"

namespace plumbline::nc {
namespace {

std::string upper_without_blanks(std::string_view text) { return upper(without_blanks(text)); }

bool holds_comments_alone(std::string_view text) {
  bool comment = false;
  for (const char c : text) {
    if (c == '(' || c == ')') {
      comment = c == '(';
    } else if (!comment && !is_blank(c)) {
      return c == ';';
    }
  }
  return true;
}

constexpr std::string_view kEndOfDosFile = "\x1a";

class HeadReader {
 public:
  HeadReader(std::string_view line, const Dialect& dialect) : line_(line), dialect_(dialect) {}

  LineHead read() {
    blanks();
    if (at_end() || line_[at_] == '(' || line_[at_] == ';' || line_[at_] == '$') {
      head_.empty = at_end() || line_[at_] != '(' || holds_comments_alone(line_.substr(at_));
      return head_;
    }
    if (line_[at_] == '%') return percent();
    if (line_.substr(at_) == kEndOfDosFile) {
      head_.empty = true;
      return head_;
    }
    if (line_[at_] == '/') skip_slash();
    if (dialect_.syntax.statements == Statements::macro_b) {
      macro();
    } else {
      names();
    }
    return head_;
  }

 private:
  bool at_end() const { return at_ >= line_.size(); }
  void blanks() {
    while (!at_end() && is_blank(line_[at_])) ++at_;
  }
  bool next_is(char letter) const { return !at_end() && upper(line_[at_]) == letter; }

  void skip_slash() {
    head_.behind_slash = true;
    ++at_;
    digits();
    blanks();
  }

  std::string_view digits() {
    const std::size_t begin = at_;
    while (!at_end() && is_digit(line_[at_])) ++at_;
    return line_.substr(begin, at_ - begin);
  }

  std::string_view identifier() {
    const std::size_t begin = at_;
    while (!at_end() && is_of_name(line_[at_])) ++at_;
    return line_.substr(begin, at_ - begin);
  }

  LineHead percent() {
    const std::string_view rest = line_.substr(at_);
    if (dialect_.syntax.archive_heads && is_archive_head(rest)) {
      head_.program = canonical_program(rest);
      head_.is_main = upper_without_blanks(rest).ends_with("_MPF");
    } else {
      head_.empty = true;
    }
    return head_;
  }

  void macro() {
    if (next_is('<')) {  // <PART-1> in place of O1234
      const std::size_t close = line_.find('>', at_);
      if (close != std::string_view::npos) head_.program = upper_without_blanks(line_.substr(at_, close + 1 - at_));
      return;
    }
    if (next_is('O') || next_is(':')) {  // :1234, as ISO tapes have it
      ++at_;
      blanks();
      if (!at_end() && is_digit(line_[at_])) head_.program = canonical_program(digits());
      return;
    }
    if (next_is('N')) {
      ++at_;
      blanks();
      head_.number = canonical_label('N' + std::string(digits()));
      blanks();
    }
    if (next_is('E')) return loop("END", 0, FlowWord::end_while);
    if (next_is('D')) return loop("DO", 0, FlowWord::begin_do);
    if (next_is('W')) loop("DO", line_.substr(0, line_.find('(')).rfind(']'), FlowWord::begin_while);
  }

  // END 1, DO 1, WHILE [..] DO 1: the keyword stands after what a comment is taken from, from `after` on.
  void loop(std::string_view keyword, std::size_t after, FlowWord word) {
    if (after == std::string_view::npos) return;
    const std::string_view code = line_.substr(0, line_.find('('));
    const std::size_t begin = std::max(at_, after == 0 ? 0 : after + 1);
    if (begin >= code.size()) return;
    const std::string rest = upper_without_blanks(code.substr(begin));
    const bool whole = rest.starts_with(keyword) && rest.size() > keyword.size() && is_digit(rest[keyword.size()]);
    if (!whole) return;
    head_.word = word;
    head_.loop = std::atoi(rest.c_str() + keyword.size());
  }

  void names() {
    const Syntax& syntax = dialect_.syntax;
    const bool sequence_names = syntax.labels == Labels::sequence_names;
    if (syntax.program_letter != '\0' && next_is(syntax.program_letter)) {
      head_.program = program_name(identifier(), dialect_);
      return;
    }
    if (next_is('N') && at_ + 1 < line_.size() && (sequence_names || is_digit(line_[at_ + 1]))) {
      const std::size_t begin = at_++;
      const std::string_view rest = sequence_names ? identifier() : digits();
      const std::string_view number = line_.substr(begin, 1 + rest.size());
      head_.number = canonical_label(number);
      head_.zeros = number.size() - head_.number.size();
      blanks();
      if (sequence_names && next_is('/')) skip_slash();  // N10 /X5 [G 3.1]
    } else if (next_is(':')) {
      ++at_;
      const std::string number = 'N' + std::string(digits());
      head_.number = canonical_label(number);
      head_.zeros = number.size() - head_.number.size();
      blanks();
    }
    std::string_view name = identifier();
    blanks();
    if (syntax.labels == Labels::names && !name.empty() && next_is(':')) {
      head_.label = canonical_label(name);
      ++at_;
      blanks();
      name = identifier();
    }
    head_.bare = name.empty() && (at_end() || line_[at_] == ';');
    const NameMeaning* const meaning = dialect_.meaning(name);
    if (meaning == nullptr || meaning->kind != NameMeaning::Kind::keyword) return;
    head_.word = static_cast<FlowWord>(meaning->which);
    const std::string_view rest = line_.substr(at_);
    const std::string code = upper_without_blanks(rest.substr(0, rest.find(';')));
    if (head_.word == FlowWord::begin_if && code.find("GOTO") != std::string::npos) head_.word = FlowWord::go_to;
    if (head_.word == FlowWord::begin_repeat && !code.empty()) head_.word = FlowWord::repeat_section;
    if (head_.word == FlowWord::sub) {
      blanks();
      head_.program.clear();
    }
  }

  std::string_view line_;
  const Dialect& dialect_;
  std::size_t at_ = 0;
  LineHead head_;
};

std::string without_zeros(const std::string& text, std::size_t from) {
  std::size_t digit = from;
  while (digit + 1 < text.size() && text[digit] == '0' && is_digit(text[digit + 1])) ++digit;
  return text.substr(0, from) + text.substr(digit);
}

bool digits_from(const std::string& text, std::size_t from) {
  return text.size() > from && std::all_of(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(), is_digit);
}

}  // namespace

LineHead head_of(std::string_view line, const Dialect& dialect) { return HeadReader(line, dialect).read(); }

bool holds_program_end(std::string_view line) {
  bool comment = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '(' || line[at] == ')') comment = line[at] == '(';
    const bool begins = upper(line[at]) == 'M' && (at == 0 || !is_of_name(line[at - 1]) || is_digit(line[at - 1]));
    if (comment || !begins) continue;
    const std::size_t first = std::min(line.find_first_not_of("0 ", at + 1), line.size());
    std::size_t end = first;
    while (end < line.size() && (is_digit(line[end]) || line[end] == '.')) ++end;
    const std::string_view number = line.substr(first, end - first);
    if (number == "2" || number == "30") return true;
  }
  return false;
}

std::string canonical_label(std::string_view text) {
  std::string label = upper_without_blanks(text);
  if (!label.empty() && label.front() == ':') label.front() = 'N';
  return !label.empty() && label.front() == 'N' && digits_from(label, 1) ? without_zeros(label, 1) : label;
}

std::size_t zeros_of_label(std::string_view text) {
  return upper_without_blanks(text).size() - canonical_label(text).size();
}

std::string canonical_program(std::string_view text) {
  std::string name = upper_without_blanks(text);
  if (is_archive_head(name)) {
    name.erase(0, name.starts_with("%_N_") ? 4 : 1);
    const std::size_t end = name.rfind('_');
    if (end != std::string::npos && end > 0) name.erase(end);
    return name;
  }
  if (digits_from(name, 0)) return without_zeros(name, 0);
  return !name.empty() && name.front() == 'O' && digits_from(name, 1) ? without_zeros(name, 1) : name;
}

std::string program_name(std::string_view text, const Dialect& dialect) {
  return dialect.syntax.statements == Statements::user_task ? upper_without_blanks(text) : canonical_program(text);
}

}  // namespace plumbline::nc

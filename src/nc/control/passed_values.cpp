#include "nc/control/passed_values.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/text/characters.hpp"
#include "base/text/number_text.hpp"

namespace plumbline::nc {
namespace {

constexpr std::size_t kMostDigits = 4;  // of the number of an R parameter

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// R12, and R alone, of R[12].
bool is_r_parameter(std::string_view name) {
  return upper(name.front()) == 'R' && std::all_of(name.begin() + 1, name.end(), is_digit);
}

bool is_variable(const Execution& run, std::string_view name) {
  return is_r_parameter(name) || run.control.parameters.find(name) != nullptr;
}

std::optional<std::string> value_of(const Execution& run, std::string_view name) {
  Value value{0, false};
  if (is_r_parameter(name)) {
    const std::string_view digits = name.substr(1);
    if (digits.empty() || digits.size() > kMostDigits) return std::nullopt;
    int number = 0;
    for (const char c : digits) number = number * 10 + (c - '0');
    if (run.control.parameters.has(number)) value = run.control.parameters.get(number);
  } else {
    value = *run.control.parameters.find(name);
  }
  if (!value.known || value.vacant) return std::nullopt;
  return to_decimal(value.number);
}

// The end of the name that begins here, or of the text in quotes.
std::size_t end_of_item(std::string_view text, std::size_t at) {
  if (text[at] == '"') return std::min(text.find('"', at + 1), text.size() - 1) + 1;
  std::size_t end = at + 1;
  while (end < text.size() && is_of_name(text[end])) ++end;
  return end;
}

// Where a text is joined to others by <<: "N "<<R2<<" mm" is "N 5 mm".
std::optional<std::string> joined(const Execution& run, std::string_view text) {
  std::string whole;
  while (true) {
    text = trimmed(text);
    if (text.empty()) return std::nullopt;
    const std::size_t end = end_of_item(text, 0);
    const std::string_view item = text.substr(0, end);
    if (item.front() == '"') {
      whole += item.substr(1, item.size() - 2);
    } else if (const auto value = is_variable(run, item) ? value_of(run, item) : std::nullopt) {
      whole += *value;
    } else {
      return std::nullopt;
    }
    text = trimmed(text.substr(end));
    if (text.empty()) return '"' + whole + '"';
    if (!text.starts_with("<<")) return std::nullopt;
    text.remove_prefix(2);
  }
}

// One word with what stands behind its name.
class PassedByWord {
 public:
  PassedByWord(const Execution& run, const Block& block, const Word& word, std::size_t begin, PassedValues& passed)
      : run_(run), text_(block.at(word.span)), offset_(word.span.begin), begin_(begin), passed_(passed) {}

  void find() {
    if (text_.find("<<", begin_) != std::string_view::npos) return find_joined();
    for (std::size_t at = begin_; at < text_.size();) {
      const std::size_t end = end_of_item(text_, at);
      if (text_[at] == '"' || !is_of_name(text_[at]) || is_digit(text_[at])) {
        at = text_[at] == '"' ? end : at + 1;
        continue;
      }
      const std::string_view name = text_.substr(at, end - at);
      if (is_variable(run_, name)) add(at, end, value_of(run_, name));
      at = end;
    }
  }

 private:
  // MSG("N "<<R2, 1): the values of the brackets one by one
  void find_joined() {
    std::size_t from = text_.find('(', begin_);
    for (std::size_t at = from; at < text_.size();) {
      const bool ends = at > from && (text_[at] == ',' || text_[at] == ')');
      if (ends) {
        if (const std::string_view part = text_.substr(from + 1, at - from - 1); part.find("<<") != std::string::npos) {
          add(from + 1, at, joined(run_, part));
        }
        from = at;
      }
      at = text_[at] == '"' ? end_of_item(text_, at) : at + 1;
    }
  }

  void add(std::size_t begin, std::size_t end, std::optional<std::string> value) {
    if (!value) {
      passed_.unknown = true;
      return;
    }
    const std::size_t before = text_.find_last_not_of(" \t", begin - 1);
    const bool alone =
        before == std::string_view::npos || std::string_view("=(,[").find(text_[before]) != std::string::npos;
    if (value->front() == '-' && !alone) *value = '(' + *value + ')';
    const auto place = [&](std::size_t at) { return offset_ + static_cast<std::uint32_t>(at); };
    passed_.values.push_back({{place(begin), place(end)}, std::move(*value)});
  }

  const Execution& run_;
  std::string_view text_;
  std::uint32_t offset_;
  std::size_t begin_;
  PassedValues& passed_;
};

}  // namespace

PassedValues passed_values(const Execution& run, const Block& block) {
  PassedValues passed;
  for (const Word& word : block.words) {
    if (word.letter != kNamedCode) continue;
    const CodeRow& row = run.dialect.named_codes[static_cast<std::size_t>(word.value)];
    if (row.has_arguments) PassedByWord(run, block, word, row.name.size(), passed).find();
  }
  if (!passed.values.empty() && !block.settings.empty()) passed.unknown = true;  // which may set them
  return passed;
}

}  // namespace plumbline::nc

#include "base/text/csv.hpp"

#include <algorithm>

#include "base/text/characters.hpp"

namespace plumbline {
namespace {

constexpr std::string_view kBlanks = " \t\r";

}  // namespace

CsvLines::CsvLines(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {
  rest_.remove_prefix(byte_order_mark_size(rest_));
}

bool CsvLines::next() {
  while (!rest_.empty()) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    if (line_.find_first_not_of(kBlanks) != std::string_view::npos) return true;
  }
  number_ = std::max<std::size_t>(number_, 1);
  return false;
}

std::vector<CsvField> CsvLines::fields() const {
  std::vector<CsvField> fields;
  for (std::size_t begin = 0; begin <= line_.size();) {
    const std::size_t end = std::min(line_.find(',', begin), line_.size());
    std::string_view text = line_.substr(begin, end - begin);
    const std::size_t first = std::min(text.find_first_not_of(kBlanks), text.size());
    text = text.substr(first);
    text = text.substr(0, text.find_last_not_of(kBlanks) + 1);
    fields.push_back({text, begin + first + 1});
    begin = end + 1;
  }
  return fields;
}

Place CsvLines::place() const {
  return {file_, number_, 1, std::max<std::size_t>(line_.size(), 1), std::string(line_)};
}

Place CsvLines::place(const CsvField& field) const {
  return {file_, number_, field.column, std::max<std::size_t>(field.text.size(), 1), std::string(line_)};
}

}  // namespace plumbline

#include "base/text/csv.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "base/text/encoding.hpp"

namespace plumbline {
namespace {

constexpr std::string_view kBlanks = " \t\r";

}  // namespace

CsvLines::CsvLines(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {
  refuse_not_text(rest_, file_);
  rest_.remove_prefix(byte_order_mark_size(rest_));
}

bool CsvLines::next() {
  while (!rest_.empty()) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    if (const std::size_t at = lone_carriage_return(line_); at != std::string_view::npos) {
      refuse("csv-line-end", std::string(kLoneCarriageReturn), std::string(kOtherLineEnds),
             {file_, number_, at + 1, 1, std::string(line_)});
    }
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

std::string other_separator(std::string_view line) {
  if (line.find(',') != std::string_view::npos && line.find(';') == std::string_view::npos) return {};
  for (const auto& [separator, name] : {std::pair(';', "semicolons"), std::pair('\t', "tabs")}) {
    if (line.find(separator) == std::string_view::npos) continue;
    return fmt::format("the columns seem to be separated by {}: put commas between them, and a point for decimals",
                       name);
  }
  return {};
}

Place CsvLines::place() const {
  return {file_, number_, 1, std::max<std::size_t>(line_.size(), 1), std::string(line_)};
}

Place CsvLines::place(const CsvField& field) const {
  return {file_, number_, field.column, std::max<std::size_t>(field.text.size(), 1), std::string(line_)};
}

}  // namespace plumbline

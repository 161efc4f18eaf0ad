#include "imported/foreign_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/files/files.hpp"
#include "base/files/input_name.hpp"
#include "base/text/characters.hpp"
#include "base/text/nearest_name.hpp"
#include "base/text/number_text.hpp"
#include "imported/foreign_text.hpp"

namespace plumbline::imported {
namespace {

constexpr std::string_view kBlanks = " \t\r";

struct Field {
  std::string_view text;   // without blanks and quotes around it
  std::size_t column = 1;  // in its line, in bytes
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

Field field_of(std::string_view line, std::size_t begin, std::size_t end) {
  std::string_view text = trimmed(line.substr(begin, end - begin));
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = trimmed(text.substr(1, text.size() - 2));
  const std::size_t column = text.empty() ? begin : static_cast<std::size_t>(text.data() - line.data());
  return {text, column + 1};
}

std::vector<Field> fields_of(std::string_view line, char delimiter) {
  std::vector<Field> fields;
  if (delimiter == ' ') {
    for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
      fields.push_back(field_of(line, at, end));
      at = line.find_first_not_of(kBlanks, end);
    }
    return fields;
  }
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (line[i] != delimiter || quoted)) continue;
    fields.push_back(field_of(line, begin, i));
    begin = i + 1;
  }
  return fields;
}

class ForeignReader {
 public:
  ForeignReader(const std::string& path, const Source& source) : source_(source), form_(source.form) {
    table_.file = input_name(path);
    Decoded text = decoded(table_.file, read_text(path), form_.encoding);
    table_.encoding = text.encoding;
    text_ = std::move(text.text);
  }

  ForeignTable read() {
    table_.values.resize(source_.columns.size());
    std::size_t lines_of_header = (form_.header ? 1 : 0) + form_.unit_lines;
    bool named = !form_.header;
    if (named) find_columns({});
    std::string_view rest = text_;
    for (number_ = 1; !rest.empty(); ++number_) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      line_ = rest.substr(0, end);
      if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (const std::size_t at = lone_carriage_return(line_); at != std::string_view::npos) {
        refuse("import-line-end", std::string(kLoneCarriageReturn), std::string(kOtherLineEnds),
               {table_.file, number_, at + 1, 1, std::string(line_)});
      }
      if (number_ <= form_.skip_lines || trimmed(line_).empty() || is_comment()) continue;
      if (lines_of_header > 0) {
        if (!named) find_columns(fields_of(line_, form_.delimiter));
        named = true;
        --lines_of_header;
        continue;
      }
      if (!form_.lost.empty() && trimmed(line_) == form_.lost) {
        refuse_lost();
        continue;
      }
      read_row();
    }
    if (table_.rows() == 0) {
      refuse("import-empty", "the table has no rows",
             "does the map say how the file is written: skip_lines, header, unit_lines, comment?", {table_.file});
    }
    return std::move(table_);
  }

 private:
  Place place(std::size_t column = 1, std::size_t length = 1) const {
    return {table_.file, number_, column, std::max<std::size_t>(length, 1), std::string(line_)};
  }

  // What would divide a line that the delimiter does not divide.
  std::optional<std::string> form_hint(std::size_t fields) const {
    if (fields > 1) return std::nullopt;
    for (const auto& [mark, said] : {std::pair{'\t', "tab"}, std::pair{';', ";"}, std::pair{',', ","}}) {
      if (mark == form_.delimiter || line_.find(mark) == std::string_view::npos) continue;
      return fmt::format("the line is not divided: say delimiter = \"{}\" in [table] of the map", said);
    }
    return std::nullopt;
  }

  bool is_comment() const {
    return std::any_of(form_.comments.begin(), form_.comments.end(),
                       [&](const std::string& mark) { return !mark.empty() && trimmed(line_).starts_with(mark); });
  }

  void find_columns(const std::vector<Field>& header) {
    std::vector<std::string_view> names;
    for (const Field& field : header) names.push_back(field.text);
    header_width_ = names.size();
    for (const ColumnSource& column : source_.columns) {
      if (column.number > 0) {
        table_.numbers.push_back(column.number);
        table_.names.emplace_back(column.number <= names.size() ? names[column.number - 1] : "");
        continue;
      }
      const auto found = std::find(names.begin(), names.end(), column.name);
      if (found == names.end()) {
        refuse("import-no-column",
               fmt::format("line {} of {} names no column \"{}\"", number_, table_.file, column.name),
               form_hint(names.size()).value_or(suggestion(column.name, names)), place(1, line_.size()));
      }
      if (std::count(names.begin(), names.end(), column.name) > 1) {
        refuse("import-no-column", fmt::format("two columns are called \"{}\"", column.name),
               "say column = 3 in the map, counted from 1", place(1, line_.size()));
      }
      table_.numbers.push_back(static_cast<std::size_t>(found - names.begin()) + 1);
      table_.names.push_back(column.name);
    }
  }

  // Its first line may say so of what was before the recording.
  void refuse_lost() const {
    if (table_.rows() == 0) return;
    refuse("import-lost-samples", fmt::format("samples were lost here: \"{}\"", form_.lost),
           "record anew with a deeper buffer, or import what is before and behind this line from files of their own",
           place(1, line_.size()));
  }

  // A decimal comma in a file that commas divide makes two fields of a number, and moves those behind it.
  void check_surplus(const std::vector<Field>& fields) const {
    if (header_width_ == 0 || fields.size() <= header_width_) return;
    const auto surplus = fields.begin() + static_cast<std::ptrdiff_t>(header_width_);
    if (std::all_of(surplus, fields.end(), [](const Field& field) { return field.text.empty(); })) return;
    refuse("import-columns",
           fmt::format("line {} has {} columns, and the header has {}", number_, fields.size(), header_width_),
           "is a decimal comma taken for a delimiter? Notes behind the last column need a name in the header",
           place(1, line_.size()));
  }

  void read_row() {
    const std::vector<Field> fields = fields_of(line_, form_.delimiter);
    table_.width = std::max(table_.width, fields.size());
    check_surplus(fields);
    for (std::size_t c = 0; c < source_.columns.size(); ++c) {
      if (table_.numbers[c] > fields.size()) {
        refuse("import-columns",
               fmt::format("line {} has {} columns, and {} is column {}", number_, fields.size(),
                           to_text(source_.columns[c].quantity), table_.numbers[c]),
               form_hint(fields.size())
                   .value_or("is the delimiter right? A line of another kind can be passed over with comment = "
                             "[\"...\"], a line cut off at the end deleted"),
               place(1, line_.size()));
      }
      table_.values[c].push_back(value_of(fields[table_.numbers[c] - 1], source_.columns[c]));
    }
    table_.lines.push_back(number_);
    table_.text.emplace_back(line_);
  }

  double value_of(const Field& field, const ColumnSource& column) const {
    if (std::find(form_.missing.begin(), form_.missing.end(), field.text) != form_.missing.end()) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    std::string number(field.text);
    const char other = form_.decimal == ',' ? '.' : ',';
    const bool other_mark = number.find(other) != std::string::npos;
    if (form_.decimal == ',') std::replace(number.begin(), number.end(), ',', '.');
    const std::optional<double> value = other_mark ? std::nullopt : parse_number(number);
    if (!value) {
      refuse("import-number", fmt::format("\"{}\" is no number", field.text),
             other_mark
                 ? fmt::format("the map says decimal = \"{}\"", form_.decimal)
                 : "is the line a comment, or a unit? say comment or unit_lines in the map; missing = [\"...\"] names "
                   "what stands where there is no reading",
             place(field.column, field.text.size()));
    }
    return (*value - column.minus) * column.factor;
  }

  const Source& source_;
  const TableForm& form_;
  ForeignTable table_;
  std::string text_;
  std::string_view line_;
  std::size_t number_ = 0;
  std::size_t header_width_ = 0;  // 0: there is none
};

}  // namespace

ForeignTable read_foreign_table(const std::string& path, const Source& source) {
  return ForeignReader(path, source).read();
}

}  // namespace plumbline::imported

#include "base/text/number_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/text/number_text.hpp"

namespace plumbline {
namespace {

constexpr double kLargest = 1e6;

class Reader {
 public:
  Reader(const std::string& file, std::string_view text, const std::vector<NumberColumn>& columns,
         std::string_view header)
      : columns_(columns), lines_(file, text) {
    take_header(header);
  }

  NumberTable read() {
    while (lines_.next()) {
      const std::vector<CsvField> fields = lines_.fields();
      if (!is_blank(fields)) table_.rows.push_back(row_of(fields));
    }
    return std::move(table_);
  }

 private:
  static bool is_blank(const std::vector<CsvField>& fields) {
    return std::all_of(fields.begin(), fields.end(), [](const CsvField& field) { return field.text.empty(); });
  }

  void take_header(std::string_view header) {
    const std::vector<CsvField> names = lines_.next() ? lines_.fields() : std::vector<CsvField>{};
    count_ = names.size();
    table_.header = lines_.place();
    for (const NumberColumn& column : columns_) {
      const auto is_it = [&](const CsvField& name) { return name.text == column.name; };
      const auto found = std::find_if(names.begin(), names.end(), is_it);
      if (found == names.end() && column.required) {
        const std::string separated = other_separator(lines_.place().text);
        refuse("csv-header", fmt::format("the first line does not name a column {}", column.name),
               separated.empty() ? fmt::format("begin the file with the line {}", header) : separated, lines_.place());
      }
      const auto again = found == names.end() ? found : std::find_if(found + 1, names.end(), is_it);
      if (again != names.end()) {
        refuse("csv-same-column", fmt::format("there are two columns {}", column.name), "leave one of them out",
               lines_.place(*again));
      }
      table_.has.push_back(found != names.end());
      at_.push_back(static_cast<std::size_t>(found - names.begin()));
    }
  }

  NumberTable::Row row_of(const std::vector<CsvField>& fields) const {
    if (fields.size() != count_) {
      refuse("csv-columns",
             fmt::format("row {} has {} columns, and the first line names {}", lines_.number(), fields.size(), count_),
             "write one number for each column, a point for decimals and a comma between columns", lines_.place());
    }
    NumberTable::Row row{{}, lines_.place()};
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      row.values.push_back(table_.has[i] ? number(fields[at_[i]], columns_[i])
                                         : std::numeric_limits<double>::quiet_NaN());
    }
    return row;
  }

  double number(const CsvField& field, const NumberColumn& column) const {
    const std::optional<double> value = parse_number(field.text);
    if (value && std::abs(*value) <= kLargest) return *value;
    refuse(
        "csv-number",
        fmt::format("row {}, column {}: \"{}\" is no number up to a million", lines_.number(), column.name, field.text),
        fmt::format("expected a finite number in {}, as in -12.5", column.unit), lines_.place(field));
  }

  const std::vector<NumberColumn>& columns_;
  CsvLines lines_;
  std::size_t count_ = 0;        // of columns in the file
  std::vector<std::size_t> at_;  // where each column stands
  NumberTable table_;
};

}  // namespace

NumberTable read_number_table(const std::string& file, std::string_view text, const std::vector<NumberColumn>& columns,
                              std::string_view header) {
  return Reader(file, text, columns, header).read();
}

}  // namespace plumbline

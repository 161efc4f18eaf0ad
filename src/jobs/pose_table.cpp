#include "jobs/pose_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/files.hpp"
#include "base/number_text.hpp"

namespace plumbline::jobs {
namespace {

constexpr std::array<std::string_view, kAxes> kColumns{"x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg"};
constexpr std::string_view kHeader = "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg";
constexpr double kLargest = 1e6;  // mm, deg
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

struct Field {
  std::string_view text;   // without the blanks around it
  std::size_t column = 1;  // of the text in its line
};

std::vector<Field> fields_of(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r";
  std::vector<Field> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::string_view text = line.substr(begin, end - begin);
    const std::size_t first = std::min(text.find_first_not_of(kBlanks), text.size());
    text = text.substr(first);
    text = text.substr(0, text.find_last_not_of(kBlanks) + 1);
    fields.push_back({text, begin + first + 1});
    begin = end + 1;
  }
  return fields;
}

class Reader {
 public:
  explicit Reader(const std::string& path) : file_(path == kStandardStream ? "<stdin>" : path) {}

  void take_line(std::string_view line) {
    ++number_;
    line_ = line;
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    if (!has_header_) {
      take_header();
    } else if (line_.find_first_not_of(" \t,") != std::string_view::npos) {
      take_row();
    }
  }

  std::vector<PoseRow> take() {
    if (!has_header_) take_header();
    return std::move(rows_);
  }

 private:
  Place place(std::size_t column, std::size_t length) const {
    return {file_, number_, column, std::max<std::size_t>(length, 1), std::string(line_)};
  }

  void take_header() {
    if (line_.starts_with(kByteOrderMark)) line_.remove_prefix(kByteOrderMark.size());
    const std::vector<Field> names = fields_of(line_);
    count_ = names.size();
    for (std::size_t i = 0; i < kAxes; ++i) {
      const auto found =
          std::find_if(names.begin(), names.end(), [&](const Field& name) { return name.text == kColumns[i]; });
      if (found == names.end()) {
        number_ = std::max<std::size_t>(number_, 1);
        refuse("csv-header", fmt::format("the first line does not name a column {}", kColumns[i]),
               fmt::format("begin the file with the line {}", kHeader), place(1, line_.size()));
      }
      at_[i] = static_cast<std::size_t>(found - names.begin());
    }
    has_header_ = true;
  }

  void take_row() {
    const std::vector<Field> fields = fields_of(line_);
    if (fields.size() != count_) {
      refuse("csv-columns",
             fmt::format("row {} has {} columns, and the first line names {}", number_, fields.size(), count_),
             "write one number for each column, a point for decimals and a comma between columns",
             place(1, line_.size()));
    }
    PoseRow row{{}, place(1, line_.size())};
    for (std::size_t i = 0; i < kAxes; ++i) {
      const Field& field = fields[at_[i]];
      const std::optional<double> value = parse_number(field.text);
      if (!value || std::abs(*value) > kLargest) {
        refuse("csv-number",
               fmt::format("row {}, column {}: \"{}\" is no number up to a million", number_, kColumns[i], field.text),
               fmt::format("expected a finite number in {}, as in -12.5", i < 3 ? "mm" : "deg"),
               place(field.column, field.text.size()));
      }
      row.pose.values[i] = *value;
    }
    rows_.push_back(std::move(row));
  }

  std::string file_;
  std::string_view line_;
  std::size_t number_ = 0;
  bool has_header_ = false;
  std::size_t count_ = 0;                // of columns
  std::array<std::size_t, kAxes> at_{};  // the column of each axis
  std::vector<PoseRow> rows_;
};

}  // namespace

std::vector<PoseRow> read_poses(const std::string& path) {
  const std::string text = read_text(path);
  Reader reader(path);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    reader.take_line(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
  }
  return reader.take();
}

}  // namespace plumbline::jobs

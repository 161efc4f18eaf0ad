#include "jobs/pose_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/number_text.hpp"

namespace plumbline::jobs {
namespace {

constexpr std::array<std::string_view, kAxes> kColumns{"x_mm", "y_mm", "z_mm", "a_deg", "b_deg", "c_deg"};
constexpr std::string_view kHeader = "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg";
constexpr double kLargest = 1e6;  // mm, deg

class Reader {
 public:
  Reader(const std::string& path, std::string_view text) : lines_(path == kStandardStream ? "<stdin>" : path, text) {
    take_header();
  }

  std::vector<PoseRow> rows() {
    std::vector<PoseRow> rows;
    while (lines_.next()) {
      const std::vector<CsvField> fields = lines_.fields();
      if (!is_blank(fields)) rows.push_back(row_of(fields));
    }
    return rows;
  }

 private:
  // Spreadsheets leave such rows behind.
  static bool is_blank(const std::vector<CsvField>& fields) {
    return std::all_of(fields.begin(), fields.end(), [](const CsvField& field) { return field.text.empty(); });
  }

  void take_header() {
    const std::vector<CsvField> names = lines_.next() ? lines_.fields() : std::vector<CsvField>{};
    count_ = names.size();
    for (std::size_t i = 0; i < kAxes; ++i) {
      const auto found =
          std::find_if(names.begin(), names.end(), [&](const CsvField& name) { return name.text == kColumns[i]; });
      if (found == names.end()) {
        refuse("csv-header", fmt::format("the first line does not name a column {}", kColumns[i]),
               fmt::format("begin the file with the line {}", kHeader), lines_.place());
      }
      at_[i] = static_cast<std::size_t>(found - names.begin());
    }
  }

  PoseRow row_of(const std::vector<CsvField>& fields) const {
    if (fields.size() != count_) {
      refuse("csv-columns",
             fmt::format("row {} has {} columns, and the first line names {}", lines_.number(), fields.size(), count_),
             "write one number for each column, a point for decimals and a comma between columns", lines_.place());
    }
    PoseRow row{{}, lines_.place()};
    for (std::size_t i = 0; i < kAxes; ++i) {
      const CsvField& field = fields[at_[i]];
      const std::optional<double> value = parse_number(field.text);
      if (!value || std::abs(*value) > kLargest) {
        refuse("csv-number",
               fmt::format("row {}, column {}: \"{}\" is no number up to a million", lines_.number(), kColumns[i],
                           field.text),
               fmt::format("expected a finite number in {}, as in -12.5", i < 3 ? "mm" : "deg"), lines_.place(field));
      }
      row.pose.values[i] = *value;
    }
    return row;
  }

  CsvLines lines_;
  std::size_t count_ = 0;                // of columns
  std::array<std::size_t, kAxes> at_{};  // the column of each axis
};

}  // namespace

std::vector<PoseRow> read_poses(const std::string& path) {
  const std::string text = read_text(path);
  return Reader(path, text).rows();
}

}  // namespace plumbline::jobs

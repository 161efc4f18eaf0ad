// Tables of numbers: CSV with a first line that names columns.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/csv.hpp"

namespace plumbline {

struct NumberColumn {
  std::string_view name;
  std::string_view unit;
  bool required = true;
};

struct NumberTable {
  struct Row {
    std::vector<double> values;  // in the order that was asked for; not a number in columns that are not there
    Place place;
  };
  std::vector<bool> has;  // of the columns that were asked for, which are there
  std::vector<Row> rows;
  Place header;
};

/// Reads columns found by the names of the first line, in any order; others are passed over, and so are rows of empty
/// fields, which spreadsheets leave behind. Refuses with csv-header a required column that is not there (`header`: a
/// line that would do), csv-same-column one that is there twice, csv-columns a row of another length, csv-number what
/// is no finite number up to a million.
NumberTable read_number_table(const std::string& file, std::string_view text, const std::vector<NumberColumn>& columns,
                              std::string_view header);

}  // namespace plumbline

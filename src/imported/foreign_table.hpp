// A table as an instrument or a control wrote it, read by a map.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "imported/map_file.hpp"

namespace plumbline::imported {

struct ForeignTable {
  std::string file;
  std::string encoding;                     // that it was taken for
  std::vector<std::vector<double>> values;  // of each column of the source, SI; NaN: no reading
  std::vector<std::string> names;           // of these columns in the header; empty: there is none
  std::vector<std::size_t> numbers;         // of these columns, from 1
  std::vector<std::size_t> lines;           // of the file, of each row
  std::size_t width = 0;                    // columns that the file has
  std::vector<std::string> text;            // the lines themselves, for places

  std::size_t rows() const { return lines.size(); }
  Place place(std::size_t row) const {
    return {file, lines[row], 1, std::max<std::size_t>(1, text[row].size()), text[row]};
  }
};

/// Refuses with import-encoding, import-no-column a column that the header does not have, import-columns a row without
/// it, import-number what is no number, import-lost-samples, and import-empty a table without rows, at line and column.
ForeignTable read_foreign_table(const std::string& path, const Source& source);

}  // namespace plumbline::imported

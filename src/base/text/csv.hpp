// A CSV text line by line, and what stands between its commas.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"

namespace plumbline {

struct CsvField {
  std::string_view text;   // without the blanks around it
  std::size_t column = 1;  // of the text in its line
};

class CsvLines {
 public:
  /// `text` must outlive this. A byte order mark is passed over. Refuses as refuse_not_text does.
  CsvLines(std::string file, std::string_view text);

  /// Goes to the next line that is not blank; false at the end, where the last line stays. Refuses with csv-line-end a
  /// carriage return inside a line.
  bool next();
  std::size_t number() const { return number_; }
  std::vector<CsvField> fields() const;
  /// Of the line, of a field of it.
  Place place() const;
  Place place(const CsvField& field) const;

 private:
  std::string file_;
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;  // of the line, from 1
};

/// What to do about a first line whose columns are separated by semicolons or tabs; empty: they are not.
std::string other_separator(std::string_view line);

}  // namespace plumbline

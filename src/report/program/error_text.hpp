// The error of the machine at rest, pose by pose: a table as CSV, and words.
#pragma once

#include <string>
#include <string_view>

#include "base/files/files.hpp"
#include "jobs/error_table.hpp"

namespace plumbline::report {

/// Writes a row for every pose: the pose (mm, deg), commanded strut lengths (mm), nut tensions (N), stretches (um), the
/// error of the tip (um) and its rotation vector (urad), in W.
class ErrorTable {
 public:
  /// Writes the names of the columns, `with_expected` those of what is expected besides. `output` is kept by reference.
  explicit ErrorTable(OutputFile& output, bool with_expected = false);
  void add(const jobs::PoseError& error);

 private:
  OutputFile& output_;
  bool with_expected_;
  std::string row_;
};

/// The names of these columns, between commas.
std::string_view error_columns();

/// `"plumbline": "error 1"`
std::string error_json(const jobs::ErrorTableSummary& summary);
/// "12 poses, the tip up to 41.203 um off"
std::string error_text(const jobs::ErrorTableSummary& summary);

}  // namespace plumbline::report

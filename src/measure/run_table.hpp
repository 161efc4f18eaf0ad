// The table of one run: CSV with a header, columns found by name.
#pragma once

#include <string>

#include "measure/dataset.hpp"

namespace plumbline::measure {

struct TableOptions {
  std::size_t fewest_samples = 8;
  double most_turns = 1.0 + 1e-3;    // that the angles go around
  double most_turns_by_time = 1.05;  // where only time and feed tell: the feed may be a little off
  double least_turns = 1.0 / 12;     // of a shorter arc, neither centre nor mean can be found
  double feed_tolerance = 0.25;      // by which the table's own speed may differ from the stated feed
  double most_left_out = 0.05;       // of the rows, that may have a reading that is empty or NaN
  Believe believe = Believe::nothing;
};

/// Reads the columns of `run`, whose other fields are there already. Rows with a reading that is empty or NaN are left
/// out and listed in the run, unless they are more than a few. Refuses with table-unknown-column,
/// table-same-column, table-missing-column, table-columns, table-number, table-too-few, table-time, table-angle or
/// table-feed, at the row and column.
void read_run_table(const std::string& path, Run& run, const TableOptions& options = {});

/// Whether the table of a run has a column; time or angle that follow from the feed have none.
bool has_column(const Run& run, Column column);

/// The table as text: its columns in their order, as many decimals as they had, measured quantities at least as many as
/// a simulation deserves (um: 4, N m: 5).
std::string run_table_text(const Run& run);

}  // namespace plumbline::measure

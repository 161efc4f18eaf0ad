#include "imported/taken_rows.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "measure/run_table.hpp"

namespace plumbline::imported {
namespace {

using measure::Column;
using measure::Run;

void check_range(Column column, const std::vector<double>& values, const ForeignTable& table, std::size_t first) {
  const measure::ColumnSpec& spec = measure::kColumns[static_cast<std::size_t>(column)];
  const auto wrong = std::find_if(values.begin(), values.end(),
                                  [&](double value) { return std::abs(value) > spec.largest * spec.si; });
  if (wrong == values.end()) return;
  const std::size_t row = first + static_cast<std::size_t>(wrong - values.begin());
  refuse("import-value",
         fmt::format("line {}: {:.6g} {} is beyond {:.6g} {}", table.lines[row], *wrong / spec.si, spec.unit,
                     spec.largest, spec.unit),
         column == Column::radial ? "a reading is by what the bar is longer than its length: say minus = ... where the "
                                    "file has whole lengths, and check the unit"
                                  : "check the unit, and Nm_per_A or rated_Nm",
         table.place(row));
}

}  // namespace

void check_rows(const Run& run, const ForeignTable& table, std::size_t first, bool averaged) {
  check_range(Column::radial, run.radial, table, first);
  for (std::size_t j = 0; j < run.torque.size(); ++j) {
    check_range(static_cast<Column>(static_cast<std::size_t>(Column::torque1) + j), run.torque[j], table, first);
  }
  for (std::size_t i = 1; i < run.time.size() && !averaged; ++i) {
    if (!(run.time[i] <= run.time[i - 1])) continue;
    refuse("import-value", fmt::format("time stands still in line {}", table.lines[first + i]),
           "each row is later than the one before: is a row there twice? Where the clock is coarser than the rows, "
           "samples under [circle] takes the mean of several",
           table.place(first + i));
  }
}

void check_count(const Run& run, std::size_t left_out, bool apart) {
  const measure::TableOptions table;
  const std::size_t rows = run.samples() + left_out;
  const bool many = static_cast<double>(left_out) > table.most_left_out * static_cast<double>(rows);
  if (run.samples() >= table.fewest_samples && (apart || !many)) return;
  refuse("import-value",
         left_out == 0 ? fmt::format("run {}: {} rows are too few for a circle", run.id, rows)
                       : fmt::format("run {}: {} of {} rows lack a reading that the map names", run.id, left_out, rows),
         "single rows without a reading are left out, not so many; leave a column that was not measured out of the map",
         run.place);
}

}  // namespace plumbline::imported

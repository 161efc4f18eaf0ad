// What no dataset takes, said of the rows of the file that it is in.
#pragma once

#include "imported/foreign_table.hpp"
#include "measure/dataset.hpp"

namespace plumbline::imported {

/// Readings that no column of a dataset holds, and times that stand still unless the mean of several samples is taken.
/// The run's first sample is row `first` of `table`. Refuses with import-value.
void check_rows(const measure::Run& run, const ForeignTable& table, std::size_t first, bool averaged);

/// Too few samples, or too many left out. `apart`: the motors have a clock of their own, which may begin later. Refuses
/// with import-value.
void check_count(const measure::Run& run, std::size_t left_out, bool apart);

}  // namespace plumbline::imported

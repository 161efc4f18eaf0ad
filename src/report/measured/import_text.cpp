#include "report/measured/import_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"

namespace plumbline::report {
namespace {

using imported::ColumnSource;
using imported::ForeignTable;
using imported::Quantity;

// A value as a dataset would have it.
std::string value_text(Quantity quantity, double value) {
  switch (quantity) {
    case Quantity::time:
      return fmt::format("{:.3f} s", value);
    case Quantity::angle:
      return fmt::format("{:.2f} deg", value / kDeg);
    case Quantity::radial:
      return fmt::format("{:.2f} um", value / kUm);
    case Quantity::x:
    case Quantity::y:
      return fmt::format("{:.3f} mm", value / kMm);
    default:
      return fmt::format("{:.3f} N m", value);
  }
}

std::string column_text(const ForeignTable& table, const ColumnSource& column, std::size_t place) {
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  std::size_t missing = 0;
  for (const double value : table.values[place]) {
    if (!std::isfinite(value)) {
      ++missing;
      continue;
    }
    least = std::min(least, value);
    most = std::max(most, value);
  }
  std::string text = fmt::format("  {:<8} column {:>2} {:<18} in {:<8}", to_text(column.quantity), table.numbers[place],
                                 table.names[place].empty() ? "" : "\"" + table.names[place] + "\"", column.unit);
  if (most >= least) {
    text += fmt::format("{} to {}", value_text(column.quantity, least), value_text(column.quantity, most));
  }
  if (missing > 0) text += fmt::format(", {} without a reading", missing);
  return text + "\n";
}

std::string files_text(const imported::Imported& made) {
  std::string text;
  for (std::size_t i = 0; i < made.tables.size(); ++i) {
    const ForeignTable& table = made.tables[i];
    text += fmt::format("{}: {}, {} rows of {} columns, lines {} to {}\n", table.file, table.encoding, table.rows(),
                        table.width, table.lines.front(), table.lines.back());
    for (std::size_t c = 0; c < made.sources[i].columns.size(); ++c) {
      text += column_text(table, made.sources[i].columns[c], c);
    }
  }
  return text;
}

std::string run_text(const imported::TakenRun& run) {
  std::string text = fmt::format("run {}: {} samples, lines {} to {} of {}", run.id, run.samples, run.first_line,
                                 run.last_line, run.file);
  if (run.circles > 1) text += fmt::format(", its circle {} of {}", run.circle, run.circles);
  if (run.before + run.after > 0.01) {
    text += fmt::format("; of {:.0f} deg the first {:.0f} and the last {:.0f} are run-in and run-out", run.sweep / kDeg,
                        run.before / kDeg, run.after / kDeg);
  } else {
    text += fmt::format("; {:.0f} deg", run.sweep / kDeg);
  }
  text += run.angle_from == "column" ? ", angles as they stand there" : ", angles from " + run.angle_from;
  if (run.missing > 0) {
    text += fmt::format("; {} {} without a reading left out", run.missing, run.missing == 1 ? "row" : "rows");
  }
  return text + "\n";
}

}  // namespace

std::string import_text(const imported::Imported& made, bool in_full) {
  std::string text = in_full ? files_text(made) : "";
  for (const imported::TakenRun& run : made.taken) text += run_text(run);
  return text;
}

}  // namespace plumbline::report

// The circles of a record: where in a file the tip goes around, and which turn is the one that was to be measured.
#pragma once

#include <optional>
#include <vector>

#include "imported/import.hpp"

namespace plumbline::imported {

/// Where on the circle of a run each row of a table is.
struct Ways {
  std::vector<double> angle;    // rad
  std::vector<bool> on_circle;  // false: too far from the circle
  std::string from;             // "column", "places", "time and feed"
};

/// Refuses with import-angle where nothing tells it.
Ways ways_of(const MapRun& run, const Source& source, const ForeignTable& table, const ImportOptions& options);

/// Rows in which the tip goes around without a stop, in one direction.
struct Circle {
  std::size_t first = 0, last = 0;  // rows, both included
  double sweep = 0;                 // rad, not negative
  double turn = 1;                  // +1: towards +Y from +X
};
std::vector<Circle> circles_in(const Ways& ways, const ImportOptions& options);

/// The turn of a circle that is to be measured.
struct Turn {
  std::size_t first = 0, last = 0;  // rows
  double before = 0, after = 0;     // rad that were cut
};
Turn turn_of(const Ways& ways, const Circle& circle, const MapRun& run, const ImportOptions& options);

/// The circle on which places lie, m.
struct PlacedCircle {
  double x = 0, y = 0, radius = 0;
};
/// Through the rows of a turn, by least squares; nothing: they hold no half turn.
std::optional<PlacedCircle> circle_through(const std::vector<double>& x, const std::vector<double>& y,
                                           const Turn& turn);

}  // namespace plumbline::imported

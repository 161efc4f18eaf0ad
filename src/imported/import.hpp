// Files of instruments and controls as a dataset.
#pragma once

#include "imported/foreign_table.hpp"

namespace plumbline::imported {

struct ImportOptions {
  double standing = 0.2;      // of the usual step of angle from sample to sample: slower is no circle yet, or no more
  double off_circle = 0.05;   // of the radius, by which a place may be off it
  double other_place = 2e-3;  // m, by which centre or radius of a map may differ from the places of a table
  double least_sweep = 0.5;   // rad; less is no circle
  double most_turn = 1.0005;  // turns that a run may have
};

/// What was made of one circle.
struct TakenRun {
  std::string id, file;
  std::size_t first_line = 0, last_line = 0;  // of the file, the turn that is measured
  std::size_t circle = 0, circles = 0;        // which one of the file
  double sweep = 0;                           // rad, of the circle with run-in and run-out
  double before = 0, after = 0;               // rad, that were cut
  std::size_t samples = 0;
  std::size_t missing = 0;  // rows without a reading, left out
  std::string angle_from;   // "column", "places", "time and feed"
};

struct Imported {
  measure::Dataset dataset;          // its text and its runs, as files
  std::vector<ForeignTable> tables;  // each file once
  std::vector<Source> sources;       // of each: the part of the map that it was read by
  std::vector<TakenRun> taken;
};

/// `files`: those that the map's runs name, found by their names. Refuses with import-file a run whose file is not
/// there, import-no-circle a file with fewer circles than the map says, import-angle where nothing tells the angle,
/// import-clock motors of a file of their own without times, import-value a run-in that leaves no turn, a circle that
/// is not where the places of the table are and times that go back, and as read_foreign_table does.
Imported import_files(const Map& map, const std::vector<std::string>& files, const ImportOptions& options = {});

}  // namespace plumbline::imported

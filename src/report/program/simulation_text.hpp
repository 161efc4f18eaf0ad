// A program or a dataset that was simulated: a table as CSV, and words.
#pragma once

#include <string>
#include <string_view>

#include "base/files/files.hpp"
#include "jobs/simulate.hpp"
#include "jobs/simulate_dataset.hpp"

namespace plumbline::report {

/// Writes a row for every point: line, motion, time (s), the pose asked for (mm, deg), the error of the tip (um) and of
/// the orientation (urad, rotation vector) in W, commanded strut lengths (mm), nut tensions (N), motor torques (N m).
class SimulationTable {
 public:
  /// Writes the names of the columns, `with_expected` those of what is expected besides. `output` is kept by reference.
  explicit SimulationTable(OutputFile& output, bool with_expected = false);
  void add(const jobs::SimulatedPoint& point);

 private:
  OutputFile& output_;
  bool with_expected_;
  std::string row_;
};

/// The names of these columns, between commas.
std::string_view simulation_columns();

/// How many points, how long the program takes, how far the tip is off.
std::string simulation_text(const jobs::SimulationSummary& summary);
/// `"plumbline": "simulation 1"`
std::string simulation_json(const jobs::SimulationSummary& summary);
/// "26 runs, 3,120 samples"
std::string dataset_simulation_text(const jobs::DatasetSimulationSummary& summary);

}  // namespace plumbline::report

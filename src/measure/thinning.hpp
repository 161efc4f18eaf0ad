// Long records made short: each channel low-passed and brought to an even grid of angle.
#pragma once

#include <vector>

#include "machine/model.hpp"
#include "measure/dataset.hpp"

namespace plumbline::measure {

struct ThinningOptions {
  // Points of a whole turn, the fewest first: those that hold all that the records hold are taken. A wave of up to a
  // third as many periods a turn is held.
  std::vector<std::size_t> points{360, 540, 720, 1080, 1440};
  bool fill_turns = false;  // readings where struts turn round are filled in first: they go by a law that the model may
                            // not have (friction_turns.hpp)
};

/// What became of records that were longer than a fit needs.
struct Thinning {
  std::size_t runs = 0;     // how many there are
  std::size_t thinned = 0;  // how many of them were
  std::size_t points = 0;   // of a whole turn, that they were brought to
  std::size_t longest = 0;  // samples of the longest record
};

struct Thinned {
  std::vector<Run> runs;
  Thinning thinning;
};

/// Runs of twice the fewest points and more, by EvenGrid: readings, and through the same low-pass time and the signs of
/// the struts' speeds on the commanded path: friction turns around within less than a point and drifts begin anew with
/// each turn, and what the readings have of that the model has then as well. Each channel says how fine a grid
/// holds it; all of all runs go on the finest of these, which is fine enough for waves as long as the leads of
/// `machine`'s screws, too: on a finer grid than it needs a channel tells the same, and the model simulates each point
/// once for all. Runs whose samples are too few or too uneven for it stay as they are. Results do not depend on the
/// number of threads. Refuses with simulate-unreachable a long run that the machine cannot make.
Thinned thinned(const machine::MachineModel& machine, std::vector<Run> runs, const ThinningOptions& options = {});

/// Runs as a diagnosis takes them: thinned, and without samples where struts turn round.
Thinned fit_runs(const machine::MachineModel& machine, std::vector<Run> runs, ThinningOptions options = {});

}  // namespace plumbline::measure

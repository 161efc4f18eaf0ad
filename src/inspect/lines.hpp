// What is periodic in time, whatever the tip does: a floor that shakes, a pump, the mains; as lines that runs have in
// common, at one frequency or at what sampling folds it to.
#pragma once

#include <vector>

#include "identify/equations/noise.hpp"
#include "identify/equations/run_model.hpp"

namespace plumbline::inspect {

struct LineOptions {
  double least_order = 12;    // periods a turn; slower is what machines do around a circle
  double steps_an_order = 4;  // of the frequencies that are tried
  double sigmas = 12;         // of chi-square over all runs, from which a line is one
  double in_runs = 0.6;       // of the runs must have it,
  double least_gain = 2;      // each with that many times what noise gives
  std::size_t most = 3;       // lines of a channel
  double highest = 200;       // Hz, that a frequency is sought up to from what it is folded to
};

/// One line, in runs that are sampled alike.
struct Line {
  int channel = identify::kRadial;
  double frequency = 0;  // Hz, as it is folded
  double sampling = 0;   // Hz, of these runs
  double amplitude = 0;  // SI, the median over runs
  double direction = 0;  // rad, from +X towards +Y, either way; of the bar
  bool along = false;    // whether it has a direction: else it is alike all around
  std::vector<std::size_t> runs;
};

/// In what is left of runs (SI); of each its equations with channels and residual. `noise`: of all of them.
std::vector<Line> find_lines(const std::vector<measure::Run>& runs, const std::vector<identify::RunEquations>& left,
                             const identify::NoiseModel& noise, const LineOptions& options = {});

/// The lowest frequency that is folded to all of these, within their widths; nothing: none up to `highest`.
std::optional<double> common_frequency(const std::vector<Line>& lines, const std::vector<measure::Run>& runs,
                                       double highest);

/// Runs without these lines: of each run and line the sine that fits best, beside waves of the circle.
std::vector<measure::Run> without_lines(std::vector<measure::Run> runs, const std::vector<Line>& lines);

}  // namespace plumbline::inspect

// The runs that are looked at, and what they leave.
#pragma once

#include "inspect/inspect.hpp"

namespace plumbline::inspect {

/// Runs with readings that the machine can make, made short.
struct Looked {
  std::vector<std::size_t> numbers;  // in the dataset
  std::vector<measure::Run> runs;
  std::vector<measure::Run> whole;  // with the samples where struts turn round
  std::vector<RunRows> rows;
};

/// Without rows yet. What is out of the machine's reach goes to `faults`.
Looked looked_at(const std::vector<measure::Run>& runs, const Bench& bench, const InspectOptions& options,
                 std::vector<Fault>& faults);
void make_rows(Looked& looked, const Bench& bench);

/// Noise that is assumed before any is estimated, and the least that is taken of an estimate: models are linear about
/// where they stand, and readings have last digits.
identify::NoiseModel usual_noise(const InspectOptions& options);
identify::NoiseModel at_least(identify::NoiseModel noise, const InspectOptions& options);

/// What all runs together leave of each, SI, as rows were whitened with `noise` that does not remember.
std::vector<identify::RunEquations> remainders(const Looked& looked, const Outliers& outliers,
                                               const identify::NoiseModel& noise);
/// Those of the runs that are no outliers.
std::vector<identify::RunEquations> kept(const std::vector<identify::RunEquations>& all, const Outliers& outliers);

/// A fault for each line, lines of one frequency in runs sampled otherwise taken together.
std::vector<Fault> periodic_faults(const Looked& looked, const std::vector<Line>& lines, const LineOptions& options);

}  // namespace plumbline::inspect

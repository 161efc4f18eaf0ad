// The gap between readings and model, run by run and in all, at the stages of a diagnosis.
#pragma once

#include "diagnose/diagnose.hpp"
#include "diagnose/readings/residuals.hpp"

namespace plumbline::diagnose {

/// What is left of all runs: with the base model, with the runner-up in place of the strongest effect, with what was
/// found.
struct StageResiduals {
  std::vector<identify::RunEquations> base;
  std::vector<identify::RunEquations> second;  // empty: there is none, as if it were the base model
  std::vector<identify::RunEquations> after;
};

/// Of the runs held out (`out`), or of the others; nothing of what was not measured.
Rms rms_of(const std::vector<identify::RunEquations>& runs, const std::vector<bool>& out, bool held_out);
Gap gap_of(const StageResiduals& residuals, const std::vector<bool>& out, bool held_out);

/// Each run, and the circle that compensation with what was `found` would leave of it.
std::vector<RunGap> run_gaps(const machine::MachineModel& machine, const std::vector<measure::Run>& runs,
                             const std::vector<bool>& out, const StageResiduals& residuals,
                             const physics::ForceModel& found, const CompensatedOptions& options);

}  // namespace plumbline::diagnose

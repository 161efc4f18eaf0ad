// What no effect of the catalogue explains, beside the base model.
#pragma once

#include "diagnose/diagnose.hpp"
#include "diagnose/doubt.hpp"
#include "diagnose/learnt_residual.hpp"

namespace plumbline::diagnose {

/// The base model, nuisances refitted to the runs of the bench.
struct Base {
  const Workbench& bench;
  const FittedStage& stage;
  const std::vector<identify::RunEquations>& residuals;  // of all runs
  Recurs recurs;                                         // in them
  const identify::NoiseModel& noise;                     // that runs held out are measured by
  const Description* description = nullptr;              // of what it leaves, if that is known
};

struct Unexplained {
  Description description;  // beside the base model; no terms: there are none to tell
  Fitted fitted;            // with these terms where the runs held out bear them out, else the base model
  std::vector<identify::RunEquations> residuals;  // of all runs
  bool borne_out = true;
  std::optional<LearntResidual> residual;  // that stands in the model in place of the terms
};

/// Describes what the base model leaves; where that is within the noise, again with what comes again taken for none.
/// `out`: which of all `runs` are held out.
Unexplained unexplained(const Base& base, const std::vector<measure::Run>& runs, const std::vector<bool>& out,
                        const DiagnoseOptions& options, const Say& say);

}  // namespace plumbline::diagnose

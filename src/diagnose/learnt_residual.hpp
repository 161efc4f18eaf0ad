// What the base model leaves, learnt as a sum of functions.
#pragma once

#include "diagnose/fit_beside.hpp"
#include "diagnose/residual_model/rows.hpp"

namespace plumbline::diagnose {

struct Learnt {
  LearntResidual residual;
  Fitted fitted;
};

/// In rounds, each about the model that the one before found and with the noise that is then left. Nothing where no
/// function pays. What of it makes the tip better no one can tell from circles is held back (identify::hold_unsure).
std::optional<Learnt> learn_residual(const Workbench& bench, const FittedStage& base, const DiagnoseOptions& options,
                                     const Say& say);

}  // namespace plumbline::diagnose

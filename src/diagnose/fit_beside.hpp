// The base model with rows beside it, its nuisances refitted.
#pragma once

#include <optional>

#include "diagnose/diagnose.hpp"

namespace plumbline::diagnose {

/// A model that was fitted, and the standard errors of its parameters, SI.
struct Fitted {
  physics::ForceModel forces;
  std::vector<double> errors;
  Refit fit;  // before a shift was held back
};

/// The base model alone.
Fitted plain_fit(const Workbench& bench, const FittedStage& stage, const DiagnoseOptions& options);

/// With the rows that `forces` have beside those of the bench; nothing where that leaves more than before: rows come
/// from a linear problem.
std::optional<Fitted> fit_beside(const Workbench& bench, const FittedStage& stage, const physics::ForceModel& forces,
                                 const DiagnoseOptions& options);

}  // namespace plumbline::diagnose

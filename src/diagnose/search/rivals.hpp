// Which candidates may stand in a place of the model, and what the whole model with each of them is worth.
#pragma once

#include <optional>

#include "diagnose/evidence/left_out.hpp"
#include "diagnose/search/stage.hpp"

namespace plumbline::diagnose {

/// An effect in a place of the model, of one that was picked or beside all of them.
struct Rival {
  Pick pick;
  double log_odds = 0;    // against the model without that effect
  Eigen::VectorXd start;  // where the linear problem has all unknowns with it in that place
  Refit fit;              // of the whole model; of the foremost ones, and of the first in the place of what was found
  bool refitted = false;  // and log_odds tell of that fit
  std::optional<LeftOut> left_out;  // of those refitted in the place of an effect that was found
};

/// The linear problem of a stage as if the pick at `place` were not there: its numbers go back to where they change
/// nothing, in `values`, too. Gram matrices alone.
LinearProblem taken_back(const Workbench& bench, const FittedStage& stage, std::size_t place, Eigen::VectorXd& values);

/// Candidates for a place beside the other picks of a stage, best first: by the linear problem, then the foremost of
/// them fitted. `threshold` is what an effect must reach, nats.
std::vector<Rival> rivals_for(const Workbench& bench, const FittedStage& stage, std::size_t place, double threshold,
                              const SearchOptions& options, const Say& say);

}  // namespace plumbline::diagnose

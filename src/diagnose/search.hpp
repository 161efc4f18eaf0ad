// Which effects are missing: the strongest first, then again on what is left, each pick reconsidered.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "diagnose/evidence/left_out.hpp"
#include "diagnose/evidence/threshold.hpp"
#include "diagnose/refit.hpp"

namespace plumbline::diagnose {

struct SearchOptions {
  ScoreOptions scoring;
  ThresholdOptions threshold;
  RefitOptions refit;
  int most_effects = 2;      // more at once are a sign of one that the catalogue does not have
  int most_refits = 6;       // of the candidates of one step
  double near_share = 0.25;  // of the best log odds: candidates that much behind are still fitted nonlinearly
  double near_nats = 12;     // or that much behind
  int most_swaps = 4;
  int most_noise_rounds = 3;   // fits with the noise estimated anew
  double all_struts_nats = 6;  // all struts are fitted at last where that is no more nats behind the best set of them
};

/// An effect in the place of one that was picked, and what the whole model with it is worth.
struct Rival {
  Pick pick;
  double log_odds = 0;    // against the model without that effect
  Eigen::VectorXd start;  // where the linear problem has all unknowns with it in that place
  Refit fit;              // of the whole model; of the foremost ones, and of the first in the place of what was found
  bool refitted = false;  // and log_odds tell of that fit
  std::optional<LeftOut> left_out;  // of those refitted in the place of an effect that was found
};

/// An effect that was found.
struct Found {
  Pick pick;
  double log_odds = 0;  // against the model without it
  double gain = 0;      // misfit that it takes away, the others refitted
  std::optional<LeftOut> left_out;
  std::vector<Rival> rivals;  // in its place, best first; itself left out
};

/// A fit, its noise, and the linear problem about it.
struct FittedStage {
  Refit fit;
  identify::NoiseModel noise;
  LinearProblem problem;
};

struct Model {
  std::vector<Found> found;  // strongest first
  Refit fit;
  identify::NoiseModel noise;
  double threshold = 0;   // nats
  bool one_more = false;  // beyond most_effects another one passes
  LinearProblem problem;  // about the fit (or nearly: about it before all struts were fitted), all columns
  FittedStage base;       // nothing added, nuisances refitted
};

using Say = std::function<void(const std::string&)>;

/// Searches the candidates. The base model's nuisances are refitted first.
Model search(const Workbench& bench, const SearchOptions& options, const Say& say);

}  // namespace plumbline::diagnose

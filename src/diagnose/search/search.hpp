// Which effects are missing: the strongest first, then again on what is left, each pick reconsidered.
#pragma once

#include "diagnose/search/rivals.hpp"

namespace plumbline::diagnose {

/// An effect that was found.
struct Found {
  Pick pick;
  double log_odds = 0;  // against the model without it
  std::optional<LeftOut> left_out;
  std::vector<Rival> rivals;  // in its place, best first; itself left out
};

struct Model {
  std::vector<Found> found;  // strongest first
  Refit fit;
  identify::NoiseModel noise;
  double threshold = 0;   // nats
  bool one_more = false;  // beyond most_effects another one passes
  // About the fit (or nearly: about it before all struts were fitted); rows of what the picks may marginalise.
  std::shared_ptr<const LinearProblem> problem;
  FittedStage base;  // nothing added, nuisances refitted
};

/// The picks of what was found.
std::vector<Pick> picks_of(const Model& model);

/// Searches the candidates. The base model's nuisances are refitted first.
Model search(const Workbench& bench, const SearchOptions& options, const Say& say);

}  // namespace plumbline::diagnose

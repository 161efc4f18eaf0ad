// What runs could have shown: the smallest size of each effect that would have been named from them.
#pragma once

#include <string>
#include <vector>

#include "diagnose/evidence/score.hpp"

namespace plumbline::diagnose {

struct Visible {
  std::string name;       // of the effect
  std::string key, unit;  // of the number that shows best; the unit is the file's
  double smallest = 0;    // that would pass the threshold, on the strut where it shows least; the file's unit
  bool shows = false;     // that is within the bounds of the catalogue
};

/// For each effect of the candidates, from what is left when the nuisances took their part: a size s of a column c
/// shows by s^2 <c, c>, and must beat the threshold (nats), what is less likely beforehand, and the cost of a free
/// size.
std::vector<Visible> visible_effects(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, double threshold,
                                     const ScoreOptions& options = {});

}  // namespace plumbline::diagnose

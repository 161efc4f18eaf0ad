// What runs could have shown: the smallest size of each effect that would most probably have been named from them.
#pragma once

#include <string>
#include <vector>

#include "diagnose/evidence/score.hpp"

namespace plumbline::diagnose {

struct Visible {
  std::string name;       // of the effect
  std::string key, unit;  // of the number that shows best; the unit is the file's
  double smallest = 0;    // that passes the threshold with 95 %, on the strut where it shows least; the file's unit
  bool shows = false;     // that is within the bounds of the catalogue
};

/// For each effect of the candidates, from what is left when the nuisances took their part: a size s of a column c
/// shows by s^2 <c, c>, and must beat the threshold (nats), what is less likely beforehand, and the cost of a free
/// size. What it shows by is the square of a normal deviate about s <c, c>^(1/2), which must exceed the root of what it
/// must beat in 19 of 20 machines: power, not the threshold alone.
std::vector<Visible> visible_effects(const Eigen::MatrixXd& reduced, const CandidateSet& candidates, double threshold,
                                     const ScoreOptions& options = {});

}  // namespace plumbline::diagnose

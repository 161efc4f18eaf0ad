// Options of the search for missing effects. A nat is a unit of evidence: README of diagnose/evidence.
#pragma once

#include "diagnose/evidence/score.hpp"
#include "diagnose/evidence/threshold.hpp"
#include "diagnose/search/refit.hpp"

namespace plumbline::diagnose {

struct SearchOptions {
  ScoreOptions scoring;
  ThresholdOptions threshold;
  RefitOptions refit;
  int most_effects = 2;        // more at once are a sign of one that the catalogue does not have
  int most_swaps = 4;          // after each effect that was added
  double swap_nats = 0.5;      // an effect must be that much more likely than one picked to take its place
  double all_struts_nats = 6;  // all struts are fitted at last where that is at most so many nats below the best set

  // candidates that are fitted nonlinearly
  int most_refits = 6;          // of one place
  double near_share = 0.25;     // of the best log odds: those at most so much below it
  double near_nats = 12;        // or at most so many nats below it
  double below_threshold = 3;   // nats: what the linear problem has below it may pass when it is fitted
  std::size_t most_listed = 7;  // of them, in the steps

  // the noise of each stage
  int most_noise_rounds = 3;    // fits with it estimated anew, until two estimates are alike:
  double colour_alike = 0.051;  // a step of the grid that the colour is looked for on, and a little
  double size_alike = 0.02;     // relative
};

}  // namespace plumbline::diagnose

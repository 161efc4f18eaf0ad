// What speaks against a model that seems to explain the readings, however large the noise was taken to be.
#pragma once

#include "base/mean_square.hpp"
#include "diagnose/diagnose.hpp"

namespace plumbline::diagnose {

/// What a model leaves of the readings of a run, or of many: of the bar, and of all motors. SI.
struct Left {
  MeanSquare radial, torque;
};
Left left_of(const identify::RunEquations& run);

/// How many times as far off the runs held out are as those fitted; nothing if that is little, or if single runs among
/// those fitted differ so much that chance may have done it.
std::optional<double> not_foretold(const std::vector<identify::RunEquations>& residuals, const std::vector<bool>& out,
                                   MeanSquare Left::*kind, const VerdictOptions& options);

/// What is left of readings of one kind comes again in other runs at the same pose.
struct Recurring {
  double sigmas = 0;       // of chi-square, above what noise does
  double correlation = 0;  // the largest, between runs that
  std::string by;          // differ in this alone
};

struct Recurs {
  std::optional<Recurring> radial, torque;
};

/// Noise does not come again: what does is no noise, even where the estimate of the noise has taken it for such.
/// Nothing if chance may have done it, if it is as small as the last digit of a reading, or if no two runs go all the
/// way round at one pose.
Recurs recurring(const std::vector<Contrast>& contrasts, const VerdictOptions& options);

}  // namespace plumbline::diagnose

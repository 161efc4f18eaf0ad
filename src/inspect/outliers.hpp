// Which runs the others do not predict.
#pragma once

#include "inspect/prediction.hpp"

namespace plumbline::inspect {

struct OutlierOptions {
  double excess = 0.3;      // of the mean square: from so much above what is usual a run is looked at more closely
  double bar_excess = 0.8;  // of that of the bar alone, which are fewer readings
  double most_share = 0.4;  // of all runs that may be such
  double share_of_bounds = 0.3;
  int rounds = 6;  // in which spreads of effects are fitted
};

struct Outliers {
  Prior prior;                     // its spreads fitted to the runs that are none
  std::vector<bool> out;           // which runs are
  std::vector<double> bar_square;  // the same of its readings of the bar alone; nil: it has none, or nothing else
  double usual_bar = 1;
  std::vector<double> mean_square;  // of each run as all others that are none predict it, in units of the noise
  double usual = 1;                 // the median of these of runs that are no outliers
};

/// How far beyond the limit a run is, or its readings of the bar, which torques would hide: 1 and more is an outlier.
double excess_of(const Outliers& outliers, std::size_t run, const OutlierOptions& options);

/// Takes the run that the others predict worst out, again and again, until those that are left agree.
Outliers find_outliers(const Prior& wide, const std::vector<RunRows>& runs, const OutlierOptions& options);

/// What all runs that are no outliers, but `without`, say of the machine.
Knowledge knowledge_of_others(const Outliers& outliers, const std::vector<RunRows>& runs, std::size_t without);

}  // namespace plumbline::inspect

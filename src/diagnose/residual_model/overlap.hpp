// What the functions of a shape have in common with each other and with what is known already.
#pragma once

#include "diagnose/residual_model/part.hpp"
#include "identify/equations/noise.hpp"

namespace plumbline::diagnose {

/// All whitened, the set-ups out.
struct Overlap {
  Eigen::MatrixXd gram;   // of the columns of a shape
  Eigen::MatrixXd cross;  // other columns with them
};

/// Whether the functions of a shape are tried for all struts alike, and for no strut alone.
bool only_alike(const Shape& shape);

/// Rows of channel after channel, each of so many samples, in at least as many groups as `points` says, if there are
/// more samples: the sum of each group, its noise that of one sample if theirs is white.
identify::SlopeRows in_groups(const identify::SlopeRows& rows, Eigen::Index samples, int points);

/// By rows in groups, for functions that change little within one. `others` stand in groups already. A channel that
/// tells hundreds of times less of a part than another does is left out for it.
Overlap overlap_in_groups(const Shape& shape, const Region& region, const ReadyRun& run,
                          const physics::MachineConstants& machine, const identify::NoiseModel& noise,
                          const identify::SlopeRows& others, int points);

}  // namespace plumbline::diagnose

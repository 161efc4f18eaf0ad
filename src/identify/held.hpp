// Where the tip stands as a whole stays as it was, unless a fit is sure of it.
//
// On a circle the ball's centre is free, so that no circle shows a shift of the tip that is the same everywhere: priors
// and chance say where it comes out. After the data the mean shift s over the poses that were measured is normal with
// mean m and covariance S; along an axis of S the model as given is s off, the new one s - m. The new one is further
// off where s is on the other side of m / 2: with the chance of a normal deviate below -|m| / (2 deviation). Unless
// that is small, the shift is taken back, by the likeliest change of joints and strut offsets that leaves all
// differences between places as they are: joints of the base that are shifted alike. Whoever touches off the zero on
// the machine sees no difference.
#pragma once

#include <vector>

#include "identify/tip_field.hpp"

namespace plumbline::identify {

/// What a change of the model does to the tip.
struct TipGain {
  double moved = 0;   // rms of how far it moves the tip, m
  double doubt = 0;   // rms of how far the tip may be from there: standard deviation
  double sigmas = 0;  // of what is gained, |e|^2 - |e - f|^2 for an error e and a change f: its mean in its deviations
};

struct HoldOptions {
  double sure_sigmas = 3.09;  // one of a thousand comes out further off
  double same_place = 5e-8;   // m, of a change that leaves differences between places as they are, rms
};

struct Held {
  Eigen::VectorXd values;       // of the unknowns, SI
  int axes = 0;                 // of the shift, that were held
  double shift = 0;             // how far the tip as a whole would have moved, m
  double shift_doubt = 0;       // and by how much that may be off: standard deviation
  double back = 0;              // how far it was moved back, m
  TipGain whole, off_the_part;  // with these values: where the tip stands, and with the zero touched off
};

/// `values` and `covariance` (SI; rows and columns of zeros: what stays as it is) of the unknowns after the data,
/// beside the model as given. Joints and offsets with priors take the shift back, all else keeps what was found.
Held hold_unsure(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                 const physics::ForceModel& given, const Unknowns& unknowns, const Eigen::VectorXd& values,
                 const Eigen::MatrixXd& covariance, const HoldOptions& options = {});

}  // namespace plumbline::identify

// Where the tip stands as a whole stays as it was, where a fit would make it worse more likely than not doing so.
//
// On a circle the ball's centre is free, so that no circle shows a shift of the tip that is the same everywhere: what
// is known of joints and effects says where it comes out, and chance. After the data the error e of the model as given
// is normal about the change f that was found, at every place of a part. A part that is set up where circles were
// measured is further off than before where |e - f| > |e|: that has a chance which follows from the covariance. Where
// it is more than one of a hundred, a share of the shift is taken back, the smallest with which it is not, or else that
// with the least chance: half a shift m leaves a quarter of its m^2, and has the chance of a deviate below -3m / 4s,
// the whole one of one below -m / 2s. It is taken back by the likeliest change of joints and strut offsets that leaves
// all differences between places as they are: joints of the base that are shifted alike. Whoever touches off the zero
// on the machine sees no difference.
#pragma once

#include <vector>

#include "identify/tip_field.hpp"

namespace plumbline::identify {

/// What a change of the model does to the tip.
struct TipGain {
  double moved = 0;   // rms of how far it moves the tip, m
  double doubt = 0;   // rms of how far the tip may be from there: standard deviation
  double sigmas = 0;  // of what is gained, |e|^2 - |e - f|^2 for an error e and a change f: its mean in its deviations
  double chance = 0;  // that a part set up where circles were measured comes out further off than before
};

struct HoldOptions {
  TipFieldOptions places;
  double may_be_worse = 0.01;  // chance that is taken; beyond it a shift is held
  int steps = 4;               // from none of a shift to all of it
  double matters = 1e-6;       // m, rms; to be less than that further off is to be no worse
  double same_place = 5e-8;    // m, of a change that leaves differences between places as they are, rms
};

struct Held {
  Eigen::VectorXd values;       // of the unknowns, SI
  double share = 0;             // of the shift, that was taken back
  double shift = 0;             // how far the tip as a whole would have moved, m
  double shift_doubt = 0;       // and by how much that may be off: standard deviation
  double back = 0;              // how far it was moved back, m
  TipGain whole, off_the_part;  // with these values: where the tip stands, and with the zero touched off
  Eigen::VectorXd found;        // values with all of the shift: those that data and priors make likeliest
};

/// The chance that a part is further off by more than d (m, rms) once its tip is moved by f, when the error of the
/// model as given is normal with mean m and covariance R R^T: |e - f| > |e| + d, hence 2 e.f - f.f < -2 d |e| - d^2,
/// with |e| at its rms. All of them as TipField has them, over places.
double chance_of_worse(const Eigen::VectorXd& m, const Eigen::MatrixXd& R, const Eigen::VectorXd& f, double d);

/// `values` and `covariance` (SI; rows and columns of zeros: what stays as it is) of the unknowns after the data,
/// beside the model as given. Joints and offsets with priors take the shift back, all else keeps what was found.
Held hold_unsure(const machine::RotationOrder& order, const std::vector<measure::Run>& runs,
                 const physics::ForceModel& given, const Unknowns& unknowns, const Eigen::VectorXd& values,
                 const Eigen::MatrixXd& covariance, const HoldOptions& options = {});

}  // namespace plumbline::identify

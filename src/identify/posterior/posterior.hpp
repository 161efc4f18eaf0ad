// What is known of a machine's numbers once something was learnt of it: about the numbers of its model, normal. A model
// that was learnt keeps it, so that what the tip will be off can be told of any program.
#pragma once

#include <string>
#include <vector>

#include "identify/identify.hpp"

namespace plumbline::identify {

/// One way in which the machine may be. Vectors and matrices in the order of the posterior's unknowns, SI.
struct PosteriorState {
  std::string name;            // of the effect that it stands for; empty: there is but one
  double weight = 1;           // how likely it is, beside the others
  Eigen::VectorXd mean;        // after the data: where a shift was held back the model has other values
  Eigen::MatrixXd covariance;  // of the fit, its priors and the noise; rows and columns of zeros: exact
  double widening = 1;         // times the covariance, where the priors are too narrow  [Birge 1932]
  Eigen::MatrixXd moved;       // by what the model lacks: a column for each pose left out, scaled so that the sum of
                               // their outer products adds to the covariance  [jackknife, Efron 1982]

  /// All of it: widening * covariance + moved moved^T.
  Eigen::MatrixXd doubt() const;
};

struct PosteriorNoise {
  double radial = 0;  // m, sigma of a sample; 0: no bar
  double torque = 0;  // N m
};

/// The posterior of a model. `unknowns` stand at the numbers of the model; their priors are those before the data.
struct Posterior {
  explicit Posterior(Unknowns of) : unknowns(std::move(of)) {}

  Unknowns unknowns;
  std::vector<PosteriorState> states;  // the model's own first; their weights sum to one
  PosteriorNoise noise;
  double unexplained = 0;  // m, one sigma on each axis of the tip: what comes again in the readings of the bar, and no
                           // number of the model stands for
  std::string made_by;     // "identify", "calibrate", "diagnose", in words
  bool from_data = true;   // else what the owner of the model stated in [uncertainty]
};

/// What the owner states in [uncertainty]: the posterior of a model of which nothing was learnt. No unknowns: nothing
/// is stated.
Posterior prior_of(const machine::MachineModel& machine);

/// Of an identification or a calibration: of its last stage that fitted each number, beside what [uncertainty] says of
/// those that were not fitted. `unexplained` is for the caller.
Posterior posterior_of(const machine::MachineModel& machine, const Identification& found);

/// The same with its unknowns at the numbers of other forces: of the model that was written.
Posterior about(const Posterior& posterior, const physics::ForceModel& forces);

/// Adds the unknown that another list has, with its prior.
std::size_t add_like(Unknowns& unknowns, const Unknown& like);

}  // namespace plumbline::identify

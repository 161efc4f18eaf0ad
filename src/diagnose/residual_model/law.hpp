// Functions that are a power of what they are of: by its exponent a law is known, such as that of contacts.
#pragma once

#include <optional>

#include "diagnose/residual_model/learner.hpp"

namespace plumbline::diagnose {

/// size x sign(x) |x|^exponent, x what the function is of: a tension in kN, a speed in 10 mm/s, or a strut's length as
/// a share of the middle one.
struct PowerLaw {
  double size = 0;        // SI of the channel
  double size_sigma = 0;  // standard error, at this exponent
  double exponent = 0;
  double least = 0, most = 0;  // of the exponent, 95 %
};

struct LawOptions {
  double least_exponent = 0.1, most_exponent = 4, step = 0.01;
  double least_strength = 100;  // chi-square of the function, that there is something to tell
  double least_share = 0.99;    // of it, that a law must take
  double widest = 0.4;          // interval of an exponent that tells one law from another
};

/// Of a function of one coordinate that all struts have alike; nothing where it is no power, or where these readings
/// would leave many. `covariance`: of its weights, SI. What the readings say of a law is what they say of the weights
/// without what was known of these beforehand; nuisances are marginalised as they are there.
std::optional<PowerLaw> power_law_of(const Component& component, const Eigen::MatrixXd& covariance,
                                     const physics::MachineConstants& machine, const LawOptions& options = {});

}  // namespace plumbline::diagnose

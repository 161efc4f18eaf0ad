// How far a fit moves what was known beforehand, all of it together: chi-square of the priors.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "identify/unknowns/unknowns.hpp"

namespace plumbline::identify {

struct PriorStrain {
  double chi2 = 0;     // sum of squares, in sigmas of the priors
  double degrees = 0;  // of freedom

  /// chi2 as the normal deviate that is as rare  [Wilson and Hilferty 1931]; 0 where the data say nothing.
  double deviate() const;
  /// How far chi2 is above its mean, in its standard deviations: of many degrees about the same.
  double excess() const;
  /// By how much the priors are too narrow, at least 1: chi2 / degrees  [Birge 1932].
  double widening() const;
};

/// `off`: how far each unknown was moved, in sigmas of its prior; each counts as one degree.
PriorStrain prior_strain(const Eigen::VectorXd& off);

/// The same by what the data tell. `posterior` is the covariance after the data, in sigmas of the priors: before the
/// data an unknown is normal with the prior's covariance P, after them with C about the value found. So what is found
/// is itself normal about the start, with P - C: the data cannot move what they do not tell. Along the common axes of
/// both it has the variance 1 - c, and the sum of squares over that is chi-square. Of directions with less than
/// `least_share` of that variance the data say nothing: they do not count.
PriorStrain prior_strain(const Eigen::VectorXd& off, const Eigen::MatrixXd& posterior, double least_share);

/// The same of unknowns in their own units: the values found, and the covariance after the data, in their order.
PriorStrain prior_strain(const std::vector<const Unknown*>& unknowns, const Eigen::VectorXd& values,
                         const Eigen::MatrixXd& covariance, double least_share);

}  // namespace plumbline::identify

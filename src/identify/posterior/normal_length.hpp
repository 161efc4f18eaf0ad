// How long a vector of three numbers is that are normal together: its mean, and what it does not exceed.
#pragma once

#include <span>
#include <vector>

#include "base/pose.hpp"

namespace plumbline::identify {

/// The length of e, which is normal with that mean and covariance. e^2 is a sum of squares of independent deviates with
/// weights l and means b, Q = sum l (z + b)^2, along the axes of the covariance.
class NormalLength {
 public:
  NormalLength(const Vector3<double>& mean, const Eigen::Matrix3d& covariance);

  /// Of e; by the gamma that has mean and variance of Q  [Satterthwaite 1946], exact where all weights are alike.
  double mean() const;
  double rms() const;
  /// That e is longer than `length`; by the saddlepoint of Q  [Kuonen 1999]: to 0.002 from 0.02 to 0.2.
  double chance_beyond(double length) const;

 private:
  double slope(double t) const;  // of the cumulant generating function of Q
  double saddlepoint(double q) const;

  Eigen::Array3d weight_;   // l
  Eigen::Array3d squared_;  // l b^2
};

/// A length of e that is one of several, each with a weight (their sum: one).
struct WeighedLength {
  double weight = 1;
  NormalLength length;
};

/// What e does not exceed with that probability.
double length_within(std::span<const WeighedLength> parts, double probability);

/// The same of one coordinate: its distance from nil.
struct WeighedNumber {
  double weight = 1;
  double mean = 0;
  double sigma = 0;
};
double number_within(std::span<const WeighedNumber> parts, double probability);

}  // namespace plumbline::identify

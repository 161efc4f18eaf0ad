#include "machine/condition.hpp"

#include <limits>

#include <Eigen/SVD>

namespace plumbline::machine {

double condition_number(const StrutGeometry<double>& struts, double radius) {
  const Eigen::JacobiSVD<Matrix6<double>> svd(scaled_jacobian(struts, radius));
  const double least = svd.singularValues()[kStruts - 1];
  return least > 0 ? svd.singularValues()[0] / least : std::numeric_limits<double>::infinity();
}

}  // namespace plumbline::machine

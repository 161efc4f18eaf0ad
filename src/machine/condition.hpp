// How near a pose is to a singularity: the condition number of the Jacobian.
#pragma once

#include <limits>

#include "machine/jacobian.hpp"
#include "machine/lu6.hpp"

namespace plumbline::machine {

/// J with its lengths over the platform radius (m): columns [u, (b x u) / radius], without unit.
template <class T>
Matrix6<T> scaled_jacobian(const StrutGeometry<T>& struts, double radius) {
  Matrix6<T> J = jacobian(struts);
  J.template rightCols<3>() *= T(1.0 / radius);
  return J;
}

/// The 2-norm condition number (largest over smallest singular value) of the scaled Jacobian; infinite where it is
/// singular.
double condition_number(const StrutGeometry<double>& struts, double radius);

/// True only where that number is below `most`, and surely where it is below 0.97 of that; a twentieth of its cost, for
/// finding the largest of many. Of numbers from 1e6 on it knows nothing: false.
bool condition_surely_below(const StrutGeometry<double>& struts, double radius, double most);

/// |J| |J^-1| of the scaled Jacobian in the Frobenius norm, never below the 2-norm condition number and at most six
/// times it: what is cheap enough for every point of a path. The largest double where J is singular.
template <class T>
T condition_bound(const StrutGeometry<T>& struts, double radius) {
  using std::sqrt;
  const Matrix6<T> J = scaled_jacobian(struts, radius);
  const Lu6<T> lu(J);
  T inverse = T(0.0);
  for (int j = 0; j < kStruts; ++j) inverse += lu.solve(Vector6<T>::Unit(j)).squaredNorm();
  return select<T>(lu.singular(), T(std::numeric_limits<double>::max()), sqrt(J.squaredNorm() * inverse));
}

}  // namespace plumbline::machine

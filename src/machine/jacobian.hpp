// The Jacobian of the struts: from the twist of the platform to the rates of the lengths, and (transposed) from the
// tensions of the struts to the wrench that they balance.
#pragma once

#include "machine/inverse.hpp"

namespace plumbline::machine {

/// Rows [u_j, b_j x u_j]: Ldot = J (v, w), and J^T t = (N, M about the tip), t > 0 pulls  [Ibaraki et al., Eq. 3-5;
/// docs/physics.md]. First three columns without unit, last three in m.
template <class T>
Matrix6<T> jacobian(const StrutGeometry<T>& struts) {
  Matrix6<T> J;
  for (int j = 0; j < kStruts; ++j) {
    const Vector3<T> b = struts.arm.col(j);
    const Vector3<T> u = struts.direction.col(j);
    const Vector3<T> moment = b.cross(u);
    for (int a = 0; a < 3; ++a) {
      J(j, a) = u[a];
      J(j, a + 3) = moment[a];
    }
  }
  return J;
}

}  // namespace plumbline::machine

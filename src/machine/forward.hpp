// Forward kinematics: the pose that has given strut lengths, by Newton's method on (x, R).
#pragma once

#include <optional>
#include <string_view>

#include "base/pose.hpp"
#include "machine/displacement.hpp"
#include "machine/jacobian.hpp"
#include "machine/lu6.hpp"

namespace plumbline::machine {

enum class ForwardStop {
  converged,
  too_many_iterations,
  no_progress,  // no step makes the lengths fit better: no pose near the start has them
  singular,     // J has no inverse where the iteration stands
  wrong_side,   // the way on leads through a singularity, or the start stands on the other side of one
};
std::string_view to_text(ForwardStop stop);

struct ForwardOptions {
  double tolerance_m = 1e-12;  // largest misfit of any length
  int most_iterations = 12;
  double longest_turn = 0.5;                      // rad that one step may turn
  int most_halvings = 3;                          // of a step that does not help
  int side = 0;                                   // the sign of det J that the pose shall have; 0: that of the start,
                                                  // of the second one where the first is singular
  std::optional<Pose<double>> second_start = {};  // where the way from the first is blocked; the home pose serves
};

struct ForwardResult {
  Pose<double> pose;
  int iterations = 0;     // steps taken
  double residual_m = 0;  // largest misfit of any length at `pose`
  ForwardStop stopped_because = ForwardStop::converged;

  bool converged() const { return stopped_because == ForwardStop::converged; }
};

/// The sign of det J at a pose: +1 or -1; 0 where J is singular. It differs on the two sides of a singularity.
int side_of(const Geometry& geometry, const Pose<double>& pose);

/// The pose that has the strut lengths `lengths` (m), found from `start`. Each step solves J (dx, w) = misfit and
/// applies x <- x + dx, R <- exp(w) R, then once more with the same J; where that does not halve the misfit, the plain
/// step is halved until the misfit shrinks and the side of the singularity is kept. Where a start stands on the wrong
/// side, or the way from it is blocked, starts further and further towards `second_start` are taken if there is one,
/// the steps counted on. A result that has not converged says why and must not be used as a pose.
ForwardResult forward(const Geometry& geometry, const PerStrut<double>& lengths, const Pose<double>& start,
                      const ForwardOptions& options = {});

/// A pose near another one.
template <class T>
struct NearResult {
  Pose<T> pose;
  T residual_m;         // largest misfit of any length
  MaskOf<T> converged;  // within the tolerance
  int iterations = 0;
};

struct NearOptions {
  double tolerance_m = 1e-12;
  int most_iterations = 8;
};

/// The pose whose strut lengths differ from those at `start` by `change` (m), for changes far below the size of the
/// machine (corrections: up to some millimetres): Newton's chord method, which uses one factorisation of J, that at
/// `start`, throughout. `struts` and `lu` are the struts and the factorised Jacobian at `start`. Where it has not
/// converged, or lu is singular, `converged` is false. No heap, no branch on a lane's value.
template <class T>
NearResult<T> forward_near(const Geometry& geometry, const Pose<T>& start, const StrutGeometry<T>& struts,
                           const Lu6<T>& lu, const PerStrut<T>& change, const NearOptions& options = {}) {
  const PerStrut<T> wanted = struts.length + change;
  NearResult<T> result{start, T(0.0), MaskOf<T>(false)};
  PerStrut<T> misfit = change;
  while (true) {
    result.residual_m = T(0.0);
    for (int j = 0; j < kStruts; ++j) result.residual_m = larger<T>(result.residual_m, absolute<T>(misfit[j]));
    result.converged = result.residual_m <= T(options.tolerance_m) && !lu.singular();
    if (all(result.converged || lu.singular()) || result.iterations >= options.most_iterations) return result;
    const Vector6<T> step = lu.solve(misfit);
    result.pose.p_WT += step.template head<3>();
    const Vector3<T> w = step.template tail<3>();
    result.pose.R_WP = (small_rotation<T>(w) * result.pose.R_WP).eval();
    misfit = wanted - strut_lengths<T>(geometry, result.pose);
    ++result.iterations;
  }
}

}  // namespace plumbline::machine

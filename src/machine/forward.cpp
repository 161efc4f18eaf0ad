#include "machine/forward.hpp"

#include <algorithm>

namespace plumbline::machine {
namespace {

// The machine at one pose of the iteration.
struct Standing {
  Pose<double> pose;
  PerStrut<double> misfit;  // lengths wanted minus lengths had, m
  Lu6<double> lu;
  int side;

  Standing(const Geometry& geometry, const PerStrut<double>& lengths, const Pose<double>& at)
      : Standing(strut_geometry(geometry, at), lengths, at) {}
  Standing(const StrutGeometry<double>& struts, const PerStrut<double>& lengths, const Pose<double>& at)
      : pose(at), misfit(lengths - struts.length), lu(jacobian(struts)), side(sign_of(lu)) {}

  static int sign_of(const Lu6<double>& lu) { return lu.singular() ? 0 : (lu.determinant() > 0 ? 1 : -1); }
  double residual() const { return misfit.cwiseAbs().maxCoeff(); }
};

}  // namespace

std::string_view to_text(ForwardStop stop) {
  switch (stop) {
    case ForwardStop::converged:
      return "converged";
    case ForwardStop::too_many_iterations:
      return "too many iterations";
    case ForwardStop::no_progress:
      return "no pose nearby has these strut lengths";
    case ForwardStop::singular:
      return "the pose is singular";
    case ForwardStop::wrong_side:
      break;
  }
  return "the way leads through a singularity";
}

int side_of(const Geometry& geometry, const Pose<double>& pose) {
  return Standing(geometry, PerStrut<double>::Zero(), pose).side;
}

ForwardResult forward(const Geometry& geometry, const PerStrut<double>& lengths, const Pose<double>& start,
                      const ForwardOptions& options) {
  Standing now(geometry, lengths, start);
  const int side = options.side == 0 ? now.side : options.side;
  for (int iteration = 0;; ++iteration) {
    const auto stop = [&](ForwardStop why) { return ForwardResult{now.pose, iteration, now.residual(), why}; };
    if (now.side == 0) return stop(ForwardStop::singular);
    if (now.side != side) return stop(ForwardStop::wrong_side);
    if (now.residual() <= options.tolerance_m) return stop(ForwardStop::converged);
    if (iteration == options.most_iterations) return stop(ForwardStop::too_many_iterations);

    Vector6<double> step = now.lu.solve(now.misfit);
    const double turn = step.tail<3>().norm();
    if (turn > options.longest_turn) step *= options.longest_turn / turn;
    bool taken = false;
    bool crossed = false;
    for (int halving = 0; halving <= options.most_halvings && !taken; ++halving, step *= 0.5) {
      const Standing next(geometry, lengths, displaced<double>(now.pose, step));
      crossed = crossed || next.side != side;
      taken = next.side == side && next.misfit.squaredNorm() < now.misfit.squaredNorm();
      if (taken) now = next;
    }
    if (!taken) return stop(crossed ? ForwardStop::wrong_side : ForwardStop::no_progress);
  }
}

}  // namespace plumbline::machine

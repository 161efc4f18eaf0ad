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
  double residual() const { return misfit.cwiseAbs().maxCoeff<Eigen::PropagateNaN>(); }
};

// A machine whose lengths are being sought.
struct Search {
  const Geometry& geometry;
  const PerStrut<double>& lengths;
  int side;  // the sign of det J to keep
  const ForwardOptions& options;

  Standing at(const Pose<double>& pose) const { return {geometry, lengths, pose}; }

  // The next standing on this side whose misfit is smaller, or `now` if there is none.
  ForwardStop advance(Standing& now) const {
    Vector6<double> step = now.lu.solve(now.misfit);
    const double turn = step.tail<3>().norm();
    if (turn > options.longest_turn) step *= options.longest_turn / turn;

    // Newton's step, and the same factorisation once more on what it leaves: third order  [Potra and Ptak 1984]
    const Pose<double> whole = displaced<double>(now.pose, step);
    const Vector6<double> rest = now.lu.solve(lengths - strut_lengths(geometry, whole));
    const Standing corrected = at(displaced(whole, rest));
    if (corrected.side == side && corrected.misfit.norm() < 0.5 * now.misfit.norm()) {
      now = corrected;
      return ForwardStop::converged;
    }
    bool crossed = false;
    for (int halving = 0; halving <= options.most_halvings; ++halving, step *= 0.5) {
      const Standing next = at(displaced<double>(now.pose, step));
      crossed = crossed || next.side != side;
      if (next.side == side && next.misfit.norm() < now.misfit.norm()) {
        now = next;
        return ForwardStop::converged;
      }
    }
    return crossed ? ForwardStop::wrong_side : ForwardStop::no_progress;
  }

  // From one start, `done` steps having been spent before.
  ForwardResult run(const Pose<double>& start, int done) const {
    Standing now = at(start);
    for (int iteration = done;; ++iteration) {
      const auto stop = [&](ForwardStop why) { return ForwardResult{now.pose, iteration, now.residual(), why}; };
      if (now.side == 0) return stop(ForwardStop::singular);
      if (now.side != side) return stop(ForwardStop::wrong_side);
      if (now.residual() <= options.tolerance_m) return stop(ForwardStop::converged);
      if (iteration >= options.most_iterations) return stop(ForwardStop::too_many_iterations);
      const ForwardStop advanced = advance(now);
      if (advanced != ForwardStop::converged) return stop(advanced);
    }
  }
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
  int side = options.side == 0 ? side_of(geometry, start) : options.side;
  if (side == 0 && options.second_start) side = side_of(geometry, *options.second_start);
  const Search search{geometry, lengths, side, options};
  ForwardResult result = search.run(start, 0);
  if (!options.second_start) return result;
  const Vector6<double> way = displacement_between(start, *options.second_start);
  for (int quarter = 1; quarter <= 4 && !result.converged(); ++quarter) {
    result = search.run(displaced<double>(start, way * (0.25 * quarter)), result.iterations);
  }
  return result;
}

}  // namespace plumbline::machine

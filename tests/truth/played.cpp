#include "truth/played.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Cholesky>

namespace truth {
namespace {

constexpr double kPiece = 0.005;  // s, over which the path is differenced
constexpr double kFastest = 0.2;  // m/s; what is faster is a rapid that was left out
constexpr double kWindow = 0.3;   // s, in which the tip may be late or early
constexpr double kCoarse = 0.01;  // s
constexpr double kFine = 1e-6;    // s
constexpr int kBack = 32;         // looks back over what a lag remembers

bool jumps(const Program& program, double t) {
  return (program.path(t + 2 * kPiece).x - program.path(t - 2 * kPiece).x).norm() > kFastest * 4 * kPiece;
}

// Where the struts are behind what they are told, m: of a lag of first order, int exp(-s / lag) / lag (L(t - s) - L(t))
// ds. The series -lag v + lag^2 a that stands for it on a circle runs away at the corners of a program. Nothing while
// the lag still remembers a rapid.
std::optional<Vec6> behind(const Truth& truth, const Program& program, double t) {
  const Vec6 here = believed_lengths(truth.machine, program.path(t));
  Vec6 sum = Vec6::Zero();
  double last = 0;
  for (int k = kBack - 1; k >= 0; --k) {
    const double back = -truth.flaws.lag * std::log((k + 0.5) / kBack);
    const Stand then = program.path(t - back);
    if ((program.path(t - last).x - then.x).norm() > kFastest * (back - last) + 1e-4) return std::nullopt;
    sum += believed_lengths(truth.machine, then) - here;
    last = back;
  }
  return sum / kBack;
}

struct Miss {
  Vec off;      // across the path
  Vec forward;  // along it, of unit length
};

// A move of a path lasts as long as all the pieces that stand for it, but for rounding, which adds up: the ends of
// moves in both, piece by piece.
class InStep {
 public:
  InStep(const Program& meant, const Program& run) {
    double begin = 0;
    std::size_t piece = 0;
    for (const double end : meant.ends) {
      const double wanted = run_.back() + end - begin;
      const auto off = [&](std::size_t k) { return std::abs(run.ends[k] - wanted); };
      while (piece + 1 < run.ends.size() && off(piece + 1) < off(piece)) ++piece;
      if (piece == run.ends.size()) break;
      meant_.push_back(end);
      run_.push_back(run.ends[piece++]);
      begin = end;
    }
  }
  double meant_at(double t) const {
    const auto next = std::lower_bound(run_.begin() + 1, run_.end() - 1, t) - run_.begin();
    const auto k = static_cast<std::size_t>(next);
    return meant_[k - 1] + (t - run_[k - 1]) / (run_[k] - run_[k - 1]) * (meant_[k] - meant_[k - 1]);
  }
  double seconds() const { return run_.back(); }

 private:
  std::vector<double> meant_{0}, run_{0};
};

}  // namespace

double nearest(const Program& meant, const Vec& place, double about) {
  const auto off = [&](double t) { return (meant.path(t).x - place).squaredNorm(); };
  double best = about;
  for (double t = about - kWindow; t <= about + kWindow; t += kCoarse) {
    if (off(t) < off(best)) best = t;
  }
  double low = best - kCoarse;
  double high = best + kCoarse;
  while (high - low > kFine) {
    const double third = (high - low) / 3;
    if (off(low + third) < off(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return (low + high) / 2;
}

Played play(const Truth& truth, const Program& meant, const Program& run, FrictionLaw law, double step) {
  Follower follower(truth.machine, run.path, kPiece, law);
  Truth lagging = truth;
  lagging.flaws.lag = 0;
  std::vector<Miss> misses;
  double late = 0;  // of the path that was meant against the one that is run
  for (double t = step; t < run.seconds - step; t += step) {
    const Moment moment = follower.at(t, 0, 0);
    if (jumps(run, t)) continue;
    if (truth.flaws.lag != 0) {
      const std::optional<Vec6> off = behind(truth, run, t);
      if (!off) continue;
      for (std::size_t j = 0; j < 6; ++j) {
        lagging.machine.length_offset[j] = truth.machine.length_offset[j] + (*off)[static_cast<int>(j)];
      }
    }
    const Vec tip = tip_ball(lagging, settled(lagging, moment).at, moment);
    const double then = nearest(meant, tip, t + late);
    if (jumps(meant, then)) continue;
    late = then - t;
    const Vec way = meant.path(then + kPiece).x - meant.path(then - kPiece).x;
    if (way.norm() < 1e-7) continue;
    const Vec forward = way.normalized();
    const Vec off = tip - meant.path(then).x;
    misses.push_back({off - forward.dot(off) * forward, forward});
  }
  // the shift that leaves the least across the path: sum (1 - f f^T) shift = sum off
  Eigen::Matrix3d across = 1e-12 * Eigen::Matrix3d::Identity();
  Vec sum = Vec::Zero();
  for (const Miss& miss : misses) {
    across += Eigen::Matrix3d::Identity() - miss.forward * miss.forward.transpose();
    sum += miss.off;
  }
  const Vec shift = across.ldlt().solve(sum);
  Played played;
  for (const Miss& miss : misses) {
    const double off = miss.off.norm();
    const double probed = (miss.off - shift + miss.forward.dot(shift) * miss.forward).norm();
    played.rms += off * off;
    played.probed_rms += probed * probed;
    played.most = std::max(played.most, off);
    played.probed_most = std::max(played.probed_most, probed);
  }
  played.samples = static_cast<int>(misses.size());
  const double count = std::max<double>(played.samples, 1);
  played.rms = std::sqrt(played.rms / count);
  played.probed_rms = std::sqrt(played.probed_rms / count);
  return played;
}

Offs offs(const Truth& truth, const Program& meant, const Program& run, const Program& at_rest, FrictionLaw law,
          double step) {
  Truth prompt = truth;
  prompt.flaws.lag = 0;
  const auto off = [&](const Moment& moment, double t) {
    return Vec(tip_ball(prompt, settled(prompt, moment).at, moment) - meant.path(t).x);
  };
  Stand begin = at_rest.path(0);
  Follower standing(
      truth.machine, [&](double) { return begin; }, kPiece, law);
  Offs all{off(standing.at(0, 0, 0), 0), {}};
  Follower follower(truth.machine, run.path, kPiece, law);
  const InStep both(meant, run);
  for (double t = step; t < both.seconds() - step; t += step) {
    const Moment moment = follower.at(t, 0, 0);
    const double then = both.meant_at(t);
    if (!jumps(run, t) && !jumps(meant, then)) all.along.push_back({then, off(moment, then)});
  }
  return all;
}

}  // namespace truth

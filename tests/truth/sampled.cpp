#include "truth/sampled.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <Eigen/LU>

#include "truth/played.hpp"

namespace truth {
namespace {

constexpr int kRapidMotion = 1;

// How the lengths change as a stand is moved, and turned, by a short way.
Mat6 slopes_at(const Machine& machine, const Stand& at) {
  constexpr double kStep = 1e-6;
  Mat6 slopes;
  for (int k = 0; k < 6; ++k) {
    const Vec6 way = kStep * Vec6::Unit(k);
    slopes.col(k) =
        (believed_lengths(machine, moved(at, way)) - believed_lengths(machine, moved(at, -way))) / (2 * kStep);
  }
  return slopes;
}

// Where a machine without any error has these lengths: Newton's method, its slopes kept for some steps.
Stand stand_of(const Machine& machine, const Vec6& told, Stand at) {
  constexpr double kSmall = 1e-12;  // m
  Eigen::PartialPivLU<Mat6> slopes;
  for (int step = 0; step < 100; ++step) {
    const Vec6 misfit = told - believed_lengths(machine, at);
    if (misfit.cwiseAbs().maxCoeff() < kSmall) return at;
    if (step % 5 == 0) slopes.compute(slopes_at(machine, at));
    at = moved(at, slopes.solve(misfit));
  }
  throw std::runtime_error("no pose has the strut lengths that the control asks for");
}

// The recording as a path: between two samples in proportion.
Path path_of(const Machine& machine, const Recording& recording, const Stand& start) {
  const auto stands = std::make_shared<std::vector<Stand>>();
  Stand at = start;
  for (const Period& sample : recording.samples) stands->push_back(at = stand_of(machine, sample.told, at));
  return [stands, period = recording.period](double t) {
    const double place = std::clamp(t / period, 0.0, static_cast<double>(stands->size() - 1));
    const auto before = static_cast<std::size_t>(std::min(place, static_cast<double>(stands->size()) - 2));
    const double share = place - static_cast<double>(before);
    const Stand& a = (*stands)[before];
    const Stand& b = (*stands)[before + 1];
    const Eigen::AngleAxisd turn(Rotation(a.R.transpose() * b.R));
    return Stand{a.x + share * (b.x - a.x), a.R * Eigen::AngleAxisd(share * turn.angle(), turn.axis())};
  };
}

}  // namespace

Recording read_recording(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  Recording recording;
  std::size_t first = 0;  // the counter goes on from recording to recording
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::size_t counter = 0;
    Period sample;
    words >> counter;
    for (int j = 0; j < 6; ++j) words >> sample.told[j];
    words >> sample.motion;
    if (recording.samples.empty()) first = counter;
    if (!words || counter != first + recording.samples.size())
      throw std::runtime_error(path + " lacks a sample: " + line);
    sample.told *= kMm;
    recording.samples.push_back(sample);
  }
  if (recording.samples.size() < 3) throw std::runtime_error(path + " holds no samples");
  return recording;
}

Followed follow(const Truth& truth, const Program& meant, const Recording& recording, FrictionLaw law) {
  Follower follower(truth.machine, path_of(truth.machine, recording, meant.path(0)), recording.period, law);
  Followed result;
  double then = 0;  // when the path that was meant is where the tip is
  int first = -1;
  int last = 0;
  double sum = 0;
  const int end = static_cast<int>(recording.samples.size()) - 1;
  for (int k = 1; k < end; ++k) {
    const int motion = recording.samples[static_cast<std::size_t>(k)].motion;
    if (motion == 0) continue;
    if (first < 0) first = k;
    last = k;
    const double t = k * recording.period;
    const Moment moment = follower.at(t, 0, 0);
    if (motion == kRapidMotion) continue;
    const Vec tip = tip_ball(truth, settled(truth, moment).at, moment);
    then = std::clamp(nearest(meant, tip, then + recording.period), 0.0, meant.seconds);
    const double off = (tip - meant.path(then).x).norm();
    result.cutting.push_back({t, off});
    result.most = std::max(result.most, off);
    sum += off * off;
  }
  if (result.cutting.empty()) throw std::runtime_error("the control cuts nothing");
  result.rms = std::sqrt(sum / static_cast<double>(result.cutting.size()));
  result.seconds = (last - first + 1) * recording.period;
  return result;
}

}  // namespace truth

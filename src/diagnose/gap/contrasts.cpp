#include "diagnose/gap/contrasts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angle.hpp"
#include "diagnose/readings/poses.hpp"

namespace plumbline::diagnose {

namespace {

using identify::kRadial;
using identify::RunEquations;
using measure::Run;

// The residual at an angle, between its neighbours.
class Interpolated {
 public:
  Interpolated(const Run& run, const Eigen::VectorXd& e) {
    for (std::size_t i = 0; i < run.angle.size(); ++i) {
      points_.emplace_back(within_turn(run.angle[i]), e[static_cast<Eigen::Index>(i)]);
    }
    std::sort(points_.begin(), points_.end());
  }
  double at(double angle) const {
    const double phi = within_turn(angle);
    const auto above = std::upper_bound(points_.begin(), points_.end(), std::pair(phi, 1e300));
    const auto& b = above == points_.end() ? points_.front() : *above;
    const auto& a = above == points_.begin() ? points_.back() : *(above - 1);
    const double span = within_turn(b.first - a.first);
    const double share = span > 0 ? within_turn(phi - a.first) / span : 0;
    return a.second + share * (b.second - a.second);
  }

 private:
  std::vector<std::pair<double, double>> points_;
};

constexpr double kSameFeed = 1e-6;  // relative: feeds of files differ by rounding
// One arc may be missing between the last sample and the first.
constexpr double kWholeTurn = kTurn * (kArcs - 1) / kArcs;

// Whether two runs at one pose differ in this alone. Time passes between any two: it counts only between repeats.
bool differ_by(Difference difference, const Run& a, const Run& b) {
  const bool direction = a.direction != b.direction;
  const bool feed = std::abs(a.feed - b.feed) > kSameFeed * a.feed;
  const bool payload = a.payload_mass != b.payload_mass;
  switch (difference) {
    case Difference::direction:
      return direction && !feed && !payload;
    case Difference::feed:
      return !direction && feed && !payload;
    case Difference::payload:
      return !direction && !feed && payload;
    case Difference::time:
      break;
  }
  return !direction && !feed && !payload && a.start != b.start;
}

// Gathers what the waves of one channel and order have in common, pair by pair.
struct CommonWave {
  double common = 0;    // Re(a conj b)
  double squares = 0;   // |a b|^2
  double products = 0;  // |a b|

  void add(std::complex<double> a, std::complex<double> b) {
    common += (a * std::conj(b)).real();
    squares += std::norm(a) * std::norm(b);
    products += std::abs(a) * std::abs(b);
  }
};

// The set-up takes the wave of order 1 of the bar.
constexpr int first_order(int channel) { return channel == kRadial ? 2 : 1; }

// On less than a circle waves of different orders are no different waves.
bool goes_round(const Run& run) {
  const auto [least, most] = std::minmax_element(run.angle.begin(), run.angle.end());
  return run.samples() > 2 * kWaves && *most - *least > kWholeTurn;
}

using CommonWaves = std::array<std::array<CommonWave, kWaves>, identify::kChannels>;

Recurrence recurrence_of(const CommonWaves& waves, int first_channel, int last_channel) {
  Recurrence recurrence;
  double common = 0;
  double products = 0;
  for (int channel = first_channel; channel <= last_channel; ++channel) {
    for (const CommonWave& wave : waves.at(static_cast<std::size_t>(channel))) {
      if (!(wave.squares > 0)) continue;
      recurrence.chi2 += 2 * wave.common * wave.common / wave.squares;
      ++recurrence.count;
      common += wave.common;
      products += wave.products;
    }
  }
  if (products > 0) recurrence.correlation = common / products;
  return recurrence;
}

Contrast contrast_of(Difference by, const std::vector<Run>& runs, const std::vector<int>& poses,
                     const std::vector<RunEquations>& residuals) {
  Contrast contrast{by};
  BarAndTorqueSquares common;
  BarAndTorqueSquares differs;
  CommonWaves waves{};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t k = i + 1; k < runs.size(); ++k) {
      if (poses[i] != poses[k] || runs[i].radius != runs[k].radius || !differ_by(by, runs[i], runs[k])) continue;
      ++contrast.pairs;
      for (int channel = 0; channel < identify::kChannels; ++channel) {
        const std::optional<Eigen::VectorXd> a = channel_of(residuals[i], channel);
        const std::optional<Eigen::VectorXd> b = channel_of(residuals[k], channel);
        if (!a || !b) continue;
        const Interpolated other(runs[k], *b);
        for (Eigen::Index s = 0; s < a->size(); ++s) {
          const double there = other.at(runs[i].angle[static_cast<std::size_t>(s)]);
          common.add(channel, ((*a)[s] + there) / std::numbers::sqrt2);
          differs.add(channel, ((*a)[s] - there) / std::numbers::sqrt2);
        }
        if (!goes_round(runs[i]) || !goes_round(runs[k])) continue;
        for (int order = first_order(channel); order <= kWaves; ++order) {
          waves.at(static_cast<std::size_t>(channel))
              .at(static_cast<std::size_t>(order - 1))
              .add(wave_of(*a, runs[i].angle, order), wave_of(*b, runs[k].angle, order));
        }
      }
    }
  }
  contrast.common = common.root();
  contrast.differs = differs.root();
  contrast.radial = recurrence_of(waves, kRadial, kRadial);
  contrast.torque = recurrence_of(waves, kRadial + 1, identify::kChannels - 1);
  return contrast;
}

}  // namespace

std::string_view to_text(Difference difference) {
  switch (difference) {
    case Difference::direction:
      return "direction";
    case Difference::feed:
      return "feed";
    case Difference::payload:
      return "payload";
    case Difference::time:
      break;
  }
  return "time";
}

std::vector<Contrast> contrasts_of(const std::vector<Run>& runs, const std::vector<RunEquations>& residuals) {
  const std::vector<int> poses = poses_of(runs);
  std::vector<Contrast> contrasts;
  for (const Difference by : {Difference::direction, Difference::feed, Difference::payload, Difference::time}) {
    const Contrast contrast = contrast_of(by, runs, poses, residuals);
    if (contrast.pairs > 0) contrasts.push_back(contrast);
  }
  return contrasts;
}

// a b = ((a + b)^2 - (a - b)^2) / 4
double recurring_radial(const std::vector<Contrast>& contrasts) {
  double products = 0;
  double pairs = 0;
  for (const Contrast& contrast : contrasts) {
    const double common = contrast.common.radial;
    const double differs = contrast.differs.radial;
    products += contrast.pairs * (common * common - differs * differs) / 2;
    pairs += contrast.pairs;
  }
  return pairs > 0 ? std::sqrt(std::max(0.0, products / pairs)) : 0;
}

}  // namespace plumbline::diagnose

#include "diagnose/gap_map.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <optional>

#include "base/mean_square.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "diagnose/held_out.hpp"
#include "diagnose/states.hpp"
#include "machine/limits.hpp"
#include "measure/circularity.hpp"

namespace plumbline::diagnose {
namespace {

using identify::kRadial;
using identify::RunEquations;
using measure::Run;

constexpr double kTurn = 2 * std::numbers::pi;

struct TwoSquares {
  MeanSquare radial, torque;
  void add(int channel, double value) { (channel == kRadial ? radial : torque).add(value); }
  BarAndTorque root() const { return {radial.root(), torque.root()}; }
};

std::optional<Eigen::VectorXd> channel_of(const RunEquations& run, int channel) {
  const std::optional<Eigen::Index> first = run.first_row(channel);
  if (!first) return std::nullopt;
  return run.residual.segment(*first, run.samples);
}

double within_turn(double angle) { return angle - kTurn * std::floor(angle / kTurn); }

// Amplitude and phase of the wave of one order: a exp(i phase) / 2.
std::complex<double> wave_of(const Eigen::VectorXd& e, const std::vector<double>& angle, int order) {
  std::complex<double> sum = 0;
  for (Eigen::Index i = 0; i < e.size(); ++i) sum += e[i] * std::polar(1.0, order * angle[static_cast<std::size_t>(i)]);
  return sum / static_cast<double>(e.size());
}

ChannelWhere around_the_circle(const std::vector<Run>& runs, const std::vector<RunEquations>& residuals, int channel,
                               const identify::ChannelNoise& noise) {
  ChannelWhere where{channel};
  MeanSquare all;
  std::array<MeanSquare, kArcs> arcs;
  std::array<MeanSquare, kWaves> waves;
  std::array<MeanSquare, kWaves> floors;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::optional<Eigen::VectorXd> e = channel_of(residuals[r], channel);
    if (!e) continue;
    for (Eigen::Index i = 0; i < e->size(); ++i) {
      const double share = within_turn(runs[r].angle[static_cast<std::size_t>(i)]) / kTurn;
      all.add((*e)[i]);
      arcs.at(std::min<std::size_t>(static_cast<std::size_t>(share * kArcs), kArcs - 1)).add((*e)[i]);
    }
    const auto n = static_cast<double>(e->size());
    for (int k = 0; k < kWaves; ++k) {
      const auto place = static_cast<std::size_t>(k);
      waves.at(place).add(std::numbers::sqrt2 * std::abs(wave_of(*e, runs[r].angle, k + 1)));
      floors.at(place).add(std::sqrt(2 / n * noise_power(noise, (k + 1) / n)));
    }
  }
  where.rms = all.root();
  for (std::size_t a = 0; a < kArcs; ++a) where.arcs.at(a) = arcs.at(a).root();
  for (std::size_t k = 0; k < kWaves; ++k) {
    where.waves.at(k) = waves.at(k).root();
    where.wave_noise.at(k) = floors.at(k).root();
  }
  return where;
}

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

// Whether two runs at one pose differ in this alone. Time passes between any two: it counts only between repeats.
bool differ_by(const std::string& by, const Run& a, const Run& b) {
  const bool direction = a.direction != b.direction;
  const bool feed = std::abs(a.feed - b.feed) > 1e-6 * a.feed;
  const bool payload = a.payload_mass != b.payload_mass;
  if (by == "direction") return direction && !feed && !payload;
  if (by == "feed") return !direction && feed && !payload;
  if (by == "payload") return !direction && !feed && payload;
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
  return run.samples() > 2 * kWaves && *most - *least > kTurn * 11 / 12;
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

Contrast contrast_of(const std::string& by, const std::vector<Run>& runs, const std::vector<int>& poses,
                     const std::vector<RunEquations>& residuals) {
  Contrast contrast{by};
  TwoSquares common;
  TwoSquares differs;
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

double tilt_of(const machine::RotationOrder& order, const Run& run) {
  return machine::tilt(machine::rotation<double>(order, run.tilt)) / kDeg;
}

class Groups {
 public:
  Groups(const std::vector<Run>& runs, const std::vector<RunEquations>& residuals)
      : runs_(runs), residuals_(residuals) {}

  // Runs whose figure lies from one edge to the next, the last edge included.
  void between(const std::string& by, const std::vector<double>& edges, const std::function<double(const Run&)>& of) {
    for (std::size_t g = 0; g + 1 < edges.size(); ++g) {
      const bool last = g + 2 == edges.size();
      add(by, edges[g], edges[g + 1],
          [&](const Run& r) { return of(r) >= edges[g] && (of(r) < edges[g + 1] || (last && of(r) <= edges[g + 1])); });
    }
  }
  void each(const std::string& by, const std::function<double(const Run&)>& of) {
    std::vector<double> values;
    for (const Run& run : runs_) values.push_back(of(run));
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    for (const double value : values) {
      add(by, value, value, [&](const Run& r) { return of(r) == value; });
    }
  }
  std::vector<RunGroup> found;

 private:
  void add(const std::string& by, double from, double to, const std::function<bool(const Run&)>& belongs) {
    RunGroup group{by, from, to};
    TwoSquares squares;
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      if (!belongs(runs_[r])) continue;
      ++group.runs;
      for (std::size_t c = 0; c < residuals_[r].channels.size(); ++c) {
        const Eigen::Index n = residuals_[r].samples;
        for (const double e : residuals_[r].residual.segment(static_cast<Eigen::Index>(c) * n, n)) {
          squares.add(residuals_[r].channels[c], e);
        }
      }
    }
    if (group.runs == 0) return;
    group.rms = squares.root();
    found.push_back(group);
  }

  const std::vector<Run>& runs_;
  const std::vector<RunEquations>& residuals_;
};

std::vector<RunGroup> groups_of(const machine::RotationOrder& order, const std::vector<Run>& runs,
                                const std::vector<RunEquations>& residuals, const GapMapOptions& options) {
  Groups groups(runs, residuals);
  groups.between("tilt_deg", options.tilts_deg, [&](const Run& r) { return tilt_of(order, r); });
  // feeds of files differ by rounding
  groups.each("feed_mm_min", [](const Run& r) { return std::round(r.feed / kMmPerMin * 10) / 10; });
  groups.each("payload_kg", [](const Run& r) { return r.payload_mass; });
  const auto [first, last] =
      std::minmax_element(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.start < b.start; });
  constexpr double kHour = 3600;
  std::vector<double> edges;
  for (int g = 0; g <= options.start_groups; ++g) {
    edges.push_back((first->start + (last->start - first->start) * g / options.start_groups) / kHour);
  }
  if (last->start > first->start) groups.between("start_h", edges, [](const Run& r) { return r.start / kHour; });
  return groups.found;
}

// A step and how readings would move with it: step = slope x size + noise.
struct Step {
  double slope, step;
};

// Size and standard error by least squares.
std::pair<double, double> size_of(const std::vector<Step>& steps) {
  double cross = 0;
  double square = 0;
  for (const Step& s : steps) {
    cross += s.slope * s.step;
    square += s.slope * s.slope;
  }
  if (steps.size() < 3 || !(square > 0)) return {0, 0};
  const double size = cross / square;
  double left = 0;
  for (const Step& s : steps) left += std::pow(s.step - s.slope * size, 2);
  return {size, std::sqrt(left / static_cast<double>(steps.size() - 1) / square)};
}

// dx = J^-1 dL: how the bar moves with the length of a strut
double bar_by_length(const State& state, const Vector3<double>& ball, int strut) {
  machine::Vector6<double> length = machine::Vector6<double>::Zero();
  length[strut] = 1;
  const machine::Vector6<double> moved = machine::Lu6<double>(machine::jacobian(state.struts)).solve(length);
  return (state.pose.p_WT - ball).normalized().dot(moved.head<3>());
}

std::vector<Reversal> reversals_of(const std::vector<Run>& runs, const std::vector<std::vector<State>>& states,
                                   const std::vector<RunEquations>& residuals, const GapMapOptions& options) {
  std::vector<Reversal> all;
  for (int j = 0; j < machine::kStruts; ++j) {
    Reversal reversal{j};
    std::vector<Step> lengths;
    std::vector<Step> torques;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const std::optional<Eigen::VectorXd> radial = channel_of(residuals[r], kRadial);
      const std::optional<Eigen::VectorXd> torque = channel_of(residuals[r], 1 + j);
      const Eigen::Map<const Eigen::VectorXd> angle(runs[r].angle.data(),
                                                    static_cast<Eigen::Index>(runs[r].angle.size()));
      for (std::size_t s = 0; s + 1 < states[r].size(); ++s) {
        const double before = states[r][s].speed[j];
        const double behind = states[r][s + 1].speed[j];
        if ((before < 0) == (behind < 0)) continue;
        ++reversal.count;
        const double there = angle[static_cast<Eigen::Index>(s)] +
                             before / (before - behind) *
                                 (angle[static_cast<Eigen::Index>(s + 1)] - angle[static_cast<Eigen::Index>(s)]);
        // a step towards greater angles, as one towards greater speed
        const double sign = runs[r].turn() * (behind > before ? 1 : -1);
        const auto add = [&](const std::optional<Eigen::VectorXd>& e, double slope, std::vector<Step>& steps) {
          if (!e) return;
          const auto step = measure::reversal_step({angle, *e}, there, options.reversal_window);
          if (step) steps.push_back({slope, sign * *step});
        };
        add(radial, bar_by_length(states[r][s], measure::ideal_ball(runs[r]), j), lengths);
        add(torque, 1, torques);
      }
    }
    std::tie(reversal.length, reversal.length_error) = size_of(lengths);
    std::tie(reversal.torque, reversal.torque_error) = size_of(torques);
    all.push_back(reversal);
  }
  return all;
}

}  // namespace

std::vector<Contrast> contrasts_of(const std::vector<Run>& runs, const std::vector<RunEquations>& residuals) {
  const std::vector<int> poses = poses_of(runs);
  std::vector<Contrast> contrasts;
  for (const char* const by : {"direction", "feed", "payload", "time"}) {
    Contrast contrast = contrast_of(by, runs, poses, residuals);
    if (contrast.pairs > 0) contrasts.push_back(std::move(contrast));
  }
  return contrasts;
}

GapMap where_of(const machine::RotationOrder& order, const std::vector<Run>& runs, const physics::ForceModel& forces,
                const std::vector<RunEquations>& residuals, const identify::NoiseModel& noise,
                const GapMapOptions& options) {
  GapMap where;
  for (int channel = 0; channel < identify::kChannels; ++channel) {
    const bool measured = std::any_of(residuals.begin(), residuals.end(),
                                      [&](const RunEquations& run) { return run.first_row(channel).has_value(); });
    if (!measured) continue;
    where.channels.push_back(
        around_the_circle(runs, residuals, channel, noise.channels[static_cast<std::size_t>(channel)]));
  }
  where.contrasts = contrasts_of(runs, residuals);
  where.groups = groups_of(order, runs, residuals, options);
  std::vector<std::vector<State>> states(runs.size());
  for_each_index(runs.size(), [&](std::size_t i) { states[i] = states_of(order, forces, runs[i]); });
  where.reversals = reversals_of(runs, states, residuals, options);
  return where;
}

}  // namespace plumbline::diagnose

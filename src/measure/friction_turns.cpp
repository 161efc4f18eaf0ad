#include "measure/friction_turns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "base/angle.hpp"
#include "base/median.hpp"
#include "machine/inverse.hpp"
#include "measure/simulation.hpp"

namespace plumbline::measure {
namespace {

using machine::kStruts;

// Travel of each strut since it turned round, from sample to sample; before its first turn without end.
class TravelSinceTurn {
 public:
  void go_on(const machine::PerStrut<double>& speed, double seconds) {
    for (int j = 0; j < kStruts; ++j) {
      const double before = speed_[j];
      const double now = speed[j];
      if (before * now < 0) {
        travel_[j] = now * now / (std::abs(before) + std::abs(now)) / 2 * seconds;
      } else {
        travel_[j] += (std::abs(before) + std::abs(now)) / 2 * seconds;
      }
    }
    speed_ = speed;
  }
  double least() const { return travel_.minCoeff(); }

 private:
  machine::PerStrut<double> speed_ = machine::PerStrut<double>::Zero();
  machine::PerStrut<double> travel_ = machine::PerStrut<double>::Constant(std::numeric_limits<double>::infinity());
};

std::vector<std::size_t> samples_of(const std::vector<FrictionTurn>& turns) {
  std::vector<std::size_t> samples;
  for (const FrictionTurn& turn : turns) {
    for (std::size_t i = turn.begin; i < turn.end; ++i) samples.push_back(i);
  }
  return samples;
}

// The columns of readings that were measured.
std::vector<std::vector<double>*> readings_of(Run& run) {
  std::vector<std::vector<double>*> readings;
  if (run.has_radial()) readings.push_back(&run.radial);
  for (std::vector<double>& torque : run.torque) {
    if (!torque.empty()) readings.push_back(&torque);
  }
  return readings;
}

// How far beside a turn it is looked how what is left goes on: three times its length.
std::size_t reach(const FrictionTurn& turn) { return 3 * (turn.end - turn.begin); }

// The samples of turns and those beside them, ascending.
std::vector<std::size_t> near(const std::vector<FrictionTurn>& turns, std::size_t samples, std::size_t edge) {
  std::vector<std::size_t> found;
  for (const FrictionTurn& turn : turns) {
    const std::size_t beside = reach(turn) + edge;
    std::size_t i = turn.begin > beside ? turn.begin - beside : 0;
    if (!found.empty()) i = std::max(i, found.back() + 1);
    for (; i < std::min(turn.end + beside, samples); ++i) found.push_back(i);
  }
  return found;
}

Run only(const Run& run, const std::vector<std::size_t>& samples) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0, k = 0; i < run.samples(); ++i) {
    if (k < samples.size() && samples[k] == i) {
      ++k;
    } else {
      others.push_back(i);
    }
  }
  return without_samples(run, others);
}

// With the readings that the model makes of it.
Run modelled(const machine::MachineModel& machine, const physics::ForceModel& forces, Run run) {
  const RunSimulation simulation = simulate_run(machine, forces, run);
  if (run.has_radial()) {
    const Eigen::VectorXd radial = simulation.radial(ideal_ball(run), run.bar_length());
    run.radial.assign(radial.begin(), radial.end());
  }
  for (std::size_t j = 0; j < run.torque.size(); ++j) {
    for (std::size_t i = 0; i < run.torque[j].size(); ++i)
      run.torque[j][i] = simulation.samples[i].torque[static_cast<Eigen::Index>(j)];
  }
  return run;
}

// What a model leaves about a sample, and how that goes on from one to the next.
struct Edge {
  double at = 0;
  double value = 0;
  double slope = 0;

  double operator()(std::size_t sample) const { return value + slope * (static_cast<double>(sample) - at); }
};

// From a turn outwards, from sample `first` on: medians of so many samples, the second `far` beyond the first one.
// Nothing: there are too few samples on that side.
std::optional<Edge> edge_of(std::span<const double> left, std::ptrdiff_t first, int outwards, std::size_t count,
                            std::size_t far) {
  const auto median_from = [&](std::ptrdiff_t from) -> std::optional<double> {
    std::vector<double> values;
    for (std::ptrdiff_t i = from; values.size() < count; i += outwards) {
      if (i < 0 || i >= std::ssize(left)) return std::nullopt;
      values.push_back(left[static_cast<std::size_t>(i)]);
    }
    return median(std::move(values));
  };
  const auto beyond = static_cast<std::ptrdiff_t>(far) * outwards;
  const std::optional<double> near = median_from(first);
  if (!near) return std::nullopt;
  const std::optional<double> further = median_from(first + beyond);
  const auto half = static_cast<std::ptrdiff_t>(count / 2);
  const auto middle = static_cast<double>(first + outwards * half);
  return Edge{middle, *near, further ? (*further - *near) / static_cast<double>(beyond) : 0};
}

}  // namespace

std::vector<FrictionTurn> friction_turns(const machine::MachineModel& machine, const physics::ForceModel& forces,
                                         const Run& run, const FrictionTurnOptions& options) {
  const physics::Environment environment = forces.environment();
  const double slow = options.slow * environment.sign_speed;
  TravelSinceTurn travel;
  std::vector<FrictionTurn> turns;
  std::size_t count = 0;
  bool has_turned = true;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const physics::Motion<double> motion = circular_motion(machine.rotation, run, i);
    const machine::PerStrut<double> speed =
        physics::strut_rates(machine::strut_geometry(machine.geometry, motion.pose), motion, environment).speed;
    const double way = i == 0 ? 0 : std::abs(std::remainder(run.angle[i] - run.angle[i - 1], kTurn));
    travel.go_on(speed, way * run.radius / run.feed);
    const bool turned = travel.least() < options.way;
    if (!turned && speed.cwiseAbs().minCoeff() >= slow) continue;
    ++count;
    if (turns.empty() || turns.back().end < i) {
      turns.push_back({i, i, i});
      has_turned = false;
    }
    turns.back().end = i + 1;
    if (!has_turned) turns.back().turned = turned ? i : i + 1;
    has_turned = has_turned || turned;
  }
  if (static_cast<double>(count) > options.most_of_run * static_cast<double>(run.samples())) turns.clear();
  return turns;
}

Run without_friction_turns(const machine::MachineModel& machine, const physics::ForceModel& forces, Run run,
                           const FrictionTurnOptions& options) {
  const auto samples = samples_of(friction_turns(machine, forces, run, options));
  return without_samples(std::move(run), samples);
}

void fill_friction_turns(const machine::MachineModel& machine, const physics::ForceModel& forces, Run& run,
                         const FrictionTurnOptions& options) {
  const std::vector<FrictionTurn> turns = friction_turns(machine, forces, run, options);
  if (turns.empty()) return;
  const std::vector<std::size_t> looked = near(turns, run.samples(), options.edge);
  Run model = modelled(machine, forces, only(run, looked));
  const auto measured = readings_of(run);
  const auto modelled = readings_of(model);
  for (std::size_t c = 0; c < measured.size(); ++c) {
    std::vector<double>& readings = *measured[c];
    std::vector<double> made(run.samples());
    for (std::size_t k = 0; k < looked.size(); ++k) made[looked[k]] = (*modelled[c])[k];
    std::vector<double> left(run.samples());
    for (const std::size_t i : looked) left[i] = readings[i] - made[i];
    for (const FrictionTurn& turn : turns) {
      const std::size_t far = reach(turn);
      std::optional<Edge> before = edge_of(left, static_cast<std::ptrdiff_t>(turn.begin) - 1, -1, options.edge, far);
      std::optional<Edge> after = edge_of(left, static_cast<std::ptrdiff_t>(turn.end), 1, options.edge, far);
      if (!before) before = after;
      if (!after) after = before;
      if (!before) continue;
      for (std::size_t i = turn.begin; i < turn.end; ++i)
        readings[i] = made[i] + (i < turn.turned ? *before : *after)(i);
    }
  }
}

}  // namespace plumbline::measure

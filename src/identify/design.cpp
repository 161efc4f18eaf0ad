#include "identify/design.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Cholesky>

#include "base/check.hpp"
#include "base/diagnostic.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "identify/fit.hpp"
#include "measure/planned_run.hpp"

namespace plumbline::identify {
namespace {

// In scales, of what is free and not determined by anything: keeps logarithms finite, and weighs nothing beside a
// reading.
constexpr double kFreeInformation = 1e-9;

// From 0 to 1, the same everywhere: distributions of the standard library are not.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

// 0 and never -0.
double rounded(double value, double step) { return step * std::round(value / step) + 0.0; }

const double& one_of(const std::vector<double>& values, std::mt19937_64& random) {
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(uniform(random) * static_cast<double>(values.size())))];
}

measure::Run drawn_run(const machine::MachineModel& machine, const CandidateOptions& options, std::mt19937_64& random) {
  measure::Run run;
  run.radius = one_of(options.radii, random);
  if (options.bar && *options.bar > run.radius) run.bar = options.bar;
  for (int a = 0; a < 3; ++a) {
    const machine::Range& range = machine.limits.travel[static_cast<std::size_t>(a)];
    const double room = a < 2 ? run.radius : 0;
    const double lower = range.lower + room;
    run.centre_W[a] = rounded(lower + uniform(random) * std::max(range.upper - room - lower, 0.0), options.step);
  }
  // even over the disc of tilts
  const double tilt = options.tilt_share * machine.limits.tilt * std::sqrt(uniform(random));
  const double angle = 2 * std::numbers::pi * uniform(random);
  run.tilt = {rounded(tilt * std::cos(angle), options.tilt_step), rounded(tilt * std::sin(angle), options.tilt_step),
              0};
  run.direction = uniform(random) < 0.5 ? measure::Direction::ccw : measure::Direction::cw;
  run.feed = one_of(options.feeds, random);
  run.payload_mass = one_of(options.payloads, random);
  measure::lay_samples(run, options.samples, options.bar_readings, options.torques);
  return run;
}

double log_determinant(const Eigen::MatrixXd& M) {
  const Eigen::LLT<Eigen::MatrixXd> llt(M);
  if (llt.info() != Eigen::Success) return -std::numeric_limits<double>::infinity();
  return 2 * llt.matrixLLT().diagonal().array().log().sum();
}

// The best candidate to add to what is known; the first of equals.
struct Best {
  std::size_t candidate = 0;
  double criterion = -std::numeric_limits<double>::infinity();
};

Best best_addition(const std::vector<Eigen::MatrixXd>& candidates, const Eigen::MatrixXd& known,
                   const Criterion& criterion, double weight) {
  std::vector<double> values(candidates.size());
  for_each_index(candidates.size(), [&](std::size_t i) { values[i] = criterion(known + weight * candidates[i]); });
  Best best;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] > best.criterion) best = {i, values[i]};
  }
  return best;
}

}  // namespace

bool stands_firm(const machine::RotationOrder& order, const physics::ForceModel& forces, const measure::Run& run,
                 double most) {
  try {
    return simulate_run(order, forces, run).furthest_off <= most;
  } catch (const Refusal&) {
    return false;
  }
}

std::vector<measure::Run> candidate_runs(const machine::MachineModel& machine, const CandidateOptions& options) {
  const physics::ForceModel forces(machine);
  std::mt19937_64 random(options.seed);
  std::vector<measure::Run> runs;
  for (std::size_t tries = options.most * options.tries; tries > 0 && runs.size() < options.most; --tries) {
    measure::Run run = drawn_run(machine, options, random);
    if (measure::within_limits(machine, run) && stands_firm(machine.rotation, forces, run, options.most_off))
      runs.push_back(std::move(run));
  }
  return runs;
}

Criterion d_optimal(const Unknowns& unknowns, std::vector<std::size_t> asked) {
  Eigen::VectorXd prior = prior_weights(unknowns).cwiseMax(kFreeInformation);
  std::vector<Eigen::Index> others;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    if (std::find(asked.begin(), asked.end(), i) == asked.end()) others.push_back(static_cast<Eigen::Index>(i));
  }
  return [prior = std::move(prior), others = std::move(others)](const Eigen::MatrixXd& information) {
    Eigen::MatrixXd all = information;
    all.diagonal() += prior;
    // of those asked for: det M / det M_others
    return log_determinant(all) - (others.empty() ? 0 : log_determinant(all(others, others)));
  };
}

// With M the precision in scales and R a root of a mean square, trace(M^-1 R R^T) = |L^-1 R|^2 for M = L L^T.
Criterion v_optimal(const Unknowns& unknowns, const std::vector<Eigen::MatrixXd>& mean_squares) {
  Eigen::VectorXd prior = prior_weights(unknowns).cwiseMax(kFreeInformation);
  const Eigen::VectorXd scales = unknowns.scales() / kUm;
  std::vector<Eigen::MatrixXd> roots;
  for (const Eigen::MatrixXd& square : mean_squares) {
    roots.push_back(root_of(scales.asDiagonal() * square * scales.asDiagonal()));
  }
  return [prior = std::move(prior), roots = std::move(roots)](const Eigen::MatrixXd& information) {
    Eigen::MatrixXd precision = information;
    precision.diagonal() += prior;
    const Eigen::LLT<Eigen::MatrixXd> llt(precision);
    if (llt.info() != Eigen::Success) return -std::numeric_limits<double>::infinity();
    double sum = 0;
    for (const Eigen::MatrixXd& root : roots) sum -= std::log(llt.matrixL().solve(root).squaredNorm());
    return sum / static_cast<double>(roots.size());
  };
}

double noncentrality(const Unknowns& unknowns, const Eigen::MatrixXd& information,
                     const std::vector<std::size_t>& effect, const std::vector<std::size_t>& other) {
  std::vector<Eigen::Index> rest;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const bool own = std::find(effect.begin(), effect.end(), i) != effect.end();
    const bool free = unknowns[i].free() && std::find(other.begin(), other.end(), i) == other.end();
    if (!own && !free) rest.push_back(static_cast<Eigen::Index>(i));
  }
  Eigen::MatrixXd others = information(rest, rest);
  others.diagonal() += prior_weights(unknowns)(rest).cwiseMax(kFreeInformation);
  const Eigen::LLT<Eigen::MatrixXd> llt(others);
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t place : effect) {
    const auto i = static_cast<Eigen::Index>(place);
    const double alone = information(i, i);
    if (alone <= kFreeInformation) continue;
    const Eigen::VectorXd shared = information(rest, i);
    least = std::min(least, alone - llt.matrixL().solve(shared).squaredNorm());
  }
  return std::isfinite(least) ? std::max(least, 0.0) : 0;
}

Criterion separating(const Unknowns& unknowns, std::vector<std::size_t> one, std::vector<std::size_t> other) {
  return [&unknowns, one = std::move(one), other = std::move(other)](const Eigen::MatrixXd& information) {
    // NOLINTBEGIN(readability-suspicious-call-argument): each in the other's place
    return std::log(
        std::min(noncentrality(unknowns, information, one, other), noncentrality(unknowns, information, other, one)) +
        kFreeInformation);
    // NOLINTEND(readability-suspicious-call-argument)
  };
}

Eigen::MatrixXd run_information(const machine::RotationOrder& order, const measure::Run& run, const Unknowns& unknowns,
                                const NoiseModel& noise) {
  const Eigen::VectorXd start = unknowns.start();
  const physics::ForceModel forces = unknowns.at(start);
  const Sensitivity sensitivity(forces, unknowns);
  const SimulatedRun simulated = simulate_run(order, forces, run, &sensitivity);
  return normal_equations(run_equations(run, simulated, ideal_setup(run)), noise, unknowns, 0).information;
}

Design design(const std::vector<Eigen::MatrixXd>& candidates, const Eigen::MatrixXd& known, const Criterion& criterion,
              const DesignOptions& options) {
  PLUMBLINE_CHECK(!candidates.empty());
  const double weight = options.readings_per_sample;
  Design plan{{}, {}, known};
  for (std::size_t k = 0; k < options.runs; ++k) {
    const Best best = best_addition(candidates, plan.information, criterion, weight);
    plan.chosen.push_back(best.candidate);
    plan.information += weight * candidates[best.candidate];
  }
  double now = criterion(plan.information);
  for (std::size_t pass = 0; pass < options.most_passes; ++pass) {
    const std::size_t before = plan.exchanges;
    for (std::size_t& run : plan.chosen) {
      const Eigen::MatrixXd without = plan.information - weight * candidates[run];
      const Best best = best_addition(candidates, without, criterion, weight);
      if (best.candidate == run || !(best.criterion > now + options.least_gain)) continue;
      run = best.candidate;
      now = best.criterion;
      plan.information = without + weight * candidates[run];
      ++plan.exchanges;
    }
    if (plan.exchanges == before) break;
  }
  // what tells most comes first
  std::vector<std::size_t> remaining = plan.chosen;
  plan.chosen.clear();
  plan.information = known;
  while (!remaining.empty()) {
    std::vector<double> values(remaining.size());
    for_each_index(remaining.size(),
                   [&](std::size_t i) { values[i] = criterion(plan.information + weight * candidates[remaining[i]]); });
    const auto best = std::max_element(values.begin(), values.end()) - values.begin();
    plan.chosen.push_back(remaining[static_cast<std::size_t>(best)]);
    plan.criterion.push_back(values[static_cast<std::size_t>(best)]);
    plan.information += weight * candidates[plan.chosen.back()];
    remaining.erase(remaining.begin() + best);
  }
  return plan;
}

}  // namespace plumbline::identify

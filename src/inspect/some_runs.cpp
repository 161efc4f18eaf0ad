#include "inspect/some_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include <Eigen/Cholesky>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/diagnostic.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "inspect/statistics.hpp"

namespace plumbline::inspect {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using identify::kChannels;
using identify::kRadial;
using measure::Run;

constexpr double kLeastFactor = 1.1;  // between the torques of runs

using Which = std::vector<bool>;

// What a run adds to what is known of the machine, as it is stated or mended.
struct Information {
  MatrixXd gram;  // empty: as stated
  VectorXd pull;
  double square = 0;
};

// One fault that runs may have: what each of them is when it is mended.
struct Alike {
  Fault fault;
  std::vector<Information> mended;
  double penalty = 0;          // nats, for the alternatives and for what is fitted
  std::vector<double> volume;  // nats by which smaller readings of a run are less likely
};

// All runs together, some of them mended.
class Together {
 public:
  Together(const Looked& looked, const Bench& bench) : looked_(looked), bench_(bench) {
    information_ = MatrixXd(bench.prior.precision.asDiagonal());
    for (const RunRows& rows : looked.rows) {
      information_ += rows.gram;
      stated_.push_back({{}, rows.slopes.transpose() * rows.left, rows.left.squaredNorm()});
      rows_ += rows.rows();
    }
    factored_.compute(information_);
    chi2_ = chi2_of({{}, stated_, 0, {}}, Which(runs(), false));
  }

  std::size_t runs() const { return stated_.size(); }
  double chi2() const { return chi2_; }
  Index rows() const { return rows_; }
  const Looked& looked() const { return looked_; }
  const Bench& bench() const { return bench_; }

  // Readings in place of those of each run.
  std::vector<Information> with_readings(const std::function<VectorXd(const RunRows&)>& readings) const {
    std::vector<Information> all(runs());
    for_each_index(runs(), [&](std::size_t r) {
      const RunRows& rows = looked_.rows[r];
      const VectorXd left = rows.left + bench_.white(rows, readings(rows) - rows.measured).col(0);
      all[r] = {{}, rows.slopes.transpose() * left, left.squaredNorm()};
    });
    return all;
  }
  // Other labels. A run that the machine cannot make stays as it is.
  std::vector<Information> with_labels(const std::function<void(Run&)>& change) const {
    std::vector<Information> all = stated_;
    for_each_index(runs(), [&](std::size_t r) {
      Run run = looked_.runs[r];
      change(run);
      try {
        RunRows rows = bench_.rows(run);
        all[r] = {std::move(rows.gram), rows.slopes.transpose() * rows.left, rows.left.squaredNorm()};
      } catch (const Refusal&) {
      }
    });
    return all;
  }

  // The misfit of all runs about what they say together.
  double chi2_of(const Alike& alike, const Which& which) const {
    double squares = 0;
    VectorXd pull = VectorXd::Zero(information_.cols());
    bool other_slopes = false;
    for (std::size_t r = 0; r < runs(); ++r) {
      const Information& run = which[r] ? alike.mended[r] : stated_[r];
      squares += run.square;
      pull += run.pull;
      other_slopes = other_slopes || run.gram.size() > 0;
    }
    if (!other_slopes) return squares - pull.dot(factored_.solve(pull));
    MatrixXd information = information_;
    for (std::size_t r = 0; r < runs(); ++r) {
      if (which[r] && alike.mended[r].gram.size() > 0) information += alike.mended[r].gram - looked_.rows[r].gram;
    }
    return squares - pull.dot(information.llt().solve(pull));
  }
  // The same of each run alone, which nothing is known beside but the priors.
  Which better_alone(const Alike& alike) const {
    Which better(runs());
    for_each_index(runs(), [&](std::size_t r) {
      const auto chi2 = [&](const Information& run) {
        MatrixXd information = run.gram.size() > 0 ? run.gram : looked_.rows[r].gram;
        information.diagonal() += bench_.prior.precision;
        return run.square - run.pull.dot(information.llt().solve(run.pull));
      };
      better[r] = chi2(alike.mended[r]) < chi2(stated_[r]);
    });
    return better;
  }

 private:
  const Looked& looked_;
  const Bench& bench_;
  std::vector<Information> stated_;
  MatrixXd information_;
  Eigen::LLT<MatrixXd> factored_;
  double chi2_ = 0;
  Index rows_ = 0;
};

// Which runs are mended, and what chi-square then is, with what smaller readings are less likely by.
struct Chosen {
  Which which;
  double chi2 = 0, volume = 0;
  double objective() const { return chi2 + 2 * volume; }
};

class Choice {
 public:
  Choice(const Together& together, const Alike& alike) : together_(together), alike_(alike) {}

  // From a first guess, one run after the other as long as that helps by so many nats.
  Chosen from(Which which, double nats) const {
    Chosen best = at(std::move(which));
    for (int sweep = 0; sweep < 6; ++sweep) {
      bool moved = false;
      for (std::size_t r = 0; r < together_.runs(); ++r) {
        Which other = best.which;
        other[r] = !other[r];
        Chosen changed = at(std::move(other));
        // a run that is mended must be worth it
        const double worth = best.which[r] ? -2 * nats : 2 * nats;
        if (changed.objective() + worth >= best.objective()) continue;
        best = std::move(changed);
        moved = true;
      }
      if (!moved) break;
    }
    return best;
  }
  Chosen at(Which which) const {
    Chosen chosen{std::move(which), 0, 0};
    chosen.chi2 = together_.chi2_of(alike_, chosen.which);
    for (std::size_t r = 0; r < alike_.volume.size(); ++r) chosen.volume += chosen.which[r] ? alike_.volume[r] : 0;
    return chosen;
  }

 private:
  const Together& together_;
  const Alike& alike_;
};

// The readings of a run with those of some channels changed.
VectorXd changed(const RunRows& rows, const std::vector<int>& channels, const std::vector<int>& sources, double by) {
  VectorXd readings = rows.measured;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const auto to = rows.raw.first_row(channels[c]);
    const auto from = rows.raw.first_row(sources[c]);
    if (to && from) readings.segment(*to, rows.raw.samples) = by * rows.measured.segment(*from, rows.raw.samples);
  }
  return readings;
}

Alike signs(const Together& together, FaultKind kind, const std::vector<int>& channels, double alternatives) {
  Alike alike{{kind, {}}, {}, std::log(alternatives), {}};
  alike.fault.channels = channels;
  alike.mended = together.with_readings([&](const RunRows& rows) { return changed(rows, channels, channels, -1); });
  return alike;
}

Alike exchange(const Together& together, int one, int other) {
  Alike alike{{FaultKind::motors_swapped, {}}, {}, std::log(15), {}};
  alike.fault.channels = {one, other};
  alike.mended =
      together.with_readings([&](const RunRows& rows) { return changed(rows, {one, other}, {other, one}, 1); });
  return alike;
}

Alike unit(const Together& together, const std::vector<int>& channels, double factor, double alternatives) {
  const FaultKind kind = channels.front() == kRadial ? FaultKind::bar_unit : FaultKind::torque_unit;
  Alike alike{{kind, {}}, {}, std::log(alternatives) + 0.5 * std::log(static_cast<double>(together.rows())), {}};
  alike.fault.channels = channels;
  alike.fault.values = {factor};
  alike.mended =
      together.with_readings([&](const RunRows& rows) { return changed(rows, channels, channels, 1 / factor); });
  for (const RunRows& rows : together.looked().rows) {
    double count = 0;
    for (const int channel : channels) count += rows.raw.first_row(channel) ? static_cast<double>(rows.raw.samples) : 0;
    alike.volume.push_back(count * std::max(0.0, std::log(factor)));
  }
  return alike;
}

// By what the readings of some channels of each run are best multiplied, all runs fitted together.
std::vector<double> best_scales(const Together& together, const std::vector<int>& channels) {
  const Looked& looked = together.looked();
  const auto runs = static_cast<Index>(together.runs());
  const Prior& prior = together.bench().prior;
  MatrixXd pulls(static_cast<Index>(prior.size()), runs);  // of the channels' readings
  MatrixXd square = MatrixXd::Zero(runs, runs);
  VectorXd off(runs);
  VectorXd pull = VectorXd::Zero(pulls.rows());
  MatrixXd information = prior.precision.asDiagonal();
  for (Index r = 0; r < runs; ++r) {
    const RunRows& rows = looked.rows[static_cast<std::size_t>(r)];
    const VectorXd only = rows.measured - changed(rows, channels, channels, 0);
    const VectorXd readings = together.bench().white(rows, only).col(0);
    pulls.col(r) = rows.slopes.transpose() * readings;
    square(r, r) = readings.squaredNorm();
    off[r] = readings.dot(rows.left);
    pull += rows.slopes.transpose() * rows.left;
    information += rows.gram;
  }
  const Eigen::LLT<MatrixXd> llt(information);
  const MatrixXd solved = llt.solve(pulls);
  const MatrixXd hessian = square - pulls.transpose() * solved;
  const VectorXd scales = VectorXd::Ones(runs) - hessian.ldlt().solve(off - solved.transpose() * pull);
  return {scales.begin(), scales.end()};
}

// Between the two groups of these that are furthest apart, as a ratio: nothing, where they are no two groups.
std::optional<double> ratio_of_groups(std::vector<double> scales) {
  std::erase_if(scales, [](double scale) { return !(scale > 1e-6); });
  if (scales.size() < 4) return std::nullopt;
  std::sort(scales.begin(), scales.end());
  std::size_t split = 1;
  for (std::size_t i = 1; i < scales.size(); ++i) {
    if (scales[i] / scales[i - 1] > scales[split] / scales[split - 1]) split = i;
  }
  const auto at = scales.begin() + static_cast<std::ptrdiff_t>(split);
  return median(std::vector<double>(at, scales.end())) / median(std::vector<double>(scales.begin(), at));
}

std::vector<Alike> of_channels(const Together& together) {
  const auto has = [&](int channel) {
    const auto& rows = together.looked().rows;
    return std::any_of(rows.begin(), rows.end(), [&](const RunRows& run) { return run.raw.first_row(channel); });
  };
  std::vector<Alike> all;
  const auto add_units = [&](const std::vector<int>& channels, double alternatives) {
    const std::optional<double> ratio = ratio_of_groups(best_scales(together, channels));
    if (!ratio || *ratio < kLeastFactor) return;
    all.push_back(unit(together, channels, *ratio, alternatives));
    all.push_back(unit(together, channels, 1 / *ratio, alternatives));
  };
  if (has(kRadial)) {
    all.push_back(signs(together, FaultKind::bar_sign, {kRadial}, 1));
    add_units({kRadial}, 1);
  }
  if (has(1)) {
    const std::vector<int> motors{1, 2, 3, 4, 5, 6};
    all.push_back(signs(together, FaultKind::motor_sign, motors, 7));
    add_units(motors, 7);
    for (const int one : motors) {
      all.push_back(signs(together, FaultKind::motor_sign, {one}, 7));
      add_units({one}, 7);
      for (int other = one + 1; other < kChannels; ++other) all.push_back(exchange(together, one, other));
    }
  }
  return all;
}

std::vector<Alike> of_labels(const Together& together) {
  std::vector<Alike> all;
  const auto add = [&](FaultKind kind, double alternatives, const std::function<void(Run&)>& change,
                       std::vector<double> values = {}) {
    Alike alike{{kind, {}}, {}, std::log(alternatives), {}};
    alike.fault.values = std::move(values);
    alike.mended = together.with_labels(change);
    all.push_back(std::move(alike));
  };
  add(FaultKind::direction, 1, [](Run& run) { run = turned_back(run); });
  for (const double angle : {90.0, 180.0, -90.0}) {
    const auto turned = [angle](Run& run) {
      for (double& of_sample : run.angle) of_sample += angle * kDeg;
    };
    add(FaultKind::angle_zero, 3, turned, {angle * kDeg});
  }
  return all;
}

}  // namespace

std::optional<Fault> fault_of_some(const Looked& looked, const Bench& bench, const FineNoise& noise, bool labels,
                                   const InspectOptions& options) {
  if (looked.runs.size() < 4) return std::nullopt;
  const Together together(looked, bench);
  std::vector<Alike> all = of_channels(together);
  if (labels) {
    for (Alike& one : of_labels(together)) all.push_back(std::move(one));
  }
  const double before = together.chi2();
  std::optional<Fault> best;
  double least = before;
  for (Alike& alike : all) {
    const Choice choice(together, alike);
    const bool labelled = alike.mended.front().gram.size() > 0;
    std::vector<Which> starts{together.better_alone(alike)};
    if (!labelled) starts.emplace_back(together.runs(), false);
    std::optional<Chosen> found;
    for (Which& start : starts) {
      Chosen chosen = choice.from(std::move(start), options.least_nats);
      if (!found || chosen.objective() < found->objective()) found = std::move(chosen);
    }
    const auto count = static_cast<double>(std::count(found->which.begin(), found->which.end(), true));
    const auto runs = static_cast<double>(together.runs());
    const double penalty = alike.penalty + found->volume + runs * std::log(2.0);
    if (getenv("DBG")) {
      fmt::print(stderr, "{} {} {}: {} runs, chi2/n {:.3f} -> {:.3f}, objective {:.0f}\n", to_text(alike.fault.kind),
                 fmt::join(alike.fault.channels, ","), alike.fault.values.empty() ? 0 : alike.fault.values[0], count,
                 before / static_cast<double>(together.rows()), found->chi2 / static_cast<double>(together.rows()),
                 found->objective());
    }
    if (count < 2 || count == runs || found->chi2 + 2 * penalty >= least) continue;
    least = found->chi2 + 2 * penalty;
    const double scale = std::max(1.0, found->chi2 / static_cast<double>(together.rows()));
    best = alike.fault;
    best->nats = (before - found->chi2) / (2 * scale) - penalty;
    best->before = before;
    best->after = found->chi2;
    for (std::size_t r = 0; r < together.runs(); ++r) {
      if (found->which[r]) best->runs.push_back(r);
    }
  }
  if (!best) return std::nullopt;
  const double expected = noise.expected({});
  if (best->nats < options.all_nats || before - best->after < options.explained * (before - expected) ||
      best->after > options.near * expected)
    return std::nullopt;
  best->before = std::sqrt(best->before / static_cast<double>(together.rows()));
  best->after = std::sqrt(best->after / static_cast<double>(together.rows()));
  for (std::size_t& run : best->runs) run = looked.numbers[run];
  return best;
}

}  // namespace plumbline::inspect

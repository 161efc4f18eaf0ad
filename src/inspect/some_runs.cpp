#include "inspect/some_runs.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Cholesky>

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

constexpr std::size_t kLeastRuns = 4;
constexpr double kLeastFactor = 1.1;  // between the readings of runs

using Which = std::vector<bool>;

// What a run adds to what is known of the machine, as it is stated or mended.
struct Information {
  MatrixXd gram;  // empty: as stated
  VectorXd pull;
  VectorXd white_pull;  // L^-1 pull, L L^T the information of all runs as stated
  double square = 0;
};

// One fault that runs may have: what each of them is when it is mended.
struct Alike {
  Fault fault;
  std::vector<Information> mended;
  double penalty = 0;                // nats, for the alternatives and for what is fitted
  std::vector<double> volume;        // nats by which smaller readings of a run are less likely, and larger ones more
  std::function<void(Run&)> change;  // of labels; empty: none
  Which first;                       // a first guess of which runs; empty: none

  // Whether runs have other slopes when they are mended.
  bool labelled() const {
    return std::any_of(mended.begin(), mended.end(), [](const Information& run) { return run.gram.size() > 0; });
  }
};

// All runs together, some of them mended.
class Together {
 public:
  Together(const Looked& looked, const Bench& bench) : looked_(looked), bench_(bench) {
    information_ = MatrixXd(bench.prior.precision.asDiagonal());
    for (const RunRows& rows : looked.rows) {
      information_ += rows.gram;
      rows_ += rows.rows();
    }
    factored_.compute(information_);
    for (const RunRows& rows : looked.rows) stated_.push_back(of_left(rows, rows.left));
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
      all[r] = of_left(rows, left);
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
        all[r] = of_left(rows, rows.left);
        all[r].gram = std::move(rows.gram);
      } catch (const Refusal&) {
      }
    });
    return all;
  }

  // The misfit of all runs about what they say together.
  double chi2_of(const Alike& alike, const Which& which) const {
    double squares = 0;
    VectorXd pull = VectorXd::Zero(information_.cols());
    const bool labelled = alike.labelled();
    for (std::size_t r = 0; r < runs(); ++r) {
      const Information& run = which[r] ? alike.mended[r] : stated_[r];
      squares += run.square;
      pull += labelled ? run.pull : run.white_pull;
    }
    if (!labelled) return squares - pull.squaredNorm();
    MatrixXd information = information_;
    for (std::size_t r = 0; r < runs(); ++r) {
      if (which[r] && alike.mended[r].gram.size() > 0) information += alike.mended[r].gram - looked_.rows[r].gram;
    }
    return squares - pull.dot(information.llt().solve(pull));
  }
  // The same where some runs are left out, each of their readings then being off by its noise.
  double chi2_without(const Which& out) const {
    double squares = 0;
    VectorXd pull = VectorXd::Zero(information_.cols());
    MatrixXd information = information_;
    for (std::size_t r = 0; r < runs(); ++r) {
      squares += out[r] ? static_cast<double>(looked_.rows[r].rows()) : stated_[r].square;
      if (out[r]) {
        information -= looked_.rows[r].gram;
      } else {
        pull += stated_[r].pull;
      }
    }
    return squares - pull.dot(information.llt().solve(pull));
  }
  // The least of it where so many of some runs, the worst one after the other, are left out.
  double least_without(const std::vector<std::size_t>& some, std::size_t most) const {
    Which out(runs(), false);
    double least = chi2_;
    for (std::size_t taken = 0; taken < most; ++taken) {
      std::vector<double> each(runs(), least);
      for_each_index(some.size(), [&](std::size_t i) {
        const std::size_t r = some[i];
        Which more = out;
        more[r] = true;
        if (!out[r]) each[r] = chi2_without(more);
      });
      const auto worst = std::min_element(each.begin(), each.end());
      if (*worst >= least) break;
      least = *worst;
      out[static_cast<std::size_t>(worst - each.begin())] = true;
    }
    return least;
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
  Information of_left(const RunRows& rows, const VectorXd& left) const {
    Information run{{}, rows.slopes.transpose() * left, {}, left.squaredNorm()};
    run.white_pull = factored_.matrixL().solve(run.pull);
    return run;
  }

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
  double chi2 = 0;
  double volume = 0;   // of runs whose readings become smaller; others gain nothing: noise may be less than is assumed
  double density = 0;  // of all
  double objective() const { return chi2 + 2 * volume; }
};

class Choice {
 public:
  Choice(const Together& together, const Alike& alike) : together_(together), alike_(alike) {}

  // From a first guess, one run after the other, then two at once, as long as that helps by so many nats a run.
  Chosen from(Which which, double nats) const {
    Chosen best = at(std::move(which));
    const bool pairs = !alike_.labelled();  // which would take long
    for (int sweep = 0; sweep < 6; ++sweep) {
      if (!moved(best, nats, false) && !(pairs && moved(best, nats, true))) break;
    }
    return best;
  }
  Chosen at(Which which) const {
    Chosen chosen{std::move(which)};
    chosen.chi2 = together_.chi2_of(alike_, chosen.which);
    for (std::size_t r = 0; r < alike_.volume.size(); ++r) {
      if (!chosen.which[r]) continue;
      chosen.volume += std::max(0.0, alike_.volume[r]);
      chosen.density += alike_.volume[r];
    }
    return chosen;
  }

 private:
  bool moved(Chosen& best, double nats, bool pairs) const {
    bool any = false;
    for (std::size_t r = 0; r < together_.runs(); ++r) {
      for (std::size_t s = pairs ? r + 1 : r; s < (pairs ? together_.runs() : r + 1); ++s) {
        Which other = best.which;
        other[r] = !other[r];
        if (s != r) other[s] = !other[s];
        Chosen changed = at(std::move(other));
        // runs that are mended must be worth it
        const auto more = std::count(changed.which.begin(), changed.which.end(), true) -
                          std::count(best.which.begin(), best.which.end(), true);
        if (changed.objective() + 2 * nats * static_cast<double>(more) >= best.objective()) continue;
        best = std::move(changed);
        any = true;
      }
    }
    return any;
  }

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

// The readings of each of these motors are where those of the other one should be.
Alike exchange(const Together& together, const std::vector<int>& motors, const std::vector<int>& others,
               double alternatives) {
  Alike alike{{FaultKind::motors_swapped, {}}, {}, std::log(alternatives), {}};
  alike.fault.channels = motors;
  if (motors.size() > 2) alike.fault.values.assign(others.begin(), others.end());
  alike.mended = together.with_readings([&](const RunRows& rows) { return changed(rows, motors, others, 1); });
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
    alike.volume.push_back(count * std::log(factor));
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

// Scales in two groups, between which the gap is widest.
struct Groups {
  double ratio = 1;  // of the middle of the larger ones to that of the others
  Which large, small;
};
std::optional<Groups> groups_of(const std::vector<double>& scales) {
  std::vector<double> sorted = scales;
  std::erase_if(sorted, [](double scale) { return !(scale > 1e-6); });
  if (sorted.size() < 4) return std::nullopt;
  std::sort(sorted.begin(), sorted.end());
  std::size_t split = 1;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i] / sorted[i - 1] > sorted[split] / sorted[split - 1]) split = i;
  }
  const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(split);
  Groups groups{
      median(std::vector<double>(at, sorted.end())) / median(std::vector<double>(sorted.begin(), at)), {}, {}};
  for (const double scale : scales) {
    groups.large.push_back(scale >= *at);
    groups.small.push_back(scale < *at);
  }
  return groups;
}

// One pair of motors, or two.
void add_exchanges(std::vector<Alike>& all, const Together& together) {
  for (int a = 1; a < kChannels; ++a) {
    for (int b = a + 1; b < kChannels; ++b) {
      all.push_back(exchange(together, {a, b}, {b, a}, 15));
      for (int c = a + 1; c < kChannels; ++c) {
        for (int d = c + 1; d < kChannels; ++d) {
          if (c != b && d != b) all.push_back(exchange(together, {a, b, c, d}, {b, a, d, c}, 45));
        }
      }
    }
  }
}

std::vector<Alike> of_channels(const Together& together) {
  const auto has = [&](int channel) {
    const auto& rows = together.looked().rows;
    return std::any_of(rows.begin(), rows.end(), [&](const RunRows& run) { return run.raw.first_row(channel); });
  };
  std::vector<Alike> all;
  const auto add_units = [&](const std::vector<int>& channels, double alternatives) {
    const std::optional<Groups> groups = groups_of(best_scales(together, channels));
    if (!groups || groups->ratio < kLeastFactor) return;
    all.push_back(unit(together, channels, groups->ratio, alternatives));
    all.back().first = groups->small;
    all.push_back(unit(together, channels, 1 / groups->ratio, alternatives));
    all.back().first = groups->large;
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
    }
    add_exchanges(all, together);
  }
  return all;
}

std::vector<Alike> of_labels(const Together& together) {
  std::vector<Alike> all;
  const auto add = [&](FaultKind kind, double alternatives, const std::function<void(Run&)>& change,
                       std::vector<double> values = {}) {
    Alike alike{{kind, {}}, {}, std::log(alternatives), {}};
    alike.fault.values = std::move(values);
    alike.change = change;
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
  add(FaultKind::tilt, 4, [](Run& run) { run.tilt.head<2>() = -run.tilt.head<2>().eval(); });
  add(FaultKind::tilt, 4, [](Run& run) { run.tilt[0] = -run.tilt[0]; });
  add(FaultKind::tilt, 4, [](Run& run) { run.tilt[1] = -run.tilt[1]; });
  add(FaultKind::tilt, 4, [](Run& run) { std::swap(run.tilt[0], run.tilt[1]); });
  for (const int axis : {0, 1, 2}) {
    add(FaultKind::centre, 4, [axis](Run& run) { run.centre_W[axis] = -run.centre_W[axis]; });
  }
  add(FaultKind::centre, 4, [](Run& run) { std::swap(run.centre_W[0], run.centre_W[1]); });
  return all;
}

bool is_unit(FaultKind kind) { return kind == FaultKind::bar_unit || kind == FaultKind::torque_unit; }

// What is best made of this fault: the runs that have it, and what mending it then makes of all.
Chosen chosen(const Together& together, const Alike& alike, double nats) {
  const Choice choice(together, alike);
  Chosen best = choice.from(together.better_alone(alike), nats);
  const auto also_from = [&](const Which& start) {
    Chosen other = choice.from(start, nats);
    if (other.objective() < best.objective()) best = std::move(other);
  };
  if (!alike.labelled()) also_from(Which(together.runs(), false));
  if (!alike.first.empty()) also_from(alike.first);
  return best;
}

// The fault as it stands for these runs, misfits as chi-square of all runs.
Fault made(const Together& together, const Alike& alike, const Chosen& chosen) {
  Fault fault = alike.fault;
  const double scale = std::max(1.0, chosen.chi2 / static_cast<double>(together.rows()));
  const double penalty = alike.penalty + chosen.volume + static_cast<double>(together.runs()) * std::log(2.0);
  fault.nats = (together.chi2() - chosen.chi2) / (2 * scale) - penalty;
  fault.before = together.chi2();
  fault.after = chosen.chi2;
  for (std::size_t r = 0; r < together.runs(); ++r) {
    if (chosen.which[r]) fault.runs.push_back(r);
  }
  if (alike.change && !fault.runs.empty()) {
    Run run = together.looked().runs[fault.runs.front()];
    alike.change(run);
    if (fault.kind == FaultKind::tilt) fault.values = {run.tilt.x(), run.tilt.y(), run.tilt.z()};
    if (fault.kind == FaultKind::centre) fault.values = {run.centre_W.x(), run.centre_W.y(), run.centre_W.z()};
  }
  return fault;
}

}  // namespace

std::optional<Fault> fault_of_some(const Looked& looked, const Bench& bench, const FineNoise& noise, bool labels,
                                   const InspectOptions& options) {
  if (looked.runs.size() < kLeastRuns) return std::nullopt;
  const Together together(looked, bench);
  std::vector<Alike> all = of_channels(together);
  if (labels) {
    for (Alike& one : of_labels(together)) all.push_back(std::move(one));
  }
  std::optional<Fault> best;
  double least = together.chi2();
  double least_dense = least;
  for (const Alike& alike : all) {
    const Chosen choice = chosen(together, alike, options.least_nats);
    const auto count = static_cast<std::size_t>(std::count(choice.which.begin(), choice.which.end(), true));
    const double objective = choice.objective() + 2 * alike.penalty;
    if (count < 2 || count + 2 > together.runs()) continue;  // one run, or one that is right, is judged by itself
    // which of two groups has the other unit is a matter of their noise: all of the density counts
    const double dense = choice.chi2 + 2 * (choice.density + alike.penalty);
    const bool same = best && is_unit(best->kind) && best->kind == alike.fault.kind &&
                      best->channels == alike.fault.channels &&
                      choice.chi2 < options.near * std::max(best->after, static_cast<double>(together.rows()));
    if (same ? dense >= least_dense : objective >= least) continue;
    least = objective;
    least_dense = dense;
    // what some do not show, as the sign of a coordinate that is nil, is still of all
    const Chosen all_runs = Choice(together, alike).at(Which(together.runs(), true));
    const bool of_all = all_runs.objective() < choice.objective() + 2 * options.least_nats;
    best = made(together, alike, of_all ? all_runs : choice);
    best->all = of_all;
  }
  if (!best) return std::nullopt;
  // as with one run and with all: it takes away most of what is off, and leaves little more than noise
  const double expected = noise.expected({});
  const bool explains = best->before - best->after > options.explained * (best->before - expected);
  if (best->nats < options.all_nats || !explains || best->after > options.near * expected) return std::nullopt;
  // nor is there something wrong with half as many of them alone
  if (!best->all && together.least_without(best->runs, best->runs.size() / 2) <= best->after) return std::nullopt;
  const auto rows = static_cast<double>(together.rows());
  best->before = std::sqrt(best->before / rows);
  best->after = std::sqrt(best->after / rows);
  for (std::size_t& run : best->runs) run = looked.numbers[run];
  return best;
}

}  // namespace plumbline::inspect

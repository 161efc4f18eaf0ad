#include "inspect/together.hpp"

#include <algorithm>

#include "base/diagnostic.hpp"
#include "base/parallel.hpp"

namespace plumbline::inspect {

using Eigen::Index;
using Eigen::LLT;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using measure::Run;

namespace {

constexpr int kMotors = identify::kChannels - 1;
constexpr Index kColumns = 1 + kMotors * kMotors;

// Of what channel `from` reads, where channel `to` should: the bar, then motors.
Index column(int to, int from) { return to == identify::kRadial ? 0 : 1 + kMotors * (to - 1) + from - 1; }

bool has(const RunRows& rows, const Moved& moved) {
  return rows.raw.first_row(moved.to) && rows.raw.first_row(moved.from);
}

// How much of each column comes to the readings.
VectorXd shares(const RunRows& rows, const std::vector<Moved>& all) {
  VectorXd share = VectorXd::Zero(kColumns);
  for (const Moved& moved : all) {
    if (!has(rows, moved)) continue;
    share[column(moved.to, moved.from)] += moved.by;
    share[column(moved.to, moved.to)] -= 1;
  }
  return share;
}

double chi2_alone(const LLT<MatrixXd>& factored, const Information& run) {
  return run.square - factored.matrixL().solve(run.pull).squaredNorm();
}

}  // namespace

bool Alike::labelled() const {
  return std::any_of(mended.begin(), mended.end(), [](const Information& run) { return run.gram.size() > 0; });
}

Together::Together(const Looked& looked, const Bench& bench) : looked_(looked), bench_(bench) {
  information_ = MatrixXd(bench.prior.precision.asDiagonal());
  for (const RunRows& rows : looked.rows) {
    information_ += rows.gram;
    rows_ += rows.rows();
  }
  factored_.compute(information_);
  stated_.resize(looked.rows.size());
  readings_.resize(runs());
  alone_.resize(runs());
  for_each_index(runs(), [&](std::size_t r) {
    const RunRows& rows = looked.rows[r];
    stated_[r] = as_stated(rows);
    readings_[r] = readings_of_channels(rows);
    alone_[r].factored = factored_alone(rows.gram);
    alone_[r].chi2 = chi2_alone(alone_[r].factored, stated_[r]);
  });
  chi2_ = chi2_of({{}, stated_, 0, {}}, Which(runs(), false));
}

std::vector<Information> Together::with_channels(const std::vector<Moved>& moved) const {
  std::vector<Information> all(runs());
  for (std::size_t r = 0; r < runs(); ++r) {
    const Readings& readings = readings_[r];
    const VectorXd share = shares(looked_.rows[r], moved);
    Information& run = all[r];
    run.pull = stated_[r].pull + readings.pulls * share;
    run.white_pull = factored_.matrixL().solve(run.pull);
    run.square = stated_[r].square + share.dot(2 * readings.with_left + readings.squares * share);
  }
  return all;
}

std::vector<double> Together::best_scales(const std::vector<int>& channels) const {
  const auto count = static_cast<Index>(runs());
  MatrixXd pulls(information_.cols(), count);  // of the channels' readings
  MatrixXd square = MatrixXd::Zero(count, count);
  VectorXd off(count);
  VectorXd pull = VectorXd::Zero(pulls.rows());
  for (Index r = 0; r < count; ++r) {
    const Readings& readings = readings_[static_cast<std::size_t>(r)];
    VectorXd share = VectorXd::Zero(kColumns);
    for (const int channel : channels) share[column(channel, channel)] = 1;
    pulls.col(r) = readings.pulls * share;
    square(r, r) = share.dot(readings.squares * share);
    off[r] = share.dot(readings.with_left);
    pull += stated_[static_cast<std::size_t>(r)].pull;
  }
  const MatrixXd solved = factored_.solve(pulls);
  const MatrixXd hessian = square - pulls.transpose() * solved;
  const VectorXd scales = VectorXd::Ones(count) - hessian.ldlt().solve(off - solved.transpose() * pull);
  return {scales.begin(), scales.end()};
}

std::vector<Information> Together::with_labels(const std::function<void(Run&)>& change) const {
  std::vector<Information> all = stated_;
  for_each_index(runs(), [&](std::size_t r) {
    Run run = looked_.runs[r];
    change(run);
    try {
      RunRows rows = bench_.rows(run);
      all[r] = as_stated(rows);
      all[r].gram = std::move(rows.gram);
    } catch (const Refusal&) {
    }
  });
  return all;
}

double Together::chi2_of(const Alike& alike, const Which& which) const {
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

double Together::chi2_without(const Which& out) const {
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

double Together::least_without(const std::vector<std::size_t>& some, std::size_t most) const {
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

Which Together::better_alone(const Alike& alike) const {
  std::vector<double> mended(runs());
  for_each_index(runs(), [&](std::size_t r) {
    const Information& run = alike.mended[r];
    mended[r] = chi2_alone(run.gram.size() > 0 ? factored_alone(run.gram) : alone_[r].factored, run);
  });
  Which better(runs());
  for (std::size_t r = 0; r < runs(); ++r) better[r] = mended[r] < alone_[r].chi2;
  return better;
}

Information Together::as_stated(const RunRows& rows) const {
  Information run{{}, rows.pull, {}, rows.left.squaredNorm()};
  run.white_pull = factored_.matrixL().solve(run.pull);
  return run;
}

Together::Readings Together::readings_of_channels(const RunRows& rows) const {
  MatrixXd columns = MatrixXd::Zero(rows.measured.size(), kColumns);
  const auto put = [&](int to, int from) {
    if (!has(rows, {to, from})) return;
    columns.col(column(to, from)).segment(*rows.raw.first_row(to), rows.raw.samples) =
        rows.measured.segment(*rows.raw.first_row(from), rows.raw.samples);
  };
  put(identify::kRadial, identify::kRadial);
  for (int to = 1; to <= kMotors; ++to) {
    for (int from = 1; from <= kMotors; ++from) put(to, from);
  }
  const MatrixXd white = bench_.white(rows, columns);
  return {rows.slopes.transpose() * white, white.transpose() * white, white.transpose() * rows.left};
}

LLT<MatrixXd> Together::factored_alone(const MatrixXd& gram) const {
  MatrixXd information = gram;
  information.diagonal() += bench_.prior.precision;
  return information.llt();
}

// One run after the other, then two at once, as long as that helps.
Chosen Choice::from(Which which, double nats) const {
  Chosen best = at(std::move(which));
  const bool pairs = !alike_.labelled();  // which would take long
  for (int sweep = 0; sweep < 6; ++sweep) {
    if (!moved(best, nats, false) && !(pairs && moved(best, nats, true))) break;
  }
  return best;
}

Chosen Choice::at(Which which) const {
  Chosen chosen{std::move(which)};
  chosen.chi2 = together_.chi2_of(alike_, chosen.which);
  for (std::size_t r = 0; r < alike_.volume.size(); ++r) {
    if (!chosen.which[r]) continue;
    chosen.volume += std::max(0.0, alike_.volume[r]);
    chosen.density += alike_.volume[r];
  }
  return chosen;
}

Chosen Choice::best(double nats) const {
  Chosen best = from(together_.better_alone(alike_), nats);
  const auto also_from = [&](const Which& start) {
    Chosen other = from(start, nats);
    if (other.objective() < best.objective()) best = std::move(other);
  };
  if (!alike_.labelled()) also_from(Which(together_.runs(), false));
  if (!alike_.first.empty()) also_from(alike_.first);
  return best;
}

bool Choice::moved(Chosen& best, double nats, bool pairs) const {
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

}  // namespace plumbline::inspect

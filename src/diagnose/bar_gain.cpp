#include "diagnose/bar_gain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include "base/diagnostic.hpp"
#include "diagnose/evidence/linear_problem.hpp"
#include "identify/equations/objective.hpp"

namespace plumbline::diagnose {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// measured = factor * model of the bar, measured = model of the motors: in the nuisances, in their sigmas, the numbers
// of effects, in their scales, and the factor.
class Gained {
 public:
  Gained(const Workbench& bench, const std::vector<Pick>& picks, const Refit& found, const identify::NoiseModel& noise)
      : Gained(bench, free_unknowns(bench, picks), !picks.empty(), found, noise) {}

  double factor() const { return at_[at_.size() - 1]; }
  double misfit() const { return misfit_; }
  /// What the misfit would be after the next step, if nothing bent.
  double expected() const { return misfit_ - pull_.dot(step()); }
  Index readings() const { return readings_; }
  void move() {
    at_ += step();
    look();
  }

 private:
  Gained(const Workbench& bench, const FreeUnknowns& free, bool from_found, const Refit& found,
         const identify::NoiseModel& noise)
      : bench_(bench), noise_(noise), objective_(bench.machine.rotation, bench.runs, free.unknowns, {.huber = 0}) {
    objective_.set_noise(noise);
    const identify::Unknowns& unknowns = objective_.unknowns();
    const auto n = static_cast<Index>(unknowns.size());
    at_ = VectorXd::Zero(n + 1);
    at_[n] = 1;
    scales_.resize(n);
    precision_.resize(n);
    for (Index i = 0; i < n; ++i) {
      const identify::Unknown& u = unknowns[static_cast<std::size_t>(i)];
      scales_[i] = u.scale;
      precision_[i] = u.free() ? kWeakPrecision : 1;
      if (from_found) at_[i] = (found.values[free.places[static_cast<std::size_t>(i)]] - unknowns.start()[i]) / u.scale;
    }
    look();
  }

  VectorXd step() const { return normal_.ldlt().solve(pull_); }

  void look() {
    const Index n = scales_.size();
    std::vector<Eigen::MatrixXd> grams(bench_.runs.size());
    std::vector<Index> counts(bench_.runs.size());
    const VectorXd values = objective_.unknowns().start() + at_.head(n).cwiseProduct(scales_);
    objective_.each_run(values, [&](std::size_t i, identify::RunEquations equations) {
      identify::SlopeRows rows(equations.residual.size(), n + 2);
      rows << equations.slopes * scales_.asDiagonal(), VectorXd::Zero(rows.rows()), equations.residual;
      if (const auto first = equations.first_row(identify::kRadial)) {
        const Eigen::Map<const VectorXd> measured(bench_.runs[i].radial.data(), equations.samples);
        auto of_bar = rows.middleRows(*first, equations.samples);
        of_bar.col(n) = measured - equations.residual.segment(*first, equations.samples);
        of_bar.leftCols(n) *= factor();
        of_bar.col(n + 1) = measured - factor() * of_bar.col(n);
      }
      counts[i] = rows.rows();
      rows = without_setup(equations, std::move(rows), noise_);
      grams[i] = rows.transpose() * rows;
    });
    readings_ = 0;
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(n + 2, n + 2);
    for (std::size_t i = 0; i < grams.size(); ++i) {
      gram += grams[i];
      readings_ += counts[i];
    }
    normal_ = gram.topLeftCorner(n + 1, n + 1);
    normal_.diagonal().head(n) += precision_;
    pull_ = gram.col(n + 1).head(n + 1);
    pull_.head(n) -= precision_.cwiseProduct(at_.head(n));
    misfit_ = gram(n + 1, n + 1) + at_.head(n).dot(precision_.cwiseProduct(at_.head(n)));
  }

  const Workbench& bench_;
  const identify::NoiseModel& noise_;
  identify::Objective objective_;
  VectorXd at_;                  // nuisances and numbers of effects in their scales, the factor last
  VectorXd scales_, precision_;  // SI; in scales
  Eigen::MatrixXd normal_;
  VectorXd pull_;
  double misfit_ = 0;
  Index readings_ = 0;
};

std::size_t numbers_of(const std::vector<Pick>& picks) {
  std::size_t sum = 0;
  for (const Pick& pick : picks) sum += pick.unknowns.size();
  return sum;
}

// A bar with a factor beside these picks, against all that were found; nothing where it is not likelier.
std::optional<BarGain> gain_beside(const Workbench& bench, const Model& model, const std::vector<Pick>& picks,
                                   const BarGainOptions& options) {
  try {
    Gained gained(bench, picks, model.fit, model.noise);
    const double spared = static_cast<double>(numbers_of(picks_of(model))) - static_cast<double>(numbers_of(picks)) - 1;
    const auto nats = [&](double left) {
      return (model.fit.misfit - left + spared * std::log(static_cast<double>(gained.readings()))) / 2;
    };
    for (int step = 0; step < options.steps; ++step) {
      if (nats(gained.expected()) < options.margin - options.bend) return std::nullopt;
      gained.move();
    }
    const BarGain found{gained.factor(), nats(gained.misfit())};
    const bool large = found.factor > 0 && std::abs(std::log(found.factor)) > std::log(options.least);
    return large && found.nats > options.margin ? std::optional(found) : std::nullopt;
  } catch (const Refusal&) {  // with such numbers the machine falls through a singularity
    return std::nullopt;
  }
}

}  // namespace

std::optional<BarGain> bar_gain(const Workbench& bench, const Model& model, const BarGainOptions& options) {
  if (std::none_of(bench.runs.begin(), bench.runs.end(), [](const measure::Run& run) { return run.has_radial(); }))
    return std::nullopt;
  const std::vector<Pick> all = picks_of(model);
  std::vector<std::vector<Pick>> beside{{}, all};
  for (std::size_t out = 0; out < all.size() && all.size() > 1; ++out) {
    beside.push_back(all);
    beside.back().erase(beside.back().begin() + static_cast<std::ptrdiff_t>(out));
  }
  std::optional<BarGain> likeliest;
  for (const std::vector<Pick>& picks : beside) {
    const std::optional<BarGain> one = gain_beside(bench, model, picks, options);
    if (one && (!likeliest || one->nats > likeliest->nats)) likeliest = one;
  }
  return likeliest;
}

std::optional<Doubt> doubt_of_bar(const Workbench& bench, const Model& model) {
  if (model.found.empty()) return std::nullopt;
  const std::optional<BarGain> bar = bar_gain(bench, model);
  if (!bar) return std::nullopt;
  Doubt doubt;
  for (const Found& found : model.found) doubt.effects.push_back(found.pick.candidate->name);
  doubt.why = *bar;
  return doubt;
}

}  // namespace plumbline::diagnose

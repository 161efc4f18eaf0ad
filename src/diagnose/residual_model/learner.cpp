#include "diagnose/residual_model/learner.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "base/parallel.hpp"
#include "diagnose/description/waves.hpp"
#include "diagnose/evidence/left_out.hpp"
#include "diagnose/readings/poses.hpp"

namespace plumbline::diagnose {
namespace {

using identify::SlopeRows;

constexpr double kLeastSeen = 1e-9;  // of a column's square, in units of the noise

std::vector<std::vector<int>> carriers_of(const Shape& shape) {
  if (only_alike(shape)) return {{-1}};
  std::vector<std::vector<int>> all;
  if (is_per_strut(shape.channel)) all.push_back({-1});
  std::vector<int> each(static_cast<std::size_t>(shape.parts()));
  std::iota(each.begin(), each.end(), 0);
  for (const int part : each) all.push_back({part});
  all.push_back(each);
  return all;
}

bool same_factors(const Term& a, const Term& b) {
  return a.channel == b.channel && a.strut_powers == b.strut_powers && a.shared_powers == b.shared_powers;
}

}  // namespace

Eigen::MatrixXd choice_of(const std::vector<int>& parts, int functions, int all_parts) {
  Eigen::MatrixXd choice = Eigen::MatrixXd::Zero(functions * all_parts, functions * static_cast<int>(parts.size()));
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (int part = 0; part < all_parts; ++part) {
      if (parts[k] >= 0 && parts[k] != part) continue;
      choice.block(part * functions, static_cast<Eigen::Index>(k) * functions, functions, functions).setIdentity();
    }
  }
  return choice;
}

Spread best_spread(const Eigen::MatrixXd& gram, const Eigen::VectorXd& pull) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  const Eigen::ArrayXd seen = eigen.eigenvalues().array().max(0.0);
  const Eigen::ArrayXd pulls = (eigen.eigenvectors().transpose() * pull).array().square();
  const double largest = seen.maxCoeff();
  if (!(largest > kLeastSeen)) return {};
  const auto at = [&](double log_tau2) {
    const Eigen::ArrayXd x = std::exp(log_tau2) * seen;
    return 0.5 * (std::exp(log_tau2) * pulls / (1 + x) - (1 + x).log()).sum();
  };
  constexpr double kStep = 0.5;
  const double from = -std::log(largest) - 4;
  double best = from;
  for (double t = from; t < from + 30; t += kStep) {
    if (at(t) > at(best)) best = t;
  }
  for (double step = kStep / 2; step > 0.01; step /= 2) {
    if (at(best + step) > at(best)) best += step;
    if (at(best - step) > at(best)) best -= step;
  }
  return {std::exp(best / 2), at(best)};
}

Learner::Learner(const Workbench& bench, const physics::ForceModel& forces, const LinearProblem& problem,
                 Marginalised nuisances, const identify::NoiseModel& noise, const DescriptionOptions& description,
                 ResidualOptions options)
    : machine_(forces.machine),
      runs_(ready_runs(bench, forces, problem)),
      poses_(poses_of(bench.runs)),
      noise_(noise),
      description_(description),
      options_(std::move(options)),
      taken_(std::move(nuisances)) {
  const std::vector<int> columns = taken_.columns;
  const auto count = static_cast<Eigen::Index>(columns.size());
  std::iota(taken_.columns.begin(), taken_.columns.end(), 0);
  problem_.kept.resize(static_cast<std::size_t>(count) + 1);
  std::iota(problem_.kept.begin(), problem_.kept.end(), 0);
  problem_.gram = Eigen::MatrixXd::Zero(count + 1, count + 1);
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    Block block;
    block.rows.resize(problem.blocks[i].rows.rows(), count + 1);
    block.rows << problem.rows_of(i, columns), problem.blocks[i].rows.rightCols<1>();
    block.gram = block.rows.transpose() * block.rows;
    problem_.gram += block.gram;
    problem_.blocks.push_back(std::move(block));
  }
}

SlopeRows Learner::whitened(const Shape& shape, const Region& region, std::size_t run) const {
  SlopeRows columns = columns_of(shape, region, runs_[run], machine_);
  if (only_alike(shape)) columns = columns * choice_of({-1}, shape.functions(), shape.parts());
  return without_setup(*runs_[run].raw, std::move(columns), noise_);
}

// What was taken, and last the residual, with the columns of a shape.
Overlap Learner::overlap_of(const Shape& shape, const Region& region, const Gathered& gathered) const {
  const bool known = gathered.cross.size() > 0;
  std::vector<Overlap> each(runs_.size());
  for_each_index(runs_.size(), [&](std::size_t i) {
    if (shape.is_smooth()) {
      each[i] = overlap_in_groups(shape, region, runs_[i], machine_, noise_, gathered.rows[i], options_.points);
      return;
    }
    const SlopeRows columns = whitened(shape, region, i);
    each[i].gram = columns.transpose() * columns;
    if (!known) each[i].cross = problem_.blocks[i].rows.transpose() * columns;
  });
  for (std::size_t i = 1; i < each.size(); ++i) {
    each[0].gram += each[i].gram;
    if (!known) each[0].cross += each[i].cross;
  }
  if (known) each[0].cross = gathered.cross;
  return std::move(each[0]);
}

void Learner::look_at(const Shape& shape, double tried, const Gathered& gathered, std::vector<Found>& found) const {
  const Region region = region_of(shape, runs_, machine_);
  Overlap overlap = overlap_of(shape, region, gathered);
  const auto count = static_cast<Eigen::Index>(taken_.columns.size());
  Eigen::MatrixXd own = problem_.gram.topLeftCorner(count, count);
  own.diagonal() += taken_.precision;
  Eigen::VectorXd pull = problem_.gram.col(count).head(count) - taken_.precision.cwiseProduct(taken_.departure);
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(own);
  const Eigen::MatrixXd cross = overlap.cross.topRows(count);
  overlap.gram -= cross.transpose() * ldlt.solve(cross);
  const Eigen::VectorXd left = overlap.cross.row(count).transpose() - cross.transpose() * ldlt.solve(pull);
  const std::vector<double> scales = shape.is_smooth() ? options_.length_scales : std::vector<double>{0};
  const std::vector<std::vector<int>> carriers = carriers_of(shape);
  std::vector<Found> each(carriers.size());
  for_each_index(carriers.size(), [&](std::size_t i) {
    const std::vector<int>& parts = carriers[i];
    const auto size = static_cast<Eigen::Index>(parts.size());
    const Eigen::MatrixXd choice = only_alike(shape) ? Eigen::MatrixXd::Identity(left.size(), left.size())
                                                     : choice_of(parts, shape.functions(), shape.parts());
    const Eigen::MatrixXd gram = choice.transpose() * overlap.gram * choice;
    const Eigen::VectorXd b = choice.transpose() * left;
    Found& best = each[i];
    for (const double scale : scales) {
      const Eigen::VectorXd widths = prior_widths(shape, scale).replicate(size, 1);
      const Spread spread = best_spread(widths.asDiagonal() * gram * widths.asDiagonal(), widths.cwiseProduct(b));
      if (spread.log_bayes <= best.score) continue;
      best.score = spread.log_bayes;
      best.component = {shape, region, parts, scale, spread.tau, spread.tau * widths, {}, 0, 0};
    }
    best.component.log_odds = best.score -= std::log(tried);
  });
  std::move(each.begin(), each.end(), std::back_inserter(found));
}

// Everything that may be added, the likeliest first.
std::vector<Learner::Found> Learner::ranked(ProductSums& products) const {
  std::vector<Found> found;
  Gathered few{std::vector<SlopeRows>(runs_.size()), {}};
  for_each_index(runs_.size(), [&](std::size_t i) {
    few.rows[i] = in_groups(problem_.blocks[i].rows, runs_[i].raw->samples, options_.points);
  });
  const double smooth = 8.0 * static_cast<double>(smooth_shapes().size() * options_.length_scales.size());
  for (const Shape& shape : smooth_shapes()) look_at(shape, smooth, few, found);
  double tried = 0;
  const Nuisances taken(problem_, taken_);
  const std::vector<Term> best = products.best(problem_, taken, description_, tried);
  for (auto term = best.begin(); term != best.end(); ++term) {
    if (std::any_of(best.begin(), term, [&](const Term& before) { return same_factors(before, *term); })) continue;
    few.cross = products.cross_of(*term);
    look_at({term->channel, term->strut_powers, term->shared_powers, {}, 0}, tried, few, found);
  }
  few.cross.resize(0, 0);
  tried = 0;
  const Eigen::VectorXd& sizes = taken.sizes;
  std::vector<SlopeRows> left;
  for (const Block& block : problem_.blocks)
    left.emplace_back(block.rows.rightCols<1>() - block.rows.leftCols(sizes.size()) * sizes);
  for (const Term::Channel channel : {Term::Channel::length, Term::Channel::torque}) {
    for (const double pitch : best_pitches(runs_, left, noise_, channel, description_, options_.pitches, tried))
      look_at({channel, {}, {}, {}, pitch}, 8 * tried, few, found);
  }
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.score > b.score; });
  return found;
}

// Adds the component if poses that are left out confirm it and it cancels nothing. It is tried in place: there are too
// many rows for a second set.
bool Learner::try_adding(const Component& component) {
  const Marginalised before = taken_;
  append(component);
  const std::vector<int> columns(taken_.columns.begin() + static_cast<std::ptrdiff_t>(before.columns.size()),
                                 taken_.columns.end());
  const double nats = left_out_nats(problem_, before, columns,
                                    Eigen::VectorXd::Ones(static_cast<Eigen::Index>(columns.size())), poses_);
  components_.back().left_out = nats;
  if (nats >= options_.least_left_out) {
    solve();
    if (!cancel()) return true;
  }
  drop(components_.size() - 1);
  return false;
}

// The columns of a component, in its sigmas, before the residual.
void Learner::append(const Component& component) {
  const Eigen::MatrixXd choice = only_alike(component.shape)
                                     ? Eigen::MatrixXd::Identity(component.sigmas.size(), component.sigmas.size())
                                     : choice_of(component.parts, component.shape.functions(), component.shape.parts());
  const Eigen::MatrixXd scaled = choice * component.sigmas.asDiagonal();
  const auto count = static_cast<Eigen::Index>(taken_.columns.size());
  const Eigen::Index more = component.sigmas.size();
  for_each_index(runs_.size(), [&](std::size_t i) {
    Block& block = problem_.blocks[i];
    SlopeRows rows(block.rows.rows(), count + more + 1);
    rows << block.rows.leftCols(count), whitened(component.shape, component.region, i) * scaled,
        block.rows.rightCols<1>();
    block.rows = std::move(rows);
    block.gram = block.rows.transpose() * block.rows;
  });
  problem_.gram = Eigen::MatrixXd::Zero(count + more + 1, count + more + 1);
  for (const Block& block : problem_.blocks) problem_.gram += block.gram;
  problem_.kept.resize(static_cast<std::size_t>(count + more) + 1);
  std::iota(problem_.kept.begin(), problem_.kept.end(), 0);
  for (Eigen::Index k = 0; k < more; ++k) taken_.columns.push_back(static_cast<int>(count + k));
  taken_.precision.conservativeResize(count + more);
  taken_.precision.tail(more).setOnes();
  taken_.departure.conservativeResize(count + more);
  taken_.departure.tail(more).setZero();
  if (component.weights.size() == more) taken_.departure.tail(more) = component.weights.cwiseQuotient(component.sigmas);
  components_.push_back(component);
}

void Learner::take(const Component& component) { append(component); }

Eigen::Index Learner::first_of(std::size_t place) const {
  auto first = static_cast<Eigen::Index>(taken_.columns.size());
  for (std::size_t i = place; i < components_.size(); ++i) first -= components_[i].sigmas.size();
  return first;
}

bool Learner::learn() {
  bool any = false;
  ProductSums products(runs_, machine_, noise_);
  while (static_cast<int>(components_.size()) < options_.most_components) {
    const std::vector<Found> all = ranked(products);
    int refused = 0;
    bool added = false;
    for (const Found& found : all) {
      if (found.score < options_.least_log_odds || refused >= options_.most_refused) break;
      added = try_adding(found.component);
      if (added) break;
      ++refused;
    }
    any = any || added;
    if (!added) break;
  }
  fit_spreads();
  solve();
  while (cancel()) {
    drop(components_.size() - 1);
    fit_spreads();
    solve();
  }
  return any;
}

// Each in turn, beside the others: its spread in units of what it was; one that does not pay any more is left out.
void Learner::fit_spreads() {
  for (int sweep = 0; sweep < 3; ++sweep) {
    for (std::size_t place = 0; place < components_.size();) {
      Component& component = components_[place];
      const Eigen::Index first = first_of(place);
      const Eigen::Index size = component.sigmas.size();
      std::vector<Eigen::Index> others;
      for (Eigen::Index k = 0; k < first_of(components_.size()); ++k) {
        if (k < first || k >= first + size) others.push_back(k);
      }
      const Eigen::Index residual = problem_.residual();
      Eigen::MatrixXd own = problem_.gram(others, others);
      own.diagonal() += taken_.precision(others);
      const Eigen::MatrixXd cross = problem_.gram(others, Eigen::seqN(first, size));
      const Eigen::LDLT<Eigen::MatrixXd> ldlt(own);
      const Eigen::MatrixXd gram =
          problem_.gram.block(first, first, size, size) - cross.transpose() * ldlt.solve(cross);
      const Eigen::VectorXd pull =
          Eigen::VectorXd(problem_.gram(others, residual)) - taken_.precision.cwiseProduct(taken_.departure)(others);
      // the residual as it would be without the component
      const Eigen::VectorXd left = problem_.gram.col(residual).segment(first, size) -
                                   cross.transpose() * ldlt.solve(pull) + gram * taken_.departure.segment(first, size);
      const Spread spread = best_spread(gram, left);
      component.log_odds = spread.log_bayes;
      if (spread.log_bayes < options_.least_log_odds) {
        drop(place);
        continue;
      }
      component.spread *= spread.tau;
      component.sigmas *= spread.tau;
      for (Block& block : problem_.blocks) {
        block.rows.middleCols(first, size) *= spread.tau;
        block.gram.middleCols(first, size) *= spread.tau;
        block.gram.middleRows(first, size) *= spread.tau;
      }
      problem_.gram.middleCols(first, size) *= spread.tau;
      problem_.gram.middleRows(first, size) *= spread.tau;
      taken_.departure.segment(first, size) /= spread.tau;
      ++place;
    }
  }
}

// Leaves out a component. The model is linear in its weights: the residual becomes what it is without those that the
// model has already.
void Learner::drop(std::size_t place) {
  const Eigen::Index first = first_of(place);
  const Eigen::Index size = components_[place].sigmas.size();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k <= problem_.residual(); ++k) {
    if (k < first || k >= first + size) kept.push_back(k);
  }
  const Eigen::VectorXd departure = taken_.departure.segment(first, size);
  problem_.gram.setZero(static_cast<Eigen::Index>(kept.size()), static_cast<Eigen::Index>(kept.size()));
  for (Block& block : problem_.blocks) {
    block.rows.rightCols<1>() += block.rows.middleCols(first, size) * departure;
    block.rows = SlopeRows(block.rows(Eigen::all, kept));
    block.gram = block.rows.transpose() * block.rows;
    problem_.gram += block.gram;
  }
  kept.pop_back();
  taken_.precision = Eigen::VectorXd(taken_.precision(kept));
  taken_.departure = Eigen::VectorXd(taken_.departure(kept));
  taken_.columns.resize(kept.size());
  problem_.kept.resize(kept.size() + 1);
  components_.erase(components_.begin() + static_cast<std::ptrdiff_t>(place));
}

void Learner::solve() {
  const Eigen::VectorXd step = Nuisances(problem_, taken_).sizes;
  for (std::size_t place = 0; place < components_.size(); ++place) {
    Component& component = components_[place];
    const Eigen::Index first = first_of(place);
    component.weights = component.sigmas.cwiseProduct(step.segment(first, component.sigmas.size()) +
                                                      taken_.departure.segment(first, component.sigmas.size()));
  }
}

// Whether components are large by themselves and little together, as a power is beside a function of the same tension.
bool Learner::cancel() const {
  const Eigen::Index first = first_of(0);
  const auto count = static_cast<Eigen::Index>(taken_.columns.size()) - first;
  Eigen::VectorXd weights(count);
  for (std::size_t place = 0; place < components_.size(); ++place) {
    const Component& component = components_[place];
    weights.segment(first_of(place) - first, component.sigmas.size()) =
        component.weights.cwiseQuotient(component.sigmas);
  }
  const Eigen::MatrixXd gram = problem_.gram.block(first, first, count, count);
  const double together = weights.dot(gram * weights);
  for (std::size_t place = 0; place < components_.size(); ++place) {
    const Eigen::Index from = first_of(place) - first;
    const Eigen::Index size = components_[place].sigmas.size();
    const Eigen::VectorXd own = weights.segment(from, size);
    if (own.dot(gram.block(from, from, size, size) * own) > std::pow(options_.most_over_all, 2) * together) return true;
  }
  return false;
}

Eigen::MatrixXd Learner::covariance() const {
  const auto count = static_cast<Eigen::Index>(taken_.columns.size());
  Eigen::MatrixXd own = problem_.gram.topLeftCorner(count, count);
  own.diagonal() += taken_.precision;
  return own.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
}

}  // namespace plumbline::diagnose

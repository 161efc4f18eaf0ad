// What the dataset says of a run and may say wrongly: direction, angle zero, place, tilt, payload, radius, bar.
#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/diagnostic.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "inspect/hypothesis.hpp"
#include "inspect/records/records.hpp"
#include "inspect/statistics.hpp"
#include "measure/run_table.hpp"

namespace plumbline::inspect {
namespace {

using Eigen::VectorXd;
using measure::Run;

VectorXd vector_of(std::initializer_list<double> values) {
  VectorXd v(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), v.begin());
  return v;
}

// Exactly this instead, nothing fitted.
void add(std::vector<Relabelled>& all, FaultKind kind, double alternatives, const std::function<void(Run&)>& change,
         std::size_t like = 0) {
  all.push_back({kind,
                 [change](const Run& run, const VectorXd&) {
                   Run made = run;
                   change(made);
                   return made;
                 },
                 {},
                 {},
                 alternatives,
                 like});
}

void add_fitted(std::vector<Relabelled>& all, FaultKind kind, const VectorXd& start, const VectorXd& step,
                const std::function<void(Run&, const VectorXd&)>& change, double alternatives = 1) {
  all.push_back({kind,
                 [change](const Run& run, const VectorXd& p) {
                   Run made = run;
                   change(made, p);
                   return made;
                 },
                 start, step, alternatives});
}

void add_tilts(std::vector<Relabelled>& all) {
  constexpr double kSlips = 6;
  for (const auto& slip : tilt_slips()) add(all, FaultKind::tilt, kSlips, slip);
  add_fitted(all, FaultKind::tilt, vector_of({0, 0}), vector_of({1e-3, 1e-3}),
             [](Run& run, const VectorXd& p) { run.tilt.head<2>() += p; });
}

void add_centres(std::vector<Relabelled>& all) {
  constexpr double kSlips = 5;
  for (const auto& slip : centre_slips()) add(all, FaultKind::centre, kSlips, slip);
  add(all, FaultKind::centre, kSlips, [](Run& run) { run.centre_W.head<2>() = -run.centre_W.head<2>().eval(); });
  add_fitted(all, FaultKind::centre, vector_of({0, 0, 0}), vector_of({1e-3, 1e-3, 1e-3}),
             [](Run& run, const VectorXd& p) { run.centre_W += p; });
}

// What is said of one run belongs to another one.
void add_exchanges(std::vector<Relabelled>& all, const Suspects& suspects) {
  if (suspects.runs.size() != 1) return;
  const Run& own = suspects.all[suspects.runs[0]];
  const auto others = static_cast<double>(suspects.all.size());
  // times and angles that are both measured say how fast it went
  const bool timed =
      measure::has_column(own, measure::Column::time) && measure::has_column(own, measure::Column::angle);
  const double rate = timed ? rate_of(own) : 0;
  for (std::size_t k = 0; k < suspects.all.size(); ++k) {
    const Run& other = suspects.all[k];
    const bool same_pose = (other.centre_W - own.centre_W).norm() + (other.tilt - own.tilt).norm() < 1e-9;
    const bool same_load = other.payload_mass == own.payload_mass && other.feed == own.feed;
    if (k == suspects.runs[0] || (same_pose && same_load)) continue;
    if (rate > 0 && std::abs(other.feed / other.radius / rate - 1) > RecordOptions{}.feed) continue;
    add(
        all, FaultKind::exchanged, 2 * others,
        [&other](Run& run) {
          if (other.direction != run.direction) run = turned_back(run);
          run.centre_W = other.centre_W;
          run.tilt = other.tilt;
          run.radius = other.radius;
          run.bar = other.bar;
          run.payload_mass = other.payload_mass;
          run.feed = other.feed;
        },
        k);
  }
}

// Radius and length of the bar.
void add_lengths(std::vector<Relabelled>& all) {
  add_fitted(all, FaultKind::radius, vector_of({0}), vector_of({1e-3}), [](Run& run, const VectorXd& p) {
    const double radius = run.radius * std::exp(p[0]);
    // the ball stays as far below, and time goes on as it does
    const double below = run.bar_length() * run.bar_length() - run.radius * run.radius;
    run.bar = std::sqrt(below + radius * radius);
    run.feed *= radius / run.radius;
    run.radius = radius;
  });
  add_fitted(all, FaultKind::bar_length, vector_of({0}), vector_of({1e-3}), [](Run& run, const VectorXd& p) {
    // the sine of the angle by which the bar is inclined is what counts
    const double sine = std::sqrt(std::max(0.0, 1 - std::pow(run.radius / run.bar_length(), 2))) + p[0];
    run.bar = run.radius / std::sqrt(1 - std::pow(std::clamp(sine, 0.0, 0.95), 2));
  });
}

// From several starts around.
void add_angle_zeros(std::vector<Relabelled>& all, int starts) {
  for (int k = 0; k < starts; ++k) {
    const double start = kTurn * k / starts;
    add_fitted(
        all, FaultKind::angle_zero, vector_of({start}), vector_of({1e-3}),
        [](Run& run, const VectorXd& p) {
          for (double& angle : run.angle) angle += p[0];
        },
        3);
  }
}

}  // namespace

Run turned_back(Run run) {
  run.direction = run.direction == measure::Direction::ccw ? measure::Direction::cw : measure::Direction::ccw;
  for (double& angle : run.angle) angle = -angle;
  return run;
}

std::vector<std::function<void(Run&)>> tilt_slips() {
  return {[](Run& run) { run.tilt.head<2>() = -run.tilt.head<2>().eval(); },
          [](Run& run) { run.tilt[0] = -run.tilt[0]; }, [](Run& run) { run.tilt[1] = -run.tilt[1]; },
          [](Run& run) { std::swap(run.tilt[0], run.tilt[1]); }};
}

std::vector<std::function<void(Run&)>> centre_slips() {
  std::vector<std::function<void(Run&)>> slips;
  for (const int axis : {0, 1, 2}) {
    slips.emplace_back([axis](Run& run) { run.centre_W[axis] = -run.centre_W[axis]; });
  }
  slips.emplace_back([](Run& run) { std::swap(run.centre_W[0], run.centre_W[1]); });
  return slips;
}

Relabelled payload_factor() {
  std::vector<Relabelled> one;
  add_fitted(one, FaultKind::payload, vector_of({0}), vector_of({0.01}),
             [](Run& run, const VectorXd& p) { run.payload_mass *= std::exp(p[0]); });
  return one.front();
}

std::vector<Relabelled> relabellings(const Suspects& suspects) {
  std::vector<Relabelled> all;
  add(all, FaultKind::direction, 1, [](Run& run) { run = turned_back(run); });
  add_tilts(all);
  add_centres(all);
  if (suspects.runs.size() > 1) {  // alike in all runs: what a convention does, not a slip
    add_angle_zeros(all, 4);
    return all;
  }
  add_exchanges(all, suspects);
  add_angle_zeros(all, 12);
  add_fitted(all, FaultKind::payload, vector_of({0}), vector_of({0.1}),
             [](Run& run, const VectorXd& p) { run.payload_mass = std::max(0.0, run.payload_mass + p[0]); });
  add_lengths(all);
  return all;
}

namespace {

// Rows of all suspects under a hypothesis, below each other.
struct Stack {
  identify::SlopeRows slopes;
  VectorXd left;
};

Stack stacked(const std::vector<const RunRows*>& runs) {
  Stack stack;
  Eigen::Index rows = 0;
  for (const RunRows* run : runs) rows += run->rows();
  stack.slopes.resize(rows, runs.front()->slopes.cols());
  stack.left.resize(rows);
  Eigen::Index at = 0;
  for (const RunRows* run : runs) {
    stack.slopes.middleRows(at, run->rows()) = run->slopes;
    stack.left.segment(at, run->rows()) = run->left;
    at += run->rows();
  }
  return stack;
}

Stack made_rows(const Suspects& suspects, const Relabelled& relabelled, const VectorXd& p) {
  std::vector<RunRows> rows(suspects.runs.size());
  for_each_index(rows.size(), [&](std::size_t i) {
    rows[i] = suspects.bench.rows(relabelled.made(suspects.all[suspects.runs[i]], p));
  });
  std::vector<const RunRows*> each;
  for (const RunRows& run : rows) each.push_back(&run);
  return stacked(each);
}

VectorXd made_left(const Suspects& suspects, const Relabelled& relabelled, const VectorXd& p) {
  std::vector<VectorXd> each(suspects.runs.size());
  for_each_index(each.size(), [&](std::size_t i) {
    each[i] = suspects.bench.left(relabelled.made(suspects.all[suspects.runs[i]], p));
  });
  Eigen::Index rows = 0;
  for (const VectorXd& one : each) rows += one.size();
  VectorXd left(rows);
  Eigen::Index at = 0;
  for (const VectorXd& one : each) {
    left.segment(at, one.size()) = one;
    at += one.size();
  }
  return left;
}

std::vector<double> found_values(const Suspects& suspects, const Relabelled& relabelled, const VectorXd& p) {
  const Run run = relabelled.made(suspects.all[suspects.runs[0]], p);
  switch (relabelled.kind) {
    case FaultKind::centre:
      return {run.centre_W.x(), run.centre_W.y(), run.centre_W.z()};
    case FaultKind::tilt:
      return {run.tilt.x(), run.tilt.y(), run.tilt.z()};
    case FaultKind::payload:
      return {run.payload_mass};
    case FaultKind::radius:
      return {run.radius};
    case FaultKind::bar_length:
      return {run.bar_length()};
    case FaultKind::angle_zero:
      return {std::remainder(p[0], kTurn)};
    default:
      return {};
  }
}

double penalty_of(const Suspects& suspects, const Relabelled& relabelled) {
  return std::log(relabelled.alternatives) +
         0.5 * static_cast<double>(relabelled.start.size()) * std::log(static_cast<double>(suspects.rows[0]->rows()));
}

// How the readings go with what is fitted.
Eigen::MatrixXd slopes_of(const Suspects& suspects, const Relabelled& relabelled, const VectorXd& p,
                          const VectorXd& left) {
  Eigen::MatrixXd slopes(left.size(), p.size());
  for (Eigen::Index k = 0; k < p.size(); ++k) {
    VectorXd moved = p;
    moved[k] += relabelled.step[k];
    slopes.col(k) = (left - made_left(suspects, relabelled, moved)) / relabelled.step[k];
  }
  return slopes;
}

// The same with the slopes of the runs as they are stated, from where the best fit then starts.
Tried fitted(const Suspects& suspects, Relabelled& relabelled, const Prediction& prediction) {
  constexpr int kSteps = 6;
  VectorXd p = relabelled.start;
  std::optional<Tried> best;
  for (int step = 0; step < kSteps; ++step) {
    const VectorXd left = made_left(suspects, relabelled, p);
    const VectorXd off = prediction.off(left);
    const double chi2 = prediction.square(off);
    if (best && !(chi2 < best->chi2)) break;
    const bool settled = best && best->chi2 - chi2 < 1e-3 * chi2;
    best = Tried{{relabelled.kind, suspects.runs}, chi2, penalty_of(suspects, relabelled)};
    best->fault.values = found_values(suspects, relabelled, p);
    relabelled.start = p;
    if (settled) break;
    const Eigen::MatrixXd slopes = slopes_of(suspects, relabelled, p, left);
    p += prediction.products(slopes, slopes).ldlt().solve(prediction.products(slopes, off));
  }
  return *best;
}

}  // namespace

std::vector<Tried> tried_alike(const Suspects& suspects, bool closely) {
  std::vector<Tried> all;
  if (suspects.rows.empty()) return all;
  std::vector<Relabelled> list;
  add_lengths(list);
  add_angle_zeros(list, 1);
  // a few millimetres turn the slopes by per cents of what they explain
  const Stack stack = stacked(suspects.rows);
  const Prediction prediction(suspects.known, stack.slopes);
  for (Relabelled& relabelled : list) {
    try {
      Tried one = fitted(suspects, relabelled, prediction);
      all.push_back(closely ? tried(suspects, relabelled).value_or(one) : one);
    } catch (const Refusal&) {  // out of the machine's reach
    }
  }
  return all;
}

std::optional<Tried> tried(const Suspects& suspects, const Relabelled& relabelled) {
  constexpr int kSteps = 5;
  VectorXd p = relabelled.start;
  std::optional<Tried> best;
  try {
    for (int step = 0; step < (p.size() > 0 ? kSteps : 1); ++step) {
      const Stack stack = made_rows(suspects, relabelled, p);
      const Prediction prediction(suspects.known, stack.slopes);
      const VectorXd off = prediction.off(stack.left);
      const double chi2 = prediction.square(off);
      const bool gained = !best || chi2 < best->chi2;
      const double gain = best ? best->chi2 - chi2 : chi2;
      if (gained) {
        best = Tried{{relabelled.kind, suspects.runs}, chi2, 0};
        best->fault.values = found_values(suspects, relabelled, p);
        best->fault.like = relabelled.like;
      }
      if (p.size() == 0 || !gained || (step > 0 && gain < 1e-3 * chi2)) break;
      const Eigen::MatrixXd slopes = slopes_of(suspects, relabelled, p, stack.left);
      p += prediction.products(slopes, slopes).ldlt().solve(prediction.products(slopes, off));
    }
  } catch (const Refusal&) {
    if (!best) return std::nullopt;  // out of the machine's reach
  }
  best->penalty = penalty_of(suspects, relabelled);
  return best;
}

}  // namespace plumbline::inspect

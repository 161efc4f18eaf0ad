#include "truth/strength.hpp"

#include <functional>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

namespace truth {
namespace {

using Change = std::function<void(Truth&)>;

// One change of one sigma for each nuisance that the owner of the model leaves open.
std::vector<Change> nuisances(const Spread& spread) {
  std::vector<Change> all;
  const auto add = [&](double sigma, const Change& change) {
    if (sigma > 0) all.push_back(change);
  };
  for (std::size_t j = 0; j < 6; ++j) {
    for (int a = 0; a < 3; ++a) {
      add(spread.joint, [=](Truth& t) { t.machine.base[j][a] += spread.joint; });
      add(spread.joint, [=](Truth& t) { t.machine.platform[j][a] += spread.joint; });
    }
    add(spread.offset, [=](Truth& t) { t.machine.length_offset[j] += spread.offset; });
    add(spread.friction, [=](Truth& t) { t.machine.friction[j] += spread.friction; });
  }
  const auto all_struts = [&](double sigma, const std::function<void(Truth&, std::size_t)>& change) {
    add(sigma, [=](Truth& t) {
      for (std::size_t j = 0; j < 6; ++j) change(t, j);
    });
  };
  all_struts(spread.compliance, [=](Truth& t, std::size_t j) { t.machine.per_length[j] *= 1 + spread.compliance; });
  all_struts(spread.compliance, [=](Truth& t, std::size_t j) { t.machine.constant[j] *= 1 + spread.compliance; });
  all_struts(spread.strut_mass, [=](Truth& t, std::size_t j) { t.machine.screw_mass[j] += spread.strut_mass; });
  all_struts(spread.motor_mass, [=](Truth& t, std::size_t j) { t.machine.motor_mass[j] += spread.motor_mass; });
  for (int a = 0; a < 3; ++a) {
    add(spread.centre_of_mass, [=](Truth& t) { t.machine.centre_of_mass[a] += spread.centre_of_mass; });
  }
  add(spread.platform_mass, [=](Truth& t) { t.machine.mass += spread.platform_mass; });
  for (std::size_t a = 0; a < 2; ++a) add(spread.level, [=](Truth& t) { t.flaws.level[a] += spread.level; });
  return all;
}

constexpr Eigen::Index kChannels = 7;

}  // namespace

Strength::Strength(const Model& model, const Plan& plan, const Floor& floor)
    : model_{model.machine, {}}, floor_(floor) {
  for (const PlannedRun& planned : plan) {
    Run run{planned, measured(model_, planned, FrictionLaw::tanh, Vec::Zero(), 0), {}};
    Eigen::MatrixX4d by(planned.samples, 4);
    for (Eigen::Index i = 0; i < by.rows(); ++i) {
      const Vec along = run.samples[static_cast<std::size_t>(i)].standing.at.x - planned.circle.ball();
      by.row(i) << along.normalized().transpose(), 1;
    }
    // as the ball's height and the bar's length change a planar reading alike, what is left of one is noise
    const Eigen::ColPivHouseholderQR<Eigen::MatrixX4d> qr(by);
    run.setup = Eigen::MatrixX4d::Zero(planned.samples, 4);
    Eigen::MatrixXd q = qr.householderQ() * Eigen::MatrixXd::Identity(planned.samples, 4);
    run.setup.leftCols(qr.rank()) = q.leftCols(qr.rank());
    runs_.push_back(std::move(run));
    rows_ += kChannels * planned.samples;
  }
  const std::vector<Change> changes = nuisances(model.spread);
  nuisances_.resize(rows_, static_cast<Eigen::Index>(changes.size()));
  for (std::size_t k = 0; k < changes.size(); ++k) {
    Truth changed = model_;
    changes[k](changed);
    nuisances_.col(static_cast<Eigen::Index>(k)) = slope(changed);
  }
  const Eigen::Index count = nuisances_.cols();
  normal_.compute(nuisances_.transpose() * nuisances_ + Eigen::MatrixXd::Identity(count, count));
}

// Where the model stands, a changed machine misses by so much, and moves by as much as takes that up.
Column Strength::slope(const Truth& changed) const {
  Column raw(rows_);
  Eigen::Index row = 0;
  for (const Run& run : runs_) {
    for (const Sample& s : run.samples) {
      const Vec6 by = s.standing.slopes.partialPivLu().solve(-misfit(changed, s.standing.at, s.moment));
      const Reading now =
          reading_at(changed, moved(s.standing.at, by), s.moment, run.planned.circle.ball(), run.planned.circle.bar);
      raw[row++] = now.radial - s.reading.radial;
      for (std::size_t j = 0; j < 6; ++j) raw[row++] = now.torque[j] - s.reading.torque[j];
    }
  }
  return finished(raw);
}

Column Strength::finished(const Column& raw) const {
  Column column = raw;
  Eigen::Index first = 0;
  for (const Run& run : runs_) {
    const Eigen::Index count = run.planned.samples;
    Eigen::Map<Eigen::MatrixXd> block(column.data() + first, kChannels, count);
    const Eigen::VectorXd radial = block.row(0);
    block.row(0) = (radial - run.setup * (run.setup.transpose() * radial)).transpose() / floor_.radial;
    block.bottomRows(6) /= floor_.torque;
    first += kChannels * count;
  }
  return column;
}

Column Strength::trace(const Machine& machine, const Flaws& flaws) const {
  Column raw(rows_);
  Eigen::Index row = 0;
  for (const Run& run : runs_) {
    const Samples without = measured({machine, {}}, run.planned, FrictionLaw::tanh, Vec::Zero(), 0);
    const Samples with = measured({machine, flaws}, run.planned, FrictionLaw::tanh, Vec::Zero(), 0);
    for (std::size_t i = 0; i < with.size(); ++i) {
      raw[row++] = with[i].reading.radial - without[i].reading.radial;
      for (std::size_t j = 0; j < 6; ++j) raw[row++] = with[i].reading.torque[j] - without[i].reading.torque[j];
    }
  }
  return finished(raw);
}

// min over n of |s - J n|^2 + |n|^2 = s.(s - J (J^T J + 1)^-1 J^T s)
Eigen::MatrixXd Strength::left_by_nuisances(const Eigen::MatrixXd& columns) const {
  return columns - nuisances_ * normal_.solve(nuisances_.transpose() * columns);
}

double Strength::snr(const Column& trace) const { return beyond(trace, {}); }

const Strength::Reach& Strength::reach_of(const std::string& effect) const {
  Reach& reach = reaches_[effect];
  if (reach.slopes.size() > 0) return reach;
  const std::vector<Flaws> ways = directions(effect);
  reach.slopes.resize(rows_, static_cast<Eigen::Index>(ways.size()));
  for (std::size_t k = 0; k < ways.size(); ++k) {
    reach.slopes.col(static_cast<Eigen::Index>(k)) = slope({model_.machine, ways[k]});
  }
  reach.left = left_by_nuisances(reach.slopes);
  return reach;
}

double Strength::beyond(const Column& trace, const std::vector<std::string>& effects) const {
  std::vector<const Reach*> reaches;
  Eigen::Index count = 0;
  for (const std::string& effect : effects) {
    reaches.push_back(&reach_of(effect));
    count += reaches.back()->slopes.cols();
  }
  const Column left = left_by_nuisances(trace);
  Eigen::VectorXd seen(count);
  Eigen::MatrixXd normal(count, count);
  Eigen::Index row = 0;
  for (const Reach* one : reaches) {
    const Eigen::Index rows = one->slopes.cols();
    seen.segment(row, rows) = one->slopes.transpose() * left;
    Eigen::Index col = 0;
    for (const Reach* other : reaches) {
      normal.block(row, col, rows, other->slopes.cols()) = one->slopes.transpose() * other->left;
      col += other->slopes.cols();
    }
    row += rows;
  }
  const double taken = count == 0 ? 0 : seen.dot(normal.completeOrthogonalDecomposition().solve(seen));
  return std::sqrt(std::max(0.0, trace.dot(left) - taken));
}

}  // namespace truth

#include "compensate/bound/correction_curve.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "compensate/bound/told_way.hpp"
#include "machine/condition.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kFewestIntervals = 4;
constexpr double kShareOfWave = 0.125;  // between two points of a proof
constexpr double kMostMm = 2.5;
constexpr double kMostDeg = 1;
constexpr double kArcDeg = 5;
constexpr double kSaturatedSpeeds = 6;  // v0, from which on tanh is 1 to 1e-5
constexpr double kSafetyOfSecond = 2;   // on the second derivative that the points show

Deviation larger(const Deviation& a, const Deviation& b) {
  return {std::max(a.tip_mm, b.tip_mm), std::max(a.turned_rad, b.turned_rad)};
}

AxisWords scaled(AxisWords words, double by) {
  for (double& value : words.values) value *= by;
  return words;
}

}  // namespace

// The largest angle is that of a corner of the box of A, B and C; of two opposite ones one is enough.
Deviation CorrectionCurve::rounding(const Move& move, const AxisWords& half_quanta) const {
  AxisWords half = half_quanta;
  for (const Axis axis : kAllAxes) {
    if (move.path.fixed.contains(axis)) half[axis] = 0;
  }
  Deviation rounding{length_mm(half), 0};
  for (const double fraction : {0.0, 1.0}) {
    const AxisWords pose = move.path.target(fraction, std::nullopt).pose;
    for (const double b : {-1.0, 1.0}) {
      for (const double c : {-1.0, 1.0}) {
        AxisWords corner = half;
        corner[Axis::B] *= b;
        corner[Axis::C] *= c;
        rounding.turned_rad = std::max(rounding.turned_rad, corrector_.turn_rad(pose, corner));
      }
    }
  }
  return rounding;
}

void CorrectionCurve::follow(const Move& move, const Deviation& rounding) {
  move_ = &move;
  violations_.clear();
  rounding_m_ = rounding.tip_mm * kMm + rounding.turned_rad * machine::platform_radius(corrector_.geometry());
  friction_ = corrector_.friction_turns(move.path.target(0.5, move.seconds));
  const path::Curve& curve = move.path.curve;
  const double turns = path::largest_turn_deg(curve.delta()) / kMostDeg + std::abs(curve.arc_deg()) / kArcDeg;
  const double most_mm = std::min(kMostMm, kShareOfWave * corrector_.shortest_wave() / kMm);
  const double arm_mm = machine::platform_radius(corrector_.geometry()) / kMm;
  const double turned_mm = path::largest_turn_deg(curve.delta()) * kDeg * arm_mm;
  most_share_ = 1 / std::max(1.0, (curve.linear_mm() + turned_mm) / most_mm + turns);
}

PathPlace CorrectionCurve::place(double fraction) const {
  const path::CurvePoint point = move_->path.curve.point(fraction);
  return {fraction, point.at, move_->path.target(point, move_->seconds)};
}

// The command for a machine that moves along `slope` there.
Corrected CorrectionCurve::command(const PathPlace& place, const machine::PerStrut<double>& sign,
                                   const AxisWords& slope) {
  Target target = place.target;
  target.sign = sign;
  target.slope = slope;
  if (place.fraction == 0) return corrector_.correct(target);  // the move before it ends there
  const Command command = compensate::command(corrector_, limits_, target);
  if (!command.violations.empty()) keep_worst(violations_, command.violations);
  return command.corrected;
}

std::size_t CorrectionCurve::intervals(double from, double to) const {
  return static_cast<std::size_t>(std::max(kFewestIntervals, std::ceil((to - from) / most_share_)));
}

bool CorrectionCurve::fill_nodes(const PieceEnd& begin, const PieceEnd& end, Friction friction) {
  const double share = end.fraction - begin.fraction;
  const std::size_t count = intervals(begin.fraction, end.fraction);
  const ToldWay way(move_->path, begin.told, end.told, share, end.arc);
  nodes_.clear();
  for (std::size_t i = 0; i <= count; ++i) {
    const double along = static_cast<double>(i) / static_cast<double>(count);
    PathPlace place = this->place(begin.fraction + along * share);
    Target told = place.target;
    told.pose = way.pose(along);
    told.slope = way.slope(along);
    machine::PerStrut<double> sign = begin.sign + along * (end.sign - begin.sign);
    Deviation uncertain;
    if (friction == Friction::as_told && corrector_.has_friction()) {
      const physics::StrutRates<double> rates = corrector_.rates_as_told(told);
      sign = rates.sign;
      uncertain = uncertain_friction(rates, share);
    }
    const Corrected wanted = command(place, sign, told.slope);
    if (!wanted.converged) return false;
    nodes_.push_back({std::move(place), off(told.pose, wanted.pose), uncertain});
  }
  return true;
}

// An axis that gets no word stands where it stands.
AxisWords CorrectionCurve::off(const AxisWords& told, const AxisWords& wanted) const {
  AxisWords off = told - wanted;
  for (const Axis axis : kAllAxes) {
    if (move_->path.fixed.contains(axis)) off[axis] = 0;
  }
  return off;
}

// Rounding at both ends makes a strut faster or slower by 2 r / t.
Deviation CorrectionCurve::uncertain_friction(const physics::StrutRates<double>& rates, double share) const {
  Deviation uncertain;
  if (!move_->seconds || *move_->seconds <= 0) return uncertain;
  const double v0 = corrector_.turning_speed();
  const double change = 2 * rounding_m_ / (share * *move_->seconds);
  for (int j = 0; j < machine::kStruts; ++j) {
    const double towards_zero = std::abs(rates.speed[j]) - change;
    if (towards_zero > kSaturatedSpeeds * v0) continue;
    const double turned = std::abs(std::tanh(towards_zero / v0) - std::abs(rates.sign[j])) / 2;
    uncertain.tip_mm += turned * friction_.tip_mm[j];
    uncertain.turned_rad += turned * friction_.turned_deg[j] * kDeg;
  }
  return uncertain;
}

// Between two points h apart a function leaves its chord by h^2 / 8 max |f''| at most; f'' is taken from the second
// differences d2 / h^2 of the points, kSafetyOfSecond times.
PieceProof CorrectionCurve::prove(const PieceEnd& begin, const PieceEnd& end, Friction friction) {
  PieceProof proof;
  proof.reached = fill_nodes(begin, end, friction);
  if (!proof.reached) return proof;
  const auto deviation_of = [&](std::size_t i, const AxisWords& off) {
    return deviation(corrector_, nodes_[i].place.target, nodes_[i].place.fraction, off);
  };
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Deviation here = deviation_of(i, nodes_[i].off);
    const std::size_t middle = std::clamp<std::size_t>(i, 1, nodes_.size() - 2);
    const AxisWords second = nodes_[middle + 1].off - scaled(nodes_[middle].off, 2) + nodes_[middle - 1].off;
    const Deviation between = deviation_of(middle, scaled(second, kSafetyOfSecond / 8));
    proof.worst = larger(proof.worst, {here.tip_mm + between.tip_mm + nodes_[i].uncertain.tip_mm,
                                       here.turned_rad + between.turned_rad + nodes_[i].uncertain.turned_rad});
  }
  return proof;
}

}  // namespace plumbline::compensate

#include "compensate/bound/strut_turns.hpp"

#include <algorithm>
#include <cmath>

#include "base/units.hpp"

namespace plumbline::compensate {
namespace {

constexpr int kTurnIntervals = 8;  // in which a turn is sought
constexpr int kBisections = 30;
constexpr double kFarFromTurn = 3;  // v0: tanh is 0.995
constexpr double kTurned = 0.6;     // v0: tanh is a little more than a half
constexpr int kSigns = 40;          // that are tried, from -1 to 1

}  // namespace

std::vector<double> StrutTurns::follow(const Move& move, double least_mm) {
  move_ = &move;
  return find(
      least_mm, [&](int) { return kFarFromTurn * corrector_.turning_speed(); }, 0);
}

// J / 2 (1 - tanh(v / v0)) = least / 4, where J is the jump of the tip.
std::vector<double> StrutTurns::follow_closely(const Move& move, double least_mm) {
  move_ = &move;
  const auto slow_of = [&](int strut) {
    const double turned = std::atanh(1 - least_mm / 2 / curve_.friction().tip_mm[strut]);
    return std::min(kFarFromTurn, turned) * corrector_.turning_speed();
  };
  return find(least_mm, slow_of, kTurned * corrector_.turning_speed());
}

template <class Slow>
std::vector<double> StrutTurns::find(double least_mm, const Slow& slow_of, double turned) const {
  std::vector<double> found;
  const auto speeds_at = [&](double fraction) { return curve_.speeds(curve_.place(fraction)); };
  machine::PerStrut<double> before = speeds_at(0);
  for (int i = 0; i < kTurnIntervals; ++i) {
    const double from = static_cast<double>(i) / kTurnIntervals;
    const double to = static_cast<double>(i + 1) / kTurnIntervals;
    const machine::PerStrut<double> after = speeds_at(to);
    for (int j = 0; j < machine::kStruts; ++j) {
      if (curve_.friction().tip_mm[j] <= least_mm) continue;
      const double slow = slow_of(j);
      for (const double level : {-slow, std::copysign(turned, after[j] - before[j]), slow}) {
        if ((before[j] - level) * (after[j] - level) >= 0) continue;
        double low = from;
        double high = to;
        for (int k = 0; k < kBisections; ++k) {
          const double middle = (low + high) / 2;
          ((speeds_at(middle)[j] - level) * (before[j] - level) > 0 ? low : high) = middle;
        }
        found.push_back(low);
      }
    }
    before = after;
  }
  std::sort(found.begin(), found.end());
  return found;
}

machine::PerStrut<double> StrutTurns::sign_at_end(const PieceEnd& begin, double end) const {
  const physics::StrutRates<double> there = corrector_.rates_as_told(curve_.place(end).target);
  machine::PerStrut<double> sign = there.sign;
  const double slow = kFarFromTurn * corrector_.turning_speed();
  if ((there.speed.array().abs() > slow).all()) return sign;
  const double share = end - begin.fraction;
  Speeds speeds;
  for (std::size_t i = 0; i < kLooks; ++i) {
    const double along = static_cast<double>(i) / (kLooks - 1);
    speeds[i] = curve_.speeds(curve_.place(begin.fraction + along * share));
  }
  for (int j = 0; j < machine::kStruts; ++j) {
    if (std::abs(there.speed[j]) > slow) continue;
    double least = left(j, speeds, begin.sign[j], sign[j], share);
    for (int k = 0; k <= kSigns; ++k) {
      const double tried = 2.0 * k / kSigns - 1;
      const double leaves = left(j, speeds, begin.sign[j], tried, share);
      if (leaves >= least) continue;
      least = leaves;
      sign[j] = tried;
    }
  }
  return sign;
}

// What the friction of a strut leaves on a piece, |s taken - s as told|: the most of it, and on the whole.
double StrutTurns::left(int strut, const Speeds& speeds, double begin, double end, double share) const {
  const double added =  // m/s
      move_->seconds ? curve_.friction().strut_mm[strut] / 2 * kMm * (end - begin) / (share * *move_->seconds) : 0;
  double most = 0;
  double sum = 0;
  for (std::size_t i = 0; i < kLooks; ++i) {
    const double along = static_cast<double>(i) / (kLooks - 1);
    const double told = std::tanh((speeds[i][strut] + added) / corrector_.turning_speed());
    const double off = std::abs(begin + along * (end - begin) - told);
    most = std::max(most, off);
    sum += off;
  }
  return most + sum / kLooks;
}

double StrutTurns::tip_jump_mm(const machine::PerStrut<double>& from, const machine::PerStrut<double>& to) const {
  return (to - from).cwiseAbs().dot(curve_.friction().tip_mm) / 2;
}

}  // namespace plumbline::compensate

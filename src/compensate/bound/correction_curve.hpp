// The curve of commands that puts the deformed tip on a move, and how far a straight piece of the output is from it.
#pragma once

#include <optional>
#include <vector>

#include "compensate/bound/distance.hpp"
#include "compensate/corrector.hpp"
#include "compensate/limits.hpp"
#include "compensate/move.hpp"
#include "machine/limits.hpp"
#include "nc/control/state/motion.hpp"

namespace plumbline::compensate {

/// A point of a move.
struct PathPlace {
  double fraction = 0;
  AxisWords work;  // on the original path, in the work system
  Target target;
};

/// An end of a piece: what the control is told there, pose in W; which way the friction of each strut is taken to act
/// there; and the arc along which it goes there from the end before, in the work system. Nothing: straight.
struct PieceEnd {
  double fraction = 0;
  AxisWords told;
  machine::PerStrut<double> sign = machine::PerStrut<double>::Zero();
  std::optional<nc::Arc> arc = {};
};

/// How far the tip is off the path anywhere on a piece, before its words are rounded.
struct PieceProof {
  Deviation worst;
  bool reached = true;  // false: no command puts the tool on some point of it
};

class CorrectionCurve {
 public:
  /// Both must outlive it.
  CorrectionCurve(const Corrector& corrector, const machine::Limits& limits) : corrector_(corrector), limits_(limits) {}

  /// What words that are each off by `half_quanta` (mm, deg) at most may do to a point of a move. Axes without a word
  /// are not rounded.
  Deviation rounding(const Move& move, const AxisWords& half_quanta) const;
  /// Goes over to another move, which must outlive the use of it; `rounding` is what its words may be off.
  void follow(const Move& move, const Deviation& rounding);
  /// What the friction of the struts does in the middle of it.
  const Corrector::FrictionTurns& friction() const { return friction_; }

  PathPlace place(double fraction) const;
  /// The speeds of the struts on the original path, m/s.
  machine::PerStrut<double> speeds(const PathPlace& place) const {
    return corrector_.rates_as_told(place.target).speed;
  }
  /// The command for a place where friction acts as `sign` says; limits that it breaks are noted.
  Corrected command(const PathPlace& place, const machine::PerStrut<double>& sign) {
    return command(place, sign, place.target.slope);
  }

  /// Whose sign friction follows on a piece: that of the speed which the control is told, or what the ends of the piece
  /// take it to be.
  enum class Friction { as_told, as_taken };
  /// Runs along a piece from `begin` to `end` and holds it against the curve of commands: at evenly spaced
  /// points, and by the second differences between them [docs/rewriting.md, 9].
  PieceProof prove(const PieceEnd& begin, const PieceEnd& end, Friction friction);

  /// Limits that were found broken since follow().
  std::vector<machine::Violation>& violations() { return violations_; }

 private:
  struct Node {
    PathPlace place;
    AxisWords off;
    Deviation uncertain;  // since rounding changes the speeds of the struts, and friction turns by them
  };
  Corrected command(const PathPlace& place, const machine::PerStrut<double>& sign, const AxisWords& slope);
  AxisWords off(const AxisWords& told, const AxisWords& wanted) const;
  std::size_t intervals(double from, double to) const;
  bool fill_nodes(const PieceEnd& begin, const PieceEnd& end, Friction friction);
  Deviation uncertain_friction(const physics::StrutRates<double>& rates, double share) const;

  const Corrector& corrector_;
  const machine::Limits& limits_;
  const Move* move_ = nullptr;
  double most_share_ = 1;  // of the move: between two points of a proof
  double rounding_m_ = 0;  // that a strut may be longer or shorter by rounding
  Corrector::FrictionTurns friction_;
  std::vector<Node> nodes_;
  std::vector<machine::Violation> violations_;
};

}  // namespace plumbline::compensate

// Where the control is to be sent for a move, so that the deformed machine makes it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compensate/bound/point_chooser.hpp"
#include "compensate/corrector.hpp"
#include "compensate/limits.hpp"
#include "compensate/move.hpp"
#include "machine/limits.hpp"
#include "nc/rewrite/emit_pieces.hpp"

namespace plumbline::compensate {

struct CorrectedMove {
  Move move;
  AxisWords standing;                            // by how much the control stands off the original before it
  std::vector<nc::CorrectedPoint> points;        // ends of its pieces; of a rapid its end
  std::vector<machine::PerStrut<double>> signs;  // of the struts' speeds at these
  std::vector<machine::Violation> violations;    // of limits; kOutOfReach: no command leads there
  BoundOfMove bound;                             // of one whose points were chosen by it,
  std::vector<Deviation> proven;                 // and of its pieces

  /// Where the control is sent for a point, in W.
  AxisWords commanded(std::size_t point) const {
    return move.path.frame.to_pose(points[point].nominal + points[point].shift);
  }
};

/// A move that comes soon, divided; its points are among the PointsAhead.
struct MoveAhead {
  Move move;
  std::size_t first = 0;  // of its targets
};

/// Points of moves of up to kFewPieces pieces that come soon, in their order, and what to command for each.
struct PointsAhead {
  std::uint64_t number = 0;  // no others have it
  std::uint64_t tools = 0;   // that came into the spindle before they were corrected
  AxisSet at_zero;           // axes that were taken to stand at zero
  std::vector<MoveAhead> moves;
  std::vector<Target> targets;
  Corrections corrections;
};

class MoveCorrector {
 public:
  /// Where a limit is broken the points end, or they go on and the worst violation of each kind is kept.
  enum class AtViolation { stop, go_on };

  /// Corrector and limits must outlive it. `bound` chooses the points of cuts where it is asked for.
  MoveCorrector(const Corrector& corrector, const machine::Limits& limits, AtViolation at_violation,
                const BoundSettings& bound = {})
      : corrector_(corrector), limits_(limits), at_violation_(at_violation) {
    if (bound.is_asked()) chooser_.emplace(corrector, limits, bound);
  }

  /// A move that was divided. `standing`: by how much the control stands off the original before it, in the work
  /// system. Of a rapid the end alone is corrected; the control goes there as it likes, so the limits are checked on
  /// the chord. `words`: where points are chosen by a bound. Holds until the next call.
  const CorrectedMove& correct(const Move& move, const AxisWords& standing, const WordsOfMove& words = {});
  /// correct() of a move whose points are among these takes what was found for them. To be told before each move: null
  /// where there are none, or the tool is another one; `move`: the one of their moves that will be corrected next,
  /// where that is known. They must outlive the next call of correct().
  void expect(const PointsAhead* points, const MoveAhead* move = nullptr);
  /// Places of the work system where the machine stands still, one point each.
  const CorrectedMove& correct_places(const Move& move, std::span<const AxisWords> places, const AxisWords& standing);

 private:
  void begin(const Move& move, const AxisWords& standing);
  bool take(const Target& target, const AxisWords& words);
  bool take(const Target& target, const AxisWords& words, const Corrected& corrected);
  void keep(const Corrected& corrected, const AxisWords& words);
  bool stops() const { return at_violation_ == AtViolation::stop && !result_.violations.empty(); }
  void note(std::vector<machine::Violation> violations);
  void correct_rapid();
  void stand();
  void correct_cut();
  void take_expected(const MoveAhead& ahead);
  bool take_expected();
  void correct_by_bound(const WordsOfMove& words);

  const Corrector& corrector_;
  const machine::Limits& limits_;
  AtViolation at_violation_;
  std::optional<PointChooser> chooser_;
  std::optional<machine::PerStrut<double>> standing_sign_;  // of friction, at the last corrected place
  CorrectedMove result_;
  std::vector<path::CurvePoint> points_;  // of pieces that are corrected together
  std::vector<Target> targets_;
  Corrections corrections_;
  const PointsAhead* expected_ = nullptr;
  const MoveAhead* expected_move_ = nullptr;  // of these
  std::uint64_t number_ = 0;                  // of these, or of the last
  std::size_t met_ = 0;                       // of these, so far
};

}  // namespace plumbline::compensate

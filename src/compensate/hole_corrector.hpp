// The hole of a cycle that works the spindle: it stays a cycle, so it can only be shifted as a whole.
#pragma once

#include "compensate/move_corrector.hpp"
#include "compensate/settings.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::compensate {

struct CorrectedHole {
  const CorrectedMove* at = nullptr;  // from where it begins to its bottom
  AxisWords shift;                    // of the whole hole: the mean of these
};

class HoleCorrector {
 public:
  /// All must outlive it.
  HoleCorrector(const nc::Dialect& dialect, const Corrector& corrector, const machine::Limits& limits,
                const Settings& settings, MoveCorrector& places)
      : dialect_(dialect), corrector_(corrector), limits_(limits), settings_(settings), places_(places) {}

  /// The motion that goes from R to the bottom first, of a block of one hole.
  static const nc::Motion& way_down(const nc::Step& hole);

  /// `down`: the move that the motion makes. The tool goes down and up: without friction.
  /// Holds until the next move is corrected.
  CorrectedHole correct(const Move& down, const nc::Hole& hole, const AxisWords& standing);

  /// The block of a cycle begins, with the tool where the original has it.
  void begin(const nc::Step& cycle);
  /// Refuses with compensate-cycle a hole whose correction varies too much, or puts the tool off the level that the
  /// cycle goes back to; with limit-... what the way to it breaks.
  void check(const CorrectedHole& hole);

 private:
  void refuse_varying(const CorrectedHole& hole) const;
  void check_way_to(const CorrectedHole& hole) const;
  void check_level(const CorrectedHole& corrected) const;

  const nc::Dialect& dialect_;
  const Corrector& corrector_;
  const machine::Limits& limits_;
  const Settings& settings_;
  MoveCorrector& places_;
  double stands_at_ = 0;  // height of the tool before the hole, in the original
};

}  // namespace plumbline::compensate

// The points of a move, chosen by a bound: as few as keep the deformed tip within it of the original path.
#pragma once

#include <span>
#include <vector>

#include "compensate/bound/arc_fit.hpp"
#include "compensate/bound/correction_curve.hpp"
#include "compensate/bound/strut_turns.hpp"
#include "compensate/corrector.hpp"
#include "compensate/move.hpp"
#include "compensate/settings.hpp"
#include "compensate/summary.hpp"
#include "machine/limits.hpp"
#include "nc/rewrite/arc_words.hpp"

namespace plumbline::compensate {

/// How the words of a move may be written.
struct WordsOfMove {
  AxisWords half_quanta;            // what rounding may take off one or put on it, mm and deg
  std::optional<nc::ArcForm> arcs;  // of an arc; nothing: it becomes straight pieces
};

/// What the control makes of a command, and where it stood before the move.
struct ControlBefore {
  std::optional<AxisWords> told;  // pose in W, as the control keeps it; nothing: as the correction has it
  machine::PerStrut<double> sign = machine::PerStrut<double>::Zero();  // of friction, as that command has it
  WordsOfMove words;
};

struct ChosenPoint {
  PathPlace place;
  Corrected corrected;
  std::optional<nc::Arc> arc;  // along which the control goes there, in the work system; nothing: straight
  Deviation proven;            // of the piece that ends there, rounding included
};

class PointChooser {
 public:
  /// Corrector and limits must outlive it.
  PointChooser(const Corrector& corrector, const machine::Limits& limits, const BoundSettings& settings)
      : settings_(settings),
        curve_(corrector, limits),
        turns_(corrector, curve_),
        arcs_(curve_),
        has_friction_(corrector.has_friction()) {}

  /// Chooses the points of a move that cuts, the last of them its end. Refuses with compensate-tolerance a bound that
  /// rounding alone breaks, with path-too-many-pieces more than 200,000. Holds until the next call.
  std::span<const ChosenPoint> choose(const Move& move, const ControlBefore& before);

  /// Of the last choose(): how it keeps the bound, and the limits that the move breaks.
  const BoundOfMove& bound() const { return bound_; }
  std::vector<machine::Violation>& violations() { return curve_.violations(); }
  /// False where no command puts the tool on some point of the move: the points end before it.
  bool reached() const { return reached_; }

 private:
  struct Piece {
    PieceEnd end;
    Corrected corrected;
    PathPlace place;
    Deviation as_told, as_taken;  // the worst of it, with friction so
    double share = 0;             // of the move
    bool jumps = false;           // the tip, since friction is taken to turn on it
    bool is_long = false;         // for a straight piece of an arc: a shorter one may be an arc
  };
  void set_allowed(const Move& move, const AxisWords& half_quanta);
  PieceEnd begin_of(const ControlBefore& before);
  bool choose_up_to(double last, PieceEnd& at);
  [[noreturn]] void refuse_creeping() const;
  bool try_piece(const PieceEnd& begin, double end, Piece& piece);
  void fit_arc(const PieceEnd& begin, Piece& piece);
  bool turns_bit_by_bit(const PieceEnd& begin) const;
  double shortened(const PieceEnd& begin, double last, const Piece& piece) const;
  bool keeps(const Deviation& deviation) const;
  double over(const Deviation& deviation) const;
  void accept(const Piece& piece);

  BoundSettings settings_;
  CorrectionCurve curve_;
  StrutTurns turns_;
  ArcFit arcs_;
  bool has_friction_;
  const Move* move_ = nullptr;
  Deviation allowed_, rounding_;
  double block_share_ = 0;   // of the move: what the control's time for a block is
  double least_share_ = 0;   // and the shortest of a piece
  int short_pieces_ = 0;     // one behind another, about as short as a block may be
  int broken_in_a_row_ = 0;  // pieces that do not keep the bound
  bool reached_ = true;
  BoundOfMove bound_;
  std::vector<ChosenPoint> chosen_;
};

}  // namespace plumbline::compensate

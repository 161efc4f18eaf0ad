// The arc that takes the place of a piece of an arc, so that the deformed tip follows it.
#pragma once

#include <optional>

#include "compensate/bound/correction_curve.hpp"
#include "nc/control/state/arc_shape.hpp"
#include "nc/rewrite/arc_words.hpp"

namespace plumbline::compensate {

class ArcFit {
 public:
  /// The curve must outlive it.
  explicit ArcFit(CorrectionCurve& curve) : curve_(curve) {}

  /// Goes over to another move, which the curve follows. Nothing is fitted to one that is no arc, or has no `form`.
  void follow(const Move& move, const std::optional<nc::ArcForm>& form);
  bool is_asked() const { return form_.has_value(); }
  /// The longest share of the move that one arc may stand for: all of it, or, where all of it cannot, less than a turn.
  double most_share(double begin) const;

  /// Where a piece ends that is to be an arc: words that may not stand beside one stay as they are, and a whole circle
  /// ends where it begins.
  AxisWords end_of(const PieceEnd& begin, double end, const AxisWords& told) const;
  /// The arc from end to end that leaves least of the correction, with what the control takes of a change of its
  /// radius. Nothing where there is none that the control would take for sure once its words are rounded.
  std::optional<nc::Arc> between(const PieceEnd& begin, const PieceEnd& end);
  /// A piece of which rather a shorter one is an arc than that it goes straight.
  bool is_long(double share) const;

  /// What the rounding of its centre may put on the tip's distance from the path, mm.
  double rounding_mm(double share) const;

 private:
  static bool is_whole(double begin, double end) { return begin == 0 && end == 1; }
  bool closes() const;
  bool is_sure(const nc::ArcShape& shape, double share, bool whole) const;

  CorrectionCurve& curve_;
  const Move* move_ = nullptr;
  std::optional<nc::ArcForm> form_;
  nc::ArcShape original_;
};

}  // namespace plumbline::compensate

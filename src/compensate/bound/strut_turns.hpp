// Where the struts turn round on a move, and which way their friction is taken to act on its pieces.
#pragma once

#include <array>
#include <vector>

#include "compensate/bound/correction_curve.hpp"
#include "compensate/corrector.hpp"

namespace plumbline::compensate {

class StrutTurns {
 public:
  /// Both must outlive it.
  StrutTurns(const Corrector& corrector, const CorrectionCurve& curve) : corrector_(corrector), curve_(curve) {}

  /// Looks at a move, which `curve` follows. Gives the fractions of it, rising, where a strut turns round whose
  /// friction moves the tip by more than `least_mm`, and where it gets so slow that its friction begins to turn, or
  /// fast again.
  std::vector<double> follow(const Move& move, double least_mm);
  /// The same for as few pieces as may be: a strut is slow where that moves the tip by a quarter of `least_mm`, and has
  /// turned round where sign_at_end() says so.
  std::vector<double> follow_closely(const Move& move, double least_mm);

  /// Which way friction acts at the end of a piece that begins with `begin`. A strut that is far from turning round
  /// says so itself. Of one that moves as slowly as its friction takes to turn, the sign is sought that leaves least on
  /// the piece, s as told = tanh((Ldot + K (s_b - s_a) / t) / v0): the change of the correction moves the strut as
  /// well.
  machine::PerStrut<double> sign_at_end(const PieceEnd& begin, double end) const;

  /// How far the tip would jump where friction went from one to the other at once, mm.
  double tip_jump_mm(const machine::PerStrut<double>& from, const machine::PerStrut<double>& to) const;

 private:
  static constexpr std::size_t kLooks = 5;  // along a piece
  using Speeds = std::array<machine::PerStrut<double>, kLooks>;
  template <class Slow>
  std::vector<double> find(double least_mm, const Slow& slow_of, double turned) const;
  double left(int strut, const Speeds& speeds, double begin, double end, double share) const;

  const Corrector& corrector_;
  const CorrectionCurve& curve_;
  const Move* move_ = nullptr;
};

}  // namespace plumbline::compensate

#include "compensate/bound/point_chooser.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/units.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {
namespace {

constexpr double kReserve = 0.97;  // of the bound: the correction changes a little between the tip and where it is off
constexpr double kUnknownMm = 0.02;     // mm and deg: the shortest piece where the time of a move is not known
constexpr double kTimeYields = 0.05;    // of the least time, down to which a piece may go where time yields
constexpr double kTimeReserve = 1.025;  // pieces whose speeds differ by less than 2 % share one F
constexpr double kSlack = 1e-9;
constexpr double kNearer = 0.98;
constexpr double kLeastGrown = 0.05;  // of what is allowed: a piece that leaves less is a fifth of the next one
constexpr std::size_t kMostPoints = 200'000;

double whole_way(const path::Curve& curve) { return curve.linear_mm() + path::largest_turn_deg(curve.delta()); }

constexpr double kSlowMm = 2e-3;   // mm and deg that a block of the least time goes
constexpr int kManyShort = 16;     // pieces, one behind another
constexpr int kMostBroken = 2000;  // likewise, that do not keep the bound: no turn takes as many

}  // namespace

std::span<const ChosenPoint> PointChooser::choose(const Move& move, const ControlBefore& before) {
  move_ = &move;
  bound_ = {};
  chosen_.clear();
  broken_in_a_row_ = 0;
  reached_ = true;
  short_pieces_ = 0;
  set_allowed(move, before.words.half_quanta);
  curve_.follow(move, rounding_);
  arcs_.follow(move, before.words.arcs);
  std::vector<double> ends;
  if (has_friction_) {
    ends = arcs_.is_asked() ? turns_.follow_closely(move, allowed_.tip_mm) : turns_.follow(move, allowed_.tip_mm);
  }
  ends.push_back(1);
  PieceEnd at = begin_of(before);
  for (const double end : ends) {
    const bool is_short = end < 1 && (end - at.fraction < block_share_ || 1 - end < block_share_);
    if (is_short) continue;
    if (!reached_ || !choose_up_to(end, at)) break;
  }
  return chosen_;
}

// What the rounding of both ends of a piece may do, its middle cannot exceed.
void PointChooser::set_allowed(const Move& move, const AxisWords& half_quanta) {
  rounding_ = curve_.rounding(move, half_quanta);
  allowed_.tip_mm = kReserve * settings_.tolerance_mm - rounding_.tip_mm;
  allowed_.turned_rad = kReserve * settings_.tolerance_mm / settings_.turn_length_mm - rounding_.turned_rad;
  if (allowed_.tip_mm <= 0 || allowed_.turned_rad <= 0) {
    const double least = std::max(rounding_.tip_mm, rounding_.turned_rad * settings_.turn_length_mm) / kReserve;
    refuse(
        "compensate-tolerance",
        fmt::format("the tip cannot be kept within {:.4g} um: what the control keeps of a word leaves up to {:.3g} um",
                    settings_.tolerance_mm * kMm / kUm, least * kMm / kUm),
        "give a larger --tolerance; or say in [control] of the model that the control keeps more digits",
        place_of(*move.step));
  }
  double least_share = 0;
  if (move.seconds && *move.seconds > 0) {
    const bool inverse = move.motion->feed_mode == nc::FeedMode::inverse_time;
    least_share = inverse ? kTimeReserve * settings_.least_inverse_time_s / *move.seconds : 0;
    block_share_ = std::max(least_share, kTimeReserve * settings_.least_time_s / *move.seconds);
  } else {
    block_share_ = kUnknownMm / std::max(whole_way(move.path.curve), kSlack);
  }
  const double yields = settings_.yields == BoundSettings::Yields::time ? kTimeYields : 1;
  least_share_ = std::max(least_share, block_share_ * yields);
}

// Where the control stands; not known: at the correction of the begin.
PieceEnd PointChooser::begin_of(const ControlBefore& before) {
  PieceEnd begin{0, {}, before.sign};
  if (before.told) {
    begin.told = *before.told;
    return begin;
  }
  const PathPlace place = curve_.place(0);
  if (has_friction_) begin.sign = turns_.sign_at_end(begin, kSlack);
  const Corrected corrected = curve_.command(place, begin.sign);
  reached_ = corrected.converged;
  begin.told = corrected.pose;
  return begin;
}

bool PointChooser::keeps(const Deviation& deviation) const {
  return deviation.tip_mm <= allowed_.tip_mm && deviation.turned_rad <= allowed_.turned_rad;
}

// How many times what is allowed.
double PointChooser::over(const Deviation& deviation) const {
  return std::max(deviation.tip_mm / allowed_.tip_mm, deviation.turned_rad / allowed_.turned_rad);
}

// Pieces of about equal length, as many as the last proof says: what a piece leaves goes with its length squared.
bool PointChooser::choose_up_to(double last, PieceEnd& at) {
  double count = 1;
  while (at.fraction < last) {
    double end = last;
    if (count > 1) end = std::max(at.fraction + (last - at.fraction) / count, at.fraction + least_share_);
    if (last - end < least_share_ * (1 - kSlack)) end = last;
    if (arcs_.is_asked()) end = std::min(end, at.fraction + arcs_.most_share(at.fraction));
    Piece piece;
    while (true) {
      if (!try_piece(at, end, piece)) return false;
      if (piece.is_long) {
        end = at.fraction + piece.share / 2;
        continue;
      }
      const double shorter = shortened(at, last, piece);
      if (shorter >= end) break;
      end = shorter;
    }
    accept(piece);
    const double fits = (end - at.fraction) * kNearer / std::sqrt(std::clamp(over(piece.as_taken), kLeastGrown, 1.0));
    const bool left_arc = arcs_.is_asked() && !piece.end.arc;
    count = piece.jumps || left_arc ? 1 : std::max(1.0, std::ceil((last - end) / fits));
    at = piece.end;
    if (broken_in_a_row_ > kMostBroken) refuse_creeping();
    if (chosen_.size() > kMostPoints) {
      refuse("path-too-many-pieces", fmt::format("a single move would be cut into more than {} pieces", kMostPoints),
             "check its end, or give a larger --tolerance", place_of(*move_->step));
    }
  }
  return true;
}

// As slow as friction turns, the push of the correction turns it again and again.
void PointChooser::refuse_creeping() const {
  const double mm_min = move_->path.curve.linear_mm() / move_->seconds.value_or(kMinute) * kMinute;
  refuse("compensate-tolerance",
         fmt::format("at {:.3g} mm/min the struts creep: their friction turns back and forth, and {} pieces one behind "
                     "another do not keep the bound",
                     mm_min, kMostBroken),
         "give this move a higher feed; or take fixed steps in place of --tolerance, or --no-friction",
         place_of(*move_->step));
}

bool PointChooser::try_piece(const PieceEnd& begin, double end, Piece& piece) {
  piece.place = curve_.place(end);
  piece.end = {end, {}, machine::PerStrut<double>::Zero()};
  if (has_friction_) piece.end.sign = turns_.sign_at_end(begin, end);
  piece.corrected = curve_.command(piece.place, piece.end.sign);
  reached_ = piece.corrected.converged;
  if (!reached_) return false;
  piece.end.told = piece.corrected.pose;
  piece.share = end - begin.fraction;
  piece.is_long = false;
  if (arcs_.is_asked()) fit_arc(begin, piece);
  if (piece.is_long) return true;
  const double of_centre = piece.end.arc ? arcs_.rounding_mm(piece.share) : 0;
  const PieceProof proof = curve_.prove(begin, piece.end, CorrectionCurve::Friction::as_told);
  piece.as_told = piece.as_taken = {proof.worst.tip_mm + of_centre, proof.worst.turned_rad};
  reached_ = proof.reached;
  piece.jumps = false;
  if (!has_friction_ || !reached_ || keeps(piece.as_told)) return reached_;
  piece.as_taken = curve_.prove(begin, piece.end, CorrectionCurve::Friction::as_taken).worst;
  piece.as_taken.tip_mm += of_centre;
  piece.jumps = turns_.tip_jump_mm(begin.sign, piece.end.sign) > allowed_.tip_mm;
  return true;
}

void PointChooser::fit_arc(const PieceEnd& begin, Piece& piece) {
  PieceEnd end = piece.end;
  end.told = arcs_.end_of(begin, end.fraction, end.told);
  end.arc = arcs_.between(begin, end);
  if (!end.arc) {
    piece.is_long = piece.share > 2 * least_share_ && arcs_.is_long(piece.share);
    return;
  }
  piece.end = end;
  piece.corrected.pose = end.told;
}

bool PointChooser::turns_bit_by_bit(const PieceEnd& begin) const {
  if (block_share_ * whole_way(move_->path.curve) >= kSlowMm) return false;
  const machine::PerStrut<double> soon = turns_.sign_at_end(begin, begin.fraction + block_share_);
  return turns_.tip_jump_mm(begin.sign, soon) <= allowed_.tip_mm;
}

// Where a piece ends that is too long; its own end where no shorter one is better, or the time of a block allows none.
// Where friction is taken to turn the sooner the better, but not within less than a block's time: the tip jumps either
// way. At a feed so slow that such a block hardly moves, it turns bit by bit, and half the length is turned less. Where
// many short pieces do not end it, or it turns otherwise than it is taken to, length does not matter.
double PointChooser::shortened(const PieceEnd& begin, double last, const Piece& piece) const {
  const double end = piece.end.fraction;
  const bool at_once = piece.jumps && short_pieces_ < kManyShort;
  const double least = at_once ? block_share_ : least_share_;
  if (keeps(piece.as_told) || last - begin.fraction < 2 * least) return end;
  double shorter = 0;
  if (at_once && turns_bit_by_bit(begin)) shorter = piece.share / 2;
  if (!at_once) {
    if (keeps(piece.as_taken)) return end;
    shorter = piece.share * kNearer / std::sqrt(over(piece.as_taken));
    // As many pieces of one length as that makes.
    if (shorter > least) shorter = (last - begin.fraction) / std::ceil((last - begin.fraction) / shorter);
  }
  const double to = std::min(begin.fraction + std::max(shorter, least), last - least);
  return to < end - kSlack * piece.share ? to : end;
}

void PointChooser::accept(const Piece& piece) {
  short_pieces_ = piece.share < 2 * block_share_ ? short_pieces_ + 1 : 0;
  const double tip_mm = piece.as_told.tip_mm + rounding_.tip_mm;
  const double turned_rad = piece.as_told.turned_rad + rounding_.turned_rad;
  const double turned_deg = turned_rad / kDeg;
  chosen_.push_back({piece.place, piece.corrected, piece.end.arc, {tip_mm, turned_rad}});
  broken_in_a_row_ = keeps(piece.as_told) ? 0 : broken_in_a_row_ + 1;
  if (keeps(piece.as_told)) {
    bound_.kept_mm = std::max(bound_.kept_mm, tip_mm);
    bound_.kept_deg = std::max(bound_.kept_deg, turned_deg);
    return;
  }
  BrokenBound& broken = keeps(piece.as_taken) || piece.jumps ? bound_.at_turns : bound_.by_time;
  ++broken.pieces;
  if (move_->seconds) broken.seconds += piece.share * *move_->seconds;
  broken.off_mm.take(tip_mm, move_->path.place());
  broken.off_deg.take(turned_deg, move_->path.place());
}

}  // namespace plumbline::compensate

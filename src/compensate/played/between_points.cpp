#include "compensate/played/between_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.hpp"
#include "compensate/bound/told_way.hpp"
#include "machine/orientation.hpp"
#include "path/figures.hpp"

namespace plumbline::compensate {
namespace {

constexpr std::uint64_t kTurnsEvery = 512;  // pieces, at which the effect of a strut's friction is worked out again
constexpr double kFirstCredit = 10'000;     // plays
constexpr double kCreditPerPiece = 0.04;
constexpr double kPromising = 0.6;   // of the largest found so far: from there on a part is looked at closely
constexpr std::size_t kAlways = 24;  // of the pieces of a block, where the first blocks are played anyway
constexpr double kNoWayMm = 1e-9;    // mm and deg
constexpr double kSaturated = 2.65;  // tanh is 0.99
constexpr double kHalfTurnDeg = 180;
constexpr int kProjections = 6;
constexpr int kRefinements = 10;
constexpr std::array kCloseLook{0.125, 0.25, 0.375, 0.625, 0.75, 0.875};

Vector3<double> xyz(const AxisWords& words) { return {words[Axis::X], words[Axis::Y], words[Axis::Z]}; }
Vector3<double> abc(const AxisWords& words) { return {words[Axis::A], words[Axis::B], words[Axis::C]}; }

bool goes(const path::Curve& curve) {
  return curve.linear_mm() > kNoWayMm || path::largest_turn_deg(curve.delta()) > kNoWayMm;
}

// Of a tip from the nearest point of a path, mm, or something above that which is at most `enough`; `fraction` is where
// to begin.
double distance_mm(const MovePath& path, const Vector3<double>& tip_mm, double fraction, double enough) {
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i <= kProjections; ++i) {
    const Target at = path.target(fraction, std::nullopt);
    const Vector3<double> off = tip_mm - xyz(at.pose);
    least = std::min(least, off.norm());
    if (least <= enough) break;
    const Vector3<double> slope = xyz(at.slope);
    const double bend = slope.squaredNorm() - off.dot(xyz(at.bend));
    if (!(bend > kNoWayMm * kNoWayMm)) break;
    const double next = std::clamp(fraction + off.dot(slope) / bend, 0.0, 1.0);
    if (std::abs(next - fraction) < 1e-12) break;
    fraction = next;
  }
  return least;
}

// Of an orientation from that of a path at a fraction, rad. A, B and C change evenly along it.
Vector3<double> off_turn(const Corrector& corrector, const MovePath& path, const Matrix3<double>& R_WP,
                         double fraction) {
  const AxisWords begin = path.pose(0);
  const AxisWords& delta = path.curve.delta();
  AxisWords words;
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) words[axis] = begin[axis] + fraction * delta[axis];
  return machine::logarithm<double>(R_WP * corrector.pose_of(words).R_WP.transpose());
}

// Of an orientation from the nearest one of a path, deg, or something above that which is at most `enough`.
double turn_deg(const Corrector& corrector, const MovePath& path, const Matrix3<double>& R_WP, double fraction,
                double enough) {
  const AxisWords& delta = path.curve.delta();
  const auto off_at = [&](double at) { return off_turn(corrector, path, R_WP, at); };
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i <= kProjections; ++i) {
    const Vector3<double> off = off_at(fraction);
    least = std::min(least, off.norm() / kDeg);
    if (least <= enough || abc(delta).squaredNorm() == 0) break;
    const double probe = fraction > 0.5 ? -1e-4 : 1e-4;
    const Vector3<double> slope = (off_at(fraction + probe) - off) / probe;
    if (slope.squaredNorm() < kNoWayMm * kNoWayMm) break;
    const double next = std::clamp(fraction - off.dot(slope) / slope.squaredNorm(), 0.0, 1.0);
    if (std::abs(next - fraction) < 1e-9) break;
    fraction = next;
  }
  return least;
}

// Both distances are at most those from where the path was to be at that time.
double distance_at_most_mm(const MovePath& path, const Vector3<double>& tip_mm, double fraction) {
  return (tip_mm - xyz(path.pose(fraction))).norm();
}

double turn_at_most_deg(const Corrector& corrector, const MovePath& path, const Matrix3<double>& R_WP,
                        double fraction) {
  return off_turn(corrector, path, R_WP, fraction).norm() / kDeg;
}

// A circle, or an axis that turns, may pass the same place twice.
bool comes_by_again(const path::Curve& curve) {
  return std::abs(curve.arc_deg()) > kHalfTurnDeg || path::largest_turn_deg(curve.delta()) > kHalfTurnDeg;
}

// How much of the effect of each strut's friction the machine is off the correction where that goes from sign to sign
// along the piece: friction itself turns at once.
machine::PerStrut<double> friction_shares(const machine::PerStrut<double>& before,
                                          const machine::PerStrut<double>& after) {
  machine::PerStrut<double> shares;
  for (int j = 0; j < machine::kStruts; ++j) {
    const double a = std::abs(before[j]);
    const double b = std::abs(after[j]);
    shares[j] = (before[j] * after[j] < 0 ? 1 + std::max(a, b) : 1 - std::min(a, b)) / 2;
  }
  return shares;
}

double friction_guess(const machine::PerStrut<double>& effect, const machine::PerStrut<double>& shares) {
  double guess = 0;
  for (int j = 0; j < machine::kStruts; ++j) guess += effect[j] * shares[j];
  return guess;
}

}  // namespace

// Of a block of one piece it is known beforehand where it is looked at first.
void BetweenPoints::foresee(std::span<const SentMove> moves) {
  first_looks_.forget_before(blocks_);
  std::uint64_t block = blocks_;
  for (const SentMove& move : moves) {
    if (!goes(move.path->curve)) continue;
    ++block;
    if (!must_play(block) || move.pieces.size() != 1 || move.as_it_stands) continue;
    const SentPiece& piece = move.pieces.front();
    const Part part{move.begin, piece.end, 0, piece.share, false, piece.arc, {}, {}};
    std::array<Target, FirstLooks::kFractions.size()> told;
    for (std::size_t i = 0; i < told.size(); ++i)
      told[i] = part.told(*move.path, move.seconds, FirstLooks::kFractions[i]);
    first_looks_.add(block, told);
  }
  first_looks_.play();
}

void BetweenPoints::cut(const SentMove& move) {
  const MovePath& path = *move.path;
  if (!goes(path.curve)) return;
  play_waiting(&path);
  pieces_ += move.pieces.size();
  if (corrector_.has_friction() && (blocks_ == 0 || pieces_ > kTurnsEvery)) {
    friction_ = corrector_.friction_turns(path.target(0.5, move.seconds));
    pieces_ = 0;
  }
  ++blocks_;
  credit_ += kCreditPerPiece * static_cast<double>(move.pieces.size());
  before_ = here_;
  here_ = before_ == &paths_.front() ? &paths_.back() : &paths_.front();
  *here_ = path;
  seconds_ = move.seconds;
  find_guesses(move);
  choose(move);
  sign_ = move.pieces.back().sign;
}

void BetweenPoints::rapid(const machine::PerStrut<double>& sign) {
  play_waiting(nullptr);
  before_ = here_ = nullptr;
  sign_ = sign;
}

void BetweenPoints::leave() {
  play_waiting(nullptr);
  before_ = here_ = nullptr;
  sign_.setZero();
}

void BetweenPoints::find_guesses(const SentMove& move) {
  const MovePath& path = *move.path;
  const std::span<const SentPiece> pieces = move.pieces;
  tip_.clear();
  turned_.clear();
  const double bend = path.curve.arc_deg() == 0 ? 0 : xyz(path.target(0.5, std::nullopt).bend).norm();
  ChordGuess places;
  ChordGuess turns;
  const AxisWords* last = &move.begin;
  const bool among_many = pieces.size() > PieceRanking::kGuesses;
  const machine::PerStrut<double>* sign = &sign_;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const SentPiece& piece = pieces[i];
    const AxisWords step = piece.wanted - *last;
    const AxisWords off = piece.end - piece.wanted;
    double left = places.next(xyz(step), xyz(off), bend * piece.share * piece.share);
    double turned = turns.next(abc(step), abc(off), 0);
    if (piece.arc) {
      left = piece.proven.tip_mm;
      turned = piece.proven.turned_rad / kDeg;
    }
    const PieceGuess::Kind turning = i == 0 ? PieceGuess::corner : PieceGuess::turn;
    double friction = 0;
    double friction_deg = 0;
    if (corrector_.has_friction()) {
      const machine::PerStrut<double> shares = friction_shares(*sign, piece.sign);
      friction = friction_guess(friction_.tip_mm, shares);
      friction_deg = friction_guess(friction_.turned_deg, shares);
    }
    tip_.keep({left + friction, friction <= left ? PieceGuess::smooth : turning, i, i}, among_many);
    turned_.keep({turned + friction_deg, friction_deg <= turned ? PieceGuess::smooth : turning, i, i}, among_many);
    last = &piece.wanted;
    sign = &piece.sign;
  }
}

void BetweenPoints::choose(const SentMove& move) {
  if (move.as_it_stands) {
    const AxisWords from = move.path->target(0, std::nullopt).pose;
    if (must_play(blocks_)) waiting_.push_back({from, from, 0, 1, true, {}, {}, {}});
    return;
  }
  choose_from(tip_, move);
  choose_from(turned_, move);
}

void BetweenPoints::choose_from(PieceRanking& ranking, const SentMove& move) {
  const bool must_play_block = must_play(blocks_);
  if (!must_play_block && credit_ + kFirstCredit < static_cast<double>(plays_)) return;
  const std::span<const PieceGuess> guesses = ranking.sorted();
  for (std::size_t k = 0; k < guesses.size(); ++k) {
    const PieceGuess& guess = guesses[k];
    const bool must = must_play_block && (k == 0 || (k < kAlways && blocks_ <= kAllBlocks));
    if (!must && !ranking.promises(guess)) continue;
    const SentPiece& piece = move.pieces[guess.piece];
    Part part{{}, piece.end, 0, piece.share, false, piece.arc, {}, {}};
    part.begin = guess.piece == 0 ? move.begin : move.pieces[guess.piece - 1].end;
    for (std::size_t i = 0; i < guess.piece; ++i) part.from += move.pieces[i].share;
    auto kept = std::find_if(waiting_.begin(), waiting_.end(), [&](const Part& p) { return p.from == part.from; });
    if (kept == waiting_.end()) kept = waiting_.insert(kept, part);
    (&ranking == &tip_ ? kept->tip : kept->turned) = guess;
  }
}

void BetweenPoints::play_waiting(const MovePath* next) {
  for (const Part& part : waiting_) play(part, next);
  waiting_.clear();
}

// What the control is told there.
Target BetweenPoints::Part::told(const MovePath& path, std::optional<double> seconds, double fraction) const {
  Target target = path.target(on_path(fraction), seconds);
  if (along_curve) return target;
  const ToldWay way(path, begin, end, share, arc);
  target.pose = way.pose(fraction);
  target.slope = way.slope(fraction);
  return target;
}

// How far it is off the path, at its nearest, as far as that can be more than enough.
void BetweenPoints::measure(const Part& part, const Enough& enough, Look& look, const MovePath* next) {
  if (!look.played) return;
  const double at = part.on_path(look.fraction);
  const Vector3<double> tip_mm = look.played->stands.p_WT / kMm;
  const Matrix3<double>& R_WP = look.played->stands.R_WP;
  const auto beside = [&](const MovePath& path, double from) {
    if (look.tip_mm > enough.tip_mm)
      look.tip_mm = std::min(look.tip_mm, distance_mm(path, tip_mm, from, enough.tip_mm));
    if (look.turned_deg > enough.turned_deg)
      look.turned_deg = std::min(look.turned_deg, turn_deg(corrector_, path, R_WP, from, enough.turned_deg));
  };
  beside(*here_, at);
  const bool begins = part.from == 0;
  const bool ends = part.from + part.share > 1 - FirstLooks::kEdge;
  for (const double end : {0.0, 1.0}) {
    if ((begins || ends) && comes_by_again(here_->curve)) beside(*here_, end);
    if (before_ != nullptr && begins) beside(*before_, end);
    if (next != nullptr && ends) beside(*next, end);
  }
  tip_.found.take(look.tip_mm, here_->place());
  turned_.found.take(look.turned_deg, here_->place());
}

// The part at these fractions, played together; what is found there is at most what it says. Holds until the next call.
std::span<BetweenPoints::Look> BetweenPoints::sample(const Part& part, std::span<const double> fractions) {
  std::span<const std::optional<PlayedTip>> played;
  if (looked_.empty()) played = first_looks_.of(blocks_);
  if (played.empty()) {
    told_.clear();
    for (const double fraction : fractions) told_.push_back(part.told(*here_, seconds_, fraction));
    corrector_.play(told_, played_);
    played = played_.all();
  }
  sampled_.clear();
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    ++plays_;
    Look& look = sampled_.emplace_back(Look{fractions[i], 0, 0, played[i]});
    if (look.played) {
      const double at = part.on_path(look.fraction);
      look.tip_mm = distance_at_most_mm(*here_, look.played->stands.p_WT / kMm, at);
      look.turned_deg = turn_at_most_deg(corrector_, *here_, look.played->stands.R_WP, at);
    } else if (gave_way_line_ == 0) {
      gave_way_line_ = here_->line;
    }
  }
  return sampled_;
}

// Its ends and its middle; both sides of the places where a strut turns; where that is promising, what lies between,
// and the neighbourhood of the worst place.
void BetweenPoints::play(const Part& part, const MovePath* next) {
  const AxisWords way = part.end - part.begin;
  if (!part.along_curve && !part.arc && length_mm(way) < kNoWayMm && path::largest_turn_deg(way) < kNoWayMm) return;
  const double tip_before = tip_.found.value;
  const double turned_before = turned_.found.value;
  const Enough enough{std::min(kPromising * tip_before, tip_.known(part.tip)),
                      std::min(kPromising * turned_before, turned_.known(part.turned))};
  const auto look_at = [&](std::span<const double> fractions) {
    for (Look& at : look(part, fractions)) measure(part, enough, at, next);
  };
  const auto most = [&](double Look::*figure) {
    double largest = 0;
    for (const Look& at : looked_) largest = std::max(largest, at.*figure);
    return largest;
  };
  looked_.clear();
  look_at(FirstLooks::kFractions);
  if (const std::vector<double> turns = beside_turns(); !turns.empty()) look_at(turns);
  const bool tip_promises = most(&Look::tip_mm) > kPromising * tip_before;
  const bool turn_promises = most(&Look::turned_deg) > kPromising * turned_before;
  if (tip_promises || turn_promises) {
    look_at(kCloseLook);
    std::sort(looked_.begin(), looked_.end(), [](const Look& a, const Look& b) { return a.fraction < b.fraction; });
    if (tip_promises && most(&Look::tip_mm) > tip_before) refine(part, &Look::tip_mm, next);
    if (turn_promises && most(&Look::turned_deg) > turned_before) refine(part, &Look::turned_deg, next);
  }
  const auto found = [](const PieceRanking& ranking, double before, double here) {
    return ranking.found.value > before ? ranking.found.value : here;
  };
  tip_.learn(part.tip, found(tip_, tip_before, most(&Look::tip_mm)));
  turned_.learn(part.turned, found(turned_, turned_before, most(&Look::turned_deg)));
}

std::span<BetweenPoints::Look> BetweenPoints::look(const Part& part, std::span<const double> fractions) {
  const std::span<const Look> seen = sample(part, fractions);
  looked_.insert(looked_.end(), seen.begin(), seen.end());
  return std::span(looked_).last(seen.size());
}

// Both sides of the places where the speed of a strut passes through zero, between the first and the last look.
std::vector<double> BetweenPoints::beside_turns() const {
  const machine::PerStrut<double> first = looked_.front().speed();
  const machine::PerStrut<double> change = looked_.back().speed() - first;
  std::vector<double> beside;
  for (int j = 0; j < machine::kStruts; ++j) {
    if (!(first[j] * (first[j] + change[j]) < 0)) continue;
    const double half_turn = kSaturated * corrector_.turning_speed() / std::abs(change[j]);
    for (const double fraction : {-first[j] / change[j] - half_turn, -first[j] / change[j] + half_turn}) {
      if (fraction > 0 && fraction < 1) beside.push_back(fraction);
    }
  }
  return beside;
}

// By thirds about the worst place that was looked at.
void BetweenPoints::refine(const Part& part, double Look::*figure, const MovePath* next) {
  const auto top = std::max_element(looked_.begin(), looked_.end(),
                                    [&](const Look& a, const Look& b) { return a.*figure < b.*figure; });
  double low = top == looked_.begin() ? 0 : std::prev(top)->fraction;
  double high = std::next(top) == looked_.end() ? 1 : std::next(top)->fraction;
  for (int i = 0; i < kRefinements; ++i) {
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    const std::span<Look> both = sample(part, std::array{a, b});
    for (Look& at : both) measure(part, {}, at, next);
    const bool rises = both[0].*figure < both[1].*figure;
    (rises ? low : high) = rises ? a : b;
  }
}

}  // namespace plumbline::compensate

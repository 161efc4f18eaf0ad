#include "compensate/move_corrector.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "compensate/move_reader.hpp"

namespace plumbline::compensate {
namespace {

constexpr int kManyPieces = 10'000;
constexpr int kTogether = 256;  // pieces: their targets stay in the cache

}  // namespace

const CorrectedMove& MoveCorrector::correct(const Move& move, const AxisWords& standing, const WordsOfMove& words) {
  begin(move, standing);
  if (move.is_rapid()) {
    correct_rapid();
  } else if (goes_nowhere(move.path.curve) && standing_sign_) {
    stand();
  } else if (chooser_) {
    correct_by_bound(words);
  } else {
    correct_cut();
  }
  if (!result_.signs.empty()) standing_sign_ = result_.signs.back();
  return result_;
}

const CorrectedMove& MoveCorrector::correct_places(const Move& move, std::span<const AxisWords> places,
                                                   const AxisWords& standing) {
  begin(move, standing);
  for (const AxisWords& words : places) {
    take(move.path.at_rest(words), words);
    if (stops()) break;
  }
  return result_;
}

void MoveCorrector::begin(const Move& move, const AxisWords& standing) {
  result_.move = move;
  result_.standing = standing;
  result_.points.clear();
  result_.signs.clear();
  result_.violations.clear();
  result_.bound = {};
  result_.proven.clear();
}

void MoveCorrector::note(std::vector<machine::Violation> violations) {
  if (at_violation_ == AtViolation::go_on) return keep_worst(result_.violations, violations);
  for (machine::Violation& violation : violations) result_.violations.push_back(std::move(violation));
}

bool MoveCorrector::take(const Target& target, const AxisWords& words) {
  return take(target, words, corrector_.correct(target));
}

// False where no command leads there.
bool MoveCorrector::take(const Target& target, const AxisWords& words, const Corrected& corrected) {
  if (corrected.converged && corrected.within_limits) {
    keep(corrected, words);
    return true;
  }
  Command command = compensate::command(corrector_, limits_, target, corrected);
  note(std::move(command.violations));
  if (!command.corrected.converged) {
    note({{std::string(kOutOfReach), 0, 0, 0, ""}});
    return false;
  }
  keep(command.corrected, words);
  return true;
}

void MoveCorrector::keep(const Corrected& corrected, const AxisWords& words) {
  const MovePath& path = result_.move.path;
  AxisWords nominal = words;
  AxisWords shift = path.frame.from_pose(corrected.pose) - nominal;
  for (const Axis axis : kAllAxes) {
    if (!path.at_zero.contains(axis)) continue;
    nominal[axis] = 0;
    shift[axis] = 0;
  }
  if (path.frame.tilted) {
    for (const Axis axis : {Axis::A, Axis::B, Axis::C}) shift[axis] = result_.standing[axis];
  }
  result_.points.push_back({nominal, shift, 1});
  result_.signs.push_back(corrected.sign);
}

void MoveCorrector::expect(const PointsAhead* points, const MoveAhead* move) {
  expected_ = points;
  expected_move_ = points != nullptr ? move : nullptr;
  if (points == nullptr || points->number == number_) return;
  number_ = points->number;
  met_ = 0;
}

// The very move whose points were corrected.
void MoveCorrector::take_expected(const MoveAhead& ahead) {
  const int pieces = ahead.move.pieces;
  for (int piece = 1; piece <= pieces && !stops(); ++piece) {
    const std::size_t i = ahead.first + static_cast<std::size_t>(piece) - 1;
    const AxisWords end = ahead.move.path.curve.at(ahead.move.fraction(piece));
    if (take(expected_->targets[i], end, expected_->corrections[i])) result_.points.back().share = 1.0 / pieces;
    met_ = i + 1;
  }
}

// False, and nothing is taken: the first of its pieces does not end where one was expected to.
bool MoveCorrector::take_expected() {
  const Move& move = result_.move;
  const std::vector<Target>& targets = expected_->targets;
  for (int piece = 1; piece <= move.pieces && !stops(); ++piece) {
    const path::CurvePoint end = move.path.curve.point(move.fraction(piece));
    const Target target = move.path.target(end, move.seconds);
    const auto found = std::find(targets.begin() + static_cast<std::ptrdiff_t>(met_), targets.end(), target);
    if (found == targets.end() && piece == 1) return false;
    bool taken = false;
    if (found == targets.end()) {
      taken = take(target, end.at);
    } else {
      met_ = static_cast<std::size_t>(found - targets.begin()) + 1;
      taken = take(target, end.at, expected_->corrections[met_ - 1]);
    }
    if (taken) result_.points.back().share = 1.0 / move.pieces;
  }
  return true;
}

void MoveCorrector::correct_rapid() {
  const Move& move = result_.move;
  const nc::Motion& motion = *move.motion;
  const Target end = move.begin_known ? move.path.target(1, std::nullopt) : move.path.at_rest(motion.to);
  if (!take(end, motion.to) || stops() || !move.begin_known) return;
  note(check_way(corrector_, limits_, move.path.at_rest(motion.from), end, result_.commanded(0)));
}

// Where the tool stands, the struts keep the friction of the way there.
void MoveCorrector::stand() {
  const nc::Motion& motion = *result_.move.motion;
  result_.points.push_back({motion.to, result_.standing, 1});
  result_.signs.push_back(*standing_sign_);
}

void MoveCorrector::correct_cut() {
  const Move& move = result_.move;
  if (at_violation_ == AtViolation::stop && move.pieces > kManyPieces) {
    // A slip is seen at its end, before all of them are corrected.
    const Target end = move.path.target(1, move.seconds);
    note(machine::check_programmed(limits_, corrector_.pose_of(end.pose)));
    if (stops()) return;
  }
  if (expected_move_ != nullptr) return take_expected(*expected_move_);
  if (expected_ != nullptr && move.pieces <= kFewPieces && take_expected()) return;
  for (int first = 1; first <= move.pieces; first += kTogether) {
    const int last = std::min(first + kTogether - 1, move.pieces);
    points_.clear();
    targets_.clear();
    for (int i = first; i <= last; ++i) {
      points_.push_back(move.path.curve.point(move.fraction(i)));
      targets_.push_back(move.path.target(points_.back(), move.seconds));
    }
    corrector_.correct(targets_, corrections_);
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      if (take(targets_[i], points_[i].at, corrections_[i])) result_.points.back().share = 1.0 / move.pieces;
      if (stops()) return;
    }
  }
}

void MoveCorrector::correct_by_bound(const WordsOfMove& words) {
  const Move& move = result_.move;
  ControlBefore before{std::nullopt, standing_sign_.value_or(machine::PerStrut<double>::Zero()), words};
  if (at_violation_ == AtViolation::stop) before.told = move.path.in_base_frame(move.motion->from + result_.standing);
  double from = 0;
  for (const ChosenPoint& point : chooser_->choose(move, before)) {
    keep(point.corrected, point.place.work);
    result_.points.back().share = point.place.fraction - from;
    result_.points.back().arc = point.arc;
    result_.proven.push_back(point.proven);
    from = point.place.fraction;
  }
  note(std::move(chooser_->violations()));
  if (!chooser_->reached()) note({{std::string(kOutOfReach), 0, 0, 0, ""}});
  result_.bound = chooser_->bound();
}

}  // namespace plumbline::compensate

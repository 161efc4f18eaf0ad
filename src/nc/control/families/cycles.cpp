// Canned cycles: G73, G74 and G81 to G89 in any plane, as LinuxCNC makes them [measured].
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/control/families/cycle_codes.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kWrittenDigits = 1e10;  // decimals that a length may have been written with
constexpr double kSameShift = 1e-6;      // mm
constexpr double kNoise = 1e-13;         // and the rounding of a conversion
constexpr char kFeedOut = '1';           // FA=, as grammar/okuma.toml calls it

// A cycle at one hole after the other.
class CycleRun {
 public:
  explicit CycleRun(Execution& run)
      : run_(run), control_(run.control), cycle_(run.control.cycle), axes_(axes_of(run.control.modal.plane)) {}

  void make();

 private:
  void take_unit();
  void take_words();
  void take_words_of_osp(bool is_new);
  double inherited(char letter, double before, double value, bool needed) const;
  void check_level() const;
  void check_distance_mode();
  void check_shift();
  void hole(bool first);
  void at_hole();
  double in_unit(double mm) const;
  void pecks();
  void back_bore();
  void go(MotionKind kind, double first, double second, double level);
  void along(MotionKind kind, double level) { go(kind, first_, second_, level); }
  void along_tap(double level);
  void wait();
  bool waits_as_osp() const { return run_.dialect.behaviour.return_levels && cycle_.dwell_s > 0; }

  Execution& run_;
  Control& control_;
  Cycle& cycle_;
  PlaneAxes axes_;
  int code_ = 0;
  bool goes_on_ = false;  // the same cycle is in force: words that are missing are inherited
  bool as_fanuc_ = false;
  double first_ = 0, second_ = 0, first_step_ = 0, second_step_ = 0;
  double r_ = 0, bottom_ = 0, clear_ = 0, level_ = 0, offset_level_ = 0;
  double start_ = 0;  // where the first of these cycles began
  double unit_ = 1;   // mm
  double feed_ = 0;   // of the way out; 0: as that of the way in
};

double CycleRun::inherited(const char letter, double before, double value, bool needed) const {
  if (run_.words.has(letter)) return value;
  if (needed && !goes_on_) run_.need(letter, fmt::format("G{}", code_));
  return before;
}

// What a cycle inherits is kept as numbers: after G20 the R of 5 mm is one of 5 inches [LinuxCNC, measured].
void CycleRun::take_unit() {
  const double ratio = unit_ / std::exchange(cycle_.unit_mm, unit_);
  if (ratio == 1 || !(goes_on_ || cycle_.begun)) return;
  if (as_fanuc_) {
    run_.refuse(run_.motion_code(), codes::kNotInterpreted,
                "what the cycle inherits after a change of units depends on the control",
                "write G80 before the change (G20, G21), and the cycle anew");
  }
  for (double* value :
       {&cycle_.start, &cycle_.r, &cycle_.bottom, &cycle_.peck, &cycle_.ijk[0], &cycle_.ijk[1], &cycle_.ijk[2]}) {
    *value *= ratio;
  }
}

void CycleRun::take_words() {
  const auto length = [&](char letter) {
    const Word* const word = run_.words.find(letter);
    return word == nullptr ? 0 : run_.length(*word);
  };
  const auto number = [&](char letter) {
    const Word* const word = run_.words.find(letter);
    return word == nullptr ? 0 : word->value;
  };
  cycle_.r = inherited('R', cycle_.r, length('R'), true);
  const char normal = letter(axes_.third);
  cycle_.bottom = inherited(normal, cycle_.bottom, length(normal), true);
  const bool is_new = run_.dialect.behaviour.return_levels ? run_.motion_word != nullptr : as_fanuc_ && !goes_on_;
  if (is_new) cycle_.dwell_s = 0;  // G80 and G0 end what was kept [Haas 96-8000, p. 185]
  const bool dwells = code_ == kDrillDwell || code_ == kBoreStop || code_ == kBoreByHand || code_ == kBoreDwell;
  cycle_.dwell_s = inherited('P', cycle_.dwell_s, number('P'), dwells && !as_fanuc_);
  cycle_.dwell_s = run_.words.has('P') ? cycle_.dwell_s * run_.dialect.behaviour.dwell_p_s : cycle_.dwell_s;
  const bool of_osp = run_.dialect.behaviour.return_levels;
  const bool pecks = code_ == kChipBreaking || code_ == kPeck;
  const char peck = of_osp && run_.words.has('I') ? 'I' : 'Q';
  cycle_.peck = inherited(peck, cycle_.peck, length(peck), pecks);
  for (std::size_t i = 0; i < 3; ++i) {
    cycle_.ijk[i] = inherited(kCentreLetters[i], cycle_.ijk[i], length(kCentreLetters[i]), code_ == kBackBore);
  }
  if (const Word* const word = run_.words.find('P')) check_milliseconds(run_, *word);
  if (of_osp) take_words_of_osp(is_new);
  if (cycle_.dwell_s < 0) {
    run_.refuse(*run_.words.find('P'), codes::kNegative, "the time to wait is negative", "write P0 or more");
  }
  if (pecks && cycle_.peck <= 0) {
    const Word* const word = run_.words.find(peck);
    run_.refuse(word != nullptr ? *word : run_.motion_code(), codes::kOutOfRange, "a peck has no depth",
                fmt::format("write {} greater than 0", peck));
  }
}

// With J the tool goes up to R whenever that depth has come together (setting); FA is the feed out of the hole.
void CycleRun::take_words_of_osp(bool is_new) {
  if (is_new) {
    cycle_.stays = false;
    cycle_.peck_to_r = cycle_.feed_out = 0;
  }
  cycle_.stays = cycle_.stays || (run_.words.letters() & run_.motion->stays_mask) != 0;
  if (const Word* const depth = run_.words.find('J')) cycle_.peck_to_r = run_.length(*depth);
  const Word* const feed = run_.words.find(kFeedOut);
  if (feed == nullptr) return;
  cycle_.feed_out = feed->value;
  if (cycle_.feed_out > 0) return;
  run_.refuse(*feed, codes::kNegative, "the feed out of the hole is none", "write a feed greater than 0");
}

void CycleRun::check_level() const {
  if (r_ < bottom_) {
    run_.refuse(run_.motion_code(), codes::kOutOfRange,
                fmt::format("R lies below {}, the bottom of the hole", letter(axes_.third)),
                "a hole goes down from R along the normal of the plane");
  }
  const bool pecks = code_ == kChipBreaking || code_ == kPeck;
  if (pecks) check_motions(run_, (r_ - bottom_) / cycle_.peck);
}

void CycleRun::make() {
  code_ = run_.motion->value;
  unit_ = control_.length_unit();
  as_fanuc_ = run_.dialect.behaviour.fanuc_cycles;
  goes_on_ = control_.motion_row == run_.motion;
  if (as_fanuc_) goes_on_ = cycle_.begun;  // until G80 or a move of another kind [Haas 96-8000, p. 185]
  if (as_fanuc_) check_distance_mode();
  if (as_fanuc_) check_shift();
  take_unit();
  take_words();
  level_ = control_.position[axes_.third];
  if (!cycle_.begun) cycle_.start = level_;
  cycle_.begun = true;
  double start = start_ = cycle_.start;
  first_ = control_.position[axes_.first];
  second_ = control_.position[axes_.second];
  r_ = cycle_.r;
  bottom_ = cycle_.bottom;
  offset_level_ = cycle_.ijk[index(axes_.third)];  // J in G18, I in G19 [LinuxCNC, measured]
  const auto word = [&](Axis axis, double missing) {
    return run_.words.find(axis) != nullptr ? run_.value(axis) : missing;
  };
  if (control_.modal.incremental) {
    first_step_ = word(axes_.first, 0);
    second_step_ = word(axes_.second, 0);
    r_ += start;
    bottom_ += r_;
    offset_level_ += bottom_;
  } else {
    first_ = word(axes_.first, first_);
    second_ = word(axes_.second, second_);
  }
  check_level();
  if (!as_fanuc_) check_cycle_spindle(run_, code_);
  if (start < r_ && !as_fanuc_) {
    go(MotionKind::rapid, control_.position[axes_.first], control_.position[axes_.second], r_);
    start = level_ = r_;
  }
  clear_ = run_.dialect.behaviour.return_levels ? cycle_return_level(run_, r_)
           : control_.modal.retract_to_r        ? r_
                                                : start;
  if (run_.dialect.behaviour.return_levels) check_cycle_start(run_, {first_, second_}, r_, clear_);
  const Word* count = run_.words.find('L');
  if (as_fanuc_ && count == nullptr) count = run_.words.find('K');
  const int holes = count == nullptr ? 1 : run_.whole(*count, as_fanuc_ ? 0 : 1, kNoLimit);
  check_motions(run_, holes);
  for (int i = 0; i < holes; ++i) hole(i == 0);
}

void CycleRun::hole(bool first) {
  check_motions(run_, 1);
  first_ += first_step_;
  second_ += second_step_;
  if (run_.words.polar() && (first || control_.modal.incremental)) {
    const std::array<double, 2> there = polar_end(run_, first_, second_);
    first_ = there[0];
    second_ = there[1];
  }
  Hole hole;
  hole.approach_begin = run_.holes.empty() ? 0 : run_.holes.back().end;
  const double level = first && (level_ > r_ || as_fanuc_) ? level_ : clear_;
  along(MotionKind::rapid, level);
  if (run_.chosen_row(Action::no_hole) != nullptr) return;
  hole.approach_end = run_.motions.size();
  if (level != r_) along(MotionKind::rapid, r_);
  hole.begin = run_.motions.size();
  at_hole();
  hole.end = run_.motions.size();
  hole.code = code_;
  hole.clear = clear_;
  hole.first = first_;
  hole.second = second_;
  hole.r = r_;
  hole.bottom = bottom_;
  const bool needless = run_.dialect.behaviour.return_levels && cycle_.dwell_s == 0;
  if ((run_.motion->word_mask & letter_bit('P')) != 0 && !needless) hole.dwell_s = cycle_.dwell_s;
  if (code_ == kBackBore) {
    hole.ijk = cycle_.ijk;
    (*hole.ijk)[index(axes_.third)] = offset_level_;
  }
  run_.holes.push_back(hole);
}

void CycleRun::at_hole() {
  feed_ = 0;
  if (code_ == kChipBreaking || code_ == kPeck) return pecks();
  if (code_ == kBackBore) return back_bore();
  const bool taps = code_ == kTapping || code_ == kLeftTapping;
  if (taps && !as_fanuc_ && control_.modal.plane != Plane::xy) {
    along_tap(bottom_);
    wait();
    along_tap(clear_);
    control_.position[axes_.first] = first_;
    control_.position[axes_.second] = second_;
    control_.position[axes_.third] = clear_;
    return;
  }
  along(MotionKind::feed, bottom_);
  const bool waits = code_ != kDrill && code_ != kBore;
  if (waits || waits_as_osp()) wait();
  feed_ = cycle_.feed_out;
  if (code_ == kBore) along(MotionKind::feed, r_);
  if (code_ == kBoreByHand) {
    control_.position[axes_.third] = clear_;  // the operator takes it there
    return;
  }
  const bool feeds_out = taps || code_ == kBoreDwell;
  if (as_fanuc_ && feeds_out) along(MotionKind::feed, r_);
  if (as_fanuc_ && feeds_out && clear_ == r_) return;
  along(feeds_out && !as_fanuc_ ? MotionKind::feed : MotionKind::rapid, clear_);
}

// Whether an R and a Z that G91 counted mean the same under G90 is not known.
void CycleRun::check_distance_mode() {
  const bool inherits = !run_.words.has('R') || !run_.words.has(letter(axes_.third));
  if (goes_on_ && inherits && cycle_.incremental != control_.modal.incremental) {
    run_.refuse(run_.motion_code(), codes::kNotInterpreted,
                "what R and the depth of the cycle mean after the change between G90 and G91 depends on the control",
                "state both again behind the change");
  }
  cycle_.incremental = control_.modal.incremental;
}

// Whether the level where the cycles began, and R, are kept as words or as places of the machine is not known.
void CycleRun::check_shift() {
  const double shift = control_.frame.to_machine(control_.position)[axes_.third] - control_.position[axes_.third];
  if (goes_on_ && std::abs(shift - cycle_.shift) > kSameShift) {
    run_.refuse(run_.motion_code(), codes::kNotInterpreted,
                fmt::format("what a drilling cycle keeps of its levels when the zero of {} changes is not known",
                            letter(axes_.third)),
                "write G80 before the change, and state the cycle anew after it");
  }
  cycle_.shift = shift;
}

// A length in the program's unit, as the control counts pecks: in mm the last of them could fall short of the bottom by
// a rounding, and one more be made.
double CycleRun::in_unit(double mm) const {
  const double value = mm / unit_;
  const double written = std::round(value * kWrittenDigits) / kWrittenDigits;
  return std::abs(value - written) < kNoise ? written : value;
}

void CycleRun::pecks() {
  const bool increments = control_.modal.incremental;
  const double step = in_unit(cycle_.peck);
  const double r = in_unit(cycle_.r) + (increments ? in_unit(start_) : 0);
  const double bottom = in_unit(cycle_.bottom) + (increments ? r : 0);
  const double together = in_unit(cycle_.peck_to_r) - kNoise;
  double up_at = r - together;
  for (double at = r - step; at > bottom; at -= step) {
    const double depth = at * unit_;
    along(MotionKind::feed, depth);
    const bool far = cycle_.peck_to_r > 0 && at <= up_at;
    if (far) up_at = at - together;
    if (code_ == kPeck || far) along(MotionKind::rapid, r_);
    along(MotionKind::rapid, depth + run_.dialect.behaviour.peck_gap_mm);
  }
  along(MotionKind::feed, bottom_);
  if (waits_as_osp()) wait();
  along(MotionKind::rapid, clear_);
}

// The axes of the plane, one place on.
void CycleRun::along_tap(double level) {
  Motion motion;
  motion.kind = MotionKind::feed;
  motion.to = control_.position;
  const bool zx = control_.modal.plane == Plane::zx;
  motion.to[axes_.first] = zx ? second_ : level;
  motion.to[axes_.second] = zx ? level : first_;
  motion.to[axes_.third] = zx ? first_ : second_;
  motion.known_after = control_.known;
  motion.feed = feed_of_move(run_, true);
  add_motion(run_, motion);
}

// Down beside the hole, up into it from below.
void CycleRun::back_bore() {
  const double first = first_ + cycle_.ijk[index(axes_.first)];
  const double second = second_ + cycle_.ijk[index(axes_.second)];
  go(MotionKind::rapid, first, second, r_);
  go(MotionKind::rapid, first, second, bottom_);
  along(MotionKind::rapid, bottom_);
  along(MotionKind::feed, offset_level_);
  along(MotionKind::feed, bottom_);
  go(MotionKind::rapid, first, second, bottom_);
  go(MotionKind::rapid, first, second, clear_);
  along(MotionKind::rapid, clear_);
}

void CycleRun::go(MotionKind kind, double first, double second, double level) {
  Motion motion;
  motion.kind = kind;
  motion.to = control_.position;
  motion.to[axes_.first] = first;
  motion.to[axes_.second] = second;
  motion.to[axes_.third] = level;
  motion.known_after = control_.known;
  if (kind == MotionKind::feed) motion.feed = feed_ > 0 ? feed_ : feed_of_move(run_, true);
  add_motion(run_, motion);
}

void CycleRun::wait() {
  const bool taps = code_ == kTapping || code_ == kLeftTapping;
  if (as_fanuc_ && taps && cycle_.dwell_s <= 0) return;
  Motion motion;
  motion.kind = MotionKind::dwell;
  motion.to = control_.position;
  motion.known_after = control_.known;
  motion.dwell_s = cycle_.dwell_s;
  add_motion(run_, motion);
}

}  // namespace

void move_in_cycle(Execution& run) {
  need_offsets(run);
  if (run.machine_word != nullptr) {
    run.refuse(*run.machine_word, codes::kMachineMove, "G53 needs G0 or G1",
               "write the motion code into the block of G53");
  }
  check_cycle(run);
  run.control.known = run.control.modal.incremental ? run.control.known : run.control.known | run.axes;
  run.step.role = BlockRole::cycle;
  if (run.dialect.behaviour.return_levels && run.control.modal.incremental) {
    run.refuse(run.motion_code(), codes::kNotInterpreted,
               "what a cycle's words count from under G91 was found in no source", "write G90 before it");
  }
  CycleRun(run).make();
  // What P counts in a cycle of an OSP depends on its settings: such a hole stays a cycle, whose P stays as it is.
  const Cycle& cycle = run.control.cycle;
  const bool stays = run.dialect.behaviour.return_levels && (cycle.dwell_s != 0 || cycle.stays);
  const bool whole = (works_spindle(run.motion->value) || stays) && run.chosen_row(Action::no_hole) == nullptr;
  run.step.cycle = whole ? CycleForm::spindle : CycleForm::moves;
  run.step.holes = run.holes;
  const bool begins = run.control.modal.motion != MotionMode::cycle;
  if (begins) run.control.row_before_cycle = run.control.motion_row;
  run.control.motion_row = run.motion;
  run.control.modal.motion = MotionMode::cycle;
  if (run.motion->loses_position) lose_position(run, AxisSet{Axis::X, Axis::Y, Axis::Z});
}

}  // namespace plumbline::nc

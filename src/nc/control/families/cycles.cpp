// Canned cycles: G73, G74 and G81 to G89 in any plane, as LinuxCNC makes them [measured].
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/control/families/cycle_codes.hpp"
#include "nc/control/families/cycle_words.hpp"
#include "nc/control/families/hole_motions.hpp"
#include "nc/control/state/kept.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kSameShift = 1e-6;  // mm

// A cycle at one hole after the other.
class CycleRun {
 public:
  /// `known`: the axes whose places are known before it.
  CycleRun(Execution& run, AxisSet known)
      : run_(run),
        control_(run.control),
        cycle_(run.control.cycle),
        axes_(axes_of(run.control.modal.plane)),
        known_before_(known) {}

  void make();

 private:
  void check_level() const;
  void check_depth_of_haas(const Word& times) const;
  void lift();
  void check_distance_mode();
  void check_shift();
  void take_place();
  void make_hole(bool first);

  Execution& run_;
  Control& control_;
  Cycle& cycle_;
  PlaneAxes axes_;
  AxisSet known_before_;
  int code_ = 0;
  bool goes_on_ = false;  // the same cycle is in force: words that are missing are inherited
  bool as_fanuc_ = false;
  Hole hole_;
  CycleLevels levels_;
  double first_ = 0, second_ = 0, first_step_ = 0, second_step_ = 0;
  double level_ = 0;  // where the tool stands before
};

void CycleRun::check_level() const {
  if (hole_.r < hole_.bottom) {
    run_.refuse(run_.motion_code(), codes::kOutOfRange,
                fmt::format("R lies below {}, the bottom of the hole", letter(axes_.third)),
                "a hole goes down from R along the normal of the plane");
  }
  const bool pecks = code_ == kChipBreaking || code_ == kPeck;
  if (pecks) check_motions(run_, (hole_.r - hole_.bottom) / cycle_.peck);
}

// G73 Q2. K6: six times the same hole of a Fanuc; on a Haas the tool goes up to R after each 6 mm [H, G73].
void CycleRun::check_depth_of_haas(const Word& times) const {
  const bool pecks = code_ == kChipBreaking || code_ == kPeck;
  if (!pecks || times.value <= 1 || control_.modal.incremental || run_.dialect.behaviour.return_levels) return;
  run_.refuse(
      times, codes::kNotInterpreted,
      fmt::format("{} drills the same hole so many times on a Fanuc, and is a depth on a Haas", run_.text_of(times)),
      "leave it out: Q says how deep each peck goes; to repeat holes write G91 and the steps between them");
}

void CycleRun::take_place() {
  level_ = control_.position[axes_.third];
  if (!cycle_.begun) cycle_.start = level_;
  cycle_.begun = true;
  levels_.start = cycle_.start;
  first_ = control_.position[axes_.first];
  second_ = control_.position[axes_.second];
  hole_.r = cycle_.r;
  hole_.bottom = cycle_.bottom;
  levels_.offset = cycle_.ijk[index(axes_.third)];  // J in G18, I in G19 [LinuxCNC, measured]
  const auto word = [&](Axis axis, double missing) {
    return run_.words.find(axis) != nullptr ? run_.value(axis) : missing;
  };
  if (control_.modal.incremental) {
    first_step_ = word(axes_.first, 0);
    second_step_ = word(axes_.second, 0);
    hole_.r += levels_.start;
    hole_.bottom += hole_.r;
    levels_.offset += hole_.bottom;
  } else {
    first_ = word(axes_.first, first_);
    second_ = word(axes_.second, second_);
  }
}

// To R, where the tool stands.
void CycleRun::lift() {
  for (const Axis axis : {axes_.first, axes_.second}) {
    if (known_before_.contains(axis)) continue;
    run_.refuse(
        run_.motion_code(), codes::kPositionUnknown,
        fmt::format("the cycle lifts the tool to R where it stands, and where {} stands is not known", letter(axis)),
        fmt::format("move {0} and {1} by a G0 that names both before the cycle, or begin it above R",
                    letter(axes_.first), letter(axes_.second)));
  }
  hole_.first = control_.position[axes_.first];
  hole_.second = control_.position[axes_.second];
  HoleMotions(run_, hole_, levels_).along(MotionKind::rapid, hole_.r);
}

void CycleRun::make() {
  code_ = run_.motion->value;
  as_fanuc_ = run_.dialect.behaviour.fanuc_cycles;
  goes_on_ = control_.motion_row == run_.motion;
  if (as_fanuc_) goes_on_ = cycle_.begun;  // until G80 or a move of another kind [Haas 96-8000, p. 185]
  if (as_fanuc_) check_distance_mode();
  if (as_fanuc_) check_shift();
  take_cycle_words(run_, goes_on_);
  take_place();
  check_level();
  if (!as_fanuc_) check_cycle_spindle(run_, code_);
  double start = levels_.start;
  if (start < hole_.r && !as_fanuc_) {
    lift();
    start = level_ = hole_.r;
  }
  const bool returns = run_.dialect.behaviour.return_levels;
  hole_.clear = returns ? cycle_return_level(run_, hole_.r) : control_.modal.retract_to_r ? hole_.r : start;
  if (returns) check_cycle_start(run_, {first_, second_}, hole_.r, hole_.clear);
  const Word* count = run_.words.find('L');
  if (const Word* const times = as_fanuc_ ? run_.words.find('K') : nullptr) {
    if (count != nullptr && run_.motion->value != kBackBore) {
      run_.refuse(
          *times, codes::kNotInterpreted,
          "a Fanuc repeats a hole by K, a Haas by L; which of them counts beside the other was found in no source",
          "leave one of them out");
    }
    if (count == nullptr) count = times;
    check_depth_of_haas(*times);
  }
  const int holes = count == nullptr ? 1 : run_.whole(*count, as_fanuc_ ? 0 : 1, kNoLimit);
  const AxisSet plane{axes_.first, axes_.second};
  if (holes == 0 && !(run_.axes & plane).empty()) {
    run_.refuse(*count, codes::kNotInterpreted,
                "with a count of 0 nothing is drilled; whether the control goes to the place of the hole was found in "
                "no source",
                "leave the axes of the plane out of this block, or go there with G0 before");
  }
  check_motions(run_, holes);
  for (int i = 0; i < holes; ++i) make_hole(i == 0);
}

void CycleRun::make_hole(bool first) {
  check_motions(run_, 1);
  first_ += first_step_;
  second_ += second_step_;
  if (run_.words.polar() && (first || control_.modal.incremental)) {
    const std::array<double, 2> there = polar_end(run_, first_, second_);
    first_ = there[0];
    second_ = there[1];
  }
  hole_.first = first_;
  hole_.second = second_;
  HoleMotions motions(run_, hole_, levels_);
  Hole hole = hole_;
  hole.approach_begin = run_.holes.empty() ? 0 : run_.holes.back().end;
  const double level = first && (level_ > hole_.r || as_fanuc_) ? level_ : hole_.clear;
  motions.along(MotionKind::rapid, level);
  if (run_.chosen_row(Action::no_hole) != nullptr) return;
  hole.approach_end = run_.motions.size();
  if (level != hole_.r) motions.along(MotionKind::rapid, hole_.r);
  hole.begin = run_.motions.size();
  motions.at_hole();
  hole.end = run_.motions.size();
  hole.code = code_;
  hole.row = run_.motion;
  if (code_ == kChipBreaking || code_ == kPeck) hole.peck = cycle_.peck;
  hole.peck_to_r = cycle_.peck_to_r;
  hole.feed_out = cycle_.feed_out;
  const bool needless = run_.dialect.behaviour.return_levels && cycle_.dwell_s == 0;
  if ((run_.motion->word_mask & letter_bit('P')) != 0 && !needless) hole.dwell_s = cycle_.dwell_s;
  hole.dwell_pointed = hole.dwell_s && cycle_.dwell_pointed;
  if (code_ == kBackBore) {
    hole.ijk = cycle_.ijk;
    (*hole.ijk)[index(axes_.third)] = levels_.offset;
  }
  run_.holes.push_back(hole);
}

// Whether an R and a Z that G91 counted mean the same under G90 is not known.
void CycleRun::check_distance_mode() {
  const bool inherits = !run_.words.has('R') || !run_.words.has(letter(axes_.third));
  if (goes_on_ && inherits && cycle_.incremental != control_.modal.incremental) {
    run_.refuse(run_.motion_code(), codes::kNotInterpreted,
                "what R and the depth of the cycle mean after the change between G90 and G91 depends on the control",
                "state both again after the change");
  }
  cycle_.incremental = control_.modal.incremental;
}

// Whether the level where the cycles began, and R, are kept as words or as places of the machine is not known.
void CycleRun::check_shift() {
  const AxisWords at = control_.frame.tilted ? AxisWords{} : control_.position;  // askew, each hole has its own
  const double shift = control_.frame.to_machine(at)[axes_.third] - at[axes_.third];
  if (goes_on_ && std::abs(shift - cycle_.shift) > kSameShift) {
    run_.refuse(run_.motion_code(), codes::kNotInterpreted,
                fmt::format("what a drilling cycle keeps of its levels when the zero of {} changes is not known",
                            letter(axes_.third)),
                "write G80 before the change, and state the cycle anew after it");
  }
  cycle_.shift = shift;
}

// A hole that stays a cycle is shifted by its words: what the control leaves away of them is not known. Of its pecks
// (Q, I and J) it may be one peck more or less.
void check_digits_of_hole(const Execution& run) {
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    if (const Word* const word = run.words.find(axis)) check_digits_of_increment(run, *word, axis);
  }
  for (const char letter : {'R', 'Q', 'I', 'J'}) {
    if (const Word* const word = run.words.find(letter)) check_digits_of_increment(run, *word, Axis::Z);
  }
}

// Q, I and J of a block before, that drilled by moves or not at all.
void check_digits_of_pecks(const Execution& run) {
  constexpr double kOfQuantum = 1e-6;
  const int code = run.motion->value;
  if (!run.dialect.behaviour.return_levels || (code != kChipBreaking && code != kPeck)) return;
  const double quantum = kept_of_axis_word(run.dialect.behaviour, false, run.control.modal.inches, 1, true).quantum;
  for (const double depth : {run.control.cycle.peck, run.control.cycle.peck_to_r}) {
    const double quanta = depth / run.control.length_unit() / quantum;
    if (std::abs(quanta - std::round(quanta)) <= kOfQuantum) continue;
    run.refuse(run.motion_code(), codes::kNotInterpreted,
               fmt::format("this hole stays a cycle, and the pecks of a block before are finer than the {} mm that the "
                           "control keeps: how many it makes of them was found in no source",
                           quantum),
               "write the pecks (Q, or I and J) with 3 decimals");
  }
}

// Posts name X or Y at each hole [P onCyclePoint]; beside NCYL nothing is drilled, and the words wait for the holes.
void check_hole_is_named(const Execution& run) {
  const bool named = run.axes.contains(Axis::X) || run.axes.contains(Axis::Y);
  if (named || run.chosen_row(Action::no_hole) != nullptr || !run.dialect.behaviour.return_levels) return;
  run.refuse(run.motion_code(), codes::kNotInterpreted,
             "whether a block of a cycle without X and Y drills where the tool stands was found in no source",
             "name X or Y of the hole");
}

}  // namespace

void move_in_cycle(Execution& run) {
  need_offsets(run);
  if (run.machine_word != nullptr) {
    run.refuse(*run.machine_word, codes::kMachineMove,
               fmt::format("{0} needs G0 or G1", run.text_of(*run.machine_word)),
               fmt::format("write the motion code into the block of {0}", run.text_of(*run.machine_word)));
  }
  check_cycle(run);
  const AxisSet known = run.control.known;
  run.control.known = run.control.modal.incremental ? run.control.known : run.control.known | run.axes;
  run.step.role = BlockRole::cycle;
  if (run.dialect.behaviour.return_levels && run.control.modal.incremental) {
    run.refuse(run.motion_code(), codes::kNotInterpreted,
               "what a cycle's words count from under G91 was found in no source", "write G90 before it");
  }
  check_hole_is_named(run);
  const std::size_t first = run.motions.size();
  CycleRun(run, known).make();
  // The axes that the block names are known once it has moved them.
  if (run.motions.size() > first) run.motions[first].known_before = run.motions[first].known_before & known;
  // What P counts in a cycle of an OSP depends on its settings: such a hole stays a cycle, whose P stays as it is.
  const Cycle& cycle = run.control.cycle;
  const bool stays = cycle.stays || (run.dialect.behaviour.return_levels && cycle.dwell_s != 0);
  const bool keeps = works_spindle(run.motion->value) || stays;
  const bool whole = keeps && run.chosen_row(Action::no_hole) == nullptr;
  run.step.cycle = whole ? CycleForm::spindle : CycleForm::moves;
  if (keeps) check_digits_of_hole(run);
  if (whole) check_digits_of_pecks(run);
  run.step.holes = run.holes;
  const bool begins = run.control.modal.motion != MotionMode::cycle;
  if (begins) run.control.row_before_cycle = run.control.motion_row;
  run.control.motion_row = run.motion;
  run.control.modal.motion = MotionMode::cycle;
  if (run.motion->loses_position) lose_position(run, AxisSet{Axis::X, Axis::Y, Axis::Z});
}

}  // namespace plumbline::nc

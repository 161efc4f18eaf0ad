// Drilling cycles that are called by name with their values in brackets, once or after each move (MCALL) [C 2.1, 2.2].
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "nc/control/execution.hpp"
#include "nc/control/families/called_after.hpp"
#include "nc/control/families/called_tap.hpp"
#include "nc/control/families/called_values.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kMostPecks = 1e4;                                              // that are told one by one
constexpr double kNoStroke = 1e-9;                                              // mm
constexpr int kLiftFirst = 7, kLiftSecond = 8, kLiftAlong = 9, kLiftMode = 11;  // of CYCLE86

// Each depth but the last. False: so many that nobody reads them are left out.
template <class Make>
bool in_strokes(double from, double to, double stroke, Make make) {
  if ((from - to) / stroke > kMostPecks) return false;
  for (double depth = from - stroke; depth > to + kNoStroke; depth -= stroke) make(depth);
  return true;
}

double own_feed(const CalledValues& given, int place) {
  const double rate = given.length_mm(place);
  if (rate > 0) return rate;
  given.refuse(fmt::format("no source says at which feed it {} without {}", place == kFeedDown ? "cuts" : "goes back",
                           place == kFeedDown ? "FFR" : "RFF"),
               "give both feeds: FFR and RFF, its seventh and eighth values");
}

// One call of a cycle where the axes stand.
class CalledHole {
 public:
  CalledHole(Execution& run, const CycleCall& call, std::size_t approach)
      : run_(run),
        control_(run.control),
        call_(call),
        given_(run, call),
        places_(places_of(call)),
        axes_(axes_of(run.control.modal.plane)) {
    hole_.approach_begin = approach;
  }

  void make();

 private:
  void check() const;
  void check_simple() const;
  void take_levels();
  double depth_mm() const;
  void at_hole();
  void pecks();
  void tap_in_strokes();
  void lift();
  void go(MotionKind kind, double level, double feed = 0);
  void go_beside(double first_mm, double second_mm, double level);
  void feed_to(double level) { go(MotionKind::feed, level, feed_of_move(run_, true)); }
  void wait(double seconds);

  Execution& run_;
  Control& control_;
  const CycleCall& call_;
  CalledValues given_;
  Places places_;
  PlaneAxes axes_;
  Hole hole_;
  double last_share_ = 1;         // of the feed, at the bottom of a deep hole
  bool unknown_strokes_ = false;  // of the moves from here on
};

void CalledHole::check() const {
  if (static_cast<int>(call_.arguments.size()) > places_.last + 1) {
    given_.refuse("no source says what the last values in its brackets mean",
                  fmt::format("leave out what stands after the first {}", places_.last + 1));
  }
  if (!given_.value(kDepth) && !given_.value(kRelativeDepth)) {
    given_.refuse("it needs a depth", "write it as in CYCLE81(10,0,2,-15)");
  }
  if (given_.number(places_.geometry) != 0) {
    given_.refuse("a depth that counts to the diameter depends on the shape of the tool", "give the depth of the tip");
  }
  const int plane = last_digit(given_.number(places_.plane));
  const int active = control_.modal.plane == Plane::xy ? 1 : control_.modal.plane == Plane::zx ? 2 : 3;
  if (plane != 0 && plane != active) {
    given_.refuse("it works in another plane than the one in force", "choose that plane before, with G17, G18 or G19");
  }
  const double axis = given_.number(places_.axis);
  if (axis != 0 && axis != static_cast<double>(index(axes_.third)) + 1) {
    given_.refuse("it drills along another axis than the normal of the plane in force", "leave its tool axis out");
  }
  if (control_.modal.feed_mode == FeedMode::inverse_time) {
    given_.refuse("it takes no inverse time", "write G94 before it");
  }
  if (places_.code == kCalledDrill && places_.how < 0) check_simple();
}

// Newer controls have a dwell after the depth of CYCLE81, posts write no place for it: where all is 0, both agree.
void CalledHole::check_simple() const {
  for (int place = kDwell; place < static_cast<int>(call_.arguments.size()); ++place) {
    const double given = given_.number(place);
    if (given == 0 || (place >= 7 && given == 10)) continue;
    given_.refuse("sources disagree on what stands after the relative depth", "leave it out, or use CYCLE82");
  }
}

double CalledHole::depth_mm() const {
  const double reference = given_.length_mm(kReferencePlane);
  const int how = last_digit(given_.number(places_.how));
  const bool relative = how == 1 || (how == 0 && given_.value(kRelativeDepth) && given_.number(kRelativeDepth) != 0);
  const bool both = given_.value(kDepth) && given_.value(kRelativeDepth) && given_.number(kRelativeDepth) != 0;
  const double below = reference - std::abs(given_.length_mm(kRelativeDepth));
  if (both && given_.number(kDepth) != 0 && std::abs(below - given_.length_mm(kDepth)) > 1e-9) {
    given_.refuse("its two depths contradict each other", "leave out one of DP and DPR");
  }
  // [Siemens, 6FC5398-2EP40, CYCLE82: the tens say seconds or turns of the spindle]
  if (const long dwell = std::labs(std::lround(given_.number(places_.how))) / 10 % 10; dwell > 1) {
    given_.refuse("its last value asks for a dwell in turns of the spindle, which is not interpreted",
                  "give the dwell in seconds, and 0 or 1 as the tens of that value");
  }
  if (how > 2 || (how == 1 && !given_.value(kRelativeDepth)) || (how == 2 && !given_.value(kDepth))) {
    given_.refuse("its last value asks for a depth that is not there", "give the depth that it names, or leave it out");
  }
  return relative ? below : given_.length_mm(kDepth);
}

void CalledHole::take_levels() {
  const double reference = given_.length_mm(kReferencePlane);
  hole_.code = places_.code;
  hole_.r = reference + std::abs(given_.length_mm(kSafety));
  hole_.clear = given_.length_mm(kRetractPlane);
  hole_.bottom = depth_mm();
  if (hole_.clear == reference && given_.value(kRelativeDepth) && given_.number(kRelativeDepth) != 0) {
    run_.refuse(codes::kOutOfRange,
                fmt::format("{} has one plane for both, and a relative depth: the control stops there (alarm 61101)",
                            call_.row->name),
                "give the depth itself, or a retraction plane above the reference plane");
  }
  if (hole_.bottom >= reference || hole_.clear < reference) {
    run_.refuse(codes::kOutOfRange,
                fmt::format("{} begins below its bottom, or goes back into the part", call_.row->name),
                "the retraction plane lies above the reference plane, and the depth below it");
  }
}

void CalledHole::make() {
  need_offsets(run_);
  if (control_.length_doubt != Control::LengthDoubt::none) refuse_length_doubt(run_, run_.first_word());
  check();
  const AxisSet plane{axes_.first, axes_.second};
  if (!control_.known.contains(plane)) {
    run_.refuse(codes::kPositionUnknown,
                fmt::format("{} drills where the axes stand, which is not known", call_.row->name),
                "move there before with a G0 that names both axes of the plane");
  }
  take_levels();
  hole_.approach_end = run_.motions.size();
  hole_.first = control_.position[axes_.first];
  hole_.second = control_.position[axes_.second];
  go(MotionKind::rapid, hole_.r);
  hole_.begin = run_.motions.size();
  at_hole();
  hole_.end = run_.motions.size();
  run_.holes.push_back(hole_);
  run_.step.holes = run_.holes;
  run_.step.role = BlockRole::cycle;
  run_.step.cycle = places_.keeps ? CycleForm::spindle : CycleForm::moves;
  run_.step.call = &call_;
  leave_own_feeds(control_, given_, call_, last_share_);
  leave_spindle(control_, given_, places_.code);
  if (call_.row->loses_position) lose_position(run_, AxisSet{Axis::X, Axis::Y, Axis::Z});
}

void CalledHole::at_hole() {
  const bool no_wait = (places_.code == kCalledDrill && places_.how < 0) || places_.code == kCalledBoreStop;
  const double seconds = no_wait ? 0 : given_.number(kDwell);
  switch (places_.code) {
    case kCalledDeep:
      return pecks();
    case kCalledTap:
      tap_in_strokes();
      [[fallthrough]];
    case kCalledFloatingTap:
      go(MotionKind::feed, hole_.bottom, tapping_feed(run_, given_, places_, false));
      unknown_strokes_ = false;
      wait(seconds);
      go(MotionKind::feed, hole_.r, tapping_feed(run_, given_, places_, true));
      break;
    case kCalledReam:
      go(MotionKind::feed, hole_.bottom, own_feed(given_, kFeedDown));
      wait(seconds);
      go(MotionKind::feed, hole_.r, own_feed(given_, kFeedUp));
      break;
    case kCalledBoreDwell:
      feed_to(hole_.bottom);
      wait(seconds);
      feed_to(hole_.r);
      break;
    case kCalledBore:
      feed_to(hole_.bottom);
      wait(seconds);
      lift();
      return go_beside(0, 0, hole_.clear);
    default:
      feed_to(hole_.bottom);
      wait(seconds);
      break;
  }
  go(MotionKind::rapid, hole_.clear);
}

// Off the wall at the bottom, up beside it, and back over the hole [C 2.1.8].
void CalledHole::lift() {
  const double first = given_.length_mm(kLiftFirst);
  const double second = given_.length_mm(kLiftSecond);
  const double along = given_.length_mm(kLiftAlong);
  if (first == 0 && second == 0 && along == 0) return;
  if (given_.number(kLiftMode) != 0) {
    given_.refuse("no source says whether it lifts off the wall with another _GMODE than 0",
                  "give _GMODE, its twelfth value, as 0, or RPA, RPO and RPAP as 0");
  }
  go_beside(first, second, hole_.bottom + along);
  if (first != 0 || second != 0) go_beside(first, second, hole_.r);
}

// It waits DTB at each depth, at the last one DTD if that is given, and DTS above the hole if it clears the chips there
// [C 2.1.4]. With DAM how deep it goes after the first depth is the cycle's business: the rest of the way is told as
// one move, in how many strokes and how long is not known.
void CalledHole::pecks() {
  const double reference = given_.length_mm(kReferencePlane);
  const double first = first_depth_mm(given_);
  if (given_.number(7) < -1) {
    given_.refuse("no source says what a factor of its depths over 1 means",
                  "give DAM as -0.001 to -1, or as a length");
  }
  const bool chips = breaks_chips(given_);
  const ControlBehaviour& habits = run_.dialect.behaviour;
  const double at_depth = dwell_of_deep_hole(given_, 8, 10);
  const double at_start = dwell_of_deep_hole(given_, 9, 100);
  const double at_end = dwell_of_deep_hole(given_, 15, 1000);
  double share = first_share(given_);
  const auto next_peck = [&](double depth) {
    go(MotionKind::feed, depth, share * feed_of_move(run_, true));
    last_share_ = share;
    share = 1;
  };
  const auto stroke = [&](double depth) {
    next_peck(depth);
    wait(at_depth);
    if (chips) return feed_to(std::min(depth + given_.length_mm(14, habits.chip_break_mm), hole_.r));
    go(MotionKind::rapid, hole_.r);
    wait(at_start);
    go(MotionKind::rapid, depth + given_.length_mm(16, habits.peck_gap_mm));
  };
  const bool told = given_.number(7) == 0 && in_strokes(reference, hole_.bottom, first, stroke);
  if (!told && reference - first > hole_.bottom + kNoStroke) {
    stroke(reference - first);
    unknown_strokes_ = true;
  }
  next_peck(hole_.bottom);
  unknown_strokes_ = false;
  wait(at_end != 0 ? at_end : at_depth);
  go(MotionKind::rapid, hole_.clear);
}

// Before the last stroke: deep holes are tapped in strokes of DAM, each way back by the pitch as well, by VRT to break
// the chips (VARI 1) or out of the hole (VARI 2) [B].
void CalledHole::tap_in_strokes() {
  const int kind = last_digit(given_.number(15));
  const double stroke = std::abs(given_.length_mm(16));
  if (kind == 0) return;
  if (kind > 2) given_.refuse("no source says what its kind of work is", "give VARI as 0, 1 or 2");
  if (stroke == 0) given_.refuse("it taps in strokes, and how deep each goes is missing", "give DAM, or VARI as 0");
  const bool told = in_strokes(given_.length_mm(kReferencePlane), hole_.bottom, stroke, [&](double depth) {
    go(MotionKind::feed, depth, tapping_feed(run_, given_, places_, false));
    go(MotionKind::feed,
       kind == 2 ? hole_.r : std::min(depth + given_.length_mm(17, run_.dialect.behaviour.chip_break_mm), hole_.r),
       tapping_feed(run_, given_, places_, true));
  });
  unknown_strokes_ = !told;
}

void CalledHole::go(MotionKind kind, double level, double feed) {
  Motion motion;
  motion.kind = kind;
  motion.feed = feed;
  motion.unknown_strokes = unknown_strokes_ && kind == MotionKind::feed;
  motion.to = control_.position;
  motion.to[axes_.third] = level;
  motion.known_after = control_.known;
  motion.known_after.insert(axes_.third);
  add_motion(run_, motion);
}

// A rapid to so far beside the hole.
void CalledHole::go_beside(double first_mm, double second_mm, double level) {
  Motion motion;
  motion.kind = MotionKind::rapid;
  motion.to = control_.position;
  motion.to[axes_.first] = hole_.first + first_mm;
  motion.to[axes_.second] = hole_.second + second_mm;
  motion.to[axes_.third] = level;
  motion.known_after = control_.known;
  add_motion(run_, motion);
}

void CalledHole::wait(double seconds) {
  if (seconds == 0) return;
  const double turns = std::max(-seconds, 0.0);
  if (turns > 0 && control_.spindle_stands())
    given_.refuse("a dwell in turns needs a turning spindle", "write S and M3 before");
  Motion motion{.kind = MotionKind::dwell};
  motion.to = control_.position;
  motion.known_after = control_.known;
  motion.dwell_s = turns > 0 ? turns / control_.spindle_speed * 60 : seconds;
  motion.dwell_turns = turns;
  add_motion(run_, motion);
}

CycleCall call_of(const Execution& run, const CodeRow& row) {
  CycleCall call;
  call.row = &row;
  for (const Argument& argument : run.block->arguments) {
    CallArgument& given = call.arguments.emplace_back();
    if (argument.expression != kLiteral) given.value = argument.value;
    const bool is_plane = static_cast<int>(call.arguments.size()) <= kReferencePlane + 1;
    if (is_plane && argument.span.begin == argument.span.end) {  // what is left out is 0 [N p. 494]
      given = {"0", 0};
    } else if (argument.plain) {
      given.text = std::string(run.block->at(argument.span));
    } else {
      append_decimal(given.text, argument.value, kMostDecimals);
      call.by_variables = true;
    }
  }
  return call;
}

}  // namespace

void check_no_modal_call(const Execution& run, const Word& word) {
  if (run.control.modal_call.row == nullptr || run.axes.empty()) return;
  run.refuse(word, codes::kNotInterpreted,
             fmt::format("{} is in force after each move: whether it is called after {} was found in no source",
                         run.control.modal_call.row->name, run.text_of(word)),
             "end it before with MCALL alone in a block");
}

void set_modal_call(Execution& run) {
  Control& control = run.control;
  control.modal_call = CycleCall{};
  if (const CodeRow* const row = run.chosen_row(Action::called_cycle)) control.modal_call = call_of(run, *row);
  control.modal.modal_call = control.modal_call.row != nullptr;
}

void call_cycle(Execution& run, const CodeRow& row) {
  if (run.chosen_row(Action::modal_call) != nullptr) return;
  if (run.control.modal_call.row != nullptr) {
    run.refuse(codes::kNotInterpreted, fmt::format("{} is called while another is called after each move", row.name),
               "write MCALL alone before it");
  }
  run.control.call = call_of(run, row);
  CalledHole(run, run.control.call, run.motions.size()).make();
}

namespace {

// X5 M1, X5 G9 under MCALL: between the move and the hole, or behind both.
void check_beside_position(const Execution& run) {
  for (const Chosen& code : run.chosen) {
    if (code.row->order != Order::after_motion) continue;
    run.refuse(*code.word, codes::kNotInterpreted,
               fmt::format("whether {} acts before {} drills at this position or after it was found in no source",
                           run.text_of(*code.word), run.control.modal_call.row->name),
               "put it into a block of its own");
  }
}

}  // namespace

void drill_after_move(Execution& run) {
  if (run.control.modal_call.row == nullptr || run.axes.empty()) return;
  const bool straight = run.motion->action == Action::rapid || run.motion->action == Action::feed;
  if (!straight || run.machine_word != nullptr) {
    run.refuse(run.motion_code(), codes::kNotInterpreted,
               fmt::format("{} is in force after each move, and this one is no straight move in the work system",
                           run.control.modal_call.row->name),
               "end it before with MCALL alone in a block");
  }
  check_beside_position(run);
  CalledHole(run, run.control.modal_call, 0).make();
}

}  // namespace plumbline::nc

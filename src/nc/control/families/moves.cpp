// What straight moves and arcs share: their ends, their feed, and what must be known for them.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/text/characters.hpp"
#include "base/units.hpp"
#include "nc/control/execution.hpp"
#include "nc/control/families/cycle_codes.hpp"
#include "nc/control/parameters/expression.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {

void Execution::refuse(const Word& word, std::string_view code, std::string message, std::string help) const {
  refuse_at(*block, word.span, code, std::move(message), std::move(help));
}

void Execution::refuse(std::string_view code, std::string message, std::string help) const {
  refuse(first_word(), code, std::move(message), std::move(help));
}

Word Execution::first_word() const {
  if (!block->words.empty()) return block->words.front();
  Word whole;
  whole.span = {0, static_cast<std::uint32_t>(block->text.size())};
  return whole;
}

void Execution::refuse_point(const Word& word) const {
  if (!word.point || word.expression != kLiteral || dialect.syntax.statements != Statements::macro_b) return;
  refuse(word, codes::kNotWhole,
         fmt::format("{} has a point, and the control takes none in this word (alarm 007)", text_of(word)),
         "write a whole number without a point");
}

int Execution::whole(const Word& word, int least, int most) const {
  refuse_point(word);
  const int number = whole_number(*block, word.span, word.value, fmt::format("the {} word", word.letter));
  if (number >= least && number <= most) return number;
  refuse(word, codes::kOutOfRange, fmt::format("{}{} is out of range", word.letter, number),
         most == kNoLimit ? fmt::format("write {} or more", least) : fmt::format("write {} to {}", least, most));
}

const Chosen* Execution::chosen_code(Action action) const {
  for (const Chosen& code : chosen) {
    if (code.row->action == action) return &code;
  }
  return nullptr;
}

const CodeRow* Execution::chosen_row(Action action) const {
  const Chosen* const code = chosen_code(action);
  return code == nullptr ? nullptr : code->row;
}

// As the letters are said: an F, a P.
std::string_view article_of(char letter) {
  return std::string_view("AEFHILMNORSX").find(letter) != std::string_view::npos ? "an" : "a";
}

std::string vacancy_in(const Block& block) {
  return block.left_out.empty() ? "" : fmt::format(", and {} has no value here", block.at(block.left_out.front()));
}

const Word& Execution::need(char letter, std::string_view code_text) const {
  if (const Word* word = words.find(letter)) return *word;
  refuse(codes::kWordMissing,
         fmt::format("{} needs {} {} word{}", code_text, article_of(letter), letter, vacancy_in(*block)),
         "add it to the block");
}

const Word& Execution::motion_code() const { return motion_word != nullptr ? *motion_word : block->words.front(); }

namespace {

constexpr double kMostMotionsOfBlock = 100'000;  // all of a block are kept at once

// The end that a word means for an axis that stands at `from`.
double end_of_word(const Execution& run, const Word& word, Axis axis, double begin) {
  const double value = run.value(axis);
  const bool incremental = run.control.modal.incremental && word.mode == WordMode::modal;
  if (incremental || word.mode == WordMode::incremental) {
    check_increment(run, word, axis);
    return begin + value;
  }
  // where tables count as empty a wrapped axis stays where it is at a stop and a change of tools, as X, Y and Z do
  const AxisSet known = is_wrapped(run, axis) ? run.control.known : run.control.surely_known();
  const std::optional<double> from = known.contains(axis) ? std::optional(begin) : std::nullopt;
  switch (word.mode) {
    case WordMode::shortest:
      return rotary_end(RotaryRule::shortest, value, false, from);
    case WordMode::positive:
    case WordMode::negative:
      return rotary_end(RotaryRule::sign, within_one_turn(value), word.mode == WordMode::negative, from);
    default:
      break;
  }
  const RotaryRule rule = run.control.modal.rule_of(axis);
  if (rule == RotaryRule::linear) return value;
  if (rule == RotaryRule::sign) check_within_turn(run, word);
  check_sign_of_zero(run, word, axis);
  if (from && is_wrapped(run, axis)) check_stands_there(run, word, axis, *from);
  return rotary_end(rule, value, std::signbit(value), from);
}

}  // namespace

double distance(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

// What is missing is that of where the move begins.
std::array<double, 2> polar_end(const Execution& run, double x, double y) {
  const Word* const radius_word = run.words.find('@');
  const Word* const angle_word = run.words.find('^');
  PLUMBLINE_CHECK(radius_word != nullptr || angle_word != nullptr);
  const Word& word = radius_word != nullptr ? *radius_word : *angle_word;
  const Control& control = run.control;
  if (control.modal.plane != Plane::xy) {
    run.refuse(word, codes::kOutOfRange, "polar words need the XY plane", "write G17 before, or X, Y and Z");
  }
  const bool complete = !control.modal.incremental && radius_word != nullptr && angle_word != nullptr;
  if (!complete && !control.known.contains(AxisSet{Axis::X, Axis::Y})) {
    run.refuse(word, codes::kPositionUnknown, "where X and Y stand is not known",
               "move there with a G0 that names both axes");
  }
  if ((control.modal.incremental || angle_word == nullptr) && x == 0 && y == 0) {
    run.refuse(word, codes::kOutOfRange, "the move begins at the origin, which has no angle",
               "give radius and angle as absolute words");
  }
  double radius = std::hypot(x, y);
  double angle = std::atan2(y, x);
  if (radius_word != nullptr) radius = run.length(*radius_word) + (control.modal.incremental ? radius : 0);
  if (angle_word != nullptr) angle = angle_word->value * kDeg + (control.modal.incremental ? angle : 0);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

AxisWords end_of_move(const Execution& run) {
  AxisWords end = run.control.position;
  const Modal& modal = run.control.modal;
  for (const Axis axis : kAllAxes) {
    const Word* const word = run.words.find(axis);
    if (word == nullptr) continue;
    const bool is_place =
        !modal.incremental && word->mode == WordMode::modal && modal.rule_of(axis) == RotaryRule::linear;
    end[axis] = is_place ? word->value * modal.unit_of(axis) : end_of_word(run, *word, axis, end[axis]);
  }
  if (!run.words.polar()) return end;
  const std::array<double, 2> polar = polar_end(run, end[Axis::X], end[Axis::Y]);
  end[Axis::X] = polar[0];
  end[Axis::Y] = polar[1];
  return end;
}

AxisSet absolute_words(const Execution& run) {
  AxisSet stated = run.control.modal.incremental ? AxisSet{} : run.axes;
  if (run.has_word_modes) {
    for (const Axis axis : kAllAxes) {
      const Word* const word = run.words.find(axis);
      if (word == nullptr || word->mode == WordMode::modal) continue;
      if (word->mode == WordMode::incremental) {
        stated.erase(axis);
      } else {
        stated.insert(axis);
      }
    }
  }
  return stated;
}

namespace {

// An increment after it may bring along a shift that it has not followed yet.
AxisSet shifted_after(const Execution& run, const Motion& motion) {
  const AxisSet shifted = run.control.shifted;
  if (motion.kind == MotionKind::dwell) return shifted;
  if (!motion.in_machine_coordinates) return shifted - absolute_words(run);
  const Control& control = run.control;
  AxisSet aside;
  for (const Axis axis : kAllAxes) {
    if (!run.axes.contains(axis) || motion.machine[axis] == motion.to[axis]) continue;
    const bool by_length = control.behaviour.increment_unknown_after_length && control.frame.tool[axis] != 0;
    if (by_length || control.behaviour.increment_unknown_after_offset) aside.insert(axis);
  }
  return shifted | aside;
}

// Rigid taps (M29, G284) turn the spindle themselves.
bool turns_spindle(const Execution& run) {
  const bool taps = run.motion != nullptr && run.motion->action == Action::cycle && is_tap(run.motion->value);
  return taps && (run.dialect.behaviour.fanuc_cycles || run.dialect.behaviour.return_levels);
}

}  // namespace

AxisSet known_after_move(const Execution& run) { return run.control.known | absolute_words(run); }

namespace {

// The length acts along Z alone: a rapid that does not name it, or goes to the end of its travel, goes where it says.
bool goes_without_length(const Execution& run) {
  const bool rapid = run.motion != nullptr && run.motion->action == Action::rapid;
  if (!rapid || run.chosen_row(Action::tool_tip_on) != nullptr) return false;
  return !run.axes.contains(Axis::Z) || axes_to_limits(run).contains(Axis::Z);
}

}  // namespace

void need_offsets(const Execution& run) {
  check_on_plane(run);
  if (run.in_machine_system()) {
    run.refuse(run.motion_code(), codes::kNotInterpreted,
               "in machine coordinates (H0) rapids alone are read: how the tool's length counts there was found in no "
               "source",
               "choose a work system before it, as with G15 H1");
  }
  if (run.control.length == Control::Length::unknown && !goes_without_length(run)) {
    run.refuse(run.motion_code(), codes::kNotInterpreted,
               "whether the end of tool-tip mode ends the tool length that it began with was found in no source",
               "write G56 H or G53 before this move; rapids of X, Y, A, B and C alone need it not, nor does G0 Z9999");
  }
  const AxisSet missing = AxisSet::all() - run.control.active().known;
  if (missing.empty()) return;
  std::string letters;
  for (const Axis axis : kAllAxes) {
    if (missing.contains(axis)) letters += fmt::format("{}{}", letters.empty() ? "" : ", ", letter(axis));
  }
  if (run.control.modal.work_system == 0) {
    run.refuse(run.motion_code(), codes::kWorkOffsetUnknown, "the program moves before it chooses a work system",
               "which one is in force at the start depends on what ran before; choose one first, as with G15 H1");
  }
  const std::string name = run.dialect.name_of_system(run.control.modal.work_system);
  run.refuse(
      run.motion_code(), codes::kWorkOffsetUnknown,
      fmt::format("the program moves in {}, whose offset of {} is not known", name, letters),
      fmt::format("give what stands in the control's table: --work-offset {}=X,Y,Z,A,B,C", without_blanks(name)));
}

double feed_of_move(const Execution& run, bool linear) {
  Control& control = run.control;
  const Word* const word = run.words.find('F');
  if (control.modal.feed_mode == FeedMode::inverse_time) {
    control.feed_kept = std::numeric_limits<double>::quiet_NaN();
    if (word != nullptr && word->value > 0) return word->value;
    run.refuse(word != nullptr ? *word : run.motion_code(), codes::kFeedMissing,
               "inverse time (G93) needs F in every block that feeds",
               "add the F word: 1 over the minutes of the move");
  }
  if (control.feed_taken != nullptr) {
    run.refuse(
        run.motion_code(), codes::kFeedMissing,
        fmt::format("{} has feeds of its own, and whether the F before it is in force again after it was found in "
                    "no source",
                    control.feed_taken->name),
        "write F anew before this move, or beside it");
  }
  const bool per_revolution = control.modal.feed_mode == FeedMode::per_revolution;
  if (per_revolution && (turns_spindle(run) ? control.spindle_speed <= 0 : control.spindle_stands())) {
    run.refuse(run.motion_code(), codes::kFeedMissing, "a feed per revolution (G95) needs a turning spindle",
               "write S and M3 before this move");
  }
  if (per_revolution && control.speed_limited) {
    run.refuse(
        run.motion_code(), codes::kNotInterpreted,
        "LIMS limits the spindle's speed under G97, and with it this feed per revolution, which is not interpreted",
        "leave LIMS out, and write the S that the spindle keeps");
  }
  if (per_revolution && !linear && control.modal.inches && run.dialect.behaviour.inch_turn_per_revolution_unknown) {
    run.refuse(run.motion_code(), codes::kNotInterpreted,
               "a turn alone with a feed per revolution (G95) in inches: whether F counts degrees or inches then was "
               "found in no source",
               "write G93 or G94 with the F of this move, or the program in mm");
  }
  const double feed = linear || per_revolution ? control.feed_linear : control.modal.feed_rotary;
  if (feed > 0) return feed;
  if (word != nullptr && word->value == 0) {
    run.refuse(*word, codes::kFeedMissing, fmt::format("{} is no feed: the move would never end", run.text_of(*word)),
               "write the feed that is meant");
  }
  run.refuse(word != nullptr ? *word : run.motion_code(), codes::kFeedMissing, "no feed is in force for this move",
             "write F; G93, G94 and G95 drop the F before them, a change of units on some controls as well");
}

void check_motions(const Execution& run, double count) {
  const double allowed = std::min(kMostMotionsOfBlock, static_cast<double>(run.settings.max_blocks));
  if (static_cast<double>(run.motions.size()) + count <= allowed) return;
  run.refuse(run.motion_code(), codes::kTooManyBlocks, fmt::format("this block makes more than {:.0f} moves", allowed),
             "look for a slip in L, K, P or Q; --max-blocks may be lower than what the program needs");
}

namespace {

// In inches a degree may count as one, or as a mm: of the block, or of what corrects it.
FeedRule feed_rule_of(const Execution& run) {
  const Control& control = run.control;
  const bool counts = control.feed_rule == FeedRule::all_axes_as_mm && !run.settings.feed_rule;
  const bool unknown = run.dialect.behaviour.inch_turn_unknown && control.modal.inches && counts;
  return unknown ? FeedRule::unknown : control.feed_rule;
}

// What the words of a move in inches say, for those who read where it ends.
void keep_inches(const Execution& run, const Motion& motion) {
  Control& control = run.control;
  if (!control.modal.inches) return;
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    const Word* const word = run.words.find(axis);
    if (word == nullptr) continue;
    const bool increment = control.modal.incremental;
    const double mm = (increment ? control.position[axis] : 0) + run.length(*word);
    const double inches = (increment ? control.position_in_unit(axis) : 0) + word->value;
    if (motion.to[axis] == mm) control.inch_places[index(axis)] = {mm, inches};
  }
}

}  // namespace

void add_motion(Execution& run, const Motion& planned) {
  Control& control = run.control;
  Motion& motion = run.motions.emplace_back(planned);
  motion.line = run.block->line;
  motion.feed_mode = control.modal.feed_mode;
  motion.mm_per_unit = control.modal.inches ? kMmPerInch : 1;
  motion.feed_rule = feed_rule_of(run);
  motion.feed_along_circle =
      run.settings.helix_feed_along_circle.value_or(run.dialect.behaviour.helix_feed_along_circle);
  if (!(run.axes & kTurningAxes).empty()) control.turned = AxisSet{};
  motion.from = control.position;
  motion.known_before = control.known;
  motion.machine = control.frame.to_machine(motion.to);
  control.shifted = shifted_after(run, motion);
  if (!control.lost.empty()) control.lost = control.lost - absolute_words(run);
  keep_inches(run, motion);
  const bool length_unknown = control.length == Control::Length::unknown;
  const AxisSet tip_lost =
      length_unknown && tilts_tool(run, motion.known_after, motion.to) ? AxisSet::linear() : AxisSet{};
  if (run.settings.as_with_empty_tables) {
    control.lost = control.lost | tip_lost;
  } else {
    motion.known_after = motion.known_after - tip_lost;
  }
  control.position = motion.to;
  control.known = motion.known_after;
  if (control.length_doubt != Control::LengthDoubt::none) {  // where the tip stands then is not known
    motion.known_before.erase(Axis::Z);
    motion.known_after.erase(Axis::Z);
  }
}

void lose_position(Execution& run, AxisSet axes) {
  run.step.loses_position = true;
  run.control.turned = run.control.turned - axes;
  if (run.settings.as_with_empty_tables) {
    run.control.lost = run.control.lost | axes;
  } else {
    run.control.known = run.control.known - axes;
  }
}

}  // namespace plumbline::nc

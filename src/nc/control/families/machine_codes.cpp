// Codes that make the machine wait, switch or stop: G4, M0, M1, M2, M30, M60, spindle, outputs and inputs, user codes.
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr int kInputResult = 5399;  // parameter that M66 sets
constexpr int kWaitModes = 4;

void orient_spindle(Execution& run) {
  run.control.turn_spindle(kSpindleStands);
  const Word* const angle = run.words.find('R');
  if (angle != nullptr && (angle->value < 0 || angle->value > kFullTurn)) {
    run.refuse(*angle, codes::kOutOfRange, "the spindle's angle is out of range", "write R0 to R360");
  }
  if (const Word* direction = run.words.find('P')) run.whole(*direction, 0, 2);
  const Word* const longest = run.words.find('Q');
  if (longest != nullptr && longest->value <= 0) {
    run.refuse(*longest, codes::kOutOfRange, "the time that the spindle may take must be above 0",
               "write seconds, or leave Q out");
  }
}

void set_output(const Execution& run, const Chosen& chosen) {
  run.whole(run.need('P', fmt::format("M{}", chosen.row->code / 10)), 0, kNoLimit);
}

// M66: what it reads is not known before the machine runs.
void read_input(Execution& run) {
  const Word* const digital = run.words.find('P');
  const Word* const analog = run.words.find('E');
  if (digital != nullptr && analog != nullptr) {
    run.refuse(*analog, codes::kWordUnused, "M66 reads either P or E", "leave one of them");
  }
  const Word& input = digital == nullptr && analog != nullptr ? *analog : run.need('P', "M66");
  run.whole(input, 0, kNoLimit);
  const Word* const mode = run.words.find('L');
  const int wait = mode == nullptr ? 0 : run.whole(*mode, 0, kWaitModes);
  const Word* const timeout = run.words.find('Q');
  if (wait != 0 && analog != nullptr) {
    run.refuse(*mode, codes::kOutOfRange, "an analog input cannot be waited for", "write L0");
  }
  if (wait != 0 && run.need('Q', "M66 with L").value <= 0) {
    run.refuse(*timeout, codes::kOutOfRange, "M66 would wait for no time at all", "write the seconds to wait at most");
  }
  // rs274, which has no inputs, leaves what is there.
  Parameters& parameters = run.control.parameters;
  const double there = parameters.has(kInputResult) ? parameters.get(kInputResult).number : 0;
  const double reads = digital != nullptr && there != 0 ? 1 : there;
  parameters.set(kInputResult, {reads, run.settings.as_with_empty_tables});
}

void switch_coolant(Switches& switches, int code) {
  if (code == kCoolantOff) switches.mist = switches.flood = false;
  if (code == kMist) switches.mist = true;
  if (code == kFlood) switches.flood = true;
}

// M48 and M49 switch both overrides; M50 to M53 one each, by P: on unless it is 0.
void switch_override(const Execution& run, int code) {
  Switches& switches = run.control.modal.switches;
  const Word* const word = run.words.find('P');
  const bool on = word == nullptr || word->value != 0;
  if (code == kOverridesOn || code == kOverridesOff) {
    switches.feed_override = switches.speed_override = code == kOverridesOn;
  }
  if (code == kFeedOverride) switches.feed_override = on;
  if (code == kSpeedOverride) switches.speed_override = on;
  if (code == kAdaptiveFeed) switches.adaptive_feed = on;
  if (code == kFeedStop) switches.feed_stop = on;
}

}  // namespace

void lose_unless_kept(Execution& run, const Chosen& chosen) {
  constexpr int kChange = 6;  // G116 selects T, then M6 [O]
  const bool changes = chosen.word->letter == 'G' && chosen.row->action == Action::change_tool;
  const int code = changes ? kChange : static_cast<int>(std::lround(chosen.word->value));
  if (chosen.row->loses_position && !run.settings.keeps_position.contains(code)) lose_position(run, AxisSet::all());
}

void call_program(Execution& run, const Chosen& chosen) {
  const bool calls = chosen.row->action == Action::call_program;
  for (const Word& word : run.block->words) {
    if (run.dialect.behaviour.call_with_moves) break;
    if (&word == chosen.word || (calls && (word.letter == 'P' || word.letter == 'L'))) continue;
    run.refuse(word, codes::kFlowControl, fmt::format("{} stands alone in its block", run.text_of(*chosen.word)),
               "put the other words into a block of their own");
  }
  const bool calls_part = calls && chosen.row->value != 0;
  run.call.kind = !calls ? ProgramCall::Kind::end : calls_part ? ProgramCall::Kind::part : ProgramCall::Kind::program;
  if (!calls) {
    const bool takes_p = (chosen.row->word_mask & letter_bit('P')) != 0;  // M99, not M17
    if (const Word* to = takes_p ? run.words.find('P') : nullptr) run.call.return_to = run.whole(*to, 0, kNoLimit);
    return;
  }
  run.call.number = run.whole(run.need('P', run.text_of(*chosen.word)), 0, kNoLimit);
  const Word* const count = run.words.find('L');
  if (count != nullptr) run.call.count = run.whole(*count, run.dialect.behaviour.least_calls, kNoLimit);
  if (run.dialect.behaviour.call_repeat_digits == 0 || count != nullptr || calls_part) return;
  const int one = static_cast<int>(std::pow(10, run.dialect.behaviour.call_repeat_digits));
  if (run.call.number < one) return;
  run.call.whole = run.call.number;
  run.call.count = run.call.number / one;  // P00030010: three times O0010
  run.call.number %= one;
}

namespace {

[[noreturn]] void refuse_dwell_without_time(const Execution& run, const Word& code, std::string_view letters) {
  std::string words;
  for (const char letter : letters) {
    words += fmt::format("{}{} {}", words.empty() ? "" : " or ", article_of(letter), letter);
  }
  run.refuse(code, codes::kWordMissing, fmt::format("G4 needs {} word{}", words, vacancy_in(*run.block)),
             "add the time to wait");
}

// Beside a change of the tool or a stop at an angle no source says which comes last: it is not taken to turn.
void turn_spindle(Execution& run, const Chosen& chosen) {
  const bool stops = run.dialect.behaviour.change_stops_spindle && run.chosen_row(Action::change_tool) != nullptr;
  const bool stands = stops || run.chosen_row(Action::position_spindle) != nullptr;
  run.control.turn_spindle(stands ? kSpindleStands : chosen.row->value);
}

}  // namespace

void dwell(Execution& run, const Word& code) {
  const std::string_view letters = run.chosen_row(Action::dwell)->words;
  const ControlBehaviour& behaviour = run.dialect.behaviour;
  const FeedMode mode = run.control.modal.feed_mode;
  if ((behaviour.dwell_unknown_per_revolution && mode == FeedMode::per_revolution) ||
      (behaviour.dwell_unknown_inverse_time && mode == FeedMode::inverse_time)) {
    run.refuse(code, codes::kNotInterpreted,
               fmt::format("whether a dwell counts seconds in this feed mode ({}) depends on the control",
                           mode == FeedMode::inverse_time ? "G93" : "G95"),
               "write G94 before it");
  }
  const Word* word = nullptr;
  for (const char letter : letters) {
    if (word == nullptr) word = run.words.find(letter);
  }
  if (word == nullptr) refuse_dwell_without_time(run, code, letters);
  if (word->value < 0) {
    run.refuse(*word, codes::kNegative, "the time to wait is negative", fmt::format("write {}0 or more", word->letter));
  }
  if (word->letter == 'P') check_milliseconds(run, *word, true);
  Motion motion;
  motion.kind = MotionKind::dwell;
  if (run.chosen_row(Action::dwell)->takes_axes) run.axes = AxisSet{};  // X is the time
  motion.to = run.control.position;
  motion.known_after = run.control.known;
  motion.dwell_s = word->value;
  if (word->letter == 'P') motion.dwell_s *= run.dialect.behaviour.dwell_p_s;
  if (word->letter == 'S') {  // turns of the spindle
    if (run.control.spindle_stands()) {
      run.refuse(*word, codes::kFeedMissing, "a dwell in turns needs a turning spindle", "write S and M3 before it");
    }
    motion.dwell_s = word->value / run.control.spindle_speed * 60;
  }
  add_motion(run, motion);
}

void machine_code(Execution& run, const Chosen& chosen) {
  switch (chosen.row->action) {
    case Action::orient_spindle:
      return orient_spindle(run);
    case Action::set_output:
      return set_output(run, chosen);
    case Action::set_analog_output:
      run.whole(run.need('E', run.text_of(*chosen.word)), 0, kNoLimit);
      return;
    case Action::read_input:
      return read_input(run);
    case Action::call_program:
    case Action::end_program:
      return call_program(run, chosen);
    case Action::spindle:
      return turn_spindle(run, chosen);
    case Action::coolant:
      return switch_coolant(run.control.modal.switches, chosen.row->value);
    case Action::override_switch:
      return switch_override(run, chosen.row->value);
    case Action::retract_to_start:
    case Action::retract_to_r:
      run.control.modal.retract_to_r = chosen.row->action == Action::retract_to_r;
      run.control.cycle_return = run.control.modal.retract_to_r ? Control::Return::r : Control::Return::level;
      return;
    case Action::end:
      run.control.ended = true;
      return;
    case Action::user_code:
      if (run.dialect.behaviour.passed_code_keeps_position &&
          run.settings.passed_m_codes.contains(static_cast<int>(std::lround(chosen.word->value))))
        return;
      [[fallthrough]];
    case Action::stop:
      return lose_unless_kept(run, chosen);
    default:
      return;
  }
}

}  // namespace plumbline::nc

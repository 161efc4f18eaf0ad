// What straight moves and arcs share: their ends, their feed, and what must be known for them.
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "nc/codes.hpp"
#include "nc/execution.hpp"
#include "nc/expression.hpp"
#include "nc/parser.hpp"

namespace plumbline::nc {

void Execution::refuse(const Word& word, std::string_view code, std::string message, std::string help) const {
  refuse_at(*block, word.span, code, std::move(message), std::move(help));
}

void Execution::refuse(std::string_view code, std::string message, std::string help) const {
  const Span whole{0, static_cast<std::uint32_t>(block->text.size())};
  refuse_at(*block, block->words.empty() ? whole : block->words.front().span, code, std::move(message),
            std::move(help));
}

int Execution::whole(const Word& word, int least, int most) const {
  const int number = whole_number(*block, word.span, word.value, fmt::format("the {} word", word.letter));
  if (number >= least && number <= most) return number;
  refuse(word, codes::kOutOfRange, fmt::format("{}{} is out of range", word.letter, number),
         most == kNoLimit ? fmt::format("write {} or more", least) : fmt::format("write {} to {}", least, most));
}

const Word& Execution::need(char letter, std::string_view code_text) const {
  if (const Word* word = words.find(letter)) return *word;
  refuse(codes::kWordMissing, fmt::format("{} needs a {} word", code_text, letter), "add it to the block");
}

std::string name_of_system(int system) {
  return system <= 6 ? fmt::format("G{}", 53 + system) : fmt::format("G59.{}", system - 6);
}

const Word& Execution::motion_code() const { return motion_word != nullptr ? *motion_word : block->words.front(); }

AxisWords end_of_move(const Execution& run) {
  AxisWords end = run.control.position;
  for (const Axis axis : kAllAxes) {
    const Word* const word = run.words.find(axis);
    if (word == nullptr) continue;
    end[axis] = run.control.modal.incremental ? end[axis] + run.value(axis) : run.value(axis);
  }
  return end;
}

AxisSet known_after_move(const Execution& run) {
  if (run.control.modal.incremental) return run.control.known;
  return run.control.known | run.axes;
}

void need_offsets(const Execution& run) {
  const AxisSet missing = AxisSet::all() - run.control.active().known;
  if (missing.empty()) return;
  std::string letters;
  for (const Axis axis : kAllAxes) {
    if (missing.contains(axis)) letters += fmt::format("{}{}", letters.empty() ? "" : ", ", letter(axis));
  }
  const std::string name = name_of_system(run.control.modal.work_system);
  run.refuse(run.motion_code(), codes::kWorkOffsetUnknown,
             fmt::format("the program moves in {}, whose offset of {} is not known", name, letters),
             fmt::format("give what stands in the control's table: --work-offset {}=X,Y,Z,A,B,C", name));
}

double feed_of_move(const Execution& run, bool linear) {
  const Control& control = run.control;
  const Word* const word = run.words.find('F');
  if (control.modal.feed_mode == FeedMode::inverse_time) {
    if (word != nullptr && word->value > 0) return word->value;
    run.refuse(word != nullptr ? *word : run.motion_code(), codes::kFeedMissing,
               "inverse time (G93) needs F in every block that feeds",
               "add the F word: 1 over the minutes of the move");
  }
  const bool per_revolution = control.modal.feed_mode == FeedMode::per_revolution;
  if (per_revolution && control.spindle_speed == 0) {
    run.refuse(run.motion_code(), codes::kFeedMissing, "a feed per revolution (G95) needs a turning spindle",
               "write S and M3 before this move");
  }
  const double feed = linear || per_revolution ? control.feed_linear : control.feed_rotary;
  if (feed > 0) return feed;
  run.refuse(word != nullptr ? *word : run.motion_code(), codes::kFeedMissing, "no feed is in force for this move",
             "write F; G93, G94 and G95 drop the F before them");
}

void add_motion(Execution& run, Motion motion) {
  Control& control = run.control;
  motion.line = run.block->line;
  motion.feed_mode = control.modal.feed_mode;
  motion.mm_per_unit = control.modal.inches ? kMmPerInch : 1;
  motion.from = control.position;
  motion.known_before = control.known;
  motion.machine = control.frame.to_machine(motion.to);
  control.position = motion.to;
  control.known = motion.known_after;
  run.motions.push_back(motion);
}

void lose_position(Execution& run, AxisSet axes) {
  run.step.loses_position = true;
  if (!run.settings.as_with_empty_tables) run.control.known = run.control.known - axes;
}

}  // namespace plumbline::nc

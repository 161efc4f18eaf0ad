// Holes of cycles that stay cycles, shifted.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "nc/language/block_words.hpp"
#include "nc/rewrite/emit.hpp"

namespace plumbline::nc {

// How far the level is off that cycles go back to: where the first of them began.
void Emitter::note_cycle_level(const Step& step) {
  const Axis normal = axes_of(step.after->plane).third;
  if (control_.motion != MotionMode::cycle) cycle_level_shift_ = control_.work_shift(*step.frame)[normal];
}

EmittedMove Emitter::hole(const Step& step, const AxisWords& shift) {
  if (step.call != nullptr) return called_hole(step, shift);
  follow(step);
  begin_change(step);
  restore_feed_state(step, find_word(*step.block, 'F') != nullptr);
  const BlockCodes codes = codes_.codes_of(*step.block);
  const PlaneAxes axes = axes_of(step.after->plane);
  note_cycle_level(step);
  AxisWords end_shift = control_.work_shift(*step.frame);
  if (!step.after->retract_to_r) end_shift[axes.third] = cycle_level_shift_;
  // It went up to R before the cycle then, and comes back to the higher of the two.
  const bool comes_from_below = !step.after->retract_to_r && !dialect_.behaviour.fanuc_cycles &&
                                std::abs(step.holes.front().clear - step.holes.front().r) <= kSameHeight;
  editor_.start(*step.block, spelling_);
  if (merges_points(step, codes)) keep_each_point(editor_, *step.block);
  for (const Word& word : step.block->words) {
    std::optional<Axis> axis = axis_of(word.letter);
    const bool level = step.holes.front().ijk && word.letter == kCentreLetters[index(axes.third)];
    if (word.letter == 'R' || level) axis = axes.third;
    if (!axis) continue;
    const bool turns = is_rotary(*axis);  // it stays where it stands
    const double per_unit = step.after->inches && !turns ? kMmPerInch : 1;
    const double by = turns ? end_shift[*axis] : shift[*axis];
    const double value = planner_.words().rounded(step, *axis, word.value + by / per_unit);
    const double off = (value - word.value) * per_unit;
    const bool goes_back_there = word.letter == 'R' && step.after->retract_to_r;
    const bool in_plane = word.letter == letter(axes.first) || word.letter == letter(axes.second);
    if (goes_back_there || in_plane) end_shift[*axis] = off;
    if (word.letter == 'R' && comes_from_below) end_shift[*axis] = std::max(end_shift[*axis], off);
    std::string text;
    append_word(text, word.letter, value, kMostDecimals,
                {spelling_.lower_case, false, spelling_.point, spelling_.most_digits});
    editor_.replace(word.span, text);
  }
  if (dialect_.behaviour.return_levels && !step.after->retract_to_r)
    end_shift[axes.third] = 0;  // the level of G71, as it is
  line_.clear();
  editor_.apply(line_);
  text_.write_line(step, line_);
  text_.end_block(step);
  control_.set_work_shift(*step.frame, end_shift);
  control_.motion = MotionMode::cycle;
  if (codes.feed_mode != nullptr) control_.feed_mode = step.after->feed_mode;
  if (find_word(*step.block, 'F') != nullptr) control_.set_feed(step.after->feed);
  return {true, 1, std::nullopt, 0};
}

// What is called after each move would drill at each move that is written out.
void Emitter::end_modal_call(const Step& step) {
  if (step.call == nullptr || !step.after->modal_call || !control_.modal_call) return;
  text_.write_own_line(in_spelling(codes_.name_of(Action::modal_call), spelling_));
  control_.modal_call = false;
}

// A move to above the hole, and the call with its levels.
EmittedMove Emitter::called_hole(const Step& step, const AxisWords& shift) {
  follow(step);
  begin_change(step);
  restore_feed_state(step, false);
  const PlaneAxes axes = axes_of(step.after->plane);
  const Hole& hole = step.holes.front();
  const double per_unit = step.after->inches ? kMmPerInch : 1;
  AxisWords end_shift = control_.work_shift(*step.frame);
  line_.clear();
  append_code(line_, codes_.motion(MotionMode::rapid), spelling_);
  for (const auto& [axis, position] : {std::pair{axes.first, hole.first}, std::pair{axes.second, hole.second}}) {
    const double value = planner_.words().rounded(step, axis, (position + shift[axis]) / per_unit);
    end_shift[axis] = value * per_unit - position;
    const std::size_t begin = line_.size();
    append_word(line_, letter(axis), value, kMostDecimals, spelling_);
    if (!step.after->incremental) continue;
    line_.insert(line_.find_first_not_of(' ', begin) + 1, "=AC(");
    line_ += ')';
  }
  text_.write_line(step, line_);
  text_.write(text_.line_end(step));
  editor_.start(*step.block, spelling_);
  const auto move_level = [&](std::size_t place) {
    if (place >= step.call->arguments.size() || !step.call->arguments[place].value) return;
    const double value = *step.call->arguments[place].value;
    const double moved = planner_.words().rounded(step, axes.third, value + shift[axes.third] / per_unit);
    if (place == 0) end_shift[axes.third] = (moved - value) * per_unit;
    std::string text;
    append_decimal(text, moved, kMostDecimals);
    editor_.replace(step.block->arguments[place].span, text);
  };
  for (const char digit : step.call->row->levels) move_level(static_cast<std::size_t>(digit - '0'));
  line_.clear();
  editor_.apply(line_);
  text_.write_line(step, line_);
  text_.end_block(step);
  control_.set_work_shift(*step.frame, end_shift);
  control_.motion = MotionMode::rapid;
  return {true, 1, std::nullopt, 0};
}

}  // namespace plumbline::nc

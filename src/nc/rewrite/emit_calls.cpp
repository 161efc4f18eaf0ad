// Holes of called cycles, shifted: a move to above the hole, and the call with its levels.
#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "nc/rewrite/emit.hpp"

namespace plumbline::nc {

// What is called after each move would drill at each move that is written out.
void Emitter::end_modal_call(const Step& step) {
  if (step.call == nullptr || !step.after->modal_call || !control_.modal_call) return;
  out_.write(in_spelling(codes_.name_of(Action::modal_call), spelling_) + newline_);
  control_.modal_call = false;
}

EmittedMove Emitter::called_hole(const Step& step, const AxisWords& shift) {
  note_header(step);
  begin_change(step);
  restore_feed_state(step, false);
  const PlaneAxes axes = axes_of(step.after->plane);
  const Hole& hole = step.holes.front();
  const double per_unit = step.after->inches ? kMmPerInch : 1;
  AxisWords left = control_.work_shift(*step.frame);
  line_.clear();
  append_code(line_, codes_.motion(MotionMode::rapid), spelling_);
  for (const auto& [axis, position] : {std::pair{axes.first, hole.first}, std::pair{axes.second, hole.second}}) {
    const double value = planner_.rounded(step, axis, (position + shift[axis]) / per_unit);
    left[axis] = value * per_unit - position;
    const std::size_t begin = line_.size();
    append_word(line_, letter(axis), value, kMostDecimals, spelling_);
    if (!step.after->incremental) continue;
    line_.insert(line_.find_first_not_of(' ', begin) + 1, "=AC(");
    line_ += ')';
  }
  write_line(step, line_);
  out_.write(line_end(step));
  editor_.start(*step.block, spelling_);
  const auto move_level = [&](std::size_t place) {
    if (place >= step.call->arguments.size() || !step.call->arguments[place].value) return;
    const double value = *step.call->arguments[place].value;
    const double moved = planner_.rounded(step, axes.third, value + shift[axes.third] / per_unit);
    if (place == 0) left[axes.third] = (moved - value) * per_unit;
    std::string text;
    append_decimal(text, moved, kMostDecimals);
    editor_.replace(step.block->arguments[place].span, text);
  };
  for (const char digit : step.call->row->levels) move_level(static_cast<std::size_t>(digit - '0'));
  line_.clear();
  editor_.apply(line_);
  write_line(step, line_);
  out_.write(unrolls() ? newline_ : step.block->line_end);
  control_.set_work_shift(*step.frame, left);
  control_.motion = MotionMode::rapid;
  return {true, 1, std::nullopt, 0};
}

}  // namespace plumbline::nc

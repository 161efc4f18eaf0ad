// A hole that a called cycle makes (CYCLE84, MCALL CYCLE83): the way to above it, then a call for it alone.
#include <utility>

#include "base/characters.hpp"
#include "nc/plain.hpp"

namespace plumbline::nc {

void PlainSteps::add_called_hole(const Step& step, const Hole& hole) {
  for (std::size_t i = hole.approach_begin; i < hole.approach_end; ++i) add_move(step, step.motions[i]);
  Own& own = next_own(step);
  own.text = std::exchange(number_, {});
  append_code(own.text, step.call->row->name, spelling_);
  own.text += '(';
  for (std::size_t i = 0; i < step.call->arguments.size(); ++i) {
    if (i > 0) own.text += ',';
    own.text += step.call->arguments[i].text;
  }
  own.text += ')';
  own.hole = hole;
  own.before.motion = own.after.motion = mode_;
  own.step.motions = step.motions.subspan(hole.begin, hole.end - hole.begin);
  own.step.holes = {&own.hole, 1};
  own.step.role = BlockRole::cycle;
  own.step.cycle = CycleForm::spindle;
  own.step.call = step.call;
  own.step.loses_position = step.loses_position;
  own.step.named = AxisSet::linear();
  parse(own, step);
  add(own);
}

}  // namespace plumbline::nc

#include "nc/rewrite/output/emit_state.hpp"

#include "base/units.hpp"

namespace plumbline::nc {
AxisWords OutputState::work_shift(const Frame& frame) const { return frame.turned_back(shift); }

void OutputState::set_work_shift(const Frame& frame, const AxisWords& work) { shift = frame.turned(work); }

void OutputState::adopt(const Modal& modal) {
  motion = modal.motion;
  feed_mode = modal.feed_mode;
  feed = modal.feed;
  feed_rotary = modal.feed_rotary;
}

void OutputState::change_unit(const Modal& before, const Modal& after) {
  if (before.inches == after.inches) return;
  feed = after.inches ? feed / kMmPerInch : feed * kMmPerInch;
}

void OutputState::follow(const Step& step, const BlockCodes& codes) {
  if (codes.motion != nullptr) motion = step.after->motion;
  if (codes.modal_call != nullptr) modal_call = step.after->modal_call;
  if (codes.feed_mode != nullptr) {
    if (feed_mode != step.after->feed_mode) drop_feed();  // a control drops the F of the other mode
    feed_mode = step.after->feed_mode;
  }
  change_unit(*step.before, *step.after);
  if (codes.feed != nullptr || step.after->feed == 0) {
    feed = step.after->feed;
    feed_rotary = step.after->feed_rotary;
  }
  if (step.motions.empty()) return;
  if (step.orienting) {
    shift = shift_after(*step.orienting, shift);
    return;
  }
  if (step.role == BlockRole::machine_move) {
    for (const Axis axis : kAllAxes) {
      if (step.named.empty() || step.named.contains(axis)) shift[axis] = 0;
    }
    return;
  }
  AxisWords work = work_shift(*step.frame);
  AxisSet stated = step.after->incremental ? AxisSet{} : step.named;
  for (const Word& word : step.block->words) {
    const std::optional<Axis> axis = axis_of(word.letter);
    if (axis && word.mode == WordMode::incremental) stated.erase(*axis);
    if (axis && word.mode == WordMode::absolute) stated.insert(*axis);
  }
  if (stated.empty()) return;
  for (const Axis axis : kAllAxes) {
    if (stated.contains(axis)) work[axis] = 0;
  }
  set_work_shift(*step.frame, work);
}

}  // namespace plumbline::nc

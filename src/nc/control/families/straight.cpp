// G0 and G1, in the work system or, with G53, in machine coordinates.
#include <cmath>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kTiny = 1e-7;  // mm under which an axis counts as standing [LinuxCNC's canonical layer]

void end_in_machine_coordinates(const Execution& run, Motion& motion) {
  const Control& control = run.control;
  if (control.modal.incremental) {
    run.refuse(*run.machine_word, codes::kMachineMove,
               fmt::format("{} cannot move by increments", run.text_of(*run.machine_word)), "write G90 before it");
  }
  for (const Axis axis : kAllAxes) {
    const Word* const word = run.has_word_modes ? run.words.find(axis) : nullptr;
    if (word == nullptr || word->mode == WordMode::modal || word->mode == WordMode::absolute) continue;
    run.refuse(*word, codes::kMachineMove,
               fmt::format("how {} counts in machine coordinates was found in no source", run.text_of(*word)),
               "write the position itself");
  }
  check_tool_unit(run, *run.machine_word);
  check_no_rotary_words(run);
  check_wrapped_words(run);
  const Frame frame = control.frame.without_rotary_tool();
  AxisWords machine = frame.to_machine(control.position);
  for (const Axis axis : kAllAxes) {
    if (run.axes.contains(axis)) machine[axis] = run.value(axis);
  }
  const AxisWords work = frame.from_machine(machine);
  const AxisSet plane = control.frame.mixed();
  const bool turned = !plane.empty();
  const bool moves_plane = !(run.axes & plane).empty();
  AxisSet moved = run.axes;
  if (turned && moves_plane) moved = moved | plane;
  motion.to = control.position;
  for (const Axis axis : kAllAxes) {
    if (!moved.contains(axis)) continue;
    const Word* const word = run.words.find(axis);
    if (word != nullptr) check_sign_of_zero(run, *word, axis);
    const bool negative = word != nullptr && std::signbit(word->value);
    const auto from = control.known.contains(axis) ? std::optional(control.position[axis]) : std::nullopt;
    motion.to[axis] = rotary_end(control.modal.rule_of(axis), work[axis], negative, from);
  }
  motion.known_after = control.known | run.axes;
  // A turned X is made of both X and Y.
  if (turned && moves_plane && !motion.known_after.contains(plane)) motion.known_after = motion.known_after - plane;
  motion.in_machine_coordinates = true;
}

bool moves_linearly(const Motion& motion, const AxisWords& from) {
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    if (std::abs(motion.to[axis] - from[axis]) > kTiny) return true;
  }
  return false;
}

bool moves_rotary(const Motion& motion, const AxisWords& from) {
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
    if (std::abs(motion.to[axis] - from[axis]) > kTiny) return true;
  }
  return false;
}

}  // namespace

void move_straight(Execution& run) {
  if (run.machine_word == nullptr && move_as_it_stands(run)) return;
  Control& control = run.control;
  Motion motion;
  motion.kind = run.motion->action == Action::rapid ? MotionKind::rapid : MotionKind::feed;
  if (run.machine_word != nullptr) {
    end_in_machine_coordinates(run, motion);
    run.step.role = BlockRole::machine_move;
  } else {
    need_offsets(run);
    motion.to = end_of_move(run);
    motion.known_after = known_after_move(run);
    if (run.vector != nullptr) end_along_vector(run, motion);
  }
  if (motion.kind == MotionKind::feed) {
    const bool linear = moves_linearly(motion, control.position) || !moves_rotary(motion, control.position);
    motion.feed = feed_of_move(run, linear);
    const bool inverse = motion.feed_mode == FeedMode::inverse_time;
    if (inverse) control.feed_kept = motion.feed * length_mm(motion.to - control.position) / control.length_unit();
    if (run.vector != nullptr) check_way_of_vector(run, motion);
  }
  add_motion(run, motion);
  if (run.machine_word != nullptr) end_length_at_home(run);
  if (run.machine_word != nullptr && control.frame.tilted) lose_position(run, AxisSet::linear());
  const bool tip_unknown = run.machine_word != nullptr && run.dialect.behaviour.machine_move_tool_unknown;
  if (tip_unknown && control.frame.tool != AxisWords{}) lose_position(run, run.axes & AxisSet::linear());
}

}  // namespace plumbline::nc

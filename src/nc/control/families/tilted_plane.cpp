// Planes that lie askew: G68.2 defines one, G53.1 turns the tool along its Z, G69 ends it.
#include <string_view>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

[[noreturn]] void refuse_beside_plane(const Execution& run, const Word& word, std::string message, std::string help) {
  run.refuse(word, codes::kTiltedPlane, std::move(message), std::move(help));
}

// The cycle that tilts planes, where the control has one.
std::string_view swivel_cycle(const Dialect& dialect) {
  for (const CodeRow& row : dialect.named_codes) {
    if (row.action == Action::swivel) return row.name;
  }
  return {};
}

// A plane's words count from the work system alone: with another shift or turn in force no source says in which order
// they act.
void check_bare_frame(const Execution& run, const Word& code) {
  const Control& control = run.control;
  const std::string_view name = run.block->at(code.span);
  const auto refuse_in_force = [&](std::string_view what, std::string_view way_out) {
    refuse_beside_plane(run, code,
                        fmt::format("{} while {} is in force: how the two go together is in no source", name, what),
                        fmt::format("write {} before it", way_out));
  };
  if (control.frame.tilted)
    refuse_in_force("another tilted plane",
                    swivel_cycle(run.dialect).empty() ? "G69" : std::string(swivel_cycle(run.dialect)) + "()");
  if (control.turn_deg != 0 || control.frame.rotation_deg != 0) refuse_in_force("a turned system", "what ends it");
  if (control.frame.g92 != AxisWords{}) refuse_in_force("a shift by G92", "G92.1");
  if (control.local != AxisWords{}) refuse_in_force("a shift of the work system", "what ends it");
  if (control.feed_rule == FeedRule::tool_tip) refuse_in_force("tool center point control", "G49");
  if (control.modal.motion == MotionMode::cycle) refuse_in_force("a drilling cycle", "G80");
}

// Where X, Y and Z stand in the new system depends on how the control turns the tool.
void lose_linear_axes(Execution& run) {
  if (!run.settings.as_with_empty_tables) run.control.known = run.control.known - AxisSet::linear();
}

RotationOrder order_of(const Execution& run) { return run.settings.rotation_order; }

}  // namespace

FreeRotation free_rotation(const Execution& run) {
  const FreeRotation said = run.settings.free_rotation;
  return said == FreeRotation::unknown && run.settings.as_with_empty_tables ? FreeRotation::c_stays : said;
}

FreeRotation free_rotation(const Execution& run, const Word& word, std::string_view code) {
  const FreeRotation free = free_rotation(run);
  if (free != FreeRotation::unknown) return free;
  run.refuse(word, code,
             fmt::format(
                 "{} turns the tool into a direction, which leaves the rotation about the tool open: what this control "
                 "does with C then, the program does not say",
                 run.block->at(word.span)),
             "say it, if you know it of this control: --free-rotation c-stays or c-zero; or program A, B and C");
}

void begin_tilted_plane(Execution& run, const Word& code, const AxisWords& origin, const Turn& plane) {
  check_bare_frame(run, code);
  need_offsets(run);
  Control& control = run.control;
  Frame next = control.frame;
  next.tilted = true;
  next.plane = plane;
  control.plane_origin = origin;
  next.origin = next.origin + origin;
  control.change_frame(next);
  control.tool_on_plane = false;
  lose_linear_axes(run);
}

// G68.2 X Y Z I J K: the origin in the work system, and Euler angles about Z, X as turned, Z as turned.
void define_tilted_plane(Execution& run, const Chosen& chosen) {
  for (const char letter : {'P', 'Q', 'R'}) {
    const Word* const word = run.words.find(letter);
    if (word == nullptr) continue;
    refuse_beside_plane(run, *word,
                        fmt::format("{} {} says otherwise how the plane lies, which no source at hand covers",
                                    run.block->at(chosen.word->span), run.block->at(word->span)),
                        letter == 'P' && word->value == 0
                            ? "leave P0 out, where it says that I J K are Euler angles about Z, X and Z"
                            : "give the plane by its origin and Euler angles: G68.2 X Y Z I J K");
  }
  if (counts_increments(run)) {
    refuse_beside_plane(run, *chosen.word,
                        "whether the origin of a plane counts by increments under G91 is in no source",
                        "write G90 before it");
  }
  const std::string name(run.block->at(chosen.word->span));
  AxisWords origin;
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    run.need(letter(axis), name);
    origin[axis] = run.value(axis);
  }
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
    if (run.axes.contains(axis)) check_no_rotary_words(run);
  }
  const std::array<double, 3> angles{run.need('I', name).value, run.need('J', name).value, run.need('K', name).value};
  begin_tilted_plane(run, *chosen.word, origin, turned_in_turn("ZXZ", angles));
}

// The rotary axes turn, and X, Y, Z may follow the tip or not.
void turn_tool_on_plane(Execution& run, const Word& code) {
  Control& control = run.control;
  const Turn& plane = control.frame.plane;
  Orienting orienting{{plane[2], plane[5], plane[8]}, order_of(run), free_rotation(run, code, codes::kTiltedPlane), 0};
  const AxisWords& zero = control.frame.origin;
  if (orienting.free == FreeRotation::c_stays) {
    if (!control.known.contains(Axis::C)) {
      refuse_beside_plane(run, code, "where C stands is not known, and A and B depend on it",
                          std::string(kWhereCStands));
    }
    orienting.c_deg = control.position[Axis::C] + zero[Axis::C];
  } else if (zero[Axis::C] != 0) {
    refuse_beside_plane(run, code, "C goes to zero, and the work offset moves that zero",
                        "give an offset without C, or say that C stays: --free-rotation c-stays");
  }
  const auto pose = orientation_along(orienting.along, orienting.order, orienting.c_deg);
  if (!pose) {
    refuse_beside_plane(run, code, "the tool cannot be tilted so far: the plane's Z points sideways or down",
                        "look at the angles of the plane; a hexapod tilts by some tens of degrees");
  }
  Motion motion;
  motion.kind = MotionKind::rapid;
  motion.in_machine_coordinates = true;
  motion.to = control.position;
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) motion.to[axis] = (*pose)[axis] - zero[axis];
  motion.known_after = control.known | AxisSet::rotary();
  if (!run.settings.as_with_empty_tables) motion.known_after = motion.known_after - AxisSet::linear();
  run.step.role = BlockRole::machine_move;
  run.step.orienting = orienting;
  add_motion(run, motion);
  control.tool_on_plane = true;
}

void turn_tool(Execution& run, const Chosen& chosen) {
  if (run.control.frame.tilted) return turn_tool_on_plane(run, *chosen.word);
  refuse_beside_plane(run, *chosen.word, fmt::format("{} without a tilted plane", run.block->at(chosen.word->span)),
                      "write G68.2 X Y Z I J K before it");
}

void end_tilted_plane(Execution& run) {
  Control& control = run.control;
  if (!control.frame.tilted) return;
  Frame next = control.frame;
  next.tilted = false;
  next.plane = kNoTurn;
  next.origin = next.origin - control.plane_origin;
  control.plane_origin = {};
  control.change_frame(next);
  lose_linear_axes(run);
}

void check_on_plane(const Execution& run) {
  const Control& control = run.control;
  if (!control.frame.tilted) return;
  check_no_rotary_words(run);
  if (control.tool_on_plane) return;
  refuse_beside_plane(run, run.motion_code(), "a plane is tilted, and the tool was not turned along its Z yet",
                      swivel_cycle(run.dialect).empty() ? "write G53.1 after G68.2"
                                                        : "let the cycle turn the axes: its direction 1 or -1");
}

// What the axes do then, and about which point, no source says.
void check_no_rotary_words(const Execution& run) {
  if (!run.control.frame.tilted && run.chosen_row(Action::tilted_plane) == nullptr) return;
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
    if (!run.axes.contains(axis)) continue;
    const Word* const word = run.words.find(axis);
    refuse_beside_plane(
        run, word != nullptr ? *word : *run.vector,
        fmt::format("{} in a tilted plane: what a rotary word means there was found in no source", letter(axis)),
        "turn the axes before the plane begins, or end it");
  }
}

void check_no_plane(const Execution& run, const Word& word) {
  if (!run.control.frame.tilted) return;
  refuse_beside_plane(run, word,
                      fmt::format("{} in a tilted plane is not interpreted: no source says in which system it counts",
                                  run.block->at(word.span)),
                      "end the plane before it, and define it again after it");
}

}  // namespace plumbline::nc

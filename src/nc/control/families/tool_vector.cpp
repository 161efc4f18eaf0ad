// The direction of the tool as a vector from its tip to the spindle: A3= B3= C3=, or I J K under G43.5. A and B follow
// from it, C is what --free-rotation says.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kSameWay = 0.01;    // deg between two ways to turn that are taken for one
constexpr double kSameTime = 0.001;  // of a block
constexpr std::array kRotaryAxes{Axis::A, Axis::B, Axis::C};

[[noreturn]] void refuse_vector(const Execution& run, std::string message, std::string help) {
  run.refuse(*run.vector, codes::kToolVector, std::move(message), std::move(help));
}

bool is_taken(const Execution& run, char letter) {
  for (const Chosen& chosen : run.chosen) {
    if (chosen.row->group != kMotionGroup && (chosen.row->word_mask & letter_bit(letter)) != 0) return true;
  }
  return false;
}

double component(const Execution& run, char letter) {
  const Word* const word = run.words.find(letter);
  return word == nullptr ? 0 : word->value;
}

// What is not written is 0, and the length of the vector does not count [W 7-20; T 9].
ToolDirection direction(const Execution& run) {
  return {component(run, 'I'), component(run, 'J'), component(run, 'K')};
}

// I1 counts thousandths where I1. counts units.
void check_points(const Execution& run) {
  if (run.dialect.behaviour.increment_mm == 0 || run.settings.calculator_type.value_or(false)) return;
  const Word* first = nullptr;
  for (const char letter : kCentreLetters) {
    const Word* const word = run.words.find(letter);
    if (word == nullptr || word->value == 0 || word->expression != kLiteral) continue;
    if (first != nullptr && first->point != word->point) {
      run.refuse(*word, codes::kToolVector,
                 "parts of the direction with a decimal point and without one: what each of them counts is not known",
                 "write all of them with a point");
    }
    first = word;
  }
}

void check_mode(const Execution& run, bool straight) {
  if (!run.control.tool_vectors || run.chosen_row(Action::tool_length_off) != nullptr) return;
  for (const Axis axis : kRotaryAxes) {
    if (!run.axes.contains(axis) || run.chosen_row(Action::go_home) != nullptr) continue;
    run.refuse(*run.words.find(axis), codes::kToolVector,
               fmt::format("{} where I, J and K give the direction of the tool", letter(axis)),
               "write the direction, or G43.4 before it");
  }
  if (run.motion == nullptr || straight || run.motion->action != Action::cycle) return;
  run.refuse(run.motion_code(), codes::kToolVector,
             "a drilling cycle where I, J and K give the direction of the tool is not interpreted",
             "write G49 or G43 before it");
}

// What the direction counts in where the work system is turned or its A, B, C are shifted is in no source.
void check_frame(const Execution& run) {
  const Frame& frame = run.control.frame;
  if (!frame.mixed().empty()) {
    refuse_vector(run, "a direction of the tool in a turned system is not interpreted", "end the turn before it");
  }
  const AxisWords shift = frame.origin + frame.g92 + frame.tool;
  for (const Axis axis : kRotaryAxes) {
    if (shift[axis] == 0) continue;
    refuse_vector(run,
                  fmt::format("an offset shifts {}, and whether it turns the direction of the tool was found in no "
                              "source",
                              letter(axis)),
                  "choose a work offset whose A, B and C are 0, or program A, B and C");
  }
}

void check_words(const Execution& run) {
  if (!(run.axes & AxisSet::rotary()).empty()) {
    refuse_vector(run, "the direction of the tool is given twice: by a vector, and by A, B or C", "leave one of them");
  }
  for (const char letter : kCentreLetters) {
    const Word* const word = run.words.find(letter);
    if (word == nullptr || word->mode == WordMode::modal) continue;
    refuse_vector(run, "a part of a direction is a plain value", "write it as in A3=0.5");
  }
  if (counts_increments(run))
    refuse_vector(run, "a direction of the tool under G91 is not interpreted", "write G90 before it");
  check_points(run);
}

ToolDirection between(const ToolDirection& a, const ToolDirection& b) {
  const ToolDirection sum{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  const double size = std::hypot(sum[0], sum[1], sum[2]);
  return {sum[0] / size, sum[1] / size, sum[2] / size};
}

double angle_deg(const ToolDirection& a, const ToolDirection& b) {
  const double chord = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  return 2 * std::asin(std::min(chord / 2, 1.0)) / kDeg;
}

// F counts the travel of A, B and C, or the angle between the directions [F p. 277].
void check_feed(const Execution& run, const Motion& motion, double angle) {
  const bool counts_turns = run.control.feed_rule == FeedRule::all_axes_as_mm && !run.settings.feed_rule;
  if (!counts_turns || run.control.modal.feed_mode == FeedMode::inverse_time) return;
  const AxisWords travel = motion.to - run.control.position;
  const double linear = std::hypot(travel[Axis::X], travel[Axis::Y], travel[Axis::Z]);
  const double by_axes = std::hypot(travel[Axis::A], travel[Axis::B], travel[Axis::C]);
  if (std::abs(std::hypot(linear, by_axes) - std::hypot(linear, angle)) <= kSameTime * std::hypot(linear, angle))
    return;
  refuse_vector(run,
                "the tool turns in this block, and whether F counts the angle between the directions or the travel of "
                "A, B and C depends on the settings of the control",
                "write FGROUP(X,Y,Z), or say how the control counts: --feed-rule xyz (F is the speed along X, Y, Z) or "
                "--feed-rule all");
}

}  // namespace

void find_tool_vector(Execution& run) {
  run.vector = nullptr;
  const bool by_code = run.control.tool_vectors || std::any_of(run.chosen.begin(), run.chosen.end(),
                                                               [](const Chosen& c) { return c.row->tool_vectors; });
  for (const char letter : kCentreLetters) {
    const Word* const word = run.words.find(letter);
    if (word == nullptr || run.vector != nullptr) continue;
    if (word->use == WordUse::tool_vector || (by_code && !is_taken(run, letter))) run.vector = word;
  }
}

void check_tool_vector(Execution& run) {
  const bool straight = run.motion != nullptr && run.machine_word == nullptr &&
                        (run.motion->action == Action::rapid || run.motion->action == Action::feed);
  check_mode(run, straight);
  if (run.vector == nullptr) return;
  if (!straight || run.chosen_row(Action::tool_length) != nullptr) {
    refuse_vector(run, "a direction of the tool belongs to a straight move in the work system",
                  fmt::format("put it into a block of its own with G0 or G1; an arc takes {}, and no direction",
                              run.dialect.syntax.names ? "CR=" : "R"));
  }
  check_words(run);
  if (run.control.modal_call.row != nullptr) {
    refuse_vector(run, "a drilling cycle is called after each move, and this one turns the tool",
                  "turn the tool before MCALL");
  }
  for (const RotaryRule rule : run.control.modal.rotary) {
    if (rule == RotaryRule::linear) continue;
    refuse_vector(run, "which way round an axis without end turns to a direction is not known",
                  "write A, B and C, or leave --rotary out");
  }
  run.axes = run.axes | AxisSet::rotary();
  run.step.end_words = EndWords::tool_vector;
}

void end_along_vector(const Execution& run, Motion& motion) {
  check_frame(run);
  const Control& control = run.control;
  const FreeRotation free = free_rotation(run, *run.vector, codes::kToolVector);
  double c_deg = 0;
  if (free == FreeRotation::c_stays) {
    if (!control.known.contains(Axis::C)) {
      refuse_vector(run, "where C stands is not known, and A and B depend on it", std::string(kWhereCStands));
    }
    c_deg = control.position[Axis::C];
  }
  const auto pose = orientation_along(direction(run), run.settings.rotation_order, c_deg);
  if (!pose) {
    refuse_vector(run, "the tool cannot be tilted so far: the direction is none, or points sideways or down",
                  "the vector points from the tip of the tool to the spindle: K (C3) is above 0");
  }
  for (const Axis axis : kRotaryAxes) motion.to[axis] = (*pose)[axis];
  motion.known_after = motion.known_after | AxisSet::rotary();
}

// Between its ends the tool turns as A, B and C go on evenly (ORIMKS, ORIAXES), or along a great circle (ORIWKS,
// ORIVECT) [N p. 674, p. 1262; Fanuc: in no source].
void check_way_of_vector(const Execution& run, const Motion& motion) {
  const Control& control = run.control;
  if (run.settings.as_with_empty_tables || !control.known.contains(AxisSet::rotary())) return;
  const RotationOrder& order = run.settings.rotation_order;
  const ToolDirection from = direction_of(order, control.position);
  const ToolDirection to = direction_of(order, motion.to);
  AxisWords middle;
  for (const Axis axis : kRotaryAxes) middle[axis] = (control.position[axis] + motion.to[axis]) / 2;
  if (angle_deg(between(from, to), direction_of(order, middle)) > kSameWay) {
    refuse_vector(
        run,
        "the tool turns so far in this block that it matters how: A, B and C evenly, or along a great circle, "
        "which settings of the control decide",
        "let the CAM system write shorter blocks, or A, B and C in place of the vector");
  }
  check_feed(run, motion, angle_deg(from, to));
}

}  // namespace plumbline::nc

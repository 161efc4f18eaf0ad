// Where the cycles of an OSP go back to: G71, M53, M54.
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr double kSameZero = 1e-6;  // mm

double shift_along(const Control& control, Axis normal) {
  return control.frame.to_machine(control.position)[normal] - control.position[normal];
}

// Whether the level is kept as a word or as a place of the machine was found in no source.
void check_level_holds(const Execution& run, Axis normal) {
  const ReturnLevel& stated = *run.control.return_level;
  const bool same = stated.normal == normal && std::abs(stated.shift - shift_along(run.control, normal)) <= kSameZero;
  if (same) return;
  const std::string anew =
      fmt::format("state it anew: write G71 {}.. after the change, before the cycle", letter(normal));
  if (stated.normal != normal) {
    run.refuse(
        run.motion_code(), codes::kNotInterpreted,
        fmt::format("the level that M53 goes back to was stated along {}, in another plane", letter(stated.normal)),
        anew);
  }
  run.refuse(
      run.motion_code(), codes::kNotInterpreted,
      fmt::format("the zero of {} has changed (a tool's length, a work offset or G92) since G71 stated the level "
                  "that M53 goes back to, and no source says whether that level goes along",
                  letter(normal)),
      anew);
}

}  // namespace

void set_return_level(Execution& run, const Word& code) {
  Control& control = run.control;
  const Axis normal = axes_of(control.modal.plane).third;
  if (control.modal.incremental) {
    run.refuse(code, codes::kNotInterpreted, "what a return level counts from under G91 was found in no source",
               "write G90 before it");
  }
  if (run.axes != AxisSet{normal}) {
    run.refuse(code, codes::kAxesUnused, fmt::format("a return level is one word, {}", letter(normal)),
               fmt::format("write it as in {} {}50", run.block->at(code.span), letter(normal)));
  }
  need_offsets(run);
  control.return_level = ReturnLevel{normal, run.value(normal), shift_along(control, normal)};
}

// What G71 says under M53, R under M54.
double cycle_return_level(const Execution& run, double r) {
  const Control& control = run.control;
  const Axis normal = axes_of(control.modal.plane).third;
  if (control.cycle_return == Control::Return::r) return r;
  if (control.cycle_return == Control::Return::unknown) {
    run.refuse(
        run.motion_code(), codes::kNotInterpreted,
        "neither M53 nor M54 says where this cycle goes back to, and which is in force at the start is not known",
        "write M53 with G71 before it, or M54");
  }
  if (!control.return_level) {
    run.refuse(run.motion_code(), codes::kNotInterpreted, "M53 goes back to a level that no G71 of the program states",
               fmt::format("write G71 {}.. before the cycle", letter(normal)));
  }
  check_level_holds(run, normal);
  const double level = control.return_level->level;
  if (level >= r) return level;
  run.refuse(run.motion_code(), codes::kNotInterpreted,
             fmt::format("the return level, {}{:.6g}, lies below R", letter(normal), level),
             "state a level at or above R with G71");
}

// How the tool comes to above the first hole is in sources for a tool that stands on the return level already.
void check_cycle_start(const Execution& run, std::array<double, 2> hole, double r, double level) {
  const Control& control = run.control;
  const PlaneAxes axes = axes_of(control.modal.plane);
  const double now = control.position[axes.third];
  const bool above = hole[0] == control.position[axes.first] && hole[1] == control.position[axes.second] &&
                     run.chosen_row(Action::no_hole) == nullptr;  // which may leave the tool there, or on the level
  if (std::abs(now - level) < kSameLevel || (above && now >= r)) return;
  run.refuse(
      run.motion_code(), codes::kNotInterpreted,
      fmt::format("the tool stands at {0}{1:.6g} and not at {0}{2:.6g}, where the cycle goes back to: how it comes "
                  "to the first hole from there was found in no source",
                  letter(axes.third), now, level),
      fmt::format("move to {}{:.6g} with G0 before the cycle", letter(axes.third), level));
}

// G80 is of another group than G0, which a cycle leaves in force. Of G1, G2 and G3 no source says it. Where no cycle is
// in force it ends nothing.
const CodeRow* row_after_cycle(const Execution& run) {
  const Control& control = run.control;
  if (!run.dialect.behaviour.rapid_after_cycles) return nullptr;
  if (control.modal.motion != MotionMode::cycle) return control.motion_row;
  const CodeRow* const before = control.row_before_cycle;
  return before != nullptr && before->action == Action::rapid ? before : nullptr;
}

}  // namespace plumbline::nc

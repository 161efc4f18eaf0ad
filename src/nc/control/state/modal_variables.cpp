#include "nc/control/state/modal_variables.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {
namespace {

// 4000 and the group, 4100 and what a letter said last [Z; K; V 13.5]
enum ModalVariable : int {
  shows_motion = 4001,
  shows_plane = 4002,
  shows_distance = 4003,
  shows_feed_mode = 4005,
  shows_unit = 4006,
  shows_cycle = 4009,
  shows_return = 4010,
  shows_system = 4014,
  shows_feed = 4109,
  shows_speed = 4119,
  shows_tool = 4120,
  shows_further_system = 4130,
};
constexpr int kOfWorkSystems = 6;  // G54 to G59; the others by their P

double number_of(const CodeRow& row) { return row.code / 10.0; }

// A cycle is of another group, and the motion before it goes on being shown.
std::optional<double> motion_shown(const Control& control) {
  const bool in_cycle = control.modal.motion == MotionMode::cycle;
  const CodeRow* const row = in_cycle ? control.row_before_cycle : control.motion_row;
  return row == nullptr ? std::nullopt : std::optional(number_of(*row));
}

double cycle_shown(const Control& control) {
  return control.modal.motion == MotionMode::cycle ? number_of(*control.motion_row) : 80;
}

double feed_mode_shown(FeedMode mode) {
  switch (mode) {
    case FeedMode::inverse_time:
      return 93;
    case FeedMode::per_minute:
      return 94;
    default:
      return 95;
  }
}

std::optional<double> shown(const Control& control, int number) {
  const Modal& modal = control.modal;
  switch (number) {
    case shows_motion:
      return motion_shown(control);
    case shows_plane:
      return 17.0 + static_cast<double>(modal.plane);
    case shows_distance:
      return modal.incremental ? 91 : 90;
    case shows_feed_mode:
      return feed_mode_shown(modal.feed_mode);
    case shows_unit:
      return modal.inches ? 20 : 21;
    case shows_cycle:
      return cycle_shown(control);
    case shows_return:
      return modal.retract_to_r ? 99 : 98;
    case shows_system:
      return modal.work_system > kOfWorkSystems ? 54.1 : 53.0 + modal.work_system;
    case shows_feed:
      return modal.feed_mode == FeedMode::per_minute && modal.feed > 0 ? std::optional(modal.feed) : std::nullopt;
    case shows_speed:
      return control.spindle_speed > 0 ? std::optional(control.spindle_speed) : std::nullopt;
    case shows_tool:
      return control.selected_tool >= 0 ? std::optional<double>(control.selected_tool) : std::nullopt;
    case shows_further_system:
      return modal.work_system > kOfWorkSystems ? std::optional<double>(modal.work_system - kOfWorkSystems)
                                                : std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<Value> modal_variable(const Control& control, int number) {
  const std::optional<double> value = shown(control, number);
  return value ? std::optional(Value{*value, true}) : std::nullopt;
}

void refuse_unread_variable(const Block& block, int number, Span span) {
  constexpr std::array kAll{shows_motion, shows_plane, shows_distance, shows_feed_mode,
                            shows_unit,   shows_cycle, shows_return,   shows_system,
                            shows_feed,   shows_speed, shows_tool,     shows_further_system};
  const bool is_modal = std::find(kAll.begin(), kAll.end(), number) != kAll.end();
  refuse_at(block, span, codes::kNotInterpreted,
            fmt::format("#{} {}", number,
                        is_modal ? "shows what a block before has left in force, and no block of this program has"
                                 : "is a variable of the control itself, which is not interpreted"),
            is_modal ? "write the code, or the F, S or T, that it shows before this block"
                     : "write the value itself; #1 to #33, #100 to #199 and #500 to #999 are the program's");
}

}  // namespace plumbline::nc

#include "nc/control/state/named_parameters.hpp"

#include <algorithm>
#include <array>

namespace plumbline::nc {
namespace {

constexpr double kMotionOff = 800;       // G80
constexpr double kNoMotionMode = -1;     // after a NURBS [LinuxCNC, measured]
constexpr double kNoCompensation = 400;  // G40

struct Name {
  std::string_view name;
  Value (*value)(const Control&);
};

Value flag(bool value) { return {value ? 1.0 : 0.0, true}; }
Value only_the_machine_knows(const Control&) { return {0, false}; }
Value always_zero(const Control&) { return {0, true}; }
Value always_one(const Control&) { return {1, true}; }

// As the table of names in the manual has them [LinuxCNC, "Parameters": predefined named parameters].
constexpr std::array kNames{
    Name{"_vmajor", [](const Control&) { return Value{2.9}; }},
    Name{"_vminor", always_zero},
    Name{"_metric", [](const Control& c) { return flag(!c.modal.inches); }},
    Name{"_imperial", [](const Control& c) { return flag(c.modal.inches); }},
    Name{"_absolute", [](const Control& c) { return flag(!c.modal.incremental); }},
    Name{"_incremental", [](const Control& c) { return flag(c.modal.incremental); }},
    Name{"_inverse_time", [](const Control& c) { return flag(c.modal.feed_mode == FeedMode::inverse_time); }},
    Name{"_units_per_minute", [](const Control& c) { return flag(c.modal.feed_mode == FeedMode::per_minute); }},
    Name{"_units_per_rev", [](const Control& c) { return flag(c.modal.feed_mode == FeedMode::per_revolution); }},
    Name{"_ijk_absolute_mode", [](const Control& c) { return flag(c.modal.arc_centre_absolute); }},
    Name{"_retract_r_plane", [](const Control& c) { return flag(c.modal.retract_to_r); }},
    Name{"_retract_old_z", [](const Control& c) { return flag(!c.modal.retract_to_r); }},
    Name{"_spindle_css_mode", [](const Control& c) { return flag(c.modal.switches.surface_speed); }},
    Name{"_spindle_rpm_mode", [](const Control& c) { return flag(!c.modal.switches.surface_speed); }},
    Name{"_lathe_diameter_mode", always_zero},
    Name{"_lathe_radius_mode", always_one},
    Name{"_ccomp", [](const Control&) { return Value{kNoCompensation}; }},
    Name{"_tool_offset", [](const Control& c) { return flag(c.frame.tool != AxisWords{}); }},
    Name{"_plane", [](const Control& c) { return Value{170.0 + 10.0 * static_cast<double>(c.modal.plane)}; }},
    Name{"_coord_system",
         [](const Control& c) {
           return Value{c.modal.work_system <= 6 ? 530.0 + 10 * c.modal.work_system : 584.0 + c.modal.work_system};
         }},
    Name{"_spindle_on", [](const Control& c) { return flag(c.modal.switches.spindle != kSpindleStands); }},
    Name{"_spindle_cw", [](const Control& c) { return flag(c.modal.switches.spindle == kClockwise); }},
    Name{"_mist", [](const Control& c) { return flag(c.modal.switches.mist); }},
    Name{"_flood", [](const Control& c) { return flag(c.modal.switches.flood); }},
    Name{"_speed_override", [](const Control& c) { return flag(c.modal.switches.speed_override); }},
    Name{"_feed_override", [](const Control& c) { return flag(c.modal.switches.feed_override); }},
    Name{"_adaptive_feed", [](const Control& c) { return flag(c.modal.switches.adaptive_feed); }},
    Name{"_feed_hold", [](const Control& c) { return flag(c.modal.switches.feed_stop); }},
    // The number after F: a change of units leaves it as it is [LinuxCNC, measured].
    Name{"_feed",
         [](const Control& c) {
           return Value{c.modal.feed_rotary, c.modal.feed_mode != FeedMode::inverse_time};
         }},
    Name{"_rpm", [](const Control& c) { return Value{c.spindle_speed}; }},
    Name{"_current_pocket", only_the_machine_knows},
    Name{"_selected_pocket", only_the_machine_knows},
    Name{"_remap_level", always_zero},
    Name{"_u", always_zero},
    Name{"_v", always_zero},
    Name{"_w", always_zero},
};
constexpr std::array<std::string_view, kAxes> kPositions{"_x", "_y", "_z", "_a", "_b", "_c"};
constexpr std::array<std::string_view, kAxes> kMachinePositions{"_abs_x", "_abs_y", "_abs_z",
                                                                "_abs_a", "_abs_b", "_abs_c"};
// What the control alone does not hold.
constexpr std::array<std::string_view, 8> kOthers{"_line",          "_call_level", "_motion_mode",    "_current_tool",
                                                  "_selected_tool", "_value",      "_value_returned", "_task"};

std::optional<Axis> axis_named(const std::array<std::string_view, kAxes>& names, std::string_view plain) {
  const auto* const at = std::find(names.begin(), names.end(), plain);
  if (at == names.end()) return std::nullopt;
  return kAllAxes[static_cast<std::size_t>(at - names.begin())];
}

// That of the last T.
Value selected_tool(const Control& control, const ProgramSettings& settings) {
  if (control.selected_tool >= 0) return {static_cast<double>(control.selected_tool), true};
  return {0, settings.as_with_empty_tables};
}

// What was in force before the first motion code depends on what ran before.
Value motion_mode(const Control& control, const ProgramSettings& settings) {
  if (control.motion_row != nullptr) return {static_cast<double>(control.motion_row->code), true};
  if (control.motion_end == Control::MotionEnd::nurbs_end) return {kNoMotionMode, true};
  return {kMotionOff, control.motion_end == Control::MotionEnd::off || settings.as_with_empty_tables};
}

}  // namespace

bool is_predefined(std::string_view plain) {
  const auto is_it = [&](const Name& known) { return known.name == plain; };
  return std::any_of(kNames.begin(), kNames.end(), is_it) || position_named(plain) || machine_position_named(plain) ||
         std::find(kOthers.begin(), kOthers.end(), plain) != kOthers.end();
}

std::optional<Value> predefined(const Control& control, const ProgramSettings& settings, std::string_view plain) {
  for (const Name& known : kNames) {
    if (known.name == plain) return known.value(control);
  }
  if (plain == "_motion_mode") return motion_mode(control, settings);
  if (plain == "_selected_tool") return selected_tool(control, settings);
  return std::nullopt;
}

bool is_rewritten(std::string_view plain) {
  constexpr std::array<std::string_view, 4> kRewritten{"_feed", "_motion_mode", "_retract_r_plane", "_retract_old_z"};
  return std::find(kRewritten.begin(), kRewritten.end(), plain) != kRewritten.end();
}

std::optional<Axis> position_named(std::string_view plain) { return axis_named(kPositions, plain); }
std::optional<Axis> machine_position_named(std::string_view plain) { return axis_named(kMachinePositions, plain); }

}  // namespace plumbline::nc

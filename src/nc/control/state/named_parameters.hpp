// Parameters that have names of the control's own: #<_feed>, #<_spindle_on> and the like.
#pragma once

#include <optional>
#include <string_view>

#include "nc/control/state/control.hpp"

namespace plumbline::nc {

/// True for a name that the control has itself; `plain` in small letters without blanks.
bool is_predefined(std::string_view plain);

/// What it is worth, unknown where only the machine knows; nothing for other names, and for those that show positions,
/// the line or the depth of calls.
std::optional<Value> predefined(const Control& control, const ProgramSettings& settings, std::string_view plain);

/// Whether a rewritten program has another value of it where this one stands: pieces have their own F, and cycles and
/// arcs become other moves.
bool is_rewritten(std::string_view plain);

/// The axis whose place in the work system, or on the control's display, the name shows.
std::optional<Axis> position_named(std::string_view plain);
std::optional<Axis> machine_position_named(std::string_view plain);

}  // namespace plumbline::nc

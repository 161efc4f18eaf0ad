// Variables of macro B that show which codes are in force: #4001 to #4020, #4109, #4119, #4120, #4130.
#pragma once

#include <optional>

#include "nc/control/parameters/expression.hpp"
#include "nc/control/state/control.hpp"

namespace plumbline::nc {

/// What the blocks before left in force, as the variable shows it; nothing for other variables, for groups that are not
/// followed, and where no block said it and the control's settings decide.
std::optional<Value> modal_variable(const Control& control, int number);

/// Refuses a variable of the control that is not read, or not yet.
[[noreturn]] void refuse_unread_variable(const Block& block, int number, Span span);

}  // namespace plumbline::nc

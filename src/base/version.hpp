// The version of plumbline.
#pragma once

#include <string_view>

namespace plumbline {

/// As in "0.1.0".
constexpr std::string_view version() { return PLUMBLINE_VERSION; }

}  // namespace plumbline

// H words of a SINUMERIK: functions that the control hands to the machine's PLC.
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

namespace plumbline::nc {

/// Why one is refused [Basic Functions 840D sl, 6FC5397-0BP40-5BA2, p. 852].
inline std::string user_function_text(std::string_view word) {
  return fmt::format(
      "{} is an auxiliary function that the control hands to its PLC: what the machine does then its "
      "builder alone knows",
      word);
}
inline constexpr std::string_view kUserFunctionHelp =
    "take it out of the program that is compensated; --pass lets M codes of the builder through, and no H word";

}  // namespace plumbline::nc

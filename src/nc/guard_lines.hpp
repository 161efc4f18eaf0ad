// The guard of a compensated program (--guard): lines that stop a control which is set otherwise. Where they do not
// stop it, they leave it as they found it; so who reads the program passes over them.
#pragma once

#include <string_view>

namespace plumbline::nc {

inline constexpr std::string_view kGuardBegins = "(guard: the control must be set as this program was made for)";
inline constexpr std::string_view kGuardEnds = "(guard: passed)";

/// True of the lines that a guard is made of, between these two.
constexpr bool is_guard_line(std::string_view line) {
  for (const std::string_view begin : {"#<plumbline_", "o<plumbline_", "(MSG, plumbline guard: ", "G43 H"}) {
    if (line.starts_with(begin)) return true;
  }
  const bool system = line.starts_with("G5") && line.size() <= 5 && line.find(' ') == std::string_view::npos;
  return line == "M2" || line == "G49" || (system && line >= "G54");
}

}  // namespace plumbline::nc

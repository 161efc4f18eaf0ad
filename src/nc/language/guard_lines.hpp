// The guard of a compensated program (--guard): lines that stop a control which is set otherwise. Where they do not
// stop it, they leave it as they found it; so who reads the program passes over them.
#pragma once

#include <string_view>

#include "nc/language/dialect.hpp"

namespace plumbline::nc {

inline constexpr std::string_view kGuardBegins = "guard: the control must be set as this program was made for";
inline constexpr std::string_view kGuardEnds = "guard: passed";

/// Whether the line is one of these two as a comment of the dialect: a guard stands between them.
bool is_guard_line(std::string_view line, std::string_view text, const Dialect& dialect);

/// True of the lines that a guard of the dialect is made of, between these two.
bool is_part_of_guard(std::string_view line, const Dialect& dialect);

}  // namespace plumbline::nc

// The lines of a guard, a control's language each, without the comments that it stands between.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nc/sequence/program.hpp"

namespace plumbline::jobs {

inline constexpr std::string_view kGuardTolerance = "0.001";  // mm and deg

/// Custom macro B: alarm 3101 where the control starts in inches, with another work system than G54, with a tool
/// length or a shift by G92 or G52, where the sum of a work offset and the external one differs, or where an axis of
/// `assumed` stands elsewhere. Tool lengths are not compared: which variables hold them depends on the memory of the
/// control. Refuses with guard-system beyond G54.1 P48.
std::vector<std::string> fanuc_guard(const nc::ProgramSettings& program, AxisSet assumed, const nc::Dialect& dialect);

/// SINUMERIK: a message, M0 and M30 where the frames of a work system add up to another shift or to a turn, or where an
/// axis of `assumed` stands elsewhere. It chooses each of these systems, and G500 in the end. Tool lengths are not
/// compared.
std::vector<std::string> siemens_guard(const nc::ProgramSettings& program, AxisSet assumed, const nc::Dialect& dialect);

}  // namespace plumbline::jobs

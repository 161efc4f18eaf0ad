// The lines of a guard, a control's language each, without the comments that it stands between.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compensate/program_survey.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::jobs {

inline constexpr std::string_view kGuardTolerance = "0.001";  // mm and deg

/// LinuxCNC: a message and M2 where the control starts with another work system, another G92, another unit, distance
/// mode or feed mode that the program does not state, a tool offset, another tool in the spindle if that was given,
/// where an axis stands elsewhere than given, where a work system or a tool offset differs.
std::vector<std::string> linuxcnc_guard(const nc::ProgramSettings& program, const compensate::ProgramSurvey& survey);

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

// The interpreted motion of a program, one JSON object a line.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/files.hpp"
#include "base/progress.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline {

/// Writes a line for each motion that `program` makes, in order: line, motion, to, machine (mm, deg), feed, feed_mode,
/// and for arcs plane, centre (mm, in the work system) and turns (negative: clockwise). Rapids and dwells have feed 0.
/// Refuses what nc::Program refuses.
void trace(const InputFile& program, const nc::Dialect& dialect, nc::ProgramSettings settings,
           const std::function<void(std::string_view)>& write, const Progress& progress = {});
void trace(const InputFile& program, const nc::Dialect& dialect, nc::ProgramSettings settings, OutputFile& output,
           const Progress& progress = {});

/// One line of a trace, with its line end, appended to `out`.
void append_trace_line(std::string& out, const nc::Motion& motion);

}  // namespace plumbline

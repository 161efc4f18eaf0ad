// The motion of a program, one JSON object a line.
#pragma once

#include <string>

#include "base/files/files.hpp"
#include "nc/control/state/motion.hpp"

namespace plumbline::report {

/// One line, with its line end, appended to `out`: line, motion, to, machine (mm, deg), feed, feed_mode, and for arcs
/// plane, centre (mm, in the work system) and turns (negative: clockwise). Rapids and dwells have feed 0.
void append_trace_line(std::string& out, const nc::Motion& motion);

/// Writes these lines into a file.
class TraceWriter {
 public:
  explicit TraceWriter(OutputFile& output) : output_(output) {}
  void add(const nc::Motion& motion);
  /// To be called after the last one.
  void flush();

 private:
  OutputFile& output_;
  std::string text_;
};

}  // namespace plumbline::report

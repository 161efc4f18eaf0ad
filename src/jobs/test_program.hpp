// The NC program of a circular test.
#pragma once

#include <string>

#include "machine/model.hpp"
#include "measure/dataset.hpp"
#include "nc/language/dialect.hpp"

namespace plumbline::jobs {

struct TestProgramOptions {
  double retreat = 0.050;                 // m, the highest that the tool goes up to before and after the test
  double retreat_step = 0.010;            // m, by which it goes less high where the machine's limits are near
  double reserve = 0.001;                 // m, up to these limits, for the correction of the program
  double approach_feed = 1000.0 / 60000;  // m/s, the fastest that it goes down
};

/// A program that makes the circle of a run: to above the start, down, a stop at which the bar is put in, half a turn
/// as a run-in, the turn that is measured from angle 0, half a turn more, a stop at which the bar is taken out, up.
/// Positions are those of the tool tip in W: a guard (guard_block.hpp), where the dialect has one, stops the control if
/// the first work system is shifted or a tool length acts. All at constant feed and tilt.
std::string test_program(const machine::MachineModel& machine, const measure::Run& run, const nc::Dialect& dialect,
                         const TestProgramOptions& options = {});

/// "01-ccw.ngc": a name for it, of letters, digits, - and _ alone, as the dialect's programs end.
std::string test_program_name(const std::string& id, const nc::Dialect& dialect);

}  // namespace plumbline::jobs

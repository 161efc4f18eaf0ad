// The path of a program on a page: in space with the machine, along the program, its worst places.
#pragma once

#include <string>

#include "compensate/recorded/drawn_path.hpp"
#include "machine/model.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// What the points of a path hold.
struct PathKind {
  bool corrected = false;     // the machine is told something else than the original says
  std::string told = "told";  // what that is called
};

/// Columns in mm, deg, um, mdeg, N, mm/min, ms, s; places in the machine's own coordinates (W).
Json program_section(const compensate::DrawnPath& path, const machine::MachineModel& model, const PathKind& kind);

}  // namespace plumbline::report

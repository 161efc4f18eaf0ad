// The path of a program on a page: in space with the machine, along the program, its worst places.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "compensate/recorded/drawn_path.hpp"
#include "jobs/expected/tip_doubts.hpp"
#include "machine/model.hpp"
#include "report/page/page.hpp"

namespace plumbline::report {

/// What the points of a path hold, and what the page calls it.
struct PathKind {
  bool corrected = false;                         // there are other places beside those that the program asks for
  std::string shift = "correction";               // from these to those
  std::string told = "what the control is told";  // those
  std::string replaced = "written for it";        // a text that stands for a block
  std::string program = {};                       // its file; lines of others are shown with their file's name
  std::span<const std::optional<jobs::PoseDoubt>> doubts = {};  // at its points, how far off the tip may be; or none
};

/// Columns in mm, deg, um, mdeg, N, mm/min, ms, s; places in the machine's own coordinates (W). `model`: null where the
/// path has no machine.
Json program_section(const compensate::DrawnPath& path, const machine::MachineModel* model, const PathKind& kind);

}  // namespace plumbline::report

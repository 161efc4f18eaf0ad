// A program played on the model of a machine: where the tool tip really goes, and what that takes.
#pragma once

#include <cstdint>
#include <string>

#include "base/files/files.hpp"
#include "base/progress.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {

struct SimulationSummary {
  std::uint64_t points = 0;
  std::uint64_t passed_moves = 0;  // in machine coordinates or to unknown positions: not in the table
  double largest_um = 0;           // distance of the tip from its pose
  std::size_t largest_line = 0;
  double rms_um = 0;
  double seconds = 0;
};

/// Writes a row for every point of the path at the step settings, as CSV: line, motion, time (s; rapids take none), the
/// pose asked for (mm, deg), the error of the tip (um) and of the orientation (urad, rotation vector) in W, commanded
/// strut lengths (mm), nut tensions (N) and motor torques (N m). The program is taken as it stands, no limits. Refuses
/// what compensate::MoveReader refuses, and simulate-unreachable.
SimulationSummary simulate_program(const std::string& program, const settings::Options& options, OutputFile& out,
                                   const Progress& progress = {});

}  // namespace plumbline::jobs

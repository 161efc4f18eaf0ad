// A program played on the model of a machine: where the tool tip really goes, and what that takes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/axes.hpp"
#include "base/diagnostic.hpp"
#include "base/files/source.hpp"
#include "base/progress.hpp"
#include "compensate/recorded/drawn_path.hpp"
#include "jobs/expected/expected_error.hpp"
#include "machine/geometry.hpp"
#include "machine/model.hpp"
#include "nc/control/state/motion.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {

/// A point of the path, and how the machine stands there.
struct SimulatedPoint {
  std::size_t line = 0;
  nc::MotionKind motion = nc::MotionKind::feed;
  double time_s = 0;                      // rapids take none
  AxisWords pose;                         // asked for, mm and deg
  machine::Vector6<double> error;         // of the tip (m) and of the orientation (rotation vector, rad), in W
  machine::PerStrut<double> lengths;      // commanded, m
  machine::PerStrut<double> nut_tension;  // N
  machine::PerStrut<double> torque;       // N m, of the motors
  std::optional<PoseDoubt> doubt;         // how far the tip may be from there
};

struct SimulationSummary {
  std::uint64_t points = 0;
  std::uint64_t passed_moves = 0;  // in machine coordinates or to unknown positions: not looked at
  double largest_um = 0;           // distance of the tip from its pose
  std::size_t largest_line = 0;
  double rms_um = 0;
  double seconds = 0;                      // without those of:
  std::uint64_t untimed_moves = 0;         // that cut, and take what the program alone does not say: G95
  std::uint64_t beyond_travel = 0;         // of the points
  std::optional<Diagnostic> first_beyond;  // a warning of the first
  std::optional<ExpectedError> expected;
};

/// The path of a program for a picture, and the machine that moves along it.
struct ProgramPicture {
  machine::MachineModel model;
  compensate::DrawnPath path;
  std::vector<std::optional<PoseDoubt>> doubts;  // at its points; empty: nothing is known
};

/// Hands over every point of the path at the step settings, in order. The program is taken as it stands; points
/// beyond the limits are counted.
/// `known`: where it is not null, points and summary have how far the tip may be from where they say.
/// Refuses what compensate::MoveReader refuses, and simulate-unreachable.
SimulationSummary simulate_program(const Source& program, const settings::Options& options,
                                   const std::function<void(const SimulatedPoint&)>& take,
                                   const Progress& progress = {}, ProgramPicture* picture = nullptr,
                                   const identify::Posterior* known = nullptr);

}  // namespace plumbline::jobs

// A model against measurements: how far what it says is from what was measured.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/files/source.hpp"
#include "inspect/fault.hpp"
#include "machine/geometry.hpp"
#include "measure/dataset.hpp"

namespace plumbline::jobs {

/// One run. What was not measured is left out.
struct RunComparison {
  std::string id;
  std::optional<double> radial_rms_um;  // after the set-up was fitted
  std::optional<double> torque_rms_Nm;  // of all six struts
  std::array<double, machine::kStruts> torque_mean_abs_Nm{};
  std::array<double, 3> ball_um{};  // set-up: where the ball stood, from the ideal place
  double bar_um = 0;                // how much longer the bar was than stated
};

struct Comparison {
  std::optional<double> radial_rms_um;  // over all samples
  std::optional<double> torque_rms_Nm;  // over all samples and struts
  std::array<double, machine::kStruts> torque_mean_abs_Nm{};
  std::vector<RunComparison> runs;
  inspect::Inspection inspection;         // what may be wrong with the data
  std::optional<Diagnostic> other_model;  // a warning: the data are of another machine
};

/// Simulates every run of a dataset, as it is but for single spikes, and compares, the set-up (ball centre, bar length)
/// fitted per run. Refuses what the reader of models, physics::ForceModel and measure::simulate_run refuse.
Comparison compare(const Source& model, const measure::Dataset& measured);

}  // namespace plumbline::jobs

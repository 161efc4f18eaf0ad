// Circular tests as they are looked at: what was measured around the circle, and what models say beside it.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "measure/circularity.hpp"
#include "physics/force_model.hpp"

namespace plumbline::jobs {

using StrutColumns = std::array<Eigen::VectorXd, machine::kStruts>;

/// A model that is laid beside measurements.
struct NamedModel {
  std::string name;
  const machine::MachineModel* machine = nullptr;
  const physics::ForceModel* forces = nullptr;
};

/// What one model makes of a run. Columns as those of the run; empty: not measured.
struct ModelProfile {
  Eigen::VectorXd radial;              // simulated, the set-up fitted, m
  Eigen::VectorXd compensated;         // what a bar would read if the program were compensated with the model, m
  StrutColumns torque;                 // simulated, N m
  double compensated_circularity = 0;  // max - min about the least-squares circle, m
  std::optional<double> radial_rms;    // of measured minus simulated, m
  std::array<double, machine::kStruts> torque_rms{};  // N m
};

/// One run, its samples in the order of their angle within one turn. Readings of the bar are given without mean and
/// first harmonic of the measured ones: what the balls' centring makes.
struct RunProfile {
  measure::Run run;        // its design and what was measured, as it came
  Eigen::VectorXd angle;   // rad, from 0, rising
  Eigen::VectorXd radial;  // measured, m
  StrutColumns torque;     // measured, N m
  std::optional<measure::CircularityFigures> figures;
  std::vector<ModelProfile> models;
};

/// Refuses with simulate-unreachable.
std::vector<RunProfile> run_profiles(const std::vector<measure::Run>& runs, std::span<const NamedModel> models);

/// Runs and the models beside them.
struct RunsAndModels {
  std::vector<std::string> models;  // as they are called: by their names, or where these are alike by their files
  std::vector<RunProfile> runs;
  std::string readings = "measured";  // what the runs' own columns are: a plan's are predicted
};

/// Refuses as the readers of models, physics::ForceModel and run_profiles do.
RunsAndModels profiles_of_files(const std::vector<measure::Run>& runs, const std::vector<std::string>& models);

}  // namespace plumbline::jobs

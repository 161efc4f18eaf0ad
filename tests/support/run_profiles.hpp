// Runs with two models beside them, made by hand.
#pragma once

#include <numbers>

#include "jobs/run_profiles.hpp"

namespace plumbline::testing {

/// A run of the bar and the motors, and one of the motors alone; two models that are 1 um and 2 um, 0.1 N m and
/// 0.2 N m off.
inline jobs::RunsAndModels small_runs() {
  jobs::RunsAndModels both;
  both.models = {"first", "second"};
  for (const char* const id : {"a", "<b>"}) {
    jobs::RunProfile profile;
    profile.run.id = id;
    profile.run.radius = 0.144;
    profile.run.feed = 1.0 / 60;
    profile.run.angle = {0, std::numbers::pi / 2, std::numbers::pi, 3 * std::numbers::pi / 2};
    profile.angle = Eigen::Vector4d(0, 0.5, 1, 1.5) * std::numbers::pi;
    for (auto& torque : profile.run.torque) torque.assign(4, 1.5);
    profile.torque.fill(Eigen::Vector4d::Constant(1.5));
    const bool bar = profile.run.id == "a";
    if (bar) {
      profile.run.radial = {1e-6, -1e-6, 1e-6, -1e-6};
      profile.radial = Eigen::Vector4d(1e-6, -1e-6, 1e-6, -1e-6);
      profile.figures = measure::CircularityFigures{2e-6, 1.9e-6, 1.1e-6, -0.9e-6, {}};
    }
    for (const double times : {1.0, 2.0}) {
      jobs::ModelProfile model;
      model.torque.fill(Eigen::Vector4d::Constant(1.5 - 0.1 * times));
      model.torque_rms.fill(0.1 * times);
      if (bar) {
        model.radial = profile.radial.array() - 1e-6 * times;
        model.compensated = Eigen::Vector4d(0.5e-6, 0, -0.5e-6, 0);
        model.compensated_circularity = 1e-6;
        model.radial_rms = 1e-6 * times;
      }
      profile.models.push_back(std::move(model));
    }
    both.runs.push_back(std::move(profile));
  }
  return both;
}

}  // namespace plumbline::testing

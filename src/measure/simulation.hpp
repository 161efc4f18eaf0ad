// What a model of the machine says that a run would measure.
#pragma once

#include <cmath>
#include <vector>

#include "measure/circular_motion.hpp"
#include "physics/error.hpp"

namespace plumbline::measure {

/// Where the ball on the table stands in the ideal set-up: below the centre of the circle by sqrt(bar^2 - radius^2).
Vector3<double> ideal_ball(const Run& run);

/// What holds during a run: friction on, effects of acceleration on, the known payload.
physics::Environment environment_of(const physics::ForceModel& forces, const Run& run);

/// One sample of a simulated run.
template <class T>
struct SampleReading {
  Vector3<T> tip_W;             // where the tool tip's ball stands, m
  machine::PerStrut<T> torque;  // of the motors, N m
  physics::ErrorStop stopped_because = physics::ErrorStop::converged;
};

/// Simulates one sample with `parameters` in place of the model's (parameters_as).
template <class T>
SampleReading<T> simulate_sample(const physics::ForceModel& forces, const T* parameters,
                                 const physics::Environment& environment, const physics::Motion<double>& motion) {
  const physics::TipError<T> error = physics::tip_error(forces, parameters, environment, motion_as<T>(motion));
  return {error.pose.p_WT, error.loads.torque, error.stopped_because};
}

/// The bar's reading: distance of the two balls minus the bar's length.
template <class T>
T bar_reading(const Vector3<T>& tip_W, const Vector3<T>& ball_W, const T& bar) {
  using std::sqrt;
  return sqrt((tip_W - ball_W).squaredNorm()) - bar;
}

/// A run as the model makes it.
struct RunSimulation {
  std::vector<SampleReading<double>> samples;
  /// The readings of a bar of that length whose ball stands there, m.
  Eigen::VectorXd radial(const Vector3<double>& ball_W, double bar) const;
};

/// Refuses with simulate-unreachable: the machine cannot stand at that sample of the run.
[[noreturn]] void refuse_unreachable(const Run& run, std::size_t sample, physics::ErrorStop stop);

/// All samples of a run with the model's own parameters. Refuses with simulate-unreachable a run that the machine
/// cannot make.
RunSimulation simulate_run(const machine::MachineModel& machine, const physics::ForceModel& forces, const Run& run);

/// The dataset with its measured columns replaced by simulated ones: no noise, ideal set-up.
Dataset simulated(const machine::MachineModel& machine, const physics::ForceModel& forces, Dataset dataset);

}  // namespace plumbline::measure

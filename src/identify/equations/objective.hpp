// What a fit minimises: the misfit of all runs against the noise, and of the unknowns against what is known of them
// beforehand, the set-up of each run taken out exactly.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "identify/equations/noise.hpp"
#include "identify/equations/tracker.hpp"
#include "measure/dataset.hpp"

namespace plumbline::identify {

/// Normal equations about a point, in scales of the unknowns (Unknown::scale).
struct NormalEquations {
  Eigen::MatrixXd information;  // of the data alone: J^T W J, the set-ups projected out
  Eigen::VectorXd gradient;     // of half the misfit of the data
  double misfit = 0;            // of the data: sum of squares in units of the noise, outliers counting linearly
  Eigen::Index rows = 0;        // readings
};

struct ObjectiveOptions {
  double huber = 3;  // innovations beyond that many sigma count linearly [Huber 1964]; 0: all count by their square
  int most_setup_steps = 8;
  double setup_tolerance_m = 1e-12;
};

/// The runs of a dataset, and poses that a tracker measured, beside a model with unknowns. Keeps the set-up of each run
/// and the frame of the tracker, which every evaluation fits anew from where the last one left it, and what was
/// simulated last: with slopes 72 bytes for each sample and unknown. Runs are simulated on all processors; results do
/// not depend on how many.
class Objective {
 public:
  /// `runs` and `tracked` (if any) are kept by reference. Refuses with tracker-far as first_frame does.
  Objective(machine::RotationOrder order, const std::vector<measure::Run>& runs, Unknowns unknowns,
            const ObjectiveOptions& options = {}, const Tracked* tracked = nullptr);

  const Unknowns& unknowns() const { return unknowns_; }
  const NoiseModel& noise() const { return noise_; }
  void set_noise(const NoiseModel& noise) {
    noise_ = noise;
    known_at_.reset();
  }
  const std::vector<measure::Setup>& setups() const { return setups_; }
  void set_setups(std::vector<measure::Setup> setups) { setups_ = std::move(setups); }
  const TrackerFrame& frame() const { return frame_; }

  /// Simulates ahead what the next calls at `values` (SI) ask for. Refuses with simulate-unreachable.
  void simulate(const Eigen::VectorXd& values, bool derivatives);

  /// The misfit at `values` (SI) and, if asked for, its derivatives. Refuses with simulate-unreachable.
  NormalEquations evaluate(const Eigen::VectorXd& values, bool derivatives);

  /// The equations of every run at `values`, not whitened, the set-up fitted: residuals to look at. Those of the
  /// tracker come last.
  std::vector<RunEquations> equations(const Eigen::VectorXd& values, bool derivatives = false);

  /// The same with derivatives, run by run, each handed over as soon as it is made and nothing kept: slopes of all runs
  /// at once are most of the memory. `take` is called from several threads, once for each run. Without the tracker.
  void each_run(const Eigen::VectorXd& values, const std::function<void(std::size_t, RunEquations)>& take);

 private:
  std::size_t blocks() const { return runs_.size() + (tracked_ != nullptr ? 1 : 0); }
  RunEquations fitted(std::size_t block, bool derivatives);
  RunEquations fitted_run(std::size_t index, const SimulatedRun& simulated, bool derivatives);
  RunEquations fitted_poses(bool derivatives);
  bool fit_setup(const std::function<RunEquations()>& equations_at,
                 const std::function<void(const Eigen::VectorXd&)>& move, int& steps) const;

  machine::RotationOrder order_;
  const std::vector<measure::Run>& runs_;
  Unknowns unknowns_;
  ObjectiveOptions options_;
  NoiseModel noise_;
  std::vector<measure::Setup> setups_;
  const Tracked* tracked_;
  TrackerFrame frame_;
  // what was simulated last; other noise or set-ups do not change it
  std::optional<Eigen::VectorXd> simulated_at_;
  bool simulated_slopes_ = false;
  std::vector<SimulatedRun> simulated_runs_;
  SimulatedPoses simulated_poses_;
  // the last evaluation with derivatives: a fit asks for it again where it ends
  std::optional<Eigen::VectorXd> known_at_;
  NormalEquations known_;
};

/// Whitens, weighs and projects the equations of one run: what it adds to the normal equations, in scales.
NormalEquations normal_equations(RunEquations equations, const NoiseModel& noise, const Unknowns& unknowns,
                                 double huber);

}  // namespace plumbline::identify

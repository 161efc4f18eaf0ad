// How readings move with the terms of a description.
#pragma once

#include <vector>

#include "diagnose/description/description.hpp"
#include "diagnose/readings/sample_states.hpp"

namespace plumbline::diagnose {

/// A run made ready: what its samples are, and how its readings move with the channels of terms. Rows as the residual
/// of `raw`, which belongs to the problem; SI.
struct ReadyRun {
  std::vector<SampleState> states;
  const identify::RunEquations* raw = nullptr;
  Eigen::MatrixXd drive;   // slopes by each strut's drive tension
  Eigen::MatrixXd force;   // by a force at the tip, x y z
  Eigen::MatrixXd centre;  // by one at the platform's centre of mass
  Eigen::MatrixXd tip;     // by the tip's displacement, x y z
};

/// Whether a channel's terms act on struts: they have factors of a strut's beside those that all share.
bool is_per_strut(Term::Channel channel);

/// The factors of the effect `generic`, in its units: those of a strut, and those that all share.
std::array<double, 8> strut_factors(const physics::MachineConstants& machine, const SampleState& s, int j);
std::array<double, 6> shared_factors(const SampleState& s);

/// The product of factors to whole powers.
template <std::size_t N>
double product(const std::array<double, N>& factors, const std::array<int, N>& powers) {
  double value = 1;
  for (std::size_t k = 0; k < N; ++k) {
    for (int n = 0; n < powers[k]; ++n) value *= factors[k];
  }
  return value;
}

/// How the readings of a run move with each part of a channel, a column each: the coefficient of a term that is one.
Eigen::MatrixXd slopes_of(const ReadyRun& run, Term::Channel channel);

/// All runs of the bench. Refuses with simulate-unreachable as measure::simulate_run does.
std::vector<ReadyRun> ready_runs(const Workbench& bench, const physics::ForceModel& forces,
                                 const LinearProblem& problem);

/// The readings' change by the coefficient of a term, times the cosine of its wave, or minus the sine.
Eigen::VectorXd change_by(const ReadyRun& run, const physics::MachineConstants& machine, const Term& term, bool sine);

}  // namespace plumbline::diagnose

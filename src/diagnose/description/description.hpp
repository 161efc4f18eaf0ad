// What no effect of the catalogue explains, described: a sparse sum of products of what is known at each moment.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "diagnose/candidates/workbench.hpp"
#include "diagnose/evidence/linear_problem.hpp"

namespace plumbline::diagnose {

/// One term, as the effect `generic` has it (physics/effects/generic.hpp).
struct Term {
  enum class Channel {
    length,
    drive,
    torque,
    force,
    tip,
    centre
  };  // centre: a force at the centre of mass, in no product
  Channel channel = Channel::length;
  int part = -1;  // the strut or the axis; -1: all struts alike
  std::array<int, 8> strut_powers{};
  std::array<int, 6> shared_powers{};
  double pitch = 0;   // m; 0: no wave
  double cosine = 0;  // coefficient, SI: of the product, times cos(2 pi L / pitch) if there is a pitch
  double sine = 0;    // times -sin(2 pi L / pitch): cos(a + phase) = cos a cos phase - sin a sin phase
  double gain = 0;    // what the misfit drops by with it, after the terms before it
};

struct DescriptionOptions {
  int most_terms = 3;
  int most_looked_at = 60;       // terms that are compared exactly
  int waves_looked_at = 12;      // of periodic ones
  int peaks = 4;                 // of them, of each channel and strut
  double finest_pitch = 1.2e-3;  // m
  double fewest_cycles = 10;     // per metre: longer waves are products
  double wave_step = 1;          // cycles per metre between pitches that are tried
  double least_log_odds = 6;     // nats, all terms that were tried counted, that a term must reach
};

struct Description {
  std::vector<Term> terms;  // in the order of their strength
  double gain = 0;          // of all
  double log_odds = -1e9;   // of the first, all terms that were tried counted
  double tried = 0;         // how many
};

/// The best sparse description of what `marginalised` leaves of the problem.
Description describe(const Workbench& bench, const physics::ForceModel& forces, const LinearProblem& problem,
                     const Marginalised& marginalised, const identify::NoiseModel& noise,
                     const DescriptionOptions& options = {});

/// The parameters of the effect `generic` that a term stands for, SI, as a ForceModel has them.
std::vector<double> generic_parameters(const Term& term);

}  // namespace plumbline::diagnose

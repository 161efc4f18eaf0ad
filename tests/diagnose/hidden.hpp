// Readings of a machine with one number more than its model has, for the tests of this module.
#pragma once

#include "diagnose/candidates/workbench.hpp"
#include "diagnose/search/picks.hpp"
#include "identify/plans.hpp"

namespace plumbline::testing {

struct Hidden {
  machine::MachineModel machine = pm600_like();
  physics::ForceModel forces{machine};
  diagnose::CandidateSet candidates = diagnose::make_candidate_set(machine, forces);
  std::vector<measure::Run> runs;

  /// Noise of 0.1 um and 0.01 N m.
  Hidden(const char* effect, const char* key, int index, double value) {
    Eigen::VectorXd values = candidates.unknowns.start();
    values[candidates.unknowns.find(effect, key, index)] = value;
    Random random(5);
    runs = measured(wider_plan(50), candidates.unknowns.at(values), 0.1e-6, 0.01, random);
  }

  diagnose::Workbench bench() const { return {machine, forces, runs, candidates}; }
  /// An effect of which one number is fitted.
  diagnose::Pick pick(const char* effect, int unknown) const {
    return {&candidates.candidate(effect), 0, {0}, {unknown}};
  }
};

}  // namespace plumbline::testing

// Measurements of a machine that departs from its model within [uncertainty], for the tests of this module.
#pragma once

#include <fmt/format.h>

#include "identify/plans.hpp"
#include "inspect/inspect.hpp"

namespace plumbline::testing {

inline void multiply(std::vector<double>& values, double by) {
  for (double& value : values) value *= by;
}

struct Measured {
  machine::MachineModel machine = pm600_like();
  std::vector<measure::Run> runs;

  /// `load`: kg in two of the runs.
  explicit Measured(unsigned seed = 3, double load = 0) {
    Random random(seed);
    const physics::ForceModel forces(machine);
    const identify::Unknowns nuisances = identify::nuisances(machine, forces);
    std::vector<measure::Run> plan = wider_plan(72);
    for (const std::size_t loaded : {2U, 5U}) plan[loaded].payload_mass = load;
    runs = measured(plan, nuisances.at(drawn(nuisances, random)), 0.5e-6, 0.05, random);
    for (std::size_t r = 0; r < runs.size(); ++r) runs[r].id = fmt::format("{:02}", r + 1);
  }
  inspect::Inspection inspection() const { return inspect::inspect(machine, runs); }
};

}  // namespace plumbline::testing

// Measurements of a machine that departs from its model within [uncertainty], for the tests of this module.
#pragma once

#include <fmt/format.h>

#include "identify/plans.hpp"
#include "inspect/inspect.hpp"

namespace plumbline::testing {

struct Measured {
  machine::MachineModel machine = pm600_like();
  std::vector<measure::Run> runs;

  explicit Measured(unsigned seed = 3) {
    Random random(seed);
    const physics::ForceModel forces(machine);
    const identify::Unknowns nuisances = identify::nuisances(machine, forces);
    runs = measured(wider_plan(72), nuisances.at(drawn(nuisances, random)), 0.5e-6, 0.05, random);
    for (std::size_t r = 0; r < runs.size(); ++r) runs[r].id = fmt::format("{:02}", r + 1);
  }
  inspect::Inspection inspection() const { return inspect::inspect(machine, runs); }
};

}  // namespace plumbline::testing

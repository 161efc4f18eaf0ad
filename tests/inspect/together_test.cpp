#include "inspect/together.hpp"

#include <catch2/catch.hpp>

#include "inspect/spoiled.hpp"
#include "physics/force_model.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("of all runs together those are chosen that were turned around, and mending them leaves noise") {
  for (const inspect::Which& which :
       {inspect::Which{true, true, false, false, false, false, true, false},
        inspect::Which{false, false, false, true, true, true, true, false}, inspect::Which(8, false)}) {
    Measured measured(5);
    for (std::size_t r = 0; r < measured.runs.size(); ++r) {
      for (double& torque : measured.runs[r].torque[3]) torque *= which[r] ? -1 : 1;
    }
    const physics::ForceModel forces(measured.machine);
    const diagnose::CandidateSet candidates = diagnose::make_candidate_set(measured.machine, forces);
    const inspect::Prior prior = inspect::prior_of(candidates, 0.3);
    const inspect::InspectOptions options;
    const inspect::Bench bench{measured.machine, forces, candidates, prior, inspect::usual_noise(options)};
    std::vector<inspect::Fault> faults;
    inspect::Looked looked = inspect::looked_at(measured.runs, bench, options, faults);
    inspect::make_rows(looked, bench);
    const inspect::Together together(looked, bench);
    inspect::Alike alike;
    alike.mended = together.with_channels({{4, 4, -1}});
    const inspect::Chosen chosen = inspect::Choice(together, alike).best(25);
    CHECK(chosen.which == which);
    const auto count = static_cast<double>(together.rows());
    CHECK(chosen.chi2 == Approx(count).epsilon(0.25));
    CHECK(together.chi2_of(alike, inspect::Which(8, false)) == Approx(together.chi2()));
  }
}

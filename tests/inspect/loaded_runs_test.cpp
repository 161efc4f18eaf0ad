// Payloads that were misstated alike.
#include "inspect/loaded_runs.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "inspect/spoiled.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using inspect::FaultKind;

TEST_CASE("payloads misstated alike are told, with the mass that hung there") {
  for (const double stated : {1 / 2.2046, 1.4, 9.81}) {  // of the true one: pounds, a wrong weight, newtons
    CAPTURE(stated);
    Measured measured(3, 12);
    for (measure::Run& run : measured.runs) run.payload_mass *= stated;
    const inspect::Inspection inspection = measured.inspection();
    std::size_t named = 0;
    for (const inspect::Fault& fault : inspection.faults) {
      CHECK(fault.kind == FaultKind::payload);
      CHECK(fault.values.at(0) == Approx(12).epsilon(0.05));
      CHECK(fault.blocks);
      named += fault.runs.size();
    }
    CHECK(named == 2);
  }
}

TEST_CASE("payloads that are as stated are in nobody's way") { CHECK(Measured(3, 12).inspection().faults.empty()); }

// What may have been said wrongly of runs.
#include <algorithm>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "inspect/hypothesis.hpp"
#include "inspect/looked.hpp"
#include "inspect/spoiled.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using inspect::FaultKind;

namespace {

// How many other runs the description of the first one may be that of.
std::ptrdiff_t exchanges(const Measured& measured) {
  const physics::ForceModel forces(measured.machine);
  const diagnose::CandidateSet candidates = diagnose::make_candidate_set(measured.machine, forces);
  const inspect::Prior wide = inspect::prior_of(candidates, 1);
  const inspect::Bench bench{measured.machine, forces, candidates, wide, inspect::usual_noise({})};
  const inspect::Knowledge known(wide);
  const auto all = inspect::relabellings({bench, measured.runs, measured.runs, {0}, {}, known});
  return std::count_if(all.begin(), all.end(), [](const auto& one) { return one.kind == FaultKind::exchanged; });
}

}  // namespace

TEST_CASE("no description of a run that goes around at another speed is taken for its own") {
  Measured measured;
  for (measure::Run& run : measured.runs) run.columns = {{measure::Column::time}, {measure::Column::angle}};
  const std::ptrdiff_t alike = exchanges(measured);
  CHECK(alike >= 6);  // those at another place
  for (std::size_t r = 1; r < measured.runs.size(); ++r) measured.runs[r].feed *= 3;
  CHECK(exchanges(measured) == 0);
  for (measure::Run& run : measured.runs) run.columns = {{measure::Column::angle}};  // times follow from the feed
  CHECK(exchanges(measured) >= alike);
}

#include "inspect/small_faults.hpp"

#include <catch2/catch.hpp>

using namespace plumbline;
using inspect::Fault;
using inspect::FaultKind;
using inspect::Inspection;

namespace {

// Three runs, of which the first is off by 1.1 times the noise and by nothing once the fault is mended.
Inspection with(FaultKind kind, double other_run) {
  Inspection inspection;
  Fault fault{kind, {0}};
  fault.before = 1.1;
  fault.after = 1;
  fault.nats = 150;
  inspection.faults = {fault};
  inspection.runs = {{1.1, {}}, {other_run, {}}, {0.98, {}}};
  return inspection;
}

Inspection doubted(Inspection inspection) {
  inspect::doubt_small_faults(inspection, {});
  return inspection;
}

}  // namespace

TEST_CASE("a small fault is told, and stands in nobody's way, where another run is as far off") {
  const FaultKind kind =
      GENERATE(FaultKind::bar_step, FaultKind::drift, FaultKind::motor_zero, FaultKind::centre, FaultKind::exchanged);
  CAPTURE(to_text(kind));
  for (const double other_run : {1.02, 1.09, 1.3}) {
    CAPTURE(other_run);
    const Inspection found = doubted(with(kind, other_run));
    REQUIRE(found.faults.size() == 1);
    CHECK(found.faults[0].may_be_effect == (other_run > 1.05));
    CHECK(found.blocks() == (other_run < 1.05));
  }
}

TEST_CASE("what is clearly wrong, or wrong by no degrees, blocks whatever other runs are") {
  Inspection step = with(FaultKind::bar_step, 3);
  step.faults[0].before = 2;
  CHECK(doubted(step).blocks());
  CHECK(doubted(with(FaultKind::direction, 3)).blocks());
  CHECK(doubted(with(FaultKind::motor_sign, 3)).blocks());
  Inspection all = with(FaultKind::drift, 3);
  all.faults[0].all = true;
  CHECK(doubted(all).blocks());
}

TEST_CASE("a run that something is said of is no other reason") {
  Inspection inspection = with(FaultKind::bar_step, 3);
  inspection.faults.push_back(inspection.faults[0]);
  inspection.faults[1].kind = FaultKind::direction;
  inspection.faults[1].runs = {1};
  const Inspection found = doubted(inspection);
  CHECK_FALSE(found.faults[0].may_be_effect);
  CHECK(found.faults[0].blocks);
}

TEST_CASE("a setting of one run alone must be sure") {
  Inspection inspection = with(FaultKind::payload, 1);
  inspection.faults[0].nats = 60;
  CHECK(doubted(inspection).faults.empty());
  inspection.faults.push_back(inspection.faults[0]);
  inspection.faults[1].runs = {1};
  const Inspection several = doubted(inspection);
  CHECK(several.faults.size() == 2);
  CHECK_FALSE(several.blocks());
}

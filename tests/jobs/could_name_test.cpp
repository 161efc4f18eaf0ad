#include "jobs/could_name.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "diagnose/usual_noise.hpp"
#include "identify/plans.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

diagnose::Visible of(const std::vector<diagnose::Visible>& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const diagnose::Visible& v) { return v.name == name; });
}

std::vector<measure::Run> with_readings(std::vector<measure::Run> runs) {
  for (measure::Run& run : runs) {
    run.radial.assign(run.samples(), 0);
    for (auto& torque : run.torque) torque.assign(run.samples(), 0);
  }
  return runs;
}

}  // namespace

TEST_CASE("one run tells nothing of what drifts, and more runs name smaller effects") {
  const machine::MachineModel machine = pm600_like();
  const std::vector<measure::Run> runs = with_readings(wider_plan(72));
  const auto eight = jobs::could_name(machine, runs, usual_noise());
  const auto one = jobs::could_name(machine, {runs.front()}, usual_noise());
  CHECK_FALSE(of(one, "thermal-drift").shows);
  CHECK(of(eight, "backlash").shows);
  CHECK(of(eight, "backlash").smallest < of(one, "backlash").smallest);
}

TEST_CASE("samples that are left out count all the same") {
  const machine::MachineModel machine = pm600_like();
  const auto smallest = [&](std::size_t samples, std::size_t looked_at) {
    const auto runs = with_readings(wider_plan(samples));
    return of(jobs::could_name(machine, runs, usual_noise(), {looked_at, 2000}), "backlash").smallest;
  };
  CHECK(smallest(72, 36) == Approx(smallest(72, 72)).epsilon(0.05));
  CHECK(smallest(72, 36) < 0.8 * smallest(36, 36));
}

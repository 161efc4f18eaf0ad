#include "diagnose/evidence/visible.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "diagnose/evidence/linear_problem.hpp"
#include "diagnose/search/refit.hpp"
#include "diagnose/usual_noise.hpp"
#include "identify/plans.hpp"

namespace plumbline::diagnose {
namespace {

std::vector<Visible> visible_in(const std::vector<measure::Run>& runs, double threshold = 12) {
  const machine::MachineModel machine = testing::pm600_like();
  const CandidateSet candidates = make_candidate_set(machine, physics::ForceModel(machine));
  const LinearProblem problem =
      linearise(machine.rotation, runs, candidates, candidates.unknowns.start(), testing::usual_noise());
  return visible_effects(reduced_gram(problem, marginalised_by(candidates, {}, problem.values)), candidates, threshold);
}

Visible of(const std::vector<Visible>& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const Visible& v) { return v.name == name; });
}

}  // namespace

TEST_CASE("one circle at one feed cannot show what needs others, eight can show more, and smaller") {
  const std::vector<Visible> one = visible_in({testing::wider_plan(60).front()});
  const std::vector<Visible> eight = visible_in(testing::wider_plan(60));
  CHECK(one.size() == eight.size());
  const auto seen = [](const std::vector<Visible>& all) {
    return std::count_if(all.begin(), all.end(), [](const Visible& v) { return v.shows; });
  };
  CHECK(seen(one) < seen(eight));
  CHECK_FALSE(of(one, "thermal-drift").shows);
  for (const char* const name : {"backlash", "joint-viscous", "torque-scale"}) {
    INFO(name);
    CHECK(of(eight, name).shows);
    CHECK(of(eight, name).smallest < of(one, name).smallest);
  }
  CHECK(of(eight, "backlash").key == "width_um");
  CHECK(of(eight, "backlash").unit == "um");
}

TEST_CASE("what must pass a higher threshold must be larger, as the root of the nats") {
  const double low = of(visible_in(testing::wider_plan(60), 10), "backlash").smallest;
  const double high = of(visible_in(testing::wider_plan(60), 40), "backlash").smallest;
  CHECK(high > 1.5 * low);
  CHECK(high < 2.2 * low);
}

TEST_CASE("without torques nothing of what they alone read can be shown") {
  std::vector<measure::Run> runs = testing::wider_plan(60);
  for (measure::Run& run : runs) {
    for (auto& torque : run.torque) torque.clear();
  }
  CHECK_FALSE(of(visible_in(runs), "torque-scale").shows);
  CHECK(of(visible_in(runs), "backlash").shows);
}

}  // namespace plumbline::diagnose

#include "diagnose/evidence/visible.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "diagnose/evidence/linear_problem.hpp"
#include "diagnose/search/refit.hpp"
#include "diagnose/usual_noise.hpp"
#include "identify/fit.hpp"
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

TEST_CASE("of machines that carry an effect at the size that is stated 19 of 20 pass the threshold") {
  const machine::MachineModel machine = testing::pm600_like();
  const CandidateSet candidates = make_candidate_set(machine, physics::ForceModel(machine));
  const LinearProblem problem = linearise(machine.rotation, testing::wider_plan(60), candidates,
                                          candidates.unknowns.start(), testing::usual_noise());
  Eigen::MatrixXd reduced = reduced_gram(problem, marginalised_by(candidates, {}, problem.values));
  const Eigen::Index columns = reduced.cols() - 1;
  constexpr double kThreshold = 12;
  const std::vector<Visible> all = visible_effects(reduced, candidates, kThreshold);
  // what noise makes of the slopes has the covariance of their Gram matrix
  const Eigen::MatrixXd gram = reduced.topLeftCorner(columns, columns);
  const Eigen::MatrixXd root = identify::root_of(gram);
  testing::Random random(17);
  std::normal_distribution<double> normal;
  for (const char* const name : {"backlash", "joint-viscous", "level"}) {
    const Visible visible = of(all, name);
    const Candidate& candidate = candidates.candidate(name);
    int weakest = -1;
    for (int c = 0; c < columns; ++c) {
      const Column& column = candidates.columns[static_cast<std::size_t>(c)];
      if (column.effect != name || column.key != visible.key || column.unknown < 0) continue;
      if (weakest < 0 || reduced(c, c) < reduced(weakest, weakest)) weakest = c;
    }
    REQUIRE(weakest >= 0);
    double si = 1;
    for (const physics::ParameterSpec& spec : physics::effect_infos()[physics::effect_index(name)].parameters) {
      if (spec.key == visible.key) si = spec.unit.si;
    }
    const double size = visible.smallest * si / candidates.columns[static_cast<std::size_t>(weakest)].scale;
    int passed = 0;
    constexpr int kMachines = 300;
    for (int n = 0; n < kMachines; ++n) {
      Eigen::VectorXd noise(columns);
      for (double& x : noise) x = normal(random);
      const Eigen::VectorXd right = size * gram.col(weakest) + root * noise;
      reduced.col(columns).head(columns) = right;
      reduced.row(columns).head(columns) = right.transpose();
      if (best_score(reduced, candidates, candidate).log_odds >= kThreshold) ++passed;
    }
    INFO(name << ": " << visible.smallest << " " << visible.unit);
    CHECK(passed / double(kMachines) > 0.91);
    CHECK(passed / double(kMachines) < 0.995);
  }
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

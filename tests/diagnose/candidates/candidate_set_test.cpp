// The kinds of candidates have no tests of their own: what they do is to agree with the physics. The columns of
// bent_by_setting, bent_by_size and bent_by_phase, filled by run_columns, are held here against the readings that the
// effect makes when it acts. Those of straight are the slopes of identify/equations/sensitivity_test.cpp; its groups
// and numbers are held by ../search_test.cpp and ../refit_test.cpp, which find an effect's number on the strut where it
// acts.
#include "diagnose/candidates/candidate_set.hpp"

#include <catch2/catch.hpp>

#include "diagnose/candidates/kind.hpp"
#include "diagnose/evidence/linear_problem.hpp"
#include "diagnose/usual_noise.hpp"
#include "identify/plans.hpp"

namespace plumbline::diagnose {
namespace {

struct Readings {
  machine::MachineModel machine = testing::pm600_like();
  physics::ForceModel forces{machine};
  CandidateSet candidates = make_candidate_set(machine, forces);
  std::vector<measure::Run> runs = [&] {
    testing::Random random(3);
    return testing::measured(testing::wider_plan(40), forces, 0, 0, random);
  }();

  LinearProblem about(const Eigen::VectorXd& values) const {
    return linearise(machine.rotation, runs, candidates, values, testing::usual_noise());
  }
};

// How far the readings move with columns of these sizes, and how far they do when the effect acts with the numbers that
// these sizes mean.
void check_mode(const Readings& readings, const LinearProblem& problem, const Candidate& candidate,
                const ActingMode& mode, const std::vector<int>& columns, const Eigen::VectorXd& sizes) {
  Eigen::VectorXd values = readings.candidates.unknowns.start();
  for (const UnknownValue& number : candidate.kind->numbers(readings.candidates, candidate, mode, columns, sizes)) {
    REQUIRE(number.unknown >= 0);
    values[number.unknown] = number.value;
  }
  const LinearProblem moved = readings.about(values);
  for (std::size_t r = 0; r < problem.blocks.size(); ++r) {
    const identify::SlopeRows& rows = problem.blocks[r].rows;
    const Eigen::VectorXd expected = rows(Eigen::all, columns) * sizes;
    const Eigen::VectorXd change = rows.rightCols<1>() - moved.blocks[r].rows.rightCols<1>();
    CHECK((change - expected).norm() < 0.1 * expected.norm());
    CHECK(expected.norm() > 0.1);
  }
}

}  // namespace

TEST_CASE("columns that are made from others are what the effect adds, in each of its modes") {
  const Readings readings;
  const LinearProblem problem = readings.about(readings.candidates.unknowns.start());
  int bending = 0;
  for (const Candidate& candidate : readings.candidates.all) {
    const physics::Bend* bend = info_of(candidate).bend;
    if (bend == nullptr) continue;
    ++bending;
    for (const ActingMode& mode : candidate.modes) {
      INFO(candidate.name << " of shape " << mode.shape);
      const std::vector<int> columns = mode.column_groups.front();
      const double scale = readings.candidates.columns[static_cast<std::size_t>(columns.front())].scale;
      Eigen::VectorXd sizes = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(columns.size()), 2);
      if (bend->by == physics::Bend::By::size) sizes[0] = mode.shape / scale;
      check_mode(readings, problem, candidate, mode, columns, sizes);
      if (bend->by == physics::Bend::By::size) break;  // a lag twice as long bends elsewhere
    }
  }
  CHECK(bending == 3);
}

TEST_CASE("what a number of a bending effect adds is made up of columns of the problem") {
  const Readings readings;
  const CandidateSet& set = readings.candidates;
  const Candidate& lag = set.candidate("servo-lag");
  const int unknown = set.unknowns.find("servo-lag", "lag_ms");
  Eigen::VectorXd values = set.unknowns.start();
  values[unknown] = lag.modes.back().shape;
  const auto parts = lag.kind->parts(set, lag, unknown, values);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].second == Approx(0).margin(1e-12));  // at the largest lag that is tried its column does it alone
  CHECK(parts[1].first == lag.modes.back().column_groups[0][0]);
  const double scale = set.columns[static_cast<std::size_t>(parts[1].first)].scale;
  CHECK(parts[1].second * scale == Approx(values[unknown]));

  const Candidate& wave = set.candidate("cyclic");
  CHECK(wave.kind->parts(set, wave, set.unknowns.find("cyclic", "phase_deg", 2), values).empty());
}

TEST_CASE("what is left out is no candidate, and a description never is") {
  const machine::MachineModel machine = testing::pm600_like();
  const CandidateSet set = make_candidate_set(machine, physics::ForceModel(machine), {{"backlash"}});
  const auto has = [&](std::string_view name) {
    return std::any_of(set.all.begin(), set.all.end(), [&](const Candidate& c) { return c.name == name; });
  };
  CHECK_FALSE(has("backlash"));
  CHECK_FALSE(has("generic"));
  CHECK(has("cable"));
  CHECK(set.candidate("lead-error").rare);
  CHECK_FALSE(set.candidate("cable").rare);
  CHECK(set.candidate("servo-mismatch").modes.front().sums_to_zero);
}

}  // namespace plumbline::diagnose

#include "jobs/run_profiles.hpp"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "jobs/dataset_files.hpp"
#include "jobs/simulate_dataset.hpp"
#include "measure/dataset.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

const std::string kProfiledModel = source_file("models/pm600-like.toml");

// Two runs as the model makes them, one in each direction.
std::vector<measure::Run> simulated_runs(const Scratch& scratch) {
  jobs::simulate_dataset(kProfiledModel, scratch.file("plan/dataset.toml", plan_text(scratch)), scratch.path("sim"));
  return measure::read_dataset(scratch.path("sim/dataset.toml")).runs;
}

}  // namespace

TEST_CASE("a model lies on what it simulated, around the circle in the order of the angle") {
  const Scratch scratch;
  const std::vector<measure::Run> runs = simulated_runs(scratch);
  const jobs::RunsAndModels both = jobs::profiles_of_files(runs, {kProfiledModel});
  REQUIRE(both.runs.size() == 2);
  CHECK(both.models == std::vector<std::string>{"pm600-like"});
  for (const jobs::RunProfile& run : both.runs) {
    REQUIRE(run.angle.size() == 120);
    for (Eigen::Index i = 0; i < 120; ++i)
      CHECK(run.angle[i] == Approx(3.0 * static_cast<double>(i) * std::numbers::pi / 180).margin(1e-9));
    CHECK((run.radial - run.models[0].radial).cwiseAbs().maxCoeff() < 1e-9);  // the digits of the table
    CHECK(*run.models[0].radial_rms < 1e-9);
    for (std::size_t j = 0; j < 6; ++j) {
      CHECK((run.torque[j] - run.models[0].torque[j]).cwiseAbs().maxCoeff() < 1e-4);
      CHECK(run.models[0].torque_rms[j] < 1e-4);
    }
    // neither mean nor first harmonic
    CHECK(std::abs(run.radial.mean()) < 1e-9);
    CHECK(std::abs(run.radial.dot(run.angle.array().cos().matrix())) < 1e-7);
    CHECK(run.figures->least_squares == Approx(run.radial.maxCoeff() - run.radial.minCoeff()));
    CHECK(run.models[0].compensated_circularity < 0.2 * run.figures->least_squares);
  }
  // the clockwise run's samples came the other way round
  CHECK(both.runs[1].radial[1] != both.runs[0].radial[1]);
  CHECK(runs[1].radial[119] - runs[1].radial[118] ==
        Approx(both.runs[1].radial[1] - both.runs[1].radial[2]).margin(2e-6));
}

TEST_CASE("what another model leaves is measured minus simulated") {
  const Scratch scratch;
  const std::vector<measure::Run> runs = simulated_runs(scratch);
  std::string other = read_text(kProfiledModel);
  const std::string friction = "coulomb_friction_N = [110";
  other.replace(other.find(friction), friction.size(), "coulomb_friction_N = [160");
  const jobs::RunsAndModels both = jobs::profiles_of_files(runs, {kProfiledModel, scratch.file("other.toml", other)});
  CHECK(both.models == std::vector<std::string>{"pm600-like.toml", "other.toml"});
  // 50 N of friction: T = lead / (2 pi) F
  const double torque = 0.02 / (2 * std::numbers::pi) * 50;
  CHECK(both.runs[0].models[1].torque_rms[0] == Approx(torque).epsilon(0.1));
  CHECK(both.runs[0].models[1].torque_rms[1] < 0.1 * torque);
  CHECK(*both.runs[0].models[1].radial_rms > 1e-7);
}

TEST_CASE("what was not measured is left out of a profile") {
  const Scratch scratch;
  std::vector<measure::Run> runs = simulated_runs(scratch);
  runs[0].radial.clear();
  for (auto& torque : runs[1].torque) torque.clear();
  const jobs::RunsAndModels both = jobs::profiles_of_files(runs, {kProfiledModel});
  CHECK(both.runs[0].radial.size() == 0);
  CHECK_FALSE(both.runs[0].figures);
  CHECK_FALSE(both.runs[0].models[0].radial_rms);
  CHECK(both.runs[1].torque[0].size() == 0);
  CHECK(both.runs[1].models[0].torque[3].size() == 0);
  CHECK(jobs::profiles_of_files(runs, {}).runs[1].models.empty());
}

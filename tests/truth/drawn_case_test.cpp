// Blind cases as they are drawn: the same from the same seed, as strong as asked for, in files that plumbline reads.
#include "truth/drawn_case.hpp"

#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "machine/machines.hpp"
#include "measure/dataset.hpp"
#include "measure/setup.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

namespace fs = std::filesystem;

truth::CaseOptions options(const std::string& effect, double snr) {
  truth::CaseOptions o;
  o.seed = 61;
  o.machine = source_path("tests/truth/machines/small.toml");
  o.effect = effect;
  o.snr = snr;
  o.plan = "paper";
  o.samples = 60;
  o.look_alikes = false;
  return o;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a drawn case has the strength that was asked for, and is the same again from the same seed") {
  const truth::DrawnCase drawn = truth::draw_case(options("payload", 25));
  REQUIRE(drawn.hidden.size() == 1);
  CHECK(drawn.hidden[0].snr == Approx(25).epsilon(0.005));
  CHECK(drawn.truth.flaws.payload > 0);
  const truth::DrawnCase again = truth::draw_case(options("payload", 25));
  CHECK(again.data[1].samples[7].reading.radial == drawn.data[1].samples[7].reading.radial);
  CHECK(again.truth.flaws.payload == drawn.truth.flaws.payload);
}

TEST_CASE("the machine of a case makes further circles, and all else stays as it is") {
  truth::CaseOptions more = options("payload", 25);
  more.more = {"10,-20,-980,8,-4,0,cw,3000,5", "0,0,-1000,0,0,0,ccw,1000,0"};
  const truth::DrawnCase drawn = truth::draw_case(more);
  const truth::DrawnCase plain = truth::draw_case(options("payload", 25));
  REQUIRE(drawn.more.size() == 2);
  CHECK(plain.more.empty());
  const truth::Circle& circle = drawn.more[0].planned.circle;
  CHECK(circle.centre.isApprox(truth::Vec(0.01, -0.02, -0.98)));
  CHECK(circle.turn == -1);
  CHECK(circle.payload == 5);
  CHECK(drawn.more[1].planned.circle.start > drawn.more[0].planned.circle.seconds());
  CHECK(drawn.data[1].samples[7].reading.radial == plain.data[1].samples[7].reading.radial);
  CHECK(drawn.holdout[5].samples[7].reading.radial == plain.holdout[5].samples[7].reading.radial);
  const Scratch scratch;
  truth::write_case(drawn, scratch.path("case"));
  CHECK(measure::read_dataset(scratch.path("case/more/dataset.toml")).runs[1].id == "02-ccw");
  for (const char* const wrong :
       {"10,-20,-980,8,-4,0,cw,3000", "10,-20,-480,8,-4,0,up,3000,5", "1,2,3,4,5,6,ccw,-1,0"}) {
    more.more = {wrong};
    CHECK_THROWS_AS(truth::draw_case(more), std::runtime_error);
  }
}

TEST_CASE("an effect that cannot be as strong as was asked for stays within its bounds") {
  const truth::DrawnCase drawn = truth::draw_case(options("joint-viscous", 1e6));
  CHECK(drawn.hidden[0].snr < 1e5);
  CHECK(drawn.truth.flaws.joint_damping == Approx(0.95 * 1500));
}

TEST_CASE("two effects and ones outside of the catalogue are drawn by name") {
  const truth::DrawnCase two = truth::draw_case(options("two:payload,cyclic", 30));
  REQUIRE(two.hidden.size() == 2);
  CHECK(two.truth.flaws.payload != 0);
  CHECK((two.truth.flaws.cyclic != truth::Six{}));
  const truth::DrawnCase outside = truth::draw_case(options("outside:gear-beat", 30));
  CHECK(outside.hidden[0].outside);
  CHECK_THROWS_AS(truth::draw_case(options("no-such-effect", 30)), std::runtime_error);
}

TEST_CASE("what is left of a machine in which nothing is hidden is its spread and the noise") {
  const truth::DrawnCase drawn = truth::draw_case(options("none", 0));
  const Scratch scratch;
  const fs::path& folder = scratch.folder();
  truth::write_case(drawn, folder.string());
  const machine::MachineModel machine = machine::read_model((folder / "base.toml").string());
  const measure::Dataset data = measure::read_dataset((folder / "data" / "dataset.toml").string());
  REQUIRE(data.runs.size() == 2);
  const physics::ForceModel forces(machine);
  for (const measure::Run& run : data.runs) {
    const measure::RunSimulation simulation = measure::simulate_run(machine, forces, run);
    const Eigen::VectorXd left = measure::radial_residuals(run, simulation, measure::fit_setup(run, simulation));
    const double rms_um = std::sqrt(left.squaredNorm() / static_cast<double>(left.size())) / kUm;
    CHECK(rms_um > 0.4);
    CHECK(rms_um < 8);
  }
  const auto answer = nlohmann::json::parse(text_of(folder / "answer.json"));
  CHECK(answer["verdict"] == "nothing-missing");
  CHECK(answer["effects"].empty());
}

TEST_CASE("the departure of what is a nuisance, too, is what was hidden and what was drawn with the machine") {
  const Scratch scratch;
  truth::write_case(truth::draw_case(options("strut-offset", 15)), scratch.path("case"));
  const auto answer = nlohmann::json::parse(scratch.text("case/answer.json"));
  const auto& effect = answer["effects"][0];
  const auto& drawn = answer["machine_is"]["strut_offset_um"];
  for (std::size_t j = 0; j < 6; ++j) {
    const double hidden = effect["parameters"]["length_um"][j];
    CHECK(effect["departure"]["length_um"][j].get<double>() == Approx(hidden + drawn[j].get<double>()));
    CHECK(drawn[j].get<double>() != 0);
  }
}

TEST_CASE("what is no more than a nuisance shows by its prior alone, however good the readings") {
  const truth::Model model = truth::read_model(source_path("tests/truth/machines/small.toml"));
  const truth::Strength strength(model, truth::paper(40), truth::Floor{1e-8, 1e-3});
  truth::Flaws flaws;
  flaws.coulomb[2] = 10 * model.spread.friction;
  const truth::Column trace = strength.trace(model.machine, flaws);
  CHECK(trace.norm() > 500);
  CHECK(strength.snr(trace) == Approx(10).epsilon(0.02));
  CHECK(strength.beyond(trace, {"screw-coulomb"}) < 0.1);
  CHECK(strength.snr(3 * trace) == Approx(3 * strength.snr(trace)));
}

TEST_CASE("two effects may do together what neither does alone") {
  const truth::Model model = truth::read_model(source_path("tests/truth/machines/pm.toml"));
  const truth::Strength strength(model, truth::paper(40));
  truth::Flaws flaws;
  flaws.payload = 3;
  const truth::Column trace = strength.trace(model.machine, flaws);
  CHECK(strength.beyond(trace, {"payload"}) < 0.1);
  CHECK(strength.beyond(trace, {"platform-mass"}) > 1);
  CHECK(strength.beyond(trace, {"centre-of-mass"}) > 1);
  CHECK(strength.beyond(trace, {"platform-mass", "centre-of-mass"}) < 0.1);
}

TEST_CASE("friction that remembers turns over some micrometres of travel after a reversal") {
  const truth::Machine machine = truth::read_model(source_path("tests/truth/machines/small.toml")).machine;
  // the tip goes up and down by 1 mm, so that all struts turn at once
  const truth::Path path = [](double t) {
    return truth::Stand{{0, 0, -1.008 + 1e-3 * std::sin(t)}, truth::Rotation::Identity()};
  };
  truth::Follower follower(machine, path, 1e-4, truth::FrictionLaw::dahl);
  const double top = M_PI / 2;
  CHECK(follower.at(top - 0.3, 0, 0).sign.isApprox(-truth::Vec6::Ones(), 1e-3));  // going up, struts shorten
  const truth::Vec6 soon = follower.at(top + 0.02, 0, 0).sign;                    // 0.2 um below the top
  CHECK(soon.maxCoeff() < -0.8);
  CHECK(follower.at(top + 0.3, 0, 0).sign.isApprox(truth::Vec6::Ones(), 1e-3));
}

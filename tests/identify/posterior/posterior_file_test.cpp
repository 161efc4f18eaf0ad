#include "identify/posterior/posterior_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include <catch2/catch.hpp>

#include "base/text/hash.hpp"
#include "identify/model_text.hpp"
#include "identify/plans.hpp"
#include "machine/model_file.hpp"
#include "machine/numbers_hash.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::identify;
using namespace plumbline::testing;

namespace {

// A posterior with two states of a machine's numbers.
Posterior some_posterior(const machine::MachineModel& model) {
  Posterior posterior = prior_of(model);
  posterior.made_by = "a test";
  posterior.noise = {0.5e-6, 0.05};
  posterior.unexplained = 0.2e-6;
  PosteriorState& state = posterior.states.front();
  Random random(5);
  state.mean = drawn(posterior.unknowns, random);
  const Eigen::VectorXd direction = drawn(posterior.unknowns, random) - posterior.unknowns.start();
  state.covariance = 0.25 * state.covariance + 0.1 * direction * direction.transpose();
  state.widening = 1.3;
  state.moved = 0.1 * direction;
  state.weight = 0.75;
  posterior.states.push_back(state);
  posterior.states.back().name = "backlash";
  posterior.states.back().weight = 0.25;
  return posterior;
}

}  // namespace

TEST_CASE("a posterior is read as it was written") {
  const machine::MachineModel model = pm600_like();
  const Posterior posterior = some_posterior(model);
  const Posterior read =
      parse_posterior(posterior_text(posterior, machine::numbers_hash(model)), "a.posterior.toml", model);
  CHECK(read.made_by == "a test");
  CHECK(read.from_data);
  CHECK(read.noise.radial == Approx(0.5e-6));
  CHECK(read.noise.torque == Approx(0.05));
  CHECK(read.unexplained == Approx(0.2e-6));
  REQUIRE(read.unknowns.size() == posterior.unknowns.size());
  for (std::size_t i = 0; i < read.unknowns.size(); ++i) {
    CHECK(read.unknowns[i].label == posterior.unknowns[i].label);
    CHECK(read.unknowns[i].sigma == Approx(posterior.unknowns[i].sigma));
  }
  REQUIRE(read.states.size() == 2);
  CHECK(read.states[1].name == "backlash");
  CHECK(read.states[1].weight == 0.25);
  CHECK((read.states[0].mean - posterior.states[0].mean).norm() <= 1e-12 * posterior.states[0].mean.norm());
  CHECK((read.states[0].doubt() - posterior.states[0].doubt()).norm() <= 1e-9 * posterior.states[0].doubt().norm());
}

TEST_CASE("a model names its posterior, and what belongs to other numbers is not taken") {
  const Scratch folder;
  const machine::MachineModel model = pm600_like();
  const std::string text = posterior_text(some_posterior(model), machine::numbers_hash(model));
  const physics::ForceModel forces(model);
  ModelChanges changes{forces, {}, "learnt", {}, {}};
  changes.posterior = PosteriorName{"m.posterior.toml", to_hex(fnv1a(text))};
  folder.file("m.posterior.toml", text);
  folder.file("m.toml", model_text(model, changes));
  const machine::MachineModel named = machine::read_model(folder.path("m.toml"));
  CHECK(machine::numbers_hash(named) == machine::numbers_hash(model));
  CHECK(known_of(named).states.size() == 2);

  // as the file is rewritten the name is replaced
  changes.posterior = PosteriorName{"other.toml", "0"};
  const std::string again = model_text(named, changes);
  CHECK(again.find("m.posterior.toml") == std::string::npos);
  CHECK(again.find("file = \"other.toml\"") != std::string::npos);
  changes.posterior.reset();
  CHECK_FALSE(known_of(machine::parse_model(model_text(named, changes), folder.path("m.toml"))).from_data);
  CHECK(model_text(named, changes).find("[posterior]") == std::string::npos);

  // another file of that name
  folder.file("m.posterior.toml", text + "\n");
  CHECK(refusal_of([&] { known_of(named); }).code == "posterior-other-file");
  // other numbers
  std::string moved = named.document.text;
  const std::size_t mass = moved.find("mass_kg = 100");
  REQUIRE(mass != std::string::npos);
  moved.replace(mass, 13, "mass_kg = 101");
  folder.file("m.posterior.toml", text);
  CHECK(refusal_of([&] { known_of(machine::parse_model(moved, folder.path("m.toml"))); }).code ==
        "posterior-other-model");
}

TEST_CASE("a posterior that was edited is refused at the place") {
  const machine::MachineModel model = pm600_like();
  const std::string good = posterior_text(some_posterior(model), machine::numbers_hash(model));
  const auto code_of = [&](std::string_view from, std::string_view to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
    return refusal_of([&] { parse_posterior(text, "a.posterior.toml", model); }).code;
  };
  CHECK(code_of("posterior 1", "posterior 2") == "posterior-wrong");
  CHECK(code_of("weight = 0.75", "weight = 0.5") == "posterior-wrong");
  CHECK(code_of("widening = 1.3", "widening = nan") == "posterior-wrong");
  CHECK(code_of("mean = [", "mean = [1, ") == "posterior-wrong");
  CHECK(code_of("correlations = [\n", "correlations = [\n[0],\n") == "posterior-wrong");
  CHECK(code_of("key = \"", "key = \"no_") == "posterior-wrong");
  CHECK(code_of("prior_sigma = ", "prior_sigma = -") == "posterior-wrong");
}

TEST_CASE("numbers of a posterior that cannot be are refused where they stand") {
  const machine::MachineModel model = pm600_like();
  const std::string good = posterior_text(some_posterior(model), machine::numbers_hash(model));
  const auto refused = [&](const std::string& key, const std::string& number) {
    std::string text = good;
    const std::size_t at = text.find(key) + key.size();
    REQUIRE(at >= key.size());
    text.replace(at, text.find_first_of(",]\n", at) - at, number);
    const Diagnostic d = refusal_of([&] { parse_posterior(text, "a.posterior.toml", model); });
    INFO(key << number);
    CHECK(d.code == "posterior-wrong");
    CHECK(d.place.line ==
          1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n')));
  };
  refused("noise_radial_um = ", "-1");
  refused("noise_torque_Nm = ", "1e300");
  refused("unexplained_um = ", "1e300");
  refused("prior_sigma = ", "1e-300");
  refused("widening = ", "0");
  refused("widening = ", "1e300");
  refused("weight = ", "-0.5");
  refused("mean = [", "1e300");
  refused("standard_errors = [", "-1");
  refused("standard_errors = [", "1e300");
  refused("correlations = [\n[", "5");
  refused("moved = [\n[", "1e300");

  // correlations that each may be, and not together
  Posterior odd = some_posterior(model);
  Eigen::MatrixXd& covariance = odd.states.front().covariance;
  const Eigen::VectorXd errors = covariance.diagonal().cwiseSqrt();
  covariance = errors.cwiseAbs2().asDiagonal();
  for (const auto& [i, k, r] : {std::tuple{1, 0, 0.9}, std::tuple{2, 0, 0.9}, std::tuple{2, 1, -0.9}})
    covariance(i, k) = covariance(k, i) = r * errors[i] * errors[k];
  const std::string text = posterior_text(odd, machine::numbers_hash(model));
  CHECK(refusal_of([&] { parse_posterior(text, "a", model); }).code == "posterior-wrong");

  // a number that stands twice
  const std::size_t first = good.find("\n[[unknown]]");
  const std::string row = good.substr(first, good.find("\n[[unknown]]", first + 1) - first);
  CHECK(refusal_of([&] { parse_posterior(std::string(good).insert(first, row), "a", model); }).message.find("twice") !=
        std::string::npos);
}

TEST_CASE("a [posterior] without a file is not passed over") {
  const Scratch folder;
  const std::string text = pm600_like().document.text;
  const auto known = [&](const std::string& more) {
    folder.file("m.toml", text + more);
    return refusal_of([&] { known_of(machine::read_model(folder.path("m.toml"))); }).code;
  };
  CHECK(known("").empty());
  CHECK(known("\n[posterior]\n") == "posterior-wrong");
  CHECK(known("\n[posterior]\nfile = \"\"\n") == "posterior-wrong");
  CHECK(known("\n[posterior]\nhash = \"0\"\n") == "posterior-wrong");
  CHECK(known("\n[posterior]\nfile = \".\"\n") == "posterior-wrong");
  CHECK(known("\n[posterior]\nfile = \"no.toml\"\n") == "file-missing");
  REQUIRE(std::system(("mkfifo '" + folder.path("pipe.toml") + "'").c_str()) == 0);
  CHECK(known("\n[posterior]\nfile = \"pipe.toml\"\n") == "posterior-wrong");
}

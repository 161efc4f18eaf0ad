#include "jobs/expected/expected_error.hpp"

#include <catch2/catch.hpp>

#include "base/text/hash.hpp"
#include "identify/model_text.hpp"
#include "identify/posterior/posterior_file.hpp"
#include "machine/machines.hpp"
#include "machine/model_file.hpp"
#include "machine/numbers_hash.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

std::vector<compensate::PathSample> line_of_samples() {
  std::vector<compensate::PathSample> samples;
  for (int i = 0; i <= 20; ++i) {
    compensate::PathSample& sample = samples.emplace_back();
    sample.line = static_cast<std::size_t>(10 + i);
    sample.time_s = 0.5 * i;
    sample.target.pose[Axis::X] = 10 * i;
    sample.target.pose[Axis::Z] = -1000;
    sample.target.slope[Axis::X] = 10;
    sample.target.seconds = 1;
  }
  return samples;
}

// A model that names a posterior, as files.
std::string learnt_model(const Scratch& scratch, double widening) {
  const machine::MachineModel model = pm600_like();
  identify::Posterior posterior = identify::prior_of(model);
  posterior.made_by = "a test";
  posterior.states.front().widening = widening;
  const std::string text = identify::posterior_text(posterior, machine::numbers_hash(model));
  const physics::ForceModel forces(model);
  identify::ModelChanges changes{forces, {}, "", {}, {}};
  changes.posterior = identify::PosteriorName{"m.posterior.toml", to_hex(fnv1a(text))};
  scratch.file("m.posterior.toml", text);
  return scratch.file("m.toml", identify::model_text(model, changes));
}

}  // namespace

TEST_CASE("what is expected along a path, and the worst of it with its line") {
  const machine::MachineModel model = pm600_like();
  const identify::Posterior prior = identify::prior_of(model);
  const auto expected = jobs::expected_along(model, prior, {}, line_of_samples());
  REQUIRE(expected);
  CHECK(expected->poses == 21);
  CHECK_FALSE(expected->from_data);
  REQUIRE(expected->touched_off);
  CHECK(expected->zero[Axis::Z] == -1000);
  CHECK(expected->touched_off->line == 30);  // furthest from where the zero is
  CHECK(expected->touched_off->mean < expected->stands.mean);
  for (const jobs::ExpectedFigures& figures : {expected->stands, *expected->touched_off}) {
    CHECK(figures.mean > 0);
    CHECK(figures.within > figures.mean);
    CHECK(figures.largest_within >= figures.within);
  }
  CHECK_FALSE(jobs::expected_along(model, prior, {}, {}));
}

TEST_CASE("a posterior beside the model takes the place of its uncertainty") {
  const Scratch scratch;
  const machine::MachineModel model = machine::read_model(learnt_model(scratch, 4));
  const jobs::Knowledge knowledge = jobs::knowledge_of(model);
  REQUIRE(knowledge.posterior);
  CHECK(knowledge.posterior->from_data);
  CHECK(knowledge.posterior->made_by == "a test");
  const auto wider = jobs::expected_along(model, *knowledge.posterior, {}, line_of_samples());
  const auto stated = jobs::expected_along(model, identify::prior_of(model), {}, line_of_samples());
  CHECK(wider->stands.within == Approx(2 * stated->stands.within).epsilon(0.01));
}

TEST_CASE("a posterior that does not belong to the model is not used, and nothing in its place") {
  const Scratch scratch;
  const std::string path = learnt_model(scratch, 1);
  scratch.file("m.posterior.toml", "plumbline = \"posterior 1\"\n");
  const jobs::Knowledge knowledge = jobs::knowledge_of(machine::read_model(path));
  CHECK_FALSE(knowledge.posterior);
  REQUIRE(knowledge.warning);
  CHECK(knowledge.warning->code == "posterior-other-file");
  CHECK(knowledge.warning->severity == Severity::warning);
  std::filesystem::remove(scratch.path("m.posterior.toml"));
  const std::optional<Diagnostic> missing = jobs::knowledge_of(machine::read_model(path)).warning;
  REQUIRE(missing);
  CHECK(missing->code == "file-missing");
  CHECK(missing->help.starts_with("put it beside the model"));
}

TEST_CASE("a model that says nothing of how sure it is tells nothing") {
  machine::MachineModel model = pm600_like();
  std::string text = model.document.text;
  const std::size_t table = text.find("[uncertainty]");
  REQUIRE(table != std::string::npos);
  const std::size_t end = std::min(text.find("\n[", table), text.size());
  text.erase(table, end - table);
  model = machine::parse_model(text, "m.toml");
  const jobs::Knowledge knowledge = jobs::knowledge_of(model);
  CHECK_FALSE(knowledge.posterior);
  CHECK_FALSE(knowledge.warning);
}

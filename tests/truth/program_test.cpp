// Programs as the stand-in runs them.
#include "truth/program.hpp"

#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "support/scratch.hpp"
#include "truth/played.hpp"

using plumbline::testing::Scratch;

namespace {

const std::string kRapid =
    R"({"motion": "rapid", "machine": [144, 100, -1008, -25, 0, 0], "feed": 0, "feed_mode": "G94"})"
    "\n";

}  // namespace

TEST_CASE("an arc of a full turn is run as the circle of a circular test") {
  const Scratch scratch;
  const truth::Program program = truth::read_program(scratch.file(
      "a.jsonl",
      kRapid +
          R"({"motion": "arc", "machine": [144, 100, -1008, -25, 0, 0], "feed": 1000, "feed_mode": "G94", "plane": "G17", "centre": [0, 100, -1008], "turns": 1})" +
          "\n"));
  const truth::Circle circle{{0, 0.1, -1.008}, 0.144, 0.15, {-25 * M_PI / 180, 0, 0}, 1, 1.0 / 60};
  CHECK(program.seconds == Approx(circle.seconds()));
  const truth::Path path = truth::path_of(circle);
  for (const double t : {0.0, 7.0, 30.0, 54.0}) {
    CHECK((program.path(t).x - path(t).x).norm() < 1e-12);
    CHECK(program.path(t).R.isApprox(path(t).R, 1e-12));
  }
}

TEST_CASE("straight moves take the time that their feed gives, by its mode") {
  const Scratch scratch;
  const truth::Program program = truth::read_program(scratch.file(
      "a.jsonl",
      kRapid + R"({"motion": "feed", "machine": [144, 130, -968, -25, 0, 0], "feed": 600, "feed_mode": "G94"})" + "\n" +
          R"({"motion": "feed", "machine": [144, 130, -968, -20, 0, 0], "feed": 30, "feed_mode": "G93"})" + "\n"));
  CHECK(program.seconds == Approx(5 + 2));
  CHECK((program.path(2.5).x - truth::Vec(0.144, 0.115, -0.988)).norm() < 1e-12);
  CHECK(program.path(6).R.isApprox(truth::turned({-22.5 * M_PI / 180, 0, 0}), 1e-12));
}

TEST_CASE("a machine that stands off tells so in all directions, and at rest where the path begins") {
  const Scratch scratch;
  const truth::Program program = truth::read_program(scratch.file(
      "a.jsonl", kRapid +
                     R"({"motion": "feed", "machine": [144, 130, -968, -25, 0, 0], "feed": 600, "feed_mode": "G94"})" +
                     "\n"));
  truth::Truth truth{truth::read_model(plumbline::testing::source_file("tests/truth/machines/pm.toml")).machine, {}};
  truth.machine.friction = {};
  const truth::Offs before = truth::offs(truth, program, program, program, truth::FrictionLaw::tanh, 1);
  for (std::size_t j = 0; j < 6; ++j) truth.machine.base[j].z() += 20e-6;
  const truth::Offs after = truth::offs(truth, program, program, program, truth::FrictionLaw::tanh, 1);
  REQUIRE(before.along.size() == 3);
  REQUIRE(after.along.size() == 3);
  CHECK((after.zero - before.zero - truth::Vec(0, 0, 20e-6)).norm() < 0.1e-6);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK((after.along[i].off - before.along[i].off - truth::Vec(0, 0, 20e-6)).norm() < 0.1e-6);
  }
}

TEST_CASE("of a circle that is fed in along itself the last turn counts") {
  const Scratch scratch;
  const std::string arc =
      R"({"motion": "arc", "machine": [144, 100, -1008, -25, 0, 0], "feed": 1000, "feed_mode": "G94", )"
      R"("plane": "G17", "centre": [0, 100, -1008], "turns": 1})"
      "\n";
  const double in = M_PI / 18;
  const std::string begin =
      fmt::format(R"({{"motion": "rapid", "machine": [{}, {}, -1008, -25, 0, 0], "feed": 0, "feed_mode": "G94"}})"
                  "\n",
                  144 * std::cos(in), 100 - 144 * std::sin(in));
  const truth::Circle circle{{0, 0.1, -1.008}, 0.144, 0.15, {-25 * M_PI / 180, 0, 0}, 1, 1.0 / 60};
  const truth::Program whole = truth::read_program(scratch.file("a.jsonl", begin + arc + arc));
  const truth::Program turn = truth::last_turn(whole, circle.ball());
  CHECK(turn.seconds == Approx(circle.seconds()).epsilon(1e-9));
  CHECK(turn.before == Approx(circle.seconds() / 36).epsilon(1e-9));
  for (const double t : {0.0, 7.0, 54.0}) CHECK((turn.path(t).x - truth::path_of(circle)(t).x).norm() < 1e-9);

  const truth::Program once = truth::read_program(scratch.file("b.jsonl", kRapid + arc));
  CHECK(truth::last_turn(once, circle.ball()).before == Approx(0).margin(1e-9));
}

TEST_CASE("what the stand-in does not run it does not skip") {
  const Scratch scratch;
  CHECK_THROWS_AS(truth::read_program(scratch.file("a.jsonl", kRapid)), std::runtime_error);
  CHECK_THROWS_AS(truth::read_program(scratch.file("b.jsonl", R"({"motion": "probe", "machine": [0,0,0,0,0,0]})")),
                  std::runtime_error);
}

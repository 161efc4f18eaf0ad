#include "api/plumbline.hpp"

#include <stdexcept>

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

namespace {

constexpr const char* kPart = "G0 X0 Y0 Z0 A0 B0 C0\nG1 X20 A5 F500\nM2\n";

api::Options options() {
  api::Options o;
  o.paths.model = testing::source_file("models/pm600-like.toml");
  api::set_option(o, "work-offset", "G54=0,0,-1008,0,0,0");
  return o;
}

}  // namespace

TEST_CASE("the functions take paths and options, and give summaries") {
  const testing::Scratch scratch;
  const std::string part = scratch.file("p.ngc", kPart);
  const api::CompensationSummary done = api::compensate(part, scratch.path("out.ngc"), options());
  CHECK(done.moves == 2);
  CHECK(scratch.text("out.ngc").starts_with("(plumbline " + std::string(api::version())));
  CHECK(api::check(part, options()).violations == 0);
  api::trace(part, scratch.path("t.jsonl"), {});
  CHECK(scratch.text("t.jsonl").starts_with("{\"line\": 1, \"motion\": \"rapid\""));
  scratch.file("poses.csv", "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n0,0,-1008,0,0,0\n");
  CHECK(api::error(scratch.path("poses.csv"), options().paths.model, scratch.path("e.csv")).largest_um ==
        Approx(15.379).epsilon(1e-3));
}

TEST_CASE("a tolerance chooses the points, and steps beside it are thrown back") {
  const testing::Scratch scratch;
  const std::string part = scratch.file("p.ngc", kPart);
  api::Options bound = options();
  api::set_option(bound, "tolerance", "1um");
  api::set_option(bound, "no-friction", "on");
  const api::CompensationSummary done = api::compensate(part, scratch.path("out.ngc"), bound);
  REQUIRE(done.bound);
  CHECK(done.bound->kept_mm.value <= 0.001);
  CHECK(done.bound->by_time.pieces == 0);
  CHECK(done.residual_mm.value <= 0.001);
  CHECK(done.points < 20);  // of 0.1 deg: 50
  CHECK(api::check(part, bound).points == done.points);
  api::set_option(bound, "step-length", "1");
  CHECK_THROWS_AS(api::compensate(part, scratch.path("out.ngc"), bound), std::invalid_argument);
  CHECK_THROWS_AS(api::check(part, bound), std::invalid_argument);
}

TEST_CASE("what is wrong is thrown, with its place, and nothing is written") {
  const testing::Scratch scratch;
  const std::string bad = scratch.file("p.ngc", "G0 X0 Y0 Z0 A0 B0 C0\nG1 A60 F100\n");
  const Diagnostic d = testing::refusal_of([&] { api::compensate(bad, scratch.path("out.ngc"), options()); });
  CHECK(d.code == "limit-tilt");
  CHECK(d.place.line == 2);
  CHECK_FALSE(scratch.has("out.ngc"));
  api::Options o;
  CHECK_THROWS_AS(api::set_option(o, "work-offset", "G54=1"), std::invalid_argument);
  CHECK_THROWS_AS(api::set_option(o, "nonsense", "1"), std::invalid_argument);
  CHECK_THROWS_AS(api::compensate(bad, scratch.path("out.ngc"), o), std::invalid_argument);
  CHECK_THROWS_AS(api::check(bad, o), std::invalid_argument);
}

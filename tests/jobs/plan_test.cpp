// Plans for the tip; what plans are chosen by is in tests/identify/design_test.cpp, the command in tests/cli.
#include "jobs/plan.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

jobs::PlanJob job_for(const std::string& model, const std::string& asked) {
  jobs::PlanJob job;
  job.model = source_file(model);
  job.asked = {asked};
  job.design.runs = 5;
  return job;
}

// How certain a plan makes the tip over the box of `job`, whatever it was made for.
jobs::TipOverBox tip_with(const jobs::PlannedTests& plan, const std::string& model, const jobs::TipBoxOptions& box) {
  return jobs::TipBox(machine::read_model(source_file(model)), plan.after.unknowns, box).with(plan.after.covariance);
}

}  // namespace

TEST_CASE("each circle of a plan for the tip makes it more certain, and more so than one for the geometry") {
  for (const std::string model :
       {"models/pm600-like.toml", "tests/truth/machines/small.toml", "tests/truth/machines/tall.toml"}) {
    const jobs::PlanJob job = job_for(model, "tip");
    const jobs::PlannedTests plan = jobs::plan_tests(job);
    REQUIRE(plan.tip);
    REQUIRE(plan.tip->after.size() == 5);
    double before = plan.tip->before.stands.rms;
    double touched_off = plan.tip->before.touched_off.rms;
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(plan.tip->after[i].stands.rms < before);
      CHECK(plan.tip->after[i].touched_off.rms < touched_off);
      CHECK(plan.tip->after[i].stands.rms <= plan.tip->after[i].stands.worst);
      before = plan.tip->after[i].stands.rms;
      touched_off = plan.tip->after[i].touched_off.rms;
      // minus the mean of the logarithms of both mean variances, um^2
      CHECK(plan.criterion[i] == Approx(-std::log(before / kUm * touched_off / kUm)).margin(1e-4));
    }
    const jobs::TipOverBox last = tip_with(plan, model, job.box);
    CHECK(last.stands.rms == Approx(before));
    CHECK(last.touched_off.rms == Approx(touched_off));
    const jobs::PlannedTests geometry = jobs::plan_tests(job_for(model, "geometry"));
    CHECK_FALSE(geometry.tip);
    const jobs::TipOverBox of_geometry = tip_with(geometry, model, job.box);
    CAPTURE(model, of_geometry.stands.rms / kUm, of_geometry.touched_off.rms / kUm);
    CHECK(before < of_geometry.stands.rms);
    CHECK(touched_off < of_geometry.touched_off.rms);
  }
}

TEST_CASE("a plan for the tip begins with what was measured already") {
  jobs::PlanJob job = job_for("models/pm600-like.toml", "tip");
  job.design.runs = 2;
  const Scratch scratch;
  jobs::write_plan(jobs::plan_tests(job), scratch.path("first"));
  const jobs::PlannedTests alone = jobs::plan_tests(job);
  job.measured = scratch.path("first/dataset.toml");
  const jobs::PlannedTests more = jobs::plan_tests(job);
  CHECK(more.tip->before.stands.rms == Approx(alone.tip->after.back().stands.rms).epsilon(0.02));
  CHECK(more.tip->after.back().stands.rms < more.tip->before.stands.rms);
}

TEST_CASE("a plan for the tip asks for where the box is, and refuses one that is out of reach") {
  jobs::PlanJob job = job_for("models/pm600-like.toml", "tip");
  job.box.box[2] = machine::Range{0.5, 0.7};  // above the base
  CHECK(refusal_of([&] { jobs::plan_tests(job); }).code == "plan-box");
}

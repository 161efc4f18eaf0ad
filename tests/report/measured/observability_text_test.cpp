#include "report/measured/observability_text.hpp"

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using identify::WholeMotion;

namespace {

// K1, K2 and two coordinates of joints.
identify::Fit small_fit() {
  identify::Unknowns unknowns(physics::ForceModel(machine::read_model(testing::source_file("models/pm600-like.toml"))));
  unknowns.add_shared("axial-elasticity", "compliance_per_length_um_N_m");
  unknowns.add_shared("axial-elasticity", "compliance_um_N");
  unknowns.add("joint-position", "base_um", 0);
  unknowns.add("joint-position", "base_um", 1);
  return identify::Fit(std::move(unknowns));
}

}  // namespace

TEST_CASE("what data cannot tell is said by name, numbers of the geometry by how many they are") {
  const identify::Fit fit = small_fit();
  identify::Observability known;
  CHECK(report::observability_text(fit, known).empty());
  known.nothing = {2, 3};
  known.little = {1, 2};
  CHECK(report::observability_text(fit, known) ==
        std::vector<std::string>{"these data say nothing about joint-position (2 of 2)",
                                 "these data add little to what [uncertainty] says of K2, joint-position (1 of 2)"});
}

TEST_CASE("two unknowns that are not told apart are said with what is told instead, and by which circles") {
  const identify::Fit fit = small_fit();
  identify::Observability known;
  known.confusions = {{0, 1, -0.987, 1.25, 0.0239e-6, 0.0002e-6}};
  for (const auto& [at, words] : {std::pair(identify::MeasuredAt::poses, "these poses"),
                                  std::pair(identify::MeasuredAt::circles, "these circles"),
                                  std::pair(identify::MeasuredAt::circles_at_one_height, "circles at one height")}) {
    known.measured_at = at;
    CHECK(report::observability_text(fit, known).front() ==
          words + std::string(" cannot separate K1 from K2") +
              " (correlation -0.987): what they determine is 1.25 m x K1 + K2 = 0.0239 +- 0.0002 um/N");
  }
}

TEST_CASE("motions of the geometry that stay hidden are named") {
  const auto name = [](WholeMotion::Kind kind, WholeMotion::Ring ring, int axis) {
    return report::motion_text({kind, ring, axis, {}});
  };
  CHECK(name(WholeMotion::Kind::shift, WholeMotion::Ring::base, 0) == "a shift of the base joints along X");
  CHECK(name(WholeMotion::Kind::turn, WholeMotion::Ring::platform, 2) == "a turn of the platform joints about Z");
  CHECK(name(WholeMotion::Kind::wider_ring, WholeMotion::Ring::base, 0) == "a wider ring of base joints");
  CHECK(name(WholeMotion::Kind::longer_struts, WholeMotion::Ring::base, 0) == "all struts longer together");
  CHECK(report::shown_geometry_text({42, 30, {}}) ==
        std::vector<std::string>{
            "these data determine 30 of 42 directions of the geometry to better than half of what was known"});
  CHECK(report::shown_geometry_text({42, 30, {{WholeMotion::Kind::shift, WholeMotion::Ring::base, 1, {}}}}).back() ==
        "these data do not show a shift of the base joints along Y: only what was known beforehand holds them where "
        "they are");
}

TEST_CASE("of a stage, a shift that was held and priors that are refuted though it is borne out are said, too") {
  identify::Stage stage{"joint", small_fit(), {}, {}, {}, true, {}, {}};
  CHECK(report::observability_text(stage).empty());
  stage.held.emplace();
  stage.held->share = 0.5;
  stage.held->back = 3e-6;
  stage.plausible.all_strained = true;
  stage.plausible.chi2 = 90;
  stage.plausible.degrees = 40;
  stage.geometry = identify::ShownGeometry{42, 30, {}};
  const std::vector<std::string> sentences = report::observability_text(stage);
  REQUIRE(sentences.size() == 3);
  CHECK(sentences[0].find("50 % of its shift is left out (3.0 um)") != std::string::npos);
  CHECK(sentences[1].find("chi-square is 90 where 40 is expected") != std::string::npos);
  CHECK(sentences[1].find("run plumbline diagnose") != std::string::npos);
  CHECK(sentences[2].starts_with("these data determine 30 of 42 directions"));
  stage.objection = identify::Objection::torque_worse;
  CHECK(report::observability_text(stage).size() == 2);
}

// What is learnt from measurements (measured), and models that are made (new_models).
#include <catch2/catch.hpp>
#include <plumbline/plumbline.hpp>

#include "base/files/files.hpp"
#include "jobs/diagnose.hpp"
#include "report/measured/diagnosis_text.hpp"
#include "report/measured/model_file.hpp"
#include "support/scratch.hpp"

namespace {

namespace api = plumbline::api;
using plumbline::testing::source_file;

const std::string kBlind = source_file("tests/blind/open-08/");  // a machine with an effect that its model lacks
const std::string kCircles = kBlind + "data/dataset.toml";

api::Model base_model() { return api::Model(api::Input::file(kBlind + "base.toml")); }

template <class Call>
api::Diagnostic refused_with(const Call& call) {
  try {
    call();
  } catch (const api::Error& error) {
    return error.diagnostic();
  }
  return {};
}

}  // namespace

TEST_CASE("a model is compared with measurements, and may be too far off") {
  const api::Result found = api::compare(base_model(), kCircles);
  CHECK(found.number("radial_rms_um") == Approx(2.207).epsilon(1e-3));
  CHECK(found.number("runs/0/radial_rms_um") > 0);
  CHECK_FALSE(found.found());
  CHECK(found.words().find("mean absolute torque error") != std::string::npos);
  CHECK(api::compare(base_model(), kCircles, api::Options().set("max-radial-um", "2")).found());
  CHECK_FALSE(api::compare(base_model(), kCircles, api::Options().set("max-radial-um", "3")).found());
  CHECK(refused_with([] { api::compare(base_model(), "none.toml"); }).code == "file-missing");
}

TEST_CASE("a diagnosis is the one of the command, its model too") {
  plumbline::jobs::DiagnoseJob job;
  job.model = kBlind + "base.toml";
  job.dataset = kCircles;
  const plumbline::jobs::DiagnoseResult expected = plumbline::jobs::diagnose(job);
  const api::Result found = api::diagnose(base_model(), kCircles);
  CHECK(found.json() == plumbline::report::diagnosis_json(expected.diagnosis, expected.measured));
  CHECK(found.model() == plumbline::report::model_file(expected));
  const std::string further = kBlind + "holdout/dataset.toml";
  job.with = {further};
  const api::Options with = api::Options().set("with", further);
  const plumbline::jobs::DiagnoseResult joined = plumbline::jobs::diagnose(job);
  CHECK(api::diagnose(base_model(), kCircles, with).json() ==
        plumbline::report::diagnosis_json(joined.diagnosis, joined.measured));
  CHECK(api::compare(base_model(), kCircles, with).json().find("\"h1\"") != std::string::npos);
  CHECK(refused_with([&] { api::calibrate(base_model(), "", api::Options(with).set("poses", "x.csv")); }).code ==
        "usage-wrong");
  CHECK(refused_with([] { api::diagnose(base_model(), kCircles, api::Options().set("seed", "1.5")); }).code ==
        "usage-wrong");
}

TEST_CASE("a model that measurements object to is not given, unless it is forced") {
  const std::string other = source_file("tests/blind/open-09/");  // the effect is one that a fit cannot take up
  const api::Model model(api::Input::file(other + "base.toml"));
  const api::Result found = api::identify(model, other + "data/dataset.toml");
  CHECK(found.json().find("\"plumbline\": \"identification 1\"") != std::string::npos);
  CHECK(refused_with([&] { found.model(); }).code == "identify-not-plausible");
  const api::Result forced = api::identify(model, other + "data/dataset.toml", api::Options().set("force"));
  CHECK(forced.json() == found.json());
  REQUIRE(forced.warnings().size() == 1);
  CHECK(forced.warnings().front().code == "identify-not-plausible");
  CHECK(forced.model().find("[platform]") != std::string::npos);
  CHECK(api::identify(base_model(), kCircles).model().find("[platform]") != std::string::npos);
  for (const char* const id : {"all", "no-such-run"}) {
    const api::Options accepts = api::Options().set("accept", id);
    const bool is_none = std::string(id) != "all";
    for (const auto& learn : {&api::identify, &api::calibrate, &api::diagnose}) {
      if (is_none) {
        CHECK(refused_with([&] { learn(base_model(), kCircles, accepts); }).code == "inspect-unknown-run");
      } else {
        CHECK_FALSE(learn(base_model(), kCircles, accepts).json().empty());
      }
    }
  }
}

TEST_CASE("calibration takes circles or a tracker's poses, and says what is missing") {
  CHECK(refused_with([] { api::calibrate(base_model(), ""); }).code == "usage-wrong");
  CHECK(refused_with([] { api::calibrate(base_model(), "", api::Options().set("joint-sigma", "-1")); }).code ==
        "usage-wrong");
  const api::Options few = api::Options().set(
      "poses", api::Input::text("x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,measured_x_mm,measured_y_mm,measured_z_mm\n"
                                "0,0,-1008,0,0,0,0,0,-1008\n",
                                "few.csv"));
  const api::Diagnostic refused = refused_with([&] { api::calibrate(base_model(), "", few); });
  CHECK(refused.code == "tracker-too-few");
  CHECK(refused.place.file == "few.csv");
}

TEST_CASE("a new model says what it assumes, and what it cannot be made of") {
  const api::Options stated = api::Options()
                                  .set("name", "shop")
                                  .set("base-radius", "600")
                                  .set("base-angles", "0,30,120,150,240,270")
                                  .set("platform-radius", "200")
                                  .set("platform-angles", "345,45,105,165,225,285")
                                  .set("home", "0,0,-900");
  const api::Result made = api::new_model(stated);
  CHECK(made.json().find("\"platform.mass_kg\"") != std::string::npos);
  CHECK(api::Model(api::Input::text(made.model())).name() == "shop");
  CHECK(api::new_model(api::Options(stated).set("platform.mass_kg", "50")).json().find("\"platform.mass_kg\"") ==
        std::string::npos);
  for (const auto& [name, value] : {std::pair("base-angles", "1,2"), std::pair("base-radius", "-1"),
                                    std::pair("platform.mass_kg", "much"), std::pair("platform.mas", "1")}) {
    INFO(name);
    CHECK(refused_with([&, n = name, v = value] {
            api::new_model(api::Options(stated).set(n, std::string(v)));
          }).code == "usage-wrong");
  }
  CHECK(refused_with([] { api::new_model(api::Options().set("hal", "a.hal")); }).code == "usage-wrong");
  CHECK(refused_with([] { api::new_model({}); }).code.starts_with("draft-"));
}

#include "jobs/diagnose.hpp"

#include <limits>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "report/diagnosis_text.hpp"
#include "support/diagnosis.hpp"

using namespace plumbline;
using Json = nlohmann::json;

TEST_CASE("a diagnosis has the keys that others rely on, in their units") {
  const Json d = Json::parse(report::diagnosis_json(testing::small_diagnosis()));
  CHECK(d["plumbline"] == "diagnosis 1");
  CHECK(d["verdict"] == "named");
  CHECK(d["effects"][0]["name"] == "backlash");
  CHECK(d["effects"][0]["alternatives"] == Json({"cyclic"}));
  CHECK(d["effects"][0]["parameters"]["width_um"] == Json({4.1, 0.0}));
  CHECK(d["effects"][0]["standard_errors"]["width_um"] == Json({0.1, 0.0}));
  CHECK(d["confidence_set"] == Json({"backlash", "cyclic"}));
  CHECK(d["gap"]["fit"]["radial_rms_um"] == Json({{"before", 3.1}, {"after", 0.6}}));
  CHECK(d["gap"]["held_out"]["torque_rms_Nm"] == Json({{"before", 0.06}, {"after", 0.05}}));
  CHECK(d["noise"]["radial_um"] == 0.5);
  CHECK(d["runs"][1]["held_out"] == true);
  CHECK(d["runs"][0]["rms"]["radial_um"]["before"] == 3.1);
}

TEST_CASE("a diagnosis says where the gap lives, what was predicted and what it is good for, in the units of files") {
  const Json d = Json::parse(report::diagnosis_json(testing::small_diagnosis()));
  CHECK(d["evidence_nats"][0]["left_out_nats"] == Json({{"poses", 31.5}, {"runs", 33.5}}));
  CHECK(d["evidence_nats"][1]["left_out_nats"].is_null());
  CHECK(d["circularity_um"]["compensated_with_found"] == Json({{"mean", 4.0}, {"largest", 4.0}}));
  CHECK(d["runs"][0]["circularity_um"]["measured"] == 20.0);
  CHECK(d["runs"][1]["circularity_um"].is_null());
  const Json& where = d["where"];
  CHECK(where["channels"][0]["channel"] == "radial_um");
  CHECK(where["channels"][0]["arcs_rms"][3] == 5.0);
  CHECK(where["channels"][0]["harmonics_rms"][1] == 1.0);
  CHECK(where["contrasts"][0]["by"] == "direction");
  CHECK(where["contrasts"][0]["differs_rms"] == Json({{"radial_um", 2.0}, {"torque_Nm", 0.1}}));
  CHECK(where["groups"][0]["rms"]["radial_um"] == 3.1);
  CHECK(where["reversals"][0]["length_um"] == 4.0);
  CHECK(where["reversals"][0]["torque_Nm"].is_null());
}

TEST_CASE("what was not measured, or is no number, is null") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.noise.channels[1] = {};
  d.fit.before.torque = d.fit.after.torque = std::nullopt;
  d.effects[0].parameters[0].errors = {std::numeric_limits<double>::infinity(), 1e-310};
  const Json written = Json::parse(report::diagnosis_json(d));
  CHECK(written["noise"]["torque_Nm"].is_null());
  CHECK(written["gap"]["fit"]["torque_rms_Nm"]["after"].is_null());
  CHECK(written["effects"][0]["standard_errors"]["width_um"][0].is_null());
  CHECK(report::diagnosis_text(d).find("fitted     bar 3.10 -> 0.60 um (noise 0.50), torque not measured\n") !=
        std::string::npos);
}

TEST_CASE("a diagnosis in words names the effect, its numbers, and what else it may be") {
  const std::string text = report::diagnosis_text(testing::small_diagnosis());
  CHECK(
      text.starts_with("named: one of backlash, cyclic\n  backlash (50 nats, threshold 9.5)\n    these data do not "
                       "tell it from cyclic\n"));
  CHECK(text.find("width_um = 4.1 +- 0.1, 0\n") != std::string::npos);
  CHECK(text.find("not ruled out: backlash, cyclic\n") != std::string::npos);
  CHECK(text.find("held out   bar 3.00 -> 0.70 um (noise 0.50), torque 0.060 -> 0.050 N m (noise 0.050)\n") !=
        std::string::npos);
}

TEST_CASE("the headline gives the whole set, in words and as JSON") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  CHECK(Json::parse(report::diagnosis_json(d))["headline"] == "named: one of backlash, cyclic");
  d.confidence_set = {"backlash"};
  CHECK(jobs::headline(d) == "named: backlash");
  d.effects.push_back({"level", {}, {}, 20});
  CHECK(jobs::headline(d) == "named: backlash; and level");
  d.confidence_set = {"backlash", "cyclic"};
  CHECK(jobs::headline(d) == "named: one of backlash, cyclic; and level");
  d.confidence_set = {"backlash", "level", "cyclic"};
  CHECK(jobs::headline(d) == "named: two of backlash, level, cyclic");
  d.verdict = diagnose::Verdict::unknown;
  CHECK(jobs::headline(d).starts_with("unknown: "));
}

TEST_CASE("where nothing is missing, it is said what the runs could not have shown") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.verdict = diagnose::Verdict::nothing_missing;
  d.effects.clear();
  d.confidence_set.clear();
  d.visible = {{"backlash", "width_um", "um", 3.21, true}, {"thermal-drift", "", "", 0, false}};
  const std::string text = report::diagnosis_text(d);
  CHECK(text.starts_with("nothing-missing, as far as these runs can show\n"));
  CHECK(text.find("could not have shown, at any size: thermal-drift\n") != std::string::npos);
  CHECK(text.find("from this size on: backlash 3.2 um\n") != std::string::npos);
  const Json shown = Json::parse(report::diagnosis_json(d))["could_show"];
  CHECK(shown[0] == Json({{"name", "backlash"}, {"shows", true}, {"key", "width_um"}, {"smallest", 3.21}}));
  CHECK(shown[1]["smallest"].is_null());
}

TEST_CASE("a model that stays as given says why") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  CHECK(Json::parse(report::diagnosis_json(d))["model_withheld"].is_null());
  d.withheld = "the gap stays open";
  CHECK(Json::parse(report::diagnosis_json(d))["model_withheld"] == "the gap stays open");
  CHECK(report::diagnosis_text(d).find("the model stays as it was given: the gap stays open\n") != std::string::npos);
}

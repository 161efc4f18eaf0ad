#include <limits>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/parallel.hpp"
#include "base/units.hpp"
#include "machine/model_file.hpp"
#include "report/measured/diagnosis_text.hpp"
#include "report/page/diagnosis_page.hpp"
#include "support/diagnosis.hpp"

using namespace plumbline;
using Json = nlohmann::json;

namespace {

Json json_of(const diagnose::Diagnosis& diagnosis) { return Json::parse(report::diagnosis_json(diagnosis)); }

// A kept case whose hidden effect is named, or described; ten of its runs.
std::string written_by(unsigned threads, const std::string& name) {
  const HeldProcessors held(threads);
  machine::MachineModel machine = machine::read_model(testing::source_file("tests/blind/" + name + "/base.toml"));
  std::vector<measure::Run> runs =
      measure::read_dataset(testing::source_file("tests/blind/" + name + "/data/dataset.toml")).runs;
  runs.resize(10);
  diagnose::DiagnoseOptions options;
  options.search.threshold.draws = 2000;
  diagnose::Diagnosis diagnosis = diagnose::diagnose(machine, runs, options);
  const jobs::DiagnoseResult result{std::move(machine), std::move(diagnosis), {}, std::move(runs), {}};
  return report::diagnosis_json(result.diagnosis) + report::page_text(report::diagnosis_page(result, {}, {}));
}

}  // namespace

TEST_CASE("a diagnosis as JSON has what was found, in the units of files") {
  const Json found = json_of(testing::small_diagnosis());
  CHECK(found["plumbline"] == "diagnosis 1");
  CHECK(found["verdict"] == "named");
  CHECK(found["headline"] == "named: one of backlash, cyclic");
  CHECK(found["confidence_set"] == Json{"backlash", "cyclic"});
  CHECK(found["threshold_nats"] == 9.5);
  CHECK(found["converged"] == true);
  const Json& effect = found["effects"][0];
  CHECK(effect["name"] == "backlash");
  CHECK(effect["alternatives"] == Json{"cyclic"});
  CHECK(effect["parameters"]["width_um"] == Json{4.1, 0.0});
  CHECK(effect["standard_errors"]["width_um"] == Json{0.1, 0.0});
  CHECK(effect["log_odds"] == 50.0);
  CHECK(effect["left_out_nats"].is_null());
  CHECK(found["evidence_nats"][0]["left_out_nats"] == Json{{"poses", 31.5}, {"runs", 33.5}});
  CHECK(found["evidence_nats"][2] == Json{{"name", "cable"}, {"log_odds", -1.0}, {"left_out_nats", nullptr}});
}

TEST_CASE("gaps, noise and runs as JSON are in um and N m") {
  const Json found = json_of(testing::small_diagnosis());
  CHECK(found["gap"]["fit"]["radial_rms_um"] == Json{{"before", 3.1}, {"after", 0.6}});
  CHECK(found["gap"]["held_out"]["torque_rms_Nm"] == Json{{"before", 0.06}, {"after", 0.05}});
  CHECK(found["noise"]["radial_um"] == 0.5);
  CHECK(found["noise"]["torque_Nm"] == 0.05);
  CHECK(found["noise"]["torque_memory"] == 0.3);
  CHECK(found["noise"]["radial_white_share"] == 0.0);
  CHECK(found["runs"][0]["rms"]["radial_um"] == Json{{"before", 3.1}, {"after", 0.6}});
  CHECK(found["runs"][0]["rms"]["torque1_Nm"] == Json{{"before", 0.06}, {"after", 0.05}});
  CHECK(found["runs"][0]["circularity_um"]["compensated_with_found"] == 4.0);
  CHECK(found["runs"][1]["held_out"] == true);
  CHECK(found["runs"][1]["circularity_um"].is_null());
  CHECK(found["circularity_um"]["measured"] == Json{{"mean", 20.0}, {"largest", 20.0}});
  CHECK(found["where"]["channels"][0]["channel"] == "radial_um");
}

TEST_CASE("keys that a diagnosis has only at times are there then") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  Json plain = json_of(d);
  for (const char* const key : {"runner_up", "doubt", "remainder"}) CHECK_FALSE(plain.contains(key));
  CHECK_FALSE(plain["gap"]["fit"]["radial_rms_um"].contains("runner_up"));
  CHECK(plain["model_withheld"].is_null());
  d.runner_up = "cyclic";
  d.fit.runner_up.radial = 0.7e-6;
  d.doubt = diagnose::Doubt{{"backlash"}, diagnose::LargeRemainder{9}};
  d.withheld = diagnose::GivenIsNearer{diagnose::ReadingKind::torque};
  d.remainder = diagnose::Remainder{12.5, std::vector<diagnose::StrainedUnknown>{}};
  d.noise.channels[1] = {};
  Json all = json_of(d);
  CHECK(all["runner_up"] == "cyclic");
  CHECK(all["gap"]["fit"]["radial_rms_um"]["runner_up"] == 0.7);
  CHECK(all["gap"]["fit"]["torque_rms_Nm"]["runner_up"].is_null());
  CHECK(all["doubt"] == "backlash would leave too much: 9 times the noise in all");
  CHECK(all["model_withheld"] == "the model as given is nearer to the torques held out");
  CHECK(all["remainder"] == Json{{"snr", 12.5}, {"description", ""}});
  CHECK(all["noise"]["torque_Nm"].is_null());
  CHECK(all["noise"]["torque_memory"].is_null());
  d.effects[0].parameters[0].errors = {std::numeric_limits<double>::infinity(), 1e-310};
  CHECK(json_of(d)["effects"][0]["standard_errors"]["width_um"][0].is_null());
}

TEST_CASE("numbers of a point stand together, and a single one in no list") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  d.effects[0].parameters = {{"base_um", "um", {1, 2, 3, 4, 5, 6}, {0, 0, 0, 0, 0, 0}, 3, false},
                             {"force_N", "N", {7}, {0.5}, 1, true}};
  const Json parameters = json_of(d)["effects"][0]["parameters"];
  CHECK(parameters["base_um"] == Json{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}});
  CHECK(parameters["force_N"] == 7.0);
  CHECK(json_of(d)["effects"][0]["standard_errors"]["force_N"] == 0.5);
}

TEST_CASE("next tests and what could have shown are objects with null for what there is not") {
  diagnose::Diagnosis d = testing::small_diagnosis();
  measure::Run run;
  run.centre_W = {0.1, -0.05, -1};
  run.radius = 0.15;
  run.tilt = {10 * kDeg, 0, 0};
  run.direction = measure::Direction::cw;
  run.feed = 1000 * kMmPerMin;
  run.payload_mass = 20;
  d.next = {{"cyclic", diagnose::NextTest{run, 7.5}}, {"cable", {}}};
  d.visible = {{"backlash", "width_um", "um", 3.25, true}, {"cable", "", "", 0, false}};
  const Json found = json_of(d);
  CHECK(found["next_tests"][0] == Json{{"from", "cyclic"},
                                       {"test",
                                        {{"centre_mm", {100.0, -50.0, -1000.0}},
                                         {"radius_mm", 150.0},
                                         {"tilt_deg", {10.0, 0.0, 0.0}},
                                         {"direction", "cw"},
                                         {"feed_mm_min", 1000.0},
                                         {"payload_kg", 20.0}}},
                                       {"separation_sigma", 7.5}});
  CHECK(found["next_tests"][1] == Json{{"from", "cable"}, {"test", nullptr}});
  CHECK(found["could_show"][0] == Json{{"name", "backlash"}, {"shows", true}, {"key", "width_um"}, {"smallest", 3.25}});
  CHECK(found["could_show"][1] == Json{{"name", "cable"}, {"shows", false}, {"key", nullptr}, {"smallest", nullptr}});
}

TEST_CASE("what is written of a diagnosis is the same, to the byte, for any number of threads") {
  for (const char* const name : {"open-08", "open-09"}) {
    CAPTURE(name);
    const std::string alone = written_by(1, name);
    CHECK(alone.find("\"verdict\"") != std::string::npos);
    CHECK(written_by(2, name) == alone);
    CHECK(written_by(4, name) == alone);
  }
}

#include "report/measured/inspection_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "base/units.hpp"
#include "measure/runs.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using inspect::Fault;
using inspect::FaultKind;

namespace {

std::vector<measure::Run> runs_04_and_05() {
  std::vector<measure::Run> runs{circle_run({0, 100, -1008}, {-20, 0, 0}), circle_run({0, 0, -1008}, {0, 0, 0})};
  runs[0].id = "04";
  runs[1].id = "05";
  return runs;
}

Fault fault(FaultKind kind, std::vector<double> values = {}, std::vector<int> channels = {}) {
  Fault fault{kind, {0}};
  fault.values = std::move(values);
  fault.channels = std::move(channels);
  fault.before = 9.3;
  fault.after = 1.1;
  return fault;
}

bool says(const Fault& of, const std::string& words) {
  const std::string text = report::fault_text(of, runs_04_and_05());
  INFO(text);
  CHECK(text.find(words) != std::string::npos);
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("a fault is said with what mends it and how far the run is off before and after") {
  CHECK(report::fault_text(fault(FaultKind::direction), runs_04_and_05()) ==
        "run 04: with direction cw instead of ccw it is at 1.1 times the noise instead of 9.3");
  CHECK(says(fault(FaultKind::tilt, {20 * kDeg, 0, 0}), "tilt_deg [20.00, 0.00, 0.00] instead of [-20.0, 0.0, 0.0]"));
  CHECK(says(fault(FaultKind::payload, {20.3}), "payload_kg 20.30 instead of 0"));
  CHECK(says(fault(FaultKind::exchanged), "what the dataset says of run 04"));
  CHECK(says(fault(FaultKind::motors_swapped, {}, {2, 5}), "motor 2 and motor 5 exchanged"));
  CHECK(says(fault(FaultKind::torque_unit, {8.3}, {1, 2, 3, 4, 5, 6}), "the torques divided by 8.3"));
  CHECK(says(fault(FaultKind::clock, {-0.8}, {0}), "the bar taken 0.8 s earlier"));
  CHECK(says(fault(FaultKind::drift, {4e-6}, {0}), "a drift of the bar by 4.00 um"));
  Fault or_another = fault(FaultKind::direction);
  or_another.or_these = {FaultKind::angle_zero};
  CHECK(says(or_another, "; angle-zero would explain it about as well"));
}

TEST_CASE("what records say by themselves, and what is periodic in time") {
  Fault spikes{FaultKind::spikes, {1}};
  spikes.values = {2};
  CHECK(report::fault_text(spikes, runs_04_and_05()) == "run 05: 2 samples are left out as spikes");
  Fault same{FaultKind::same_readings, {1}};
  CHECK(report::fault_text(same, runs_04_and_05()) == "run 05: it has the same readings as run 04");
  Fault copied{FaultKind::motors_alike, {1}, false, {3, 2}};
  CHECK(report::fault_text(copied, runs_04_and_05()) == "run 05: motor 3 has the same readings as motor 2");
  copied.runs = {0, 1};
  CHECK(says(copied, "runs 04, 05: motor 3 has the same"));
  copied.all = true;
  CHECK(report::fault_text(copied, runs_04_and_05()) == "all runs: motor 3 has the same readings as motor 2");
  Fault silent{FaultKind::motor_silent, {0, 1}, true, {3}};
  CHECK(says(silent, "all runs: motor 3 reads noise"));
  Fault unsigned_ones{FaultKind::motors_unsigned, {0, 1}, true, {1, 2, 3, 4, 5, 6}};
  CHECK(says(unsigned_ones, "their signs are lost"));
  Fault start{FaultKind::start, {1, 0}, true, {}, {2.9, 0, 174}};
  CHECK(says(start, "run 05 would begin at 2.9 s, and run 04, from 0 s on, takes 174 s"));
  Fault periodic{FaultKind::periodic, {0, 1}, true, {0}, {4.37, 1.5e-6, 2.2, 0.5}};
  CHECK(report::fault_text(periodic, runs_04_and_05()).find("all runs: a periodic disturbance at 4.370 Hz") == 0);
  CHECK(says(periodic, "along 29 deg from +X"));
}

TEST_CASE("the whole says first whether anything is wrong, and what is not in the way as well") {
  inspect::Inspection inspection;
  inspection.runs.resize(2);
  inspection.runs[0] = {9.3, {9, 1, 0, 0, 0, 0, 0}};
  CHECK(report::inspection_text(inspection, runs_04_and_05(), true).find("nothing is wrong") == 0);
  inspection.faults = {fault(FaultKind::direction), fault(FaultKind::spikes, {1})};
  inspection.faults[1].after = 0;
  inspection.faults[1].blocks = false;
  const std::string text = report::inspection_text(inspection, runs_04_and_05(), true);
  CHECK(text.find("something is wrong") == 0);
  CHECK(text.find("left out as spikes") != std::string::npos);
  CHECK(text.find("\n04                          9.30\n") != std::string::npos);
  CHECK(report::faults_text({}, runs_04_and_05()).empty());

  const nlohmann::json read = nlohmann::json::parse(report::inspection_json(inspection, runs_04_and_05()));
  CHECK(read.at("clean") == false);
  CHECK(read.at("faults")[0].at("kind") == "direction");
  CHECK(read.at("faults")[0].at("runs") == nlohmann::json{"04"});
  CHECK(read.at("faults")[1].at("blocks") == false);
  CHECK(read.at("runs")[0].at("channels").at("radial") == 9);
}

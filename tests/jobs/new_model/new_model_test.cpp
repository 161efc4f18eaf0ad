// A model made of what is stated: new_model, model_draft and assumptions.
#include "jobs/new_model/new_model.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "jobs/new_model/assumptions.hpp"
#include "jobs/new_model/control.hpp"
#include "machine/condition.hpp"
#include "machine/limits.hpp"
#include "machine/machines.hpp"
#include "machine/model_file.hpp"
#include "report/program/new_model_text.hpp"

using namespace plumbline;

namespace {

// s times as large as the PM-600: the same machine, by the rule of its parts.
jobs::NewModelJob job_like_pm600(double s) {
  const machine::MachineModel model = testing::pm600_like();
  jobs::NewModelJob job;
  for (const double coordinate : model.geometry.base_joints_W.reshaped())
    job.base.joints_mm.push_back(s * coordinate / kMm);
  for (const double coordinate : model.geometry.platform_joints_P.reshaped())
    job.platform.joints_mm.push_back(s * coordinate / kMm);
  job.home_mm = {0, 0, -1025 * s};
  return job;
}

jobs::NewModelJob on_circles() {
  jobs::NewModelJob job;
  job.base = {1000, {-5, 5, 115, 125, 235, 245}, 0, {}};
  job.platform = {300, {-55, 55, 65, 175, 185, 295}, 50, {}};
  job.home_mm = {0, 0, 900};
  return job;
}

const jobs::DraftValue* assumed(const jobs::NewModel& made, const std::string& key) {
  const auto found = std::find_if(made.assumed.begin(), made.assumed.end(),
                                  [&](const jobs::DraftValue& value) { return value.key == key; });
  return found == made.assumed.end() ? nullptr : &*found;
}

void state(jobs::NewModelJob& job, const char* table, const char* key, std::vector<double> values) {
  job.stated.push_back({table, key, std::move(values), "", "", false, {}});
}

}  // namespace

TEST_CASE("parts are those of the PM-600 in the scale of the struts") {
  const machine::MachineModel original = testing::pm600_like();
  const jobs::NewModel same = jobs::make_new_model(job_like_pm600(1));
  for (const char* const key : {"screw_mass_kg", "joint_mass_kg", "motor_mass_kg", "motor_arm_mm", "joint_length_mm",
                                "screw_length_mm", "compliance_per_length_um_N_m", "compliance_um_N", "lead_mm"}) {
    INFO(key);
    CHECK(same.model.value("strut", key).values[0] == Approx(original.value("strut", key).values[0]).epsilon(1e-9));
  }
  const jobs::NewModel twice = jobs::make_new_model(job_like_pm600(2));
  const auto ratio = [&](const char* table, const char* key) {
    return twice.model.value(table, key).values[0] / same.model.value(table, key).values[0];
  };
  CHECK(ratio("platform", "mass_kg") == Approx(8).epsilon(1e-3));
  CHECK(ratio("strut", "screw_length_mm") == Approx(2).epsilon(1e-3));
  CHECK(ratio("strut", "compliance_per_length_um_N_m") == Approx(0.25).epsilon(1e-3));
  CHECK(ratio("strut", "compliance_um_N") == Approx(0.5).epsilon(1e-3));
  CHECK(ratio("strut", "coulomb_friction_N") == Approx(4).epsilon(1e-3));
  CHECK(twice.home_condition == Approx(same.home_condition));
  // weight as s^3, stiffness as s: error as s^2, of a machine with the same centre of mass
  CHECK(twice.home_error / same.home_error == Approx(4).epsilon(2e-3));
}

TEST_CASE("limits that nobody stated are in reach") {
  const jobs::NewModel made = jobs::make_new_model(on_circles());
  const machine::MachineModel& model = made.model;
  CHECK(made.corners.reached == 8);
  CHECK(made.corners.other_side == 0);
  CHECK(made.corners.largest_condition >= made.home_condition);
  const Vector3<double> home = machine::home_pose(model).p_WT;
  CHECK((home - Vector3<double>(0, 0, 0.9)).norm() < 1e-12);
  const double half = model.limits.travel[0].upper;
  CHECK(half > 0.1);
  for (const machine::Range& range : model.limits.travel) CHECK(range.upper - range.lower == Approx(2 * half));
  // a cube that is 5 mm larger is not
  Pose<double> corner;
  bool all = true;
  for (unsigned c = 0; c < 8; ++c) {
    for (int a = 0; a < 3; ++a)
      corner.p_WT[a] = home[a] + (((c >> static_cast<unsigned>(a)) & 1U) != 0 ? 1 : -1) * (half + 0.005);
    const Eigen::Array<double, machine::kStruts, 1> lengths =
        machine::strut_lengths<double>(model.geometry, corner).array();
    all =
        all && (lengths >= model.limits.length_min.array()).all() && (lengths <= model.limits.length_max.array()).all();
  }
  CHECK_FALSE(all);
  CHECK(model.limits.tilt > 5 * kDeg);
  CHECK(model.limits.tilt <= 30 * kDeg);
}

TEST_CASE("the text says of each line whether it is assumed, and by what rule") {
  jobs::NewModelJob job = on_circles();
  job.name = "my \"first\" one";
  job.provenance = "drawing 4711";
  state(job, "platform", "mass_kg", {150});
  state(job, "strut", "coulomb_friction_N", {100, 110, 120, 130, 140, 150});
  const jobs::NewModel made = jobs::make_new_model(job);
  CHECK(made.text.find("mass_kg = 150\n") != std::string::npos);
  CHECK(made.text.find("coulomb_friction_N = [100, 110, 120, 130, 140, 150]\n") != std::string::npos);
  CHECK(made.text.find("# drawing 4711\n") != std::string::npos);
  CHECK(made.model.name == job.name);
  CHECK(assumed(made, "mass_kg") == nullptr);
  CHECK(assumed(made, "platform_mass_kg") == nullptr);
  REQUIRE(assumed(made, "screw_mass_kg") != nullptr);
  CHECK(made.text.find("# assumed: " + assumed(made, "screw_mass_kg")->note) != std::string::npos);
  const double half = assumed(made, "screw_mass_kg")->values[0] / 2;
  CHECK(made.model.uncertainty("strut_mass_kg") == Approx(half).epsilon(1e-3));
  CHECK(made.model.uncertainty("joint_position_um") == Approx(1e-3));
  CHECK(made.model.uncertainty("strut_offset_um") == Approx(1e-3));
  CHECK(made.model.provenance.starts_with("drawing 4711; assumed: "));
  const std::string said = report::new_model_text(made);
  for (const jobs::DraftValue& value : made.assumed) CHECK(said.find(value.key + " = ") != std::string::npos);
  CHECK(said.find("8 of 8 in reach") != std::string::npos);
}

TEST_CASE("what is stated takes precedence over the control's files") {
  const testing::Scratch scratch;
  jobs::NewModelJob job = testing::job_of(scratch, testing::ini_text(), testing::hal_text());
  job.home_mm = {0, 0, 850};
  job.name = "mine";
  state(job, "limits", "z_mm", {800, 900});
  const jobs::NewModel made = jobs::make_new_model(job);
  CHECK(made.model.name == "mine");
  CHECK(made.model.limits.travel[2].lower == Approx(0.8));
  CHECK(machine::home_pose(made.model).p_WT.z() == Approx(0.85));
}

TEST_CASE("what cannot be a machine is refused") {
  const auto refused = [](const auto& change) {
    jobs::NewModelJob job = on_circles();
    change(job);
    return testing::refusal_of([&] { jobs::make_new_model(job); });
  };
  using Job = jobs::NewModelJob;
  CHECK(refused([](Job&) {}).code.empty());
  CHECK(refused([](Job& job) { job.base = {}; }).code == "draft-missing");
  CHECK(refused([](Job& job) { job.home_mm.clear(); }).code == "draft-missing");
  CHECK(refused([](Job& job) { job.platform.angles_deg.pop_back(); }).code == "draft-joints");
  CHECK(refused([](Job& job) { job.platform.joints_mm.assign(18, 1); }).code == "draft-joints");
  CHECK(refused([](Job& job) {
          job.platform = {};
          job.platform.joints_mm.assign(17, 1);
        }).code == "draft-joints");
  CHECK(refused([](Job& job) { job.home_mm = {0, 0, -50}; }).code == "draft-reach");  // in the plane of the base
  CHECK(refused([](Job& job) { state(job, "strut", "length_max_mm", {1000}); }).code == "draft-reach");
  CHECK(refused([](Job& job) { state(job, "limits", "x_mm", {800, 1200}); }).code == "draft-reach");
  const Diagnostic home = refused([](Job& job) {
    for (const char* const key : {"x_mm", "y_mm", "z_mm"}) state(job, "limits", key, {1000, 1400});
  });
  CHECK(home.code == "draft-home");
  CHECK(home.message.find("strut") != std::string::npos);
  CHECK(refused([](Job& job) { job.base.angles_deg[2] = std::nan(""); }).code == "draft-joints");
  const Diagnostic short_strut = refused([](Job& job) { state(job, "strut", "length_min_mm", {1300}); });
  CHECK(short_strut.code == "draft-reach");
  CHECK(short_strut.message.find("at home strut 1 is ") != std::string::npos);
  CHECK(refused([](Job& job) { job.base.radius_mm = 1e300; }).code == "draft-joints");
  CHECK(refused([](Job& job) { job.home_mm = {0, 0, 1e300}; }).code == "draft-number");
  CHECK(refused([](Job& job) { job.home_mm = {0, 0, std::nan("")}; }).code == "draft-number");
  CHECK(refused([](Job& job) { state(job, "limits", "condition_max", {1e12}); }).code.empty());
  // what the reader of models refuses names the key, not a line of a text that nobody has seen
  const Diagnostic slip = refused([](Job& job) { state(job, "strut", "compliance_um_N", {1e-6}); });
  CHECK(slip.code == "model-out-of-range");  // and not zero, either
  CHECK(slip.message.starts_with("[strut] compliance_um_N: "));
  const Diagnostic mass = refused([](Job& job) { state(job, "platform", "mass_kg", {-4}); });
  CHECK(mass.code == "draft-number");
  CHECK(mass.message.starts_with("[platform] mass_kg is -4 kg"));
  CHECK(mass.place.file.empty());
}

TEST_CASE("what the reader of models refuses of a control's file stands at its place there") {
  const testing::Scratch scratch;
  const std::string hal = testing::with(testing::hal_text(), "genhexkins.base.1.y 50", "genhexkins.base.1.y -50");
  const jobs::NewModelJob job = testing::job_of(scratch, testing::ini_text(), hal);
  const Diagnostic same = testing::refusal_of([&] { jobs::make_new_model(job); });
  CHECK(same.code == "model-coincident-joints");
  CHECK(same.place.file.ends_with("joints.hal"));
  CHECK(same.place.line == 3);
}

// The machine of a control's files; linuxcnc_control_files and linuxcnc_machine.
#include "jobs/new_model/linuxcnc_machine.hpp"

#include <sstream>

#include <catch2/catch.hpp>

#include "base/text/number_text.hpp"
#include "jobs/linuxcnc_control.hpp"
#include "jobs/new_model/control.hpp"
#include "machine/machines.hpp"
#include "machine/model_file.hpp"
#include "support/skip.hpp"

using namespace plumbline;

namespace {

Diagnostic refused(const std::string& ini, const std::string& hal = testing::hal_text()) {
  const testing::Scratch scratch;
  const jobs::NewModelJob job = testing::job_of(scratch, ini, hal);
  return testing::refusal_of([&] { jobs::make_new_model(job); });
}

std::string changed(const std::string& what, const std::string& in_its_place) {
  return testing::with(testing::ini_text(), what, in_its_place);
}

// What the controller computes from: arms from the tip and base joints.
void check_same_geometry(const machine::Geometry& a, const machine::Geometry& b) {
  CHECK((a.base_joints_W - b.base_joints_W).norm() < 1e-11);
  const auto arms = [](const machine::Geometry& g) {
    return machine::StrutVectors<double>(g.platform_joints_P.colwise() - g.tool_tip_P);
  };
  CHECK((arms(a) - arms(b)).norm() < 1e-11);
}

}  // namespace

TEST_CASE("a model, its control, and the model of that control have one geometry and the same limits") {
  for (const machine::MachineModel& model : testing::three_machines()) {
    INFO(model.name);
    const testing::Scratch scratch;
    for (const jobs::ControlFile& file : jobs::linuxcnc_configuration(model, {}, {}))
      scratch.file(file.name, file.text);
    jobs::NewModelJob job;
    job.control = jobs::ControlFiles{scratch.path("hexapod.ini"), {}};
    const machine::MachineModel back = jobs::make_new_model(job).model;
    check_same_geometry(model.geometry, back.geometry);
    CHECK(back.name == model.name);
    CHECK(back.limits.tilt == Approx(model.limits.tilt + model.limits.tilt_allowance - back.limits.tilt_allowance));
    CHECK((back.limits.length_min - model.limits.length_min).norm() < 1e-11);
    CHECK((back.limits.length_max - model.limits.length_max).norm() < 1e-11);
    for (std::size_t a = 0; a < 3; ++a) {
      CHECK(back.limits.travel[a].lower == Approx(model.limits.travel[a].lower).margin(1e-11));
      CHECK(back.limits.travel[a].upper == Approx(model.limits.travel[a].upper).margin(1e-11));
    }
  }
}

TEST_CASE("the model of LinuxCNC's sample hexapod is what its files say") {
  const std::string folder = "/usr/share/doc/linuxcnc/examples/sample-configs/sim/axis/vismach/hexapod-sim/";
  if (!std::filesystem::exists(folder + "hexapod.ini"))
    return testing::skip("LinuxCNC's sample configurations are not installed (scripts/setup --dev --with-oracle)");
  jobs::NewModelJob job;
  job.control = jobs::ControlFiles{folder + "hexapod.ini", {}};
  const jobs::NewModel made = jobs::make_new_model(job);
  const machine::MachineModel kept = machine::read_model(testing::source_path("models/linuxcnc-hexapod.toml"));
  check_same_geometry(made.model.geometry, kept.geometry);
  CHECK(machine::home_pose(kept).p_WT.z() == Approx(20 * 25.4 * kMm));
  CHECK(machine::strut_lengths<double>(kept.geometry, machine::home_pose(kept))[0] == Approx(29.7466 * 25.4 * kMm));
  for (const char* const key : {"screw_mass_kg", "compliance_um_N", "length_max_mm"})
    CHECK(made.model.value("strut", key).values == kept.value("strut", key).values);
}

TEST_CASE("spindle-offset and tool-offset shift all joints along Z; inches become mm") {
  const testing::Scratch scratch;
  const auto geometry = [&](const std::string& ini, const std::string& hal) {
    return jobs::make_new_model(testing::job_of(scratch, ini, hal)).model.geometry;
  };
  const machine::Geometry plain = geometry(testing::ini_text(), testing::hal_text());
  machine::Geometry shifted =
      geometry(changed("HOME = 0 0 800", "HOME = 0 0 800"), testing::hal_text() +
                                                                "setp genhexkins.spindle-offset 30\n"
                                                                "setp genhexkins.tool-offset -5\n");
  shifted.base_joints_W.row(2).array() -= 25 * kMm;
  shifted.platform_joints_P.row(2).array() -= 25 * kMm;
  check_same_geometry(plain, shifted);

  std::string inches;
  std::istringstream lines(testing::hal_text());
  for (std::string line; std::getline(lines, line);) {
    const std::size_t value = line.rfind(' ') + 1;
    const std::optional<double> mm = parse_number(std::string_view(line).substr(value));
    inches += (mm ? line.substr(0, value) + to_decimal(*mm / 25.4) : line) + "\n";
  }
  const std::string ini =
      testing::with(changed("LINEAR_UNITS = mm\nHOME = 0 0 800", "LINEAR_UNITS = inch\nHOME = 0 0 31.5"),
                    "MIN_LIMIT = 700\nMAX_LIMIT = 900", "MIN_LIMIT = 27.5\nMAX_LIMIT = 35.5");
  const machine::Geometry same = geometry(ini, inches);
  CHECK((same.base_joints_W - plain.base_joints_W).norm() < 1e-9);
  CHECK((same.platform_joints_P - plain.platform_joints_P).norm() < 1e-9);
}

TEST_CASE("limits that limit nothing are left out, and said") {
  const testing::Scratch scratch;
  std::string ini = testing::ini_text() +
                    "[AXIS_X]\nMIN_LIMIT = -9000\nMAX_LIMIT = 9000\n[AXIS_A]\nMIN_LIMIT = "
                    "-20\nMAX_LIMIT = 15\n[AXIS_B]\nMIN_LIMIT = -12\nMAX_LIMIT = 30\n";
  for (int j = 0; j < 6; ++j) ini += "[JOINT_" + std::to_string(j) + "]\nMIN_LIMIT = -1\nMAX_LIMIT = 5000\n";
  const jobs::NewModel made = jobs::make_new_model(testing::job_of(scratch, ini, testing::hal_text()));
  CHECK(made.model.limits.tilt == Approx(11.9 * kDeg));
  CHECK(made.model.limits.travel[2].lower == Approx(0.7));
  CHECK(made.model.limits.travel[0].upper < 1);
  std::string notes;
  for (const std::string& note : made.notes) notes += note + "\n";
  CHECK(notes.find("[AXIS_X] -9000 to 9000 counts as no limit") != std::string::npos);
  CHECK(notes.find("[JOINT_0] -1 to 5000 counts as no limit") != std::string::npos);
  CHECK(notes.find("not read: LIB:basic_sim.tcl") != std::string::npos);
  CHECK(notes.find("AXIS_Z") == std::string::npos);
}

TEST_CASE("what the files do not say, or say in two ways, is refused at its place") {
  CHECK(refused(testing::ini_text()).code.empty());
  const Diagnostic kinematics = refused(changed("= genhexkins", "= trivkins"));
  CHECK(kinematics.code == "draft-kinematics");
  CHECK(kinematics.place.line == 4);
  CHECK(kinematics.place.column == 14);
  CHECK(refused(changed("KINEMATICS = genhexkins\n", "")).code == "draft-missing");
  CHECK(refused(changed("LINEAR_UNITS = mm\n", "")).code == "draft-missing");
  CHECK(refused(changed("LINEAR_UNITS = mm", "LINEAR_UNITS = cm")).code == "draft-units");
  CHECK(refused(changed("HOME = 0 0 800 0 0 0\n", "")).message.find("--home") != std::string::npos);
  CHECK(refused(changed("HOME = 0 0 800 0 0 0", "HOME = 0 0")).code == "draft-number");
  CHECK(refused(changed("MIN_LIMIT = 700", "MIN_LIMIT = 950")).code == "draft-contradiction");
  CHECK(refused(testing::ini_text() + "[JOINT_2]\nHOME = 1200\n").code == "draft-contradiction");
  CHECK(refused(testing::ini_text(), testing::hal_text() + "setp genhexkins.screw-lead 5\n").code ==
        "draft-kinematics");
  CHECK(refused(changed("HOME = 0 0 800", "HOME = 0 0 1e308")).code == "draft-number");
  const Diagnostic far = refused(testing::ini_text(), testing::with(testing::hal_text(), "0.y -50", "0.y 1e308"));
  CHECK(far.code == "draft-number");
  CHECK(far.place.line == 4);
  CHECK(refused(testing::ini_text() + "[AXIS_X]\nMIN_LIMIT = -1e99\nMAX_LIMIT = 1e99\n").code.empty());
  CHECK(refused(testing::ini_text() + "[JOINT_2]\nHOME = 1e308\n").code == "draft-contradiction");
  const Diagnostic pin =
      refused(testing::ini_text(), testing::with(testing::hal_text(), "setp genhexkins.platform.3.y 35\n", ""));
  CHECK(pin.code == "draft-missing");
  CHECK(pin.message.find("genhexkins.platform.3.y") != std::string::npos);
  CHECK(pin.message.find("not read: LIB:basic_sim.tcl") != std::string::npos);
}

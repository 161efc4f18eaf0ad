#include "jobs/linuxcnc_control.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <catch2/catch.hpp>

#include "base/text/number_text.hpp"
#include "machine/machines.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

using Files = std::map<std::string, std::string>;

Files files_of(const machine::MachineModel& model, const nc::ProgramSettings& settings = {},
               const jobs::SimulatedDrives& drives = {}) {
  Files files;
  for (const jobs::ControlFile& file : jobs::linuxcnc_configuration(model, settings, drives))
    files[file.name] = file.text;
  return files;
}

// Of an INI file: "SECTION/KEY" to the value.
std::map<std::string, std::string> keys_of(const std::string& ini) {
  std::map<std::string, std::string> keys;
  std::istringstream lines(ini);
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '[') {
      section = line.substr(1, line.size() - 2);
    } else {
      const std::size_t equals = line.find(" = ");
      REQUIRE(equals != std::string::npos);
      keys[section + "/" + line.substr(0, equals)] = line.substr(equals + 3);
    }
  }
  return keys;
}

double number(const std::map<std::string, std::string>& keys, const std::string& key) {
  INFO(key);
  return *parse_number(keys.at(key));
}

// Of a HAL file: what setp sets.
std::map<std::string, double> pins_of(const std::string& hal) {
  std::map<std::string, double> pins;
  std::istringstream lines(hal);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string command;
    std::string pin;
    double value = 0;
    if (words >> command >> pin >> value && command == "setp") pins[pin] = value;
  }
  return pins;
}

}  // namespace

TEST_CASE("the control has the joints of the machine, and stands homed in the middle of the travel") {
  for (const machine::MachineModel& model : testing::three_machines()) {
    Files files = files_of(model);
    const auto pins = pins_of(files.at("hexapod.hal"));
    const auto keys = keys_of(files.at("hexapod.ini"));
    CHECK(pins.size() == 36);
    std::istringstream home_words(keys.at("TRAJ/HOME"));
    std::array<double, 6> home{};
    for (double& word : home) home_words >> word;
    CHECK(std::all_of(home.begin() + 3, home.end(), [](double turn) { return turn == 0; }));
    for (int j = 0; j < machine::kStruts; ++j) {
      double squares = 0;
      for (int a = 0; a < 3; ++a) {
        const std::string of = std::to_string(j) + "." + "xyz"[a];
        const double base = pins.at("genhexkins.base." + of);
        const double platform = pins.at("genhexkins.platform." + of);
        CHECK(base == Approx(model.geometry.base_joints_W(a, j) / kMm).margin(1e-9));
        CHECK(platform ==
              Approx((model.geometry.platform_joints_P(a, j) - model.geometry.tool_tip_P[a]) / kMm).margin(1e-9));
        squares += std::pow(home[static_cast<std::size_t>(a)] + platform - base, 2);
      }
      const std::string joint = "JOINT_" + std::to_string(j) + "/";
      CHECK(number(keys, joint + "HOME") == Approx(std::sqrt(squares)).margin(2e-8));
      CHECK(keys.at(joint + "HOME_OFFSET") == keys.at(joint + "HOME"));
      CHECK(number(keys, joint + "MIN_LIMIT") == Approx(model.limits.length_min[j] / kMm));
      CHECK(number(keys, joint + "MAX_LIMIT") == Approx(model.limits.length_max[j] / kMm));
    }
  }
}

TEST_CASE("limits are the model's; Z, which LinuxCNC counts with the tool, reaches higher by the longest one") {
  const machine::MachineModel model = testing::pm600_like();
  nc::ProgramSettings settings;
  settings.tools = nc::ToolTable({nc::Tool{1, 85, 16, 1.4, 40, ""}, nc::Tool{7, 120.5, {}, {}, {}, "MILL10"}});
  settings.work_offsets[1] = nc::WorkOffset{{{1, 2, -1008, 0, 0.5, 0}}, 12};
  Files files = files_of(model, settings, {.speed_mm_min = 6000, .acceleration_mm_s2 = 500});
  const auto keys = keys_of(files.at("hexapod.ini"));
  CHECK(number(keys, "AXIS_X/MIN_LIMIT") == -300);
  CHECK(number(keys, "AXIS_Z/MIN_LIMIT") == -1250);
  CHECK(number(keys, "AXIS_Z/MAX_LIMIT") == -679.5);
  CHECK(number(keys, "AXIS_A/MAX_LIMIT") == Approx(25.1));
  CHECK(number(keys, "AXIS_B/MIN_LIMIT") == Approx(-25.1));
  CHECK(number(keys, "AXIS_Y/MAX_VELOCITY") == 100);
  CHECK(number(keys, "AXIS_C/MAX_ACCELERATION") == 500);
  CHECK(number(keys, "JOINT_3/MAX_VELOCITY") > 100);
  CHECK(files.at("hexapod.tbl") == "T1 P1 Z85 D16\nT7 P7 Z120.5 ;MILL10\n");
  CHECK(files.at("hexapod.var") == "5220 1\n5241 1\n5242 2\n5243 -1008\n5244 0\n5245 0.5\n5246 0\n5250 12\n");
}

TEST_CASE("the control has all variables that were given, in ascending order, and the work offsets on top") {
  const machine::MachineModel model = testing::pm600_like();
  const auto variables_of = [&](const nc::ProgramSettings& settings) {
    return files_of(model, settings).at("hexapod.var");
  };
  nc::ProgramSettings another_system;
  another_system.variables = {{5220, 3}, {31, 2.25}};
  CHECK(variables_of(another_system) == "31 2.25\n5220 3\n");
  nc::ProgramSettings shifted;
  shifted.variables = {{5210, 1}, {5211, -0.1234567}, {5219, 4}};
  CHECK(variables_of(shifted) == "5210 1\n5211 -0.1234567\n5219 4\n5220 1\n");
  nc::ProgramSettings homes;
  homes.variables = {{5161, 10}, {5183, -900}, {5221, 1}, {5227, 8}};  // U of G54 behind its C
  homes.work_offsets[0] = nc::WorkOffset{{{2, 0, -1008, 0, 0, 0}}, 0};
  CHECK(variables_of(homes) ==
        "5161 10\n5183 -900\n5220 1\n5221 2\n5222 0\n5223 -1008\n5224 0\n5225 0\n5226 0\n5227 8\n5230 0\n");
}

TEST_CASE("a machine that LinuxCNC cannot be is refused") {
  machine::MachineModel model = testing::pm600_like();
  model.rotation = *machine::rotation_order("XYZ");
  CHECK(testing::refusal_of([&] { files_of(model); }).code == "control-rotation");
  model = testing::pm600_like();
  model.limits.length_max.setConstant(1.0);
  CHECK(testing::refusal_of([&] { files_of(model); }).code == "control-home");
}

TEST_CASE("a work system of another control is refused by its name") {
  const testing::Scratch scratch;
  settings::Options options;
  options.paths.model = testing::source_file("models/pm600-like.toml");
  settings::set_option(options, *settings::find_option("work-offset"), "G54.1P1=0,0,-1008,0,0,0");
  const Diagnostic refused = testing::refusal_of([&] { jobs::write_linuxcnc_control(options, {}, scratch.path("a")); });
  CHECK(refused.code == "control-work-system");
  CHECK(refused.message.find("G54.1P1") != std::string::npos);
  CHECK_FALSE(scratch.has("a"));
}

TEST_CASE("a configuration is not written over another one") {
  const testing::Scratch scratch;
  settings::Options options;
  options.paths.model = testing::source_file("models/pm600-like.toml");
  std::filesystem::create_directory(scratch.path("a"));
  scratch.file("a/hexapod.tbl", "T1 P1 Z85\n");
  CHECK(testing::refusal_of([&] { jobs::write_linuxcnc_control(options, {}, scratch.path("a")); }).code ==
        "control-folder-taken");
  CHECK_FALSE(scratch.has("a/hexapod.ini"));
  jobs::write_linuxcnc_control(options, {}, scratch.path("b/c"));
  for (const char* name : {"hexapod.ini", "hexapod.hal", "hexapod.tbl", "hexapod.var", "hexapod_view.py"})
    CHECK(scratch.has(std::string("b/c/") + name));
}

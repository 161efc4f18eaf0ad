#include "jobs/linuxcnc_control.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <list>
#include <map>

#include <fmt/format.h>

#include "base/axes.hpp"
#include "base/diagnostic.hpp"
#include "base/files/output_set.hpp"
#include "base/files/path_of.hpp"
#include "base/text/number_text.hpp"
#include "base/text/printable.hpp"
#include "machine/inverse.hpp"
#include "machine/limits.hpp"
#include "machine/model_file.hpp"
#include "nc/language/dialect.hpp"
#include "settings/program_settings.hpp"

namespace plumbline::embedded {
extern const std::string_view linuxcnc_view_py;
}

namespace plumbline::jobs {
namespace {

constexpr double kServoPeriod = 1e-3;  // s
constexpr std::size_t kLinuxcncSystems = 9;
constexpr int kFirstOffsetParameter = 5221;  // of G54; a row of twenty for each system  [RS274/NGC 3.2.1]
constexpr int kActiveSystemParameter = 5220;
constexpr int kParametersPerSystem = 20;
constexpr int kRotation = 9;  // after the first of a work system

std::string mm(double metres) { return to_decimal(metres / kMm); }

double longest_tool(const nc::ToolTable& tools) {
  double longest = 0;
  for (const nc::Tool& tool : tools.all()) longest = std::max(longest, tool.length_mm * kMm);
  return longest;
}

// A strut follows tip and platform: |dL/dt| <= |v| + |w| |b|, b from the tip to its joint.
double fastest_strut_mm_s(const machine::MachineModel& model, const nc::ToolTable& tools, double axis_speed) {
  const machine::Geometry geometry = machine::with_tool(model.geometry, longest_tool(tools));
  const double arm = (geometry.platform_joints_P.colwise() - geometry.tool_tip_P).colwise().norm().maxCoeff();
  return axis_speed + std::sqrt(3.0) * axis_speed * kDeg * arm / kMm;
}

std::string limits_text(double lower, double upper, double speed, double acceleration) {
  return fmt::format("MIN_LIMIT = {}\nMAX_LIMIT = {}\nMAX_VELOCITY = {}\nMAX_ACCELERATION = {}\n", to_decimal(lower),
                     to_decimal(upper), to_decimal(speed), to_decimal(acceleration));
}

constexpr std::string_view kGeneral = R"(# LinuxCNC simulates a hexapod with the geometry of the model "{0}":
#   linuxcnc hexapod.ini
# Written by plumbline. Travel, tilt and strut lengths are the model's. Velocities (mm/s, deg/s) and accelerations are the
# simulation's: the model states none.

[EMC]
VERSION = 1.1
MACHINE = {0}

[DISPLAY]
DISPLAY = axis
GEOMETRY = ABCXYZ
POSITION_OFFSET = RELATIVE
POSITION_FEEDBACK = ACTUAL
MAX_FEED_OVERRIDE = 1.5
CYCLE_TIME = 0.1

[TASK]
TASK = milltask
CYCLE_TIME = 0.001

[RS274NGC]
PARAMETER_FILE = hexapod.var

[EMCMOT]
EMCMOT = motmod
COMM_TIMEOUT = 1.0
SERVO_PERIOD = {1:.0f}

[EMCIO]
EMCIO = io
CYCLE_TIME = 0.1
TOOL_TABLE = hexapod.tbl

[HAL]
HALFILE = hexapod.hal

[APPLICATIONS]
APP = /usr/bin/python3 hexapod_view.py

[KINS]
KINEMATICS = genhexkins
JOINTS = {2}

[TRAJ]
COORDINATES = X Y Z A B C
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
HOME = {3} {4} {5} 0 0 0
DEFAULT_LINEAR_VELOCITY = {6}
MAX_LINEAR_VELOCITY = {6}
DEFAULT_LINEAR_ACCELERATION = {7}
MAX_LINEAR_ACCELERATION = {7}
DEFAULT_ANGULAR_VELOCITY = {6}
MAX_ANGULAR_VELOCITY = {6}
DEFAULT_ANGULAR_ACCELERATION = {7}
MAX_ANGULAR_ACCELERATION = {7}
)";

std::string general_text(const machine::MachineModel& model, double speed, double acceleration) {
  const Vector3<double> home = machine::home_pose(model).p_WT;
  return fmt::format(kGeneral, printable(model.name), kServoPeriod * 1e9, machine::kStruts, mm(home.x()), mm(home.y()),
                     mm(home.z()), to_decimal(speed), to_decimal(acceleration));
}

// LinuxCNC counts Z of an axis with the length of the tool: travel is that of the tip, and reaches higher by it.
std::string axes_text(const machine::MachineModel& model, const nc::ToolTable& tools, double speed,
                      double acceleration) {
  std::string text;
  for (const Axis axis : kAllAxes) {
    text += fmt::format("\n[AXIS_{}]\n", letter(axis));
    double lower = -360;
    double upper = 360;
    if (!is_rotary(axis)) {
      const machine::Range& travel = model.limits.travel[index(axis)];
      lower = travel.lower / kMm;
      upper = (travel.upper + (axis == Axis::Z ? longest_tool(tools) : 0)) / kMm;
    } else if (axis != Axis::C) {
      upper = (model.limits.tilt + model.limits.tilt_allowance) / kDeg;
      lower = -upper;
    }
    text += limits_text(lower, upper, speed, acceleration);
  }
  return text;
}

std::string joints_text(const machine::MachineModel& model, const nc::ToolTable& tools, double speed,
                        double acceleration) {
  const machine::PerStrut<double> home = machine::strut_lengths<double>(model.geometry, machine::home_pose(model));
  const double fastest = fastest_strut_mm_s(model, tools, speed);
  std::string text;
  for (int j = 0; j < machine::kStruts; ++j) {
    text += fmt::format("\n[JOINT_{}]\nTYPE = LINEAR\n", j);
    text += limits_text(model.limits.length_min[j] / kMm, model.limits.length_max[j] / kMm, fastest,
                        acceleration * fastest / speed);
    // without a search the joint stands at HOME_OFFSET when it is homed
    text += fmt::format("HOME = {0}\nHOME_OFFSET = {0}\nHOME_SEQUENCE = 0\n", mm(home[j]));
    // what is read back is a period old
    text += fmt::format("FERROR = {0}\nMIN_FERROR = {0}\n", to_decimal(2 * fastest * kServoPeriod, 3));
  }
  return text;
}

std::string hal_text(const machine::MachineModel& model) {
  std::string text = R"(# The kinematics, and drives that are where they are told to be. Written by plumbline.
loadrt [KINS]KINEMATICS
loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS
addf motion-command-handler servo-thread
addf motion-controller servo-thread

# joints of the base in W, joints of the platform from the tool tip, mm
)";
  for (int j = 0; j < machine::kStruts; ++j) {
    const Vector3<double> base = model.geometry.base_joints_W.col(j);
    const Vector3<double> platform = model.geometry.platform_joints_P.col(j) - model.geometry.tool_tip_P;
    for (int a = 0; a < 3; ++a) {
      text += fmt::format("setp genhexkins.base.{0}.{1} {2}\nsetp genhexkins.platform.{0}.{1} {3}\n", j, "xyz"[a],
                          mm(base[a]), mm(platform[a]));
    }
  }
  text +=
      "\n# the tool lies along -Z of the platform\nnet tool-length motion.tooloffset.z => genhexkins.tool-offset\n\n";
  for (int j = 0; j < machine::kStruts; ++j) {
    text += fmt::format("net strut{0} joint.{0}.motor-pos-cmd => joint.{0}.motor-pos-fb\n", j);
  }
  return text + R"(
net emergency-stop iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in
net tool-prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared
net tool-change iocontrol.0.tool-change => iocontrol.0.tool-changed
)";
}

std::string tool_table_text(const nc::ToolTable& tools) {
  std::string text;
  for (const nc::Tool& tool : tools.all()) {
    text += fmt::format("T{0} P{0} Z{1}", tool.number, to_decimal(tool.length_mm));
    if (tool.diameter_mm) text += fmt::format(" D{}", to_decimal(*tool.diameter_mm));
    text += tool.name.empty() ? "\n" : fmt::format(" ;{}\n", printable(tool.name));
  }
  return text;
}

// The control reads its variables in ascending order [LinuxCNC, rs274ngc_pre.cc: restore_parameters]; what
// was given as a work offset stands in place of the file's.
std::string variables_text(const nc::ProgramSettings& settings) {
  std::map<int, double> rows = settings.variables;
  rows.erase(0);  // R0 of other controls
  rows.emplace(kActiveSystemParameter, 1);
  for (std::size_t i = 0; i < kLinuxcncSystems; ++i) {
    if (!settings.work_offsets[i]) continue;
    const nc::WorkOffset& offset = *settings.work_offsets[i];
    const int first = kFirstOffsetParameter + kParametersPerSystem * static_cast<int>(i);
    for (const Axis axis : kAllAxes) rows[first + static_cast<int>(index(axis))] = offset.origin[axis];
    rows[first + kRotation] = offset.rotation_deg;
  }
  std::string text;
  for (const auto& [number, value] : rows) text += fmt::format("{} {}\n", number, exact_decimal(value));
  return text;
}

void refuse_what_linuxcnc_has_not(const machine::MachineModel& model) {
  // R = Rz(C) Ry(B) Rx(A)  [genhexkins: pmRpyMatConvert of roll A, pitch B, yaw C]
  if (machine::to_text(model.rotation) != "ZYX") {
    refuse("control-rotation",
           fmt::format("A, B and C of this machine turn in the order {}, those of genhexkins in the order ZYX",
                       machine::to_text(model.rotation)),
           "LinuxCNC has no kinematics for this machine: write your own", {model.document.file});
  }
  const Pose<double> home = machine::home_pose(model);
  const std::vector<machine::Violation> violations = machine::check_compensated(model.limits, model.geometry, home);
  if (!violations.empty()) {
    refuse("control-home",
           fmt::format("in the middle of its travel, where the control starts, {}", to_text(violations.front())),
           "look at [limits] and [strut] of the model", {model.document.file});
  }
}

// A name may be that of another system on another control: G54.1P1 is Fanuc's seventh.
void refuse_other_systems(const settings::Options& options) {
  for (const settings::NamedSystem& system : options.offset_systems) {
    if (nc::dialect("linuxcnc").system_of_name(system.name) == system.number) continue;
    refuse("control-work-system", fmt::format("LinuxCNC has no work system {}", system.name),
           "it has G54 to G59 and G59.1 to G59.3: name one of these in --work-offset", system.stated);
  }
}

}  // namespace

std::vector<ControlFile> linuxcnc_configuration(const machine::MachineModel& model, const nc::ProgramSettings& settings,
                                                const SimulatedDrives& drives) {
  refuse_what_linuxcnc_has_not(model);
  const double speed = drives.speed_mm_min / kMinute;
  const double acceleration = drives.acceleration_mm_s2;
  return {
      {"hexapod.hal", hal_text(model)},
      {"hexapod.tbl", tool_table_text(settings.tools)},
      {"hexapod.var", variables_text(settings)},
      {"hexapod_view.py", std::string(embedded::linuxcnc_view_py)},
      {"hexapod.ini", general_text(model, speed, acceleration) + axes_text(model, settings.tools, speed, acceleration) +
                          joints_text(model, settings.tools, speed, acceleration)}};
}

void write_linuxcnc_control(const settings::Options& options, const SimulatedDrives& drives,
                            const std::string& folder) {
  namespace fs = std::filesystem;
  refuse_other_systems(options);
  const machine::MachineModel model = machine::read_model(options.paths.model);
  const std::vector<ControlFile> files =
      linuxcnc_configuration(model, settings::program_settings(options, model), drives);
  for (const ControlFile& file : files) {
    const fs::path taken = path_of(folder) / path_of(file.name);
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(taken, ignored))) {
      refuse("control-folder-taken", fmt::format("there is a {} in {} already", file.name, folder),
             "you may have changed it: name another folder with -o", {taken.generic_string()});
    }
  }
  NewFolder made(folder);
  std::list<OutputFile> outputs;
  OutputSet set;
  for (const ControlFile& file : files) {
    outputs.emplace_back((path_of(folder) / path_of(file.name)).generic_string()).write(file.text);
    set.add(outputs.back());
  }
  set.commit();
  made.keep();
}

}  // namespace plumbline::jobs

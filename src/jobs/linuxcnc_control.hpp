// LinuxCNC set up to simulate a machine: its configuration with the geometry, limits, tools and work offsets that
// plumbline was given.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "machine/model.hpp"
#include "nc/control/state/program_settings.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {

/// How fast the simulated machine moves: no model states that.
struct SimulatedDrives {
  double speed_mm_min = 12000;       // of the tip, also of a rapid; a degree counts as a millimetre
  double acceleration_mm_s2 = 2000;  // of each axis
};

/// One file of the configuration.
struct ControlFile {
  std::string name;
  std::string text;
};

/// hexapod.hal, hexapod.tbl, hexapod.var, hexapod_view.py, which draws it, and, last, hexapod.ini, for LinuxCNC 2.9.
/// Struts are the joints of genhexkins, which takes joints of the platform from the tool tip, mm; the machine stands
/// homed at machine::home_pose. Each drive is where it is told to be. Refuses with control-rotation a model that does
/// not turn as genhexkins does, and with control-home one whose home pose breaks its limits.
std::vector<ControlFile> linuxcnc_configuration(const machine::MachineModel& model, const nc::ProgramSettings& settings,
                                                const SimulatedDrives& drives);

/// Reads model, tools and variables that the options name and writes the configuration into a folder, made if need be.
/// Refuses as the readers do, with control-work-system offsets of a system that LinuxCNC has not, and with
/// control-folder-taken if any of the files is there.
void write_linuxcnc_control(const settings::Options& options, const SimulatedDrives& drives, const std::string& folder);

}  // namespace plumbline::jobs

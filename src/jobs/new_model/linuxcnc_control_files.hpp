// The INI and HAL files of a control that runs LinuxCNC's kinematics for hexapods, read together.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "jobs/new_model/hal_file.hpp"
#include "jobs/new_model/ini_file.hpp"

namespace plumbline::jobs {

struct ControlFiles {
  std::string ini;
  std::vector<std::string> hal;  // empty: those that the INI names
};

struct LinuxcncControl {
  IniFile ini;
  HalPins hal;
  double unit_mm = 1;  // of lengths in both

  /// An entry that must be there; `why` says what is not known without it. Refuses with draft-missing.
  const IniEntry& need(std::string_view section, std::string_view key, std::string_view why) const;
  /// A pin of genhexkins that must be set, as "base.0.x". Refuses with draft-missing.
  const HalPin& need_pin(const std::string& name) const;
  /// What a pin of genhexkins is set to; zero, which is its default, where no file sets it.
  double pin_or_zero(const std::string& name) const;
  /// MIN_LIMIT and MAX_LIMIT of a section, in the files' units; nothing if it does not have both. Refuses with
  /// draft-contradiction and draft-number.
  std::optional<std::array<double, 2>> limits(const std::string& section) const;
};

/// Refuses as read_ini and read_hal do, and with draft-kinematics a control that is not that of a hexapod with
/// genhexkins, or corrects for turning screws, and with draft-units.
LinuxcncControl read_linuxcnc_control(const ControlFiles& files);

}  // namespace plumbline::jobs

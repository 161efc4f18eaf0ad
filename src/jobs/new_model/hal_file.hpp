// What the HAL files of a control set, as LinuxCNC's halcmd reads them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "jobs/new_model/ini_file.hpp"

namespace plumbline::jobs {

struct HalPin {
  std::string name;
  double value = 0;
  Place place;  // of the value
};

struct HalPins {
  std::vector<HalPin> pins;              // each once
  std::vector<std::string> files;        // that were read
  std::vector<std::string> other_files;  // that the INI names and nobody reads here: Tcl, LinuxCNC's own library

  const HalPin* find(std::string_view name) const;
};

/// What `setp PIN VALUE` (or PIN = VALUE) sets of the pins whose names begin with `prefix`: in the HAL files given, or,
/// if there are none, in those that the INI names and in its HALCMD lines. `source FILE` is followed; [SECTION]KEY is
/// taken from the INI. Paths count from the INI's folder. Refuses with draft-file, draft-number,
/// draft-contradiction a pin that is set to two values, and with draft-signal one that a signal sets.
HalPins read_hal(const std::vector<std::string>& files, const IniFile& ini, std::string_view prefix);

}  // namespace plumbline::jobs

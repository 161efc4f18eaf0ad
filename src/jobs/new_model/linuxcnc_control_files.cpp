#include "jobs/new_model/linuxcnc_control_files.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/units.hpp"

namespace plumbline::jobs {
namespace {

const std::string kPrefix = "genhexkins.";
constexpr double kNoLimit = 1e6;  // in any unit

void check_kinematics(const LinuxcncControl& control) {
  const IniEntry& kinematics = control.need("KINS", "KINEMATICS", "whether the machine is a hexapod is not known");
  if (!kinematics.value.starts_with("genhexkins")) {
    refuse("draft-kinematics",
           fmt::format("the kinematics are {}, not those of a hexapod with six struts", kinematics.value),
           "plumbline knows machines that run genhexkins", kinematics.place);
  }
  const HalPin* const lead = control.hal.find(kPrefix + "screw-lead");
  if (lead != nullptr && lead->value != 0) {
    refuse(
        "draft-kinematics",
        "the control corrects strut lengths by how far screws turn in their joints (screw-lead), which no model says",
        "set screw-lead to 0 if the machine does not need it; else there is no model for this machine", lead->place);
  }
}

double unit_of(const LinuxcncControl& control) {
  const IniEntry& units = control.need("TRAJ", "LINEAR_UNITS", "what its lengths are in is not known");
  const std::string& name = units.value;
  if (name == "mm" || name == "metric") return 1;
  if (name == "inch" || name == "in" || name == "imperial") return kInch / kMm;
  refuse("draft-units", fmt::format("LINEAR_UNITS = {} is no unit of length", name), "write mm or inch", units.place);
}

}  // namespace

const IniEntry& LinuxcncControl::need(std::string_view section, std::string_view key, std::string_view why) const {
  const IniEntry* const entry = ini.find(section, key);
  if (entry == nullptr) {
    refuse("draft-missing", fmt::format("there is no {} in [{}]: {}", key, section, why),
           fmt::format("add it to [{}], as the control has it", section), ini.whole());
  }
  return *entry;
}

const HalPin& LinuxcncControl::need_pin(const std::string& name) const {
  const HalPin* const pin = hal.find(kPrefix + name);
  if (pin != nullptr) return *pin;
  std::string others;
  for (const std::string& file : hal.other_files) others += (others.empty() ? "; not read: " : ", ") + file;
  refuse("draft-missing",
         fmt::format("no HAL file sets {}{}, and genhexkins would take a number of its own{}", kPrefix, name, others),
         "add setp with the machine's number, or name the file that has it with --hal",
         Place{hal.files.empty() ? ini.file : hal.files.back()});
}

double LinuxcncControl::pin_or_zero(const std::string& name) const {
  const HalPin* const pin = hal.find(kPrefix + name);
  return pin == nullptr ? 0 : pin->value;
}

std::optional<std::array<double, 2>> LinuxcncControl::limits(const std::string& section) const {
  const IniEntry* const lower = ini.find(section, "MIN_LIMIT");
  const IniEntry* const upper = ini.find(section, "MAX_LIMIT");
  if (lower == nullptr || upper == nullptr) return std::nullopt;
  // 1e99 is LinuxCNC's own word for none
  const auto held = [](double limit) { return std::clamp(limit, -kNoLimit, kNoLimit); };
  const std::array<double, 2> limits{held(numbers_of(*lower).front()), held(numbers_of(*upper).front())};
  if (limits[0] < limits[1]) return limits;
  refuse("draft-contradiction", fmt::format("MIN_LIMIT of [{}] is not below its MAX_LIMIT", section),
         "write the lower one as MIN_LIMIT", lower->place);
}

LinuxcncControl read_linuxcnc_control(const ControlFiles& files) {
  LinuxcncControl control;
  control.ini = read_ini(files.ini);
  control.hal = read_hal(files.hal, control.ini, kPrefix);
  check_kinematics(control);
  control.unit_mm = unit_of(control);
  return control;
}

}  // namespace plumbline::jobs

#include "jobs/new_model/linuxcnc_machine.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "base/axes.hpp"
#include "base/files/path_of.hpp"
#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "machine/axis_words.hpp"
#include "machine/inverse.hpp"

namespace plumbline::jobs {
namespace {

constexpr double kSameLength = 0.1;       // mm, between HOME of a joint and the strut's length at HOME of [TRAJ]
constexpr double kTiltAllowance = 0.1;    // deg that corrections may tilt beyond tilt_deg, see machine/model_keys.hpp
constexpr double kFurthestJoint = 50000;  // mm, that a model may state
constexpr double kStatableTilt = 90;      // deg that a model may state

std::string file_of(const Place& place) { return path_of(place.file).filename().generic_string(); }

std::string where(const Place& place) { return fmt::format("{}:{}", file_of(place), place.line); }

// z is the pin's with spindle-offset and tool-offset, of base and platform alike  [genhexkins.c, genhex_read_hal_pins]
void take_ring(const LinuxcncControl& control, ModelDraft& draft, const char* ring) {
  const double along_z = control.pin_or_zero("spindle-offset") + control.pin_or_zero("tool-offset");
  DraftValue joints{ring, "joints_mm", {}, "", "", false, {}};
  for (int j = 0; j < machine::kStruts; ++j) {
    for (const char axis : {'x', 'y', 'z'}) {
      const HalPin& pin = control.need_pin(fmt::format("{}.{}.{}", ring, j, axis));
      if (joints.values.empty()) joints.place = pin.place;
      const double coordinate = (pin.value + (axis == 'z' ? along_z : 0)) * control.unit_mm;
      if (!(std::abs(coordinate) <= kFurthestJoint)) {
        refuse("draft-number", fmt::format("{} puts a joint further out than any machine has it", pin.name),
               "check the number, and LINEAR_UNITS of [TRAJ]", pin.place);
      }
      joints.values.push_back(from_ticks(to_ticks(coordinate, kMostDecimals), kMostDecimals));
    }
  }
  joints.note = where(joints.place);
  draft.put(std::move(joints));
}

void take_name_and_joints(const LinuxcncControl& control, ModelDraft& draft) {
  const IniEntry* const machine = control.ini.find("EMC", "MACHINE");
  if (machine != nullptr && !machine->value.empty() && !draft.has("", "name"))
    draft.put({"", "name", {}, machine->value, "", false, machine->place});
  take_ring(control, draft, "base");
  take_ring(control, draft, "platform");
  draft.put({"", "rotation", {}, "ZYX", "R = Rz(C) Ry(B) Rx(A), as genhexkins turns", false, {}});
  draft.put({"platform", "tool_tip_mm", {0, 0, 0}, "", "genhexkins counts the platform's joints from it", false, {}});
}

// HOME of [TRAJ]: where the control believes the tip to be once all joints are homed.
AxisWords take_home(const LinuxcncControl& control, ModelDraft& draft) {
  const IniEntry& entry =
      control.need("TRAJ", "HOME", "where the tip stands at home is not known, which --home X,Y,Z would say, too");
  const std::vector<double> numbers = numbers_of(entry);
  if (numbers.size() < 3)
    refuse("draft-number", "HOME of [TRAJ] has fewer than three numbers", "write X Y Z A B C", entry.place);
  AxisWords home;
  for (const Axis axis : kAllAxes) {
    if (index(axis) < numbers.size()) home[axis] = numbers[index(axis)] * (is_rotary(axis) ? 1 : control.unit_mm);
    if (!(std::abs(home[axis]) <= kFurthestJoint))
      refuse("draft-number", "HOME of [TRAJ] lies further out than any machine goes",
             "check the number, and LINEAR_UNITS of [TRAJ]", entry.place);
  }
  draft.home_mm = {home[Axis::X], home[Axis::Y], home[Axis::Z]};
  draft.home_note = where(entry.place);
  return home;
}

void compare_homes(const LinuxcncControl& control, const machine::PerStrut<double>& lengths) {
  for (int j = 0; j < machine::kStruts; ++j) {
    const IniEntry* const entry = control.ini.find(fmt::format("JOINT_{}", j), "HOME");
    if (entry == nullptr) continue;
    const double stated = numbers_of(*entry).front() * control.unit_mm;
    const double length = lengths[j] / kMm;
    if (std::abs(stated - length) <= kSameLength) continue;
    refuse("draft-contradiction",
           fmt::format("by the joints of the HAL file strut {} is {} mm long at HOME of [TRAJ]; here it is {} mm",
                       j + 1, to_decimal(length, 3), to_decimal(stated, 3)),
           "correct what is wrong; if the joints are right and the machine is homed elsewhere, say with --home X,Y,Z "
           "where the tip stands in the middle of its work",
           entry->place);
  }
}

// Takes limits into the draft, or says why they are none.
class LimitTaker {
 public:
  LimitTaker(const LinuxcncControl& control, ModelDraft& draft, std::vector<std::string>& notes)
      : control_(control), draft_(draft), notes_(notes) {}

  void strut_lengths() {
    std::vector<double> shortest;
    std::vector<double> longest;
    for (int j = 0; j < machine::kStruts; ++j) {
      const std::string section = fmt::format("JOINT_{}", j);
      const auto limits = control_.limits(section);
      if (!limits) return;
      if ((*limits)[0] <= 0) return leave_out(section, *limits, "no strut is that short");
      shortest.push_back((*limits)[0] * control_.unit_mm);
      longest.push_back((*limits)[1] * control_.unit_mm);
    }
    put("strut", "length_min_mm", alike(shortest), "JOINT_0", "MIN_LIMIT");
    put("strut", "length_max_mm", alike(longest), "JOINT_0", "MAX_LIMIT");
  }

  // |x - x'| <= L + L' for two poses turned alike: nothing beyond twice the longest strut is ever reached.
  void travel(double longest_at_home) {
    constexpr std::array<const char*, 3> kKeys{"x_mm", "y_mm", "z_mm"};
    const bool known = draft_.has("strut", "length_max_mm");
    const double longest = known ? draft_.largest("strut", "length_max_mm") : longest_at_home;
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
      const std::string section = fmt::format("AXIS_{}", letter(axis));
      const auto limits = control_.limits(section);
      if (!limits) continue;
      const double home = draft_.home_mm[index(axis)];
      const double lower = (*limits)[0] * control_.unit_mm;
      const double upper = (*limits)[1] * control_.unit_mm;
      if (lower < home - 2 * longest || upper > home + 2 * longest)
        leave_out(section, *limits, "the struts do not take the tip that far");
      else
        put("limits", kKeys[index(axis)], {lower, upper}, section, "MIN_LIMIT");
    }
  }

  void tilt() {
    double tilt = kStatableTilt;
    std::string of;
    for (const char* const section : {"AXIS_A", "AXIS_B"}) {
      const auto limits = control_.limits(section);
      if (!limits) return;
      const double least = std::min(-(*limits)[0], (*limits)[1]);
      if (least > kStatableTilt || least <= kTiltAllowance)
        return leave_out(section, *limits, "it is no tilt that a hexapod has");
      if (of.empty() || least < tilt) of = section;
      tilt = std::min(tilt, least);
    }
    // a compensated pose may tilt by the allowance more, and the control has to let it
    put("limits", "tilt_deg", {from_ticks(to_ticks(tilt - kTiltAllowance, kMostDecimals), kMostDecimals)}, of,
        "MAX_LIMIT");
  }

 private:
  // One number where all six are the same.
  static std::vector<double> alike(const std::vector<double>& six) {
    const bool same = std::all_of(six.begin(), six.end(), [&](double length) { return length == six.front(); });
    return same ? std::vector<double>{six.front()} : six;
  }

  void leave_out(const std::string& section, const std::array<double, 2>& limits, std::string_view why) {
    notes_.push_back(fmt::format("[{}] {} to {} counts as no limit: {}", section, to_decimal(limits[0]),
                                 to_decimal(limits[1]), why));
  }

  void put(const char* table, const char* key, std::vector<double> values, const std::string& section,
           const char* ini_key) {
    if (draft_.has(table, key)) return;
    const Place& place = control_.ini.find(section, ini_key)->place;
    draft_.put({table, key, std::move(values), "", where(place), false, place});
  }

  const LinuxcncControl& control_;
  ModelDraft& draft_;
  std::vector<std::string>& notes_;
};

}  // namespace

void take_linuxcnc(const LinuxcncControl& control, ModelDraft& draft, std::vector<std::string>& notes) {
  std::string read = "read: " + file_of(control.ini.whole());
  for (const std::string& file : control.hal.files) {
    if (file != control.ini.file) read += ", " + file_of({file});
  }
  notes.push_back(std::move(read));
  for (const std::string& file : control.hal.other_files)
    notes.push_back(fmt::format("not read: {}, which is no .hal file of the machine's own", file));

  take_name_and_joints(control, draft);
  AxisWords home;
  const bool stated = !draft.home_mm.empty();
  if (stated) {
    home = {{draft.home_mm[0], draft.home_mm[1], draft.home_mm[2], 0, 0, 0}};
  } else {
    home = take_home(control, draft);
  }
  const Pose<double> pose = machine::pose_of(*machine::rotation_order("ZYX"), home);
  const machine::PerStrut<double> lengths = machine::strut_lengths<double>(draft.geometry(), pose);
  if (!stated) compare_homes(control, lengths);
  LimitTaker limits(control, draft, notes);
  limits.strut_lengths();
  limits.travel(lengths.maxCoeff() / kMm);
  limits.tilt();
}

}  // namespace plumbline::jobs

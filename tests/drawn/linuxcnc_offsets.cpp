// Work systems, shifts and tools of LinuxCNC.
#include <fmt/format.h>

#include "drawn/linuxcnc.hpp"

namespace plumbline::drawn {
namespace {

constexpr std::array<std::string_view, 9> kLinuxCncSystems{"G54", "G55",   "G56",   "G57",  "G58",
                                                           "G59", "G59.1", "G59.2", "G59.3"};

}  // namespace

void LinuxCnc::select_system(int system) {
  offsets_anew_ = true;
  const AxisWords box = to_box(at_);
  system_ = system;
  origin_ = systems_[static_cast<std::size_t>(system - 1)].origin;
  turned_deg_ = systems_[static_cast<std::size_t>(system - 1)].turned_deg;
  at_ = to_work(box);
}

void LinuxCnc::set_table(int system) {
  offsets_anew_ = true;
  System& row = systems_[static_cast<std::size_t>(system - 1)];
  const AxisWords box = to_box(at_);
  Words words{draws_.chance(20) && system == system_ ? "G10 L2 P0" : fmt::format("G10 L2 P{}", system)};
  for (const Axis axis : kAllAxes) {
    if (!draws_.chance(35) || (is_rotary(axis) && !uses_rotary_)) continue;
    const double to = row.origin[axis] + draws_.whole(-300, 300) / (is_rotary(axis) ? 1000.0 : 100.0);
    const double given = to + kBox[axis];  // of the machine
    const Spelled number = is_rotary(axis) ? spell(given, 4, 9) : spell(given / unit(), 5, 9);
    row.origin[axis] = number.value * (is_rotary(axis) ? 1 : unit()) - kBox[axis];
    words.push_back(letter(axis) + number.text);
  }
  if (draws_.chance(15) || words.size() == 1) {
    row.turned_deg = draws_.whole(-90, 90);
    words.push_back(fmt::format("R{}", row.turned_deg));
  }
  if (system == system_) {
    origin_ = row.origin;
    turned_deg_ = row.turned_deg;
    at_ = to_work(box);
  }
  put(words);
}

// G10 L20: the work system is put where the axes read what the block says.
void LinuxCnc::set_system_here() {
  offsets_anew_ = true;
  if (turned_deg_ != 0) return;
  Words words{draws_.chance(50) ? "G10 L20 P0" : fmt::format("G10 L20 P{}", system_)};
  for (const Axis axis : kAllAxes) {
    if (!draws_.chance(35) || (is_rotary(axis) && !uses_rotary_) || axis == Axis::C) continue;
    const double to = at_[axis] + draws_.whole(-300, 300) / (is_rotary(axis) ? 1000.0 : 100.0);
    const Spelled number = is_rotary(axis) ? spell(to, 4, 9) : spell(to / unit(), 5, 9);
    const double value = number.value * (is_rotary(axis) ? 1 : unit());
    origin_[axis] += at_[axis] - value;
    at_[axis] = value;
    words.push_back(letter(axis) + number.text);
  }
  if (words.size() == 1) return;
  systems_[static_cast<std::size_t>(system_ - 1)].origin = origin_;
  put(words);
}

void LinuxCnc::change_offset() {
  const int kind = draws_.whole(0, 5);
  if (kind <= 1) {
    const int system = draws_.whole(1, 9);
    if (!program_.options.program.work_offsets[static_cast<std::size_t>(system - 1)] && !draws_.chance(20)) return;
    select_system(system);
    known_ = known_ && program_.options.program.work_offsets[static_cast<std::size_t>(system - 1)].has_value();
    return put({std::string(kLinuxCncSystems[static_cast<std::size_t>(system - 1)])});
  }
  if (kind == 2 && draws_.chance(40)) return set_system_here();
  if (kind == 2) return set_table(draws_.chance(60) ? system_ : draws_.whole(1, 9));
  set_position();
}

// G92, G52 and their relatives
void LinuxCnc::set_position() {
  offsets_anew_ = true;
  const AxisWords before = at_ + shift_;
  const int kind = draws_.whole(0, 9);
  Words words;
  if (kind < 5) {
    words.emplace_back("G92");
    for (const Axis axis : kAllAxes) {
      if (!draws_.chance(30) || (is_rotary(axis) && !uses_rotary_)) continue;
      const double to = at_[axis] + draws_.whole(-300, 300) / (is_rotary(axis) ? 1000.0 : 100.0);
      const Spelled number = is_rotary(axis) ? spell(to, 4, 9) : spell(to / unit(), 5, 9);
      at_[axis] = number.value * (is_rotary(axis) ? 1 : unit());
      words.push_back(letter(axis) + number.text);
    }
    if (words.size() == 1) return;
    shift_ = stored_ = before - at_;
  } else if (kind < 7) {
    words.emplace_back("G52");
    for (const Axis axis : kAllAxes) {
      if (!draws_.chance(30) || is_rotary(axis)) continue;
      const Spelled number = spell(draws_.whole(-500, 500) / 100.0 / unit(), 5, 9);
      shift_[axis] = number.value * unit();
      words.push_back(letter(axis) + number.text);
    }
    if (words.size() == 1) return;
    stored_ = shift_;
    at_ = before - shift_;
  } else if (kind == 7) {
    words.emplace_back("G92.1");
    shift_ = stored_ = {};
    at_ = before;
  } else if (kind == 8) {
    words.emplace_back("G92.2");
    shift_ = {};
    at_ = before;
  } else {
    Words first{"G92.2"};
    shift_ = {};
    at_ = before;
    put(first);
    if (draws_.chance(50)) put(line(true));
    const AxisWords now = at_;
    shift_ = stored_;
    at_ = now - shift_;
    words.emplace_back("G92.3");
  }
  put(words);
}

void LinuxCnc::change_tool() {
  if (offsets_anew_) put(line(false));  // or rs274 takes what it moved to last for where it stands, whatever turned it
  offsets_anew_ = false;
  const int tool = draws_.whole(1, 3);
  tool_ = tool;
  const bool together = draws_.chance(60);
  if (!together) put({fmt::format("T{}", tool)});
  if (!keeps_at_tool_change_) known_ = false;
  spindle_ = spindle_ && feeds_ != Feeds::per_revolution ? false : spindle_;
  put({together ? fmt::format("T{}", tool) : "", code('M', 6)});
  if (!known_) go_to_known_place();
  if (draws_.chance(70)) tool_length();
}

void LinuxCnc::tool_length() {
  offsets_anew_ = true;
  double next = 0;
  std::string word = "G49";
  if (tool_ > 0 && draws_.chance(75)) {
    const bool own = draws_.chance(50);
    const int row = own ? tool_ : draws_.whole(1, 3);
    next = kToolLengths[row - 1];
    word = own && draws_.chance(50) ? "G43" : fmt::format("G43 H{}", row);
  }
  at_[Axis::Z] -= next - length_;
  length_ = next;
  put({word});
  if (!draws_.chance(90)) return;
  Words words;
  if (incremental_) words.emplace_back("G90");
  incremental_ = false;
  words.push_back(code('G', 0));
  motion_ = 0;
  words.push_back(axis_word(Axis::Z));
  put(words);
}

}  // namespace plumbline::drawn

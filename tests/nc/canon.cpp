#include "nc/canon.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "nc/control/state/frame.hpp"

namespace plumbline::nc::tests {
namespace {

// Reads calls one by one and keeps what later ones stand on.
class CanonReader {
 public:
  void call(const std::string& name, const std::string& arguments) {
    numbers_ = numbers_of(arguments);
    if (name.find("OFFSET") != std::string::npos) offsets_unit_ = std::max(offsets_unit_, unit_);
    if (name == "USE_LENGTH_UNITS") {
      unit_ = arguments.find("INCHES") != std::string::npos ? kMmPerInch : 1;
    } else if (name == "SELECT_PLANE") {
      plane_ = arguments.find("XZ") != std::string::npos   ? Plane::zx
               : arguments.find("YZ") != std::string::npos ? Plane::yz
                                                           : Plane::xy;
    } else if (name == "SET_G5X_OFFSET" || name == "SET_G92_OFFSET" || name == "SET_XY_ROTATION" ||
               name == "USE_TOOL_LENGTH_OFFSET") {
      change_offset(name);
    } else if (name == "SET_FEED_RATE") {
      feed_ = numbers_.at(0) * unit_;
    } else if (name == "STRAIGHT_TRAVERSE" || name == "STRAIGHT_FEED") {
      straight(name == "STRAIGHT_FEED" ? MotionKind::feed : MotionKind::rapid);
    } else if (name == "STRAIGHT_PROBE") {
      straight(MotionKind::probe);
    } else if (name == "RIGID_TAP") {
      rigid_tap();
    } else if (name == "NURBS_FEED") {
      CanonMotion spline;
      spline.spline = true;
      motions.push_back(spline);
    } else if (name == "ARC_FEED") {
      arc();
    } else if (name == "DWELL") {
      CanonMotion dwell;
      dwell.motion.kind = MotionKind::dwell;
      dwell.motion.dwell_s = numbers_.at(0);
      motions.push_back(dwell);
    }
  }

  std::vector<CanonMotion> motions;

 private:
  static std::vector<double> numbers_of(const std::string& text) {
    std::vector<double> numbers;
    std::string piece;
    std::istringstream in(std::regex_replace(text, std::regex("[,()]"), " "));
    while (in >> piece) {
      if (const auto number = parse_number(piece)) numbers.push_back(*number);
    }
    return numbers;
  }

  // Six numbers from `first`: X Y Z in the unit, A B C.
  AxisWords words(std::size_t first) const {
    AxisWords words;
    for (std::size_t i = 0; i < kAxes; ++i) words.values[i] = numbers_.at(first + i) * (i < 3 ? unit_ : 1);
    return words;
  }

  // The machine stands still, so that its position gets other words.
  void change_offset(const std::string& name) {
    const AxisWords machine = frame_.to_machine(position_);
    if (name == "SET_G5X_OFFSET") frame_.origin = words(1);
    if (name == "SET_G92_OFFSET") frame_.g92 = words(0);
    if (name == "SET_XY_ROTATION") frame_.rotation_deg = numbers_.at(0);
    if (name == "USE_TOOL_LENGTH_OFFSET") frame_.tool = words(0);
    position_ = frame_.from_machine(machine);
  }

  void add(Motion motion) {
    motion.machine = frame_.to_machine(motion.to);
    motion.feed = motion.kind == MotionKind::rapid ? 0 : feed_;
    position_ = motion.to;
    motions.push_back({motion, unit_, false, std::max(unit_, offsets_unit_)});
  }

  void straight(MotionKind kind) {
    Motion motion;
    motion.kind = kind;
    motion.from = position_;
    motion.to = words(0);
    add(motion);
  }

  // RIGID_TAP(x, y, z), and back to where it began
  void rigid_tap() {
    Motion motion;
    motion.kind = MotionKind::feed;
    const AxisWords start = position_;
    motion.to = start;
    for (std::size_t i = 0; i < 3; ++i) motion.to.values[i] = numbers_.at(i) * unit_;
    add(motion);
    motion.to = start;
    add(motion);
  }

  // ARC_FEED(first end, second end, first centre, second centre, turns, axis end, a, b, c)
  void arc() {
    const PlaneAxes axes = axes_of(plane_);
    Motion motion;
    motion.kind = MotionKind::arc;
    motion.from = position_;
    motion.to[axes.first] = numbers_.at(0) * unit_;
    motion.to[axes.second] = numbers_.at(1) * unit_;
    motion.to[axes.third] = numbers_.at(5) * unit_;
    for (std::size_t i = 0; i < 3; ++i) motion.to.values[3 + i] = numbers_.at(6 + i);
    motion.arc.plane = plane_;
    motion.arc.centre_mm[index(axes.first)] = numbers_.at(2) * unit_;
    motion.arc.centre_mm[index(axes.second)] = numbers_.at(3) * unit_;
    motion.arc.centre_mm[index(axes.third)] = position_[axes.third];
    motion.arc.turns = static_cast<int>(numbers_.at(4));
    add(motion);
  }

  std::vector<double> numbers_;
  double unit_ = 1;
  double offsets_unit_ = 1;
  double feed_ = 0;
  Plane plane_ = Plane::xy;
  Frame frame_;
  AxisWords position_;
};

std::string text_of(const Motion& motion) {
  return fmt::format("line {} kind {} to {:.4f} machine {:.4f} centre {:.4f} turns {} feed {:.4f} dwell {:.4f}",
                     motion.line, static_cast<int>(motion.kind), fmt::join(motion.to.values, " "),
                     fmt::join(motion.machine.values, " "), fmt::join(motion.arc.centre_mm, " "), motion.arc.turns,
                     motion.feed, motion.dwell_s);
}

bool near(const AxisWords& a, const AxisWords& b, double mm, double deg) {
  for (const Axis axis : kAllAxes) {
    if (std::abs(a[axis] - b[axis]) > (is_rotary(axis) ? deg : mm)) return false;
  }
  return true;
}

bool same_arc(const Arc& a, const Arc& b, double mm) {
  if (a.plane != b.plane || a.turns != b.turns) return false;
  const PlaneAxes axes = axes_of(a.plane);  // along the normal it is where the arc begins
  return std::abs(a.centre_mm[index(axes.first)] - b.centre_mm[index(axes.first)]) <= mm &&
         std::abs(a.centre_mm[index(axes.second)] - b.centre_mm[index(axes.second)]) <= mm;
}

bool goes_nowhere(const Motion& motion, double mm) {
  return motion.kind == MotionKind::rapid && near(motion.from, motion.to, mm, mm);
}

bool same(const Motion& ours, const CanonMotion& theirs, double tolerance) {
  const Motion& other = theirs.motion;
  if (ours.kind != other.kind) return false;
  if (ours.kind == MotionKind::dwell) return std::abs(ours.dwell_s - other.dwell_s) <= tolerance;
  const double mm = tolerance * theirs.unit_mm;
  if (!near(ours.to, other.to, mm, tolerance)) return false;
  const double machine_mm = 3 * tolerance * std::max(theirs.unit_mm, theirs.offsets_unit_mm);
  if (!near(ours.machine, other.machine, machine_mm, 3 * tolerance)) return false;  // a sum of four rounded numbers
  if (ours.kind == MotionKind::arc && !same_arc(ours.arc, other.arc, mm)) return false;
  const bool linear = (ours.to[Axis::X] != ours.from[Axis::X] || ours.to[Axis::Y] != ours.from[Axis::Y] ||
                       ours.to[Axis::Z] != ours.from[Axis::Z]);
  const bool compares = ours.kind != MotionKind::rapid && ours.feed_mode == FeedMode::per_minute && linear;
  return !compares || std::abs(ours.feed - other.feed) <= 26 * tolerance;  // F may be of another unit than the move
}

}  // namespace

std::vector<CanonMotion> read_canon(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  CanonReader reader;
  // No blank stands after a line number of five digits or more.
  const std::regex call(R"(^\s*\d+\s+N[0-9.]*\s*([A-Z][A-Z_0-9]*)(\(.*\))\s*$)");
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (std::regex_match(line, match, call)) reader.call(match[1], match[2]);
  }
  return reader.motions;
}

std::string first_difference(const std::vector<Motion>& ours, const std::vector<CanonMotion>& theirs,
                             double tolerance) {
  std::size_t i = 0;
  for (std::size_t j = 0; j < theirs.size(); ++j, ++i) {
    if (theirs[j].spline) {  // all pieces of one
      while (i < ours.size() && ours[i].goes_on) ++i;
      continue;
    }
    // Up to the level R, where the tool stands to the last bit or one bit below it: one of both moves there
    const double nowhere = tolerance * theirs[j].unit_mm;
    if (i < ours.size() && same(ours[i], theirs[j], tolerance)) continue;
    if (i + 1 < ours.size() && goes_nowhere(ours[i], nowhere) && same(ours[i + 1], theirs[j], tolerance)) {
      ++i;
      continue;
    }
    if (goes_nowhere(theirs[j].motion, nowhere)) {
      --i;
      continue;
    }
    if (i >= ours.size()) return fmt::format("{} motions, theirs {} and more", ours.size(), j);
    return fmt::format("motion {}:\nours   {}\ntheirs {}", i + 1, text_of(ours[i]), text_of(theirs[j].motion));
  }
  if (ours.size() == i) return "";
  return fmt::format("{} motions, theirs end at {}", ours.size(), i);
}

}  // namespace plumbline::nc::tests

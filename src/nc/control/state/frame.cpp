#include "nc/control/state/frame.hpp"

#include <cmath>

#include "base/units.hpp"

namespace plumbline::nc {

AxisWords turned_about_z(AxisWords words, double degrees) {
  if (degrees == 0) return words;
  const double c = std::cos(degrees * kDeg);
  const double s = std::sin(degrees * kDeg);
  const double x = words[Axis::X];
  const double y = words[Axis::Y];
  words[Axis::X] = c * x - s * y;
  words[Axis::Y] = s * x + c * y;
  return words;
}

AxisWords Frame::turned_forth(const AxisWords& words) const {
  return tilted ? nc::turned(plane, words) : turned_about_z(words, rotation_deg);
}

AxisWords Frame::turned_home(const AxisWords& words) const {
  return tilted ? nc::turned_back(plane, words) : turned_about_z(words, -rotation_deg);
}

AxisSet Frame::mixed() const {
  if (tilted) return AxisSet::linear();
  return rotation_deg != 0 ? kTurningAxes : AxisSet{};
}

AxisWords Frame::from_machine(const AxisWords& machine) const {
  return from_pose(machine - (tilted ? turned(tool) : tool));
}

Frame Frame::without_rotary_tool() const {
  Frame frame = *this;
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) frame.tool[axis] = 0;
  return frame;
}

}  // namespace plumbline::nc

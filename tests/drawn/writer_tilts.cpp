// Directions of the tool, and moves on a tilted plane.
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "drawn/writer.hpp"

namespace plumbline::drawn {

void Writer::draw_rules(int feed_rule_percent) {
  nc::ProgramSettings& program = program_.options.program;
  if (draws_.chance(feed_rule_percent))
    program.feed_rule = draws_.chance(50) ? nc::FeedRule::xyz_first : nc::FeedRule::all_axes_as_mm;
  program.free_rotation = draws_.chance(70) ? nc::FreeRotation::c_stays : nc::FreeRotation::c_zero;
}

bool Writer::may_tilt() const {
  const bool in_box = origin_[Axis::A] == 0 && origin_[Axis::B] == 0 && origin_[Axis::C] == 0 &&
                      shift_ == AxisWords{} && turned_deg_ == 0;
  return uses_rotary_ && known_ && !incremental_ && in_box && plane_ == nc::Plane::xy &&
         program_.options.program.rotary[2] == nc::RotaryRule::linear;
}

// d = Rz(C) Ry(B) Rx(A) (0 0 1) = Rz(C) (sin B cos A, -sin A, cos B cos A)
std::array<std::string, 3> Writer::direction() {
  const double c = program_.options.program.free_rotation == nc::FreeRotation::c_zero ? 0 : at_[Axis::C];
  const auto near = [&](Axis axis) {
    const double at = at_[axis] + draws_.between(-1.4, 1.4);
    return at * kDeg;
  };
  const double a = near(Axis::A);
  const double b = near(Axis::B);
  const double x = std::sin(b) * std::cos(a);
  const double y = -std::sin(a);
  const double length = draws_.chance(70) ? 1 : draws_.between(0.5, 9);
  const std::array<double, 3> d{(std::cos(c * kDeg) * x - std::sin(c * kDeg) * y) * length,
                                (std::sin(c * kDeg) * x + std::cos(c * kDeg) * y) * length,
                                std::cos(b) * std::cos(a) * length};
  std::array<std::string, 3> text;
  std::array<double, 3> v{};
  for (std::size_t i = 0; i < 3; ++i) {
    text[i] = fmt::format("{:.{}f}", d[i], draws_.whole(5, 8));
    v[i] = std::stod(text[i]);
  }
  const double size = std::hypot(v[0], v[1], v[2]);
  const double to_x = (std::cos(c * kDeg) * v[0] + std::sin(c * kDeg) * v[1]) / size;
  const double to_y = (-std::sin(c * kDeg) * v[0] + std::cos(c * kDeg) * v[1]) / size;
  at_[Axis::A] = -std::asin(to_y) / kDeg;
  at_[Axis::B] = std::atan2(to_x, v[2] / size) / kDeg;
  at_[Axis::C] = c;
  return text;
}

void Writer::moves_on_plane() {
  const auto word = [&](char letter, double most) { return letter + length(draws_.between(-most, most)).text; };
  put({code('G', 0), word('X', 15), word('Y', 15), word('Z', 15)});
  motion_ = 0;
  for (int left = draws_.whole(1, 4); left > 0; --left) {
    Words words;
    if (draws_.chance(70)) {
      words.push_back(motion_code(draws_.chance(80) ? 1 : 0));
      if (draws_.chance(60)) words.push_back(word('X', 15));
      words.push_back(word('Y', 15));
      if (draws_.chance(40)) words.push_back(word('Z', 15));
    } else {
      words = {motion_code(draws_.chance(50) ? 2 : 3), "I" + length(draws_.between(1, 6)).text, word('J', 5)};
    }
    if (motion_ != 0) feed_word(words);
    put(words);
  }
  motion_ = -1;
}

}  // namespace plumbline::drawn

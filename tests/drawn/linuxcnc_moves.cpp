// Moves that LinuxCNC alone knows.
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "drawn/linuxcnc.hpp"

namespace plumbline::drawn {

void LinuxCnc::spline() {
  if (plane_ != nc::Plane::xy || feeds_ != Feeds::per_minute) return;
  const auto at = [&](double reach) { return length(draws_.between(-reach, reach)).text; };
  Words words{draws_.chance(50) ? "G5" : "G5.1"};
  const bool cubic = words.front() == "G5";
  motion_ = -1;
  words.push_back(axis_word(Axis::X));
  words.push_back(axis_word(Axis::Y));
  words.push_back("I" + at(5));
  words.push_back("J" + at(5));
  if (cubic) {
    words.push_back("P" + at(5));
    words.push_back("Q" + at(5));
  }
  feed_word(words);
  put(words);
  go_to_known_place();
}

// G5.2, its points, G5.3: the curve is moved along at the end.
void LinuxCnc::nurbs() {
  if (plane_ != nc::Plane::xy || feeds_ != Feeds::per_minute || incremental_) return;
  const auto point = [&] {
    return Words{axis_word(Axis::X), axis_word(Axis::Y), fmt::format("P{}", draws_.whole(1, 3))};
  };
  known_ = false;
  Words first{"G5.2"};
  for (std::string& word : point()) first.push_back(std::move(word));
  first.emplace_back("L3");
  feed_word(first);
  put(first);
  for (int more = draws_.whole(2, 4); more > 0; --more) put(point());
  put({"G5.3"});
  motion_ = -1;
  go_to_known_place();
}

// By distance and angle about the zero of the work system.
void LinuxCnc::polar() {
  if (plane_ != nc::Plane::xy || incremental_) return;
  const bool feeds = draws_.chance(70);
  Words words{motion_code(feeds ? 1 : 0)};
  const Spelled distance = length(draws_.between(0.5, 30));
  const Spelled angle = spell(draws_.between(-180, 180), 3, 9);
  words.push_back("@" + distance.text);
  words.push_back("^" + angle.text);
  if (draws_.chance(30)) words.push_back(axis_word(Axis::Z));
  at_[Axis::X] = distance.value * std::cos(angle.value * kDeg);
  at_[Axis::Y] = distance.value * std::sin(angle.value * kDeg);
  if (feeds) feed_word(words);
  put(words);
}

// Nobody gave where that is.
void LinuxCnc::go_home() {
  const bool all = uses_rotary_ && draws_.chance(50);
  Words words{draws_.chance(60) ? "G28" : "G30"};
  if (!all) words.push_back(axis_word(Axis::Z));
  known_ = false;
  put(words);
  motion_ = -1;
  go_to_known_place();
}

void LinuxCnc::length_by_words() {
  offsets_anew_ = true;
  const Spelled z = length(draws_.between(-20, 20));
  at_[Axis::Z] -= z.value - length_;
  length_ = z.value;
  put({"G43.1", "Z" + z.text});
  go_to_known_place();
}

}  // namespace plumbline::drawn

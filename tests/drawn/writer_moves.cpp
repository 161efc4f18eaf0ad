// The modes and the moves that generators share.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "drawn/writer.hpp"

namespace plumbline::drawn {

std::string Writer::increment_word(Axis axis, double by) { return fmt::format(" {}{:.3f}", letter(axis), by); }

std::array<std::string, 2> Writer::words_there_and_back() {
  std::array<std::string, 2> words;
  for (const Axis axis : kAllAxes) {
    if ((is_rotary(axis) && !uses_rotary_) || !draws_.chance(is_rotary(axis) ? 25 : 50)) continue;
    const double by = draws_.between(-3, 3) / (is_rotary(axis) ? 1 : unit());
    words[0] += increment_word(axis, by);
    words[1] += increment_word(axis, -by);
  }
  if (words[0].empty()) words = {increment_word(Axis::X, 0.3), increment_word(Axis::X, -0.3)};
  return words;
}

std::string Writer::there_and_back() {
  const auto [there, back] = words_there_and_back();
  return fmt::format("G91 G1{}\nG1{}\n{}", there, back, incremental_ ? "G91" : "G90");
}

void Writer::change_distance() {
  incremental_ = !incremental_;
  put({incremental_ ? "G91" : "G90"});
}

void Writer::change_unit(std::string_view inches, std::string_view millimetres) {
  inches_ = !inches_;
  feed_stated_ = false;
  put({std::string(inches_ ? inches : millimetres)});
}

void Writer::change_feed_mode() {
  const int next = draws_.whole(0, 2);
  feeds_ = static_cast<Feeds>(next);
  feed_stated_ = false;
  if (feeds_ == Feeds::per_revolution) put({"S1000", "M3"});
  put({next == 0 ? "G93" : next == 1 ? "G94" : "G95"});
}

void Writer::change_plane() {
  static constexpr std::array<std::string_view, 3> kPlanes{"G17", "G18", "G19"};
  const int plane = draws_.whole(0, 2);
  plane_ = static_cast<nc::Plane>(plane);
  put({std::string(kPlanes[static_cast<std::size_t>(plane)])});
}

void Writer::go_to_known_place() {
  Words words;
  if (incremental_) words.emplace_back("G90");
  incremental_ = false;
  words.push_back(code('G', 0));
  motion_ = 0;
  goes_to_known_place_ = true;
  for (std::string& word : axes(used_axes())) words.push_back(std::move(word));
  goes_to_known_place_ = false;
  known_ = true;
  put(words);
}

std::string Writer::feed_text(double mm_min) { return "F" + spell(mm_min / unit(), 1, 9).text; }

void Writer::feed_word(Words& words) {
  if (feeds_ == Feeds::inverse_time) {
    words.push_back("F" + spell(draws_.between(2, 300), 2, 9).text);
    return;
  }
  if (feed_stated_ && draws_.chance(65)) return;
  feed_stated_ = true;
  if (feeds_ == Feeds::per_revolution) {
    words.push_back("F" + spell(draws_.between(0.05, 0.9) / unit(), inches_ ? 4 : 2, 9).text);
    return;
  }
  words.push_back(feed_text(draws_.between(100, 3000)));
}

void Writer::mixed_in(Words& words) {
  if (draws_.chance(6)) words.push_back(switch_word());
  if (draws_.chance(8)) draws_.shuffle(words);
}

Writer::Words Writer::line(bool feeds) {
  const AxisSet which = draws_.chance(15) && uses_rotary_ ? some(0, 40) : some(45, 20);
  Words words;
  words.push_back(motion_code(feeds ? 1 : 0));
  for (std::string& word : axes(which)) words.push_back(std::move(word));
  if (feeds) feed_word(words);
  mixed_in(words);
  return words;
}

Writer::Words Writer::move() { return draws_.chance(70) ? line(draws_.chance(80)) : arc(); }

void Writer::skippable() {
  const std::optional<bool> left_out = program_.options.program.block_delete;
  if (!left_out) return;
  const AxisWords at = at_;
  const nc::Plane plane = plane_;
  const int motion = motion_;
  const bool feed_stated = feed_stated_;
  const bool spindle = spindle_;
  put(move());
  blocks_.back().text.insert(0, "/");
  if (!*left_out) return;
  at_ = at;
  plane_ = plane;
  motion_ = motion;
  feed_stated_ = feed_stated;
  spindle_ = spindle;
  if (known_) blocks_.back().ends = at_;
}

// A circle, part of one, a helix; its centre by I J K or its radius.
Writer::Words Writer::arc() {
  static constexpr std::array<std::string_view, 3> kCodes{"G17", "G18", "G19"};
  static constexpr std::array<std::array<char, 2>, 3> kCentres{{{'I', 'J'}, {'K', 'I'}, {'J', 'K'}}};
  const auto plane = static_cast<nc::Plane>(draws_.chance(50) ? static_cast<int>(plane_) : draws_.whole(0, 2));
  const nc::PlaneAxes axes = nc::axes_of(plane);
  const auto& letters = kCentres[static_cast<std::size_t>(plane)];
  Words words;
  if (plane != plane_ || draws_.chance(20)) words.emplace_back(kCodes[static_cast<std::size_t>(plane)]);
  plane_ = plane;
  const bool clockwise = draws_.chance(50);
  words.push_back(motion_code(clockwise ? 2 : 3));

  const double r = draws_.between(0.8, 12);
  const double begin = draws_.between(0, 360);
  const bool full = draws_.chance(20);
  const bool by_radius = !full && draws_.chance(30);
  const double sweep = full        ? 360
                       : by_radius ? draws_.between(15, draws_.chance(70) ? 150 : 300)
                                   : draws_.between(3, 357);
  const double first = at_[axes.first];
  const double second = at_[axes.second];
  // Towards the middle of the box, so that it does not wander off
  Spelled i = length(-r * std::cos(begin * kDeg));
  Spelled j = length(-r * std::sin(begin * kDeg));
  Spelled centre_first;
  Spelled centre_second;
  if (centre_absolute_) {
    centre_first = length(first + i.value);
    centre_second = length(second + j.value);
    i.value = centre_first.value - first;
    j.value = centre_second.value - second;
  }
  const double end = std::atan2(-j.value, -i.value) / kDeg + (clockwise ? -sweep : sweep);
  const double radius = std::hypot(i.value, j.value);
  if (!full) {
    const double to_first = first + i.value + radius * std::cos(end * kDeg);
    const double to_second = second + j.value + radius * std::sin(end * kDeg);
    words.push_back(axis_word_to(axes.first, to_first));
    words.push_back(axis_word_to(axes.second, to_second));
  }
  if (by_radius) {
    const bool far = std::abs(sweep) > 180;
    const double chord = std::hypot(at_[axes.first] - first, at_[axes.second] - second);
    const double r_word = std::max(radius, chord / 2 + 0.02);
    words.push_back(radius_word(length(far ? -r_word : r_word).text));
  } else {
    if (centre_absolute_) {
      words.push_back(letters[0] + centre_first.text);
      words.push_back(letters[1] + centre_second.text);
    } else {
      if (i.value != 0 || draws_.chance(50)) words.push_back(letters[0] + i.text);
      if (j.value != 0 || i.value == 0 || draws_.chance(50)) words.push_back(letters[1] + j.text);
    }
  }
  if (draws_.chance(30)) words.push_back(axis_word(axes.third));
  if (uses_rotary_ && draws_.chance(15)) words.push_back(axis_word(Axis::B));
  if (has_turns() && draws_.chance(15)) words.push_back(turns_word(draws_.whole(1, 3)));
  feed_word(words);
  mixed_in(words);
  return words;
}

}  // namespace plumbline::drawn

#include "drawn/writer.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "base/units.hpp"

namespace plumbline::drawn {
namespace {

// What a control keeps of a number: further decimals are cut off.
double value_of(std::string text, int cut) {
  const std::size_t point = text.find('.');
  if (point != std::string::npos && text.size() > point + 1 + static_cast<std::size_t>(cut))
    text.resize(point + 1 + static_cast<std::size_t>(cut));
  return std::strtod(text.c_str(), nullptr);
}

AxisWords turned(AxisWords words, double deg) {
  if (deg == 0) return words;
  const double c = std::cos(deg * kDeg);
  const double s = std::sin(deg * kDeg);
  const double x = words[Axis::X];
  const double y = words[Axis::Y];
  words[Axis::X] = c * x - s * y;
  words[Axis::Y] = s * x + c * y;
  return words;
}

}  // namespace

Writer::Writer(std::string_view dialect, std::uint64_t seed, const Scene& scene, const Manners& manners)
    : draws_(seed), manners_(manners) {
  program_.dialect = dialect;
  program_.seed = seed;
  program_.options.dialect = dialect;
  program_.options.model = scene.model;
  program_.options.tools = scene.tools;
  program_.start = kBox;
  spacing_ = draws_.chance(70) ? 0 : draws_.whole(1, 2);
  case_ = manners_.lower_case && draws_.chance(20) ? draws_.whole(1, 2) : 0;
  numbering_ = draws_.chance(40) ? draws_.whole(1, 3) : 0;
  zeros_in_codes_ = draws_.chance(25);
  expressions_percent_ = draws_.chance(30) ? 10 : 0;
  uses_rotary_ = !draws_.chance(12);
  if (draws_.chance(6)) {  // beyond the limits here and there
    reach_mm_ = 290;
    reach_deg_ = 20;
  }
}

DrawnProgram Writer::write() {
  head();
  for (int left = draws_.whole(3, 14); left > 0; --left) piece();
  known_ = false;
  tail();
  program_.blocks = std::move(blocks_);
  return std::move(program_);
}

std::string Writer::comment() {
  static constexpr std::array kTexts{"a note", "T1 D=16", "X1 Y2", "roughing 50%", "", "G0 G1 [#1]"};
  return std::string(manners_.comment_open) + draws_.pick(kTexts) + std::string(manners_.comment_close);
}

// "5", "5.", ".5", "+5.0", "-05.50": whatever a control takes for the number.
Spelled Writer::spell(double value, int most_decimals, int cut, int increments) {
  if (increments > 0 && draws_.chance(6)) {
    const double count = std::round(value * std::pow(10.0, increments));
    return {fmt::format("{:.0f}", count == 0 ? 0 : count), count / std::pow(10.0, increments)};
  }
  const int decimals = draws_.chance(10)                                 ? draws_.whole(0, most_decimals)
                       : draws_.chance(4) && (manners_.finer || cut > 6) ? 6
                                                                         : most_decimals;
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (decimals == 0 && (increments > 0 || draws_.chance(60))) text += ".";
  if (text.find('.') != std::string::npos && draws_.chance(60)) {
    while (text.back() == '0') text.pop_back();
  }
  if (increments == 0 && text.back() == '.' && draws_.chance(50)) text.pop_back();
  const bool negative = text.front() == '-';
  if (negative) text.erase(0, 1);
  if (text.size() > 2 && text.starts_with("0.") && draws_.chance(30)) text.erase(0, 1);
  if (draws_.chance(3)) text.insert(0, "0");
  if (negative) {
    text.insert(0, "-");
  } else if (manners_.plus && draws_.chance(3)) {
    text.insert(0, "+");
  }
  return {text, value_of(text, cut)};
}

Spelled Writer::length(double mm) {
  Spelled number = inches_ ? spell(mm / unit(), manners_.decimals_inch, manners_.cut_inch, manners_.increments_inch)
                           : spell(mm, manners_.decimals_mm, manners_.cut_mm, manners_.increments_mm);
  if (draws_.chance(expressions_percent_)) number.text = expression(number);
  number.value *= unit();
  return number;
}

Spelled Writer::angle(double deg) {
  Spelled number = spell(deg, manners_.decimals_deg, manners_.cut_deg, manners_.increments_deg);
  if (draws_.chance(expressions_percent_)) number.text = expression(number);
  return number;
}

std::string Writer::expression(Spelled& number) { return number.text; }

std::string Writer::code(char letter, int number) {
  return fmt::format("{}{:0{}}", letter, number, zeros_in_codes_ ? 2 : 1);
}

std::string Writer::motion_code(int number) {
  const bool said = motion_ == number && draws_.chance(60);
  motion_ = number;
  return said ? "" : code('G', number);
}

// Words with blanks between them, or as a pen that saves them writes.
std::string Writer::joined(Words words) {
  std::erase(words, "");
  std::string text;
  for (std::string& word : words) {
    if (case_ == 1 || (case_ == 2 && draws_.chance(50))) {
      if (word.front() != '(' && word.front() != ';')
        std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
    }
    if (spacing_ == 2 && manners_.spaces_inside && word.size() > 1 && draws_.chance(10) && word.front() != '(' &&
        word.front() != ';' && word.find('<') == std::string::npos)
      word.insert(1, " ");
    const bool may_touch = !text.empty() && std::isalnum(static_cast<unsigned char>(text.back())) != 0 &&
                           std::isdigit(static_cast<unsigned char>(text.back())) != 0 &&
                           std::isalpha(static_cast<unsigned char>(word.front())) != 0 &&
                           word.find('=') == std::string::npos;
    if (text.empty() || (spacing_ == 1 && may_touch)) {
      text += word;
    } else {
      text += spacing_ == 2 ? std::string(static_cast<std::size_t>(draws_.whole(1, 3)), ' ') : std::string(" ");
      text += word;
    }
  }
  return text;
}

void Writer::put(const Words& words) {
  Words all;
  std::string before;
  const bool numbered = numbering_ == 1 || (numbering_ == 2 && draws_.chance(40)) || (numbering_ == 3);
  if (numbered) {
    number_ += numbering_ == 3 ? 10 : draws_.whole(1, 7);
    all.push_back(fmt::format("N{}", number_));
  }
  all.insert(all.end(), words.begin(), words.end());
  if (draws_.chance(4)) {
    const std::size_t at = manners_.comment_inside && draws_.chance(40)
                               ? static_cast<std::size_t>(draws_.whole(numbered ? 1 : 0, static_cast<int>(all.size())))
                               : all.size();
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(at), comment());
  }
  blocks_.push_back({joined(std::move(all)), std::nullopt});
  if (known_) blocks_.back().ends = at_;
}

void Writer::put_as_it_is(std::string text) {
  blocks_.push_back({std::move(text), std::nullopt});
  if (known_) blocks_.back().ends = at_;
}

AxisWords Writer::to_box(const AxisWords& work) const { return turned(work + shift_, turned_deg_) + origin_; }

AxisWords Writer::to_work(const AxisWords& box) const { return turned(box - origin_, -turned_deg_) - shift_; }

double Writer::target(Axis axis) {
  AxisWords box;
  for (const Axis each : kAllAxes) {
    const double reach = is_rotary(each) ? reach_deg_ : reach_mm_;
    box[each] = draws_.between(-reach, reach);
  }
  return to_work(box)[axis];
}

std::string Writer::axis_word(Axis axis) { return axis_word_to(axis, target(axis)); }

std::string Writer::axis_word_to(Axis axis, double work) {
  if (axis == Axis::C && !incremental_ && program_.options.rotary[2] != nc::RotaryRule::linear)
    return endless_word(axis, work);
  const double by = incremental_ ? work - at_[axis] : work;
  const Spelled number = is_rotary(axis) ? angle(by) : length(by);
  at_[axis] = incremental_ ? at_[axis] + number.value : number.value;
  return letter(axis) + number.text;
}

// C is an axis whose words count within a turn. Where it stands at first is known then.
void Writer::turn_endlessly() {
  if (!uses_rotary_) return;
  program_.options.rotary[2] = draws_.chance(50) ? nc::RotaryRule::shortest : nc::RotaryRule::sign;
  if (!program_.options.start[index(Axis::C)]) program_.options.start[index(Axis::C)] = 0;
}

// Some turn of it for the shorter way; under the rule of signs the sign says which way round.
std::string Writer::endless_word(Axis axis, double work) {
  constexpr double kTurn = 360;
  const bool by_sign = program_.options.rotary[2] == nc::RotaryRule::sign;
  double place = std::fmod(work, kTurn);
  if (place < 0) place += kTurn;
  if (!by_sign && draws_.chance(40)) place += draws_.chance(50) ? kTurn : -kTurn;
  place = std::max(place, by_sign ? 0.01 : -kTurn);
  const bool down = by_sign && work < at_[axis];
  const Spelled number = spell(down ? -place : place, 3, manners_.cut_deg, manners_.increments_deg);
  double way = std::fmod(std::abs(number.value) - at_[axis], kTurn);
  if (!by_sign) way = std::fmod(number.value - at_[axis], kTurn);
  if (way < 0) way += kTurn;
  if (by_sign ? down && way > 0 : way > kTurn / 2) way -= kTurn;
  at_[axis] += way;
  return letter(axis) + number.text;
}

Writer::Words Writer::axes(AxisSet which) {
  Words words;
  for (const Axis axis : kAllAxes) {
    if (which.contains(axis)) words.push_back(axis_word(axis));
  }
  return words;
}

AxisSet Writer::some(int linear_percent, int rotary_percent) {
  AxisSet which;
  while (which.empty()) {
    for (const Axis axis : kAllAxes) {
      if (is_rotary(axis) && !uses_rotary_) continue;
      if (draws_.chance(is_rotary(axis) ? rotary_percent : linear_percent)) which.insert(axis);
    }
  }
  return which;
}

void Writer::draw_work_offsets(std::span<AxisWords> systems) {
  for (std::size_t i = 0; i < systems.size(); ++i) {
    for (const Axis axis : kAllAxes)
      systems[i][axis] = i == 0 ? 0 : draws_.whole(-800, 800) / (is_rotary(axis) ? 1000.0 : 100.0);
    program_.options.work_offsets[i] = nc::WorkOffset{systems[i] + kBox, 0};
  }
}

void Writer::draw_what_stays() {
  jobs::Options& options = program_.options;
  keeps_at_tool_change_ = draws_.chance(70);
  if (keeps_at_tool_change_) options.keeps_position.insert(6);
  keeps_at_stop_ = draws_.chance(70);
  if (keeps_at_stop_) options.keeps_position.insert({0, 1});
  if (draws_.chance(25)) options.block_delete = draws_.chance(50);
}

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

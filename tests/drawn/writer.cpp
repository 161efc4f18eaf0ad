#include "drawn/writer.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "base/units.hpp"
#include "settings/options.hpp"

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
  program_.options.paths.model = scene.model;
  program_.options.paths.tools = scene.tools;
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

std::string Writer::code(char letter, int number) const {
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
  if (axis == Axis::C && !incremental_ && program_.options.program.rotary[2] != nc::RotaryRule::linear)
    return endless_word(axis, work);
  const double by = incremental_ ? work - at_[axis] : work;
  const Spelled number = is_rotary(axis) ? angle(by) : length(by);
  at_[axis] = incremental_ ? at_[axis] + number.value : number.value;
  return letter(axis) + number.text;
}

// C is an axis whose words count within a turn. Where it stands is always known then: else any turn is as good.
void Writer::turn_endlessly() {
  if (!uses_rotary_ || !keeps_at_stop_ || !keeps_at_tool_change_) return;
  program_.options.program.rotary[2] = draws_.chance(50) ? nc::RotaryRule::shortest : nc::RotaryRule::sign;
  if (!program_.options.program.start[index(Axis::C)]) program_.options.program.start[index(Axis::C)] = 0;
}

// Some turn of it for the shorter way; under the rule of signs the sign says which way round.
std::string Writer::endless_word(Axis axis, double work) {
  constexpr double kTurn = 360;
  const bool by_sign = program_.options.program.rotary[2] == nc::RotaryRule::sign;
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
    program_.options.program.work_offsets[i] = nc::WorkOffset{systems[i] + kBox, 0};
  }
}

void Writer::draw_what_stays() {
  settings::Options& options = program_.options;
  keeps_at_tool_change_ = draws_.chance(70);
  if (keeps_at_tool_change_) options.program.keeps_position.insert(6);
  keeps_at_stop_ = draws_.chance(70);
  if (keeps_at_stop_) options.program.keeps_position.insert({0, 1});
  if (draws_.chance(25)) options.program.block_delete = draws_.chance(50);
}

}  // namespace plumbline::drawn

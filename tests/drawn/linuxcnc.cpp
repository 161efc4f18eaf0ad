#include "drawn/linuxcnc.hpp"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "drawn/dialects.hpp"
#include "settings/options.hpp"

namespace plumbline::drawn {
namespace {

Manners linuxcnc_manners() {
  Manners manners;
  manners.spaces_inside = true;
  return manners;
}

}  // namespace

LinuxCnc::LinuxCnc(std::uint64_t seed, const Scene& scene) : Writer("linuxcnc", seed, scene, linuxcnc_manners()) {
  settings::Options& options = program_.options;
  for (std::size_t i = 0; i < systems_.size(); ++i) {
    for (const Axis axis : kAllAxes)
      systems_[i].origin[axis] = i == 0 ? 0 : draws_.whole(-800, 800) / (is_rotary(axis) ? 1000.0 : 100.0);
    if (i > 0 && draws_.chance(20)) systems_[i].turned_deg = draws_.whole(-90, 90);
    if (i == 0 || draws_.chance(95))
      options.program.work_offsets[i] = nc::WorkOffset{systems_[i].origin + kBox, systems_[i].turned_deg};
  }
  keeps_at_tool_change_ = draws_.chance(70);
  keeps_at_stop_ = draws_.chance(70);
  if (keeps_at_tool_change_) options.program.keeps_position.insert(6);
  if (keeps_at_stop_) options.program.keeps_position.insert({0, 1, 60});
  if (draws_.chance(40)) {
    for (const Axis axis : kAllAxes) {
      const double at = draws_.whole(-20, 20) / (is_rotary(axis) ? 5.0 : 1.0);
      options.program.start[index(axis)] = at;
      program_.start[axis] += at;
      at_[axis] = at;
    }
    known_ = true;
  }
  if (draws_.chance(25)) options.program.block_delete = draws_.chance(50);
  if (draws_.chance(8)) turn_endlessly();
}

std::string LinuxCnc::comment() {
  if (draws_.chance(8)) return "(MSG, hello)";
  if (draws_.chance(4)) return "(DEBUG, #<_x> is x)";
  return Writer::comment();
}

std::string LinuxCnc::switch_word() {
  static constexpr std::array<std::string_view, 11> kWords{"M8",  "M7",  "M9",  "G64", "G61", "G61.1",
                                                           "M48", "M49", "G40", "M5",  "M3"};
  std::string word(draws_.pick(kWords));
  if (word == "M3" || word == "M5") {
    if (feeds_ == Feeds::per_revolution) return "";
    spindle_ = word == "M3";
    return spindle_ ? fmt::format("{} S{}", word, draws_.whole(1, 40) * 100) : word;
  }
  return word;
}

Spelled LinuxCnc::parameter() {
  if (!parameters_.empty() && draws_.chance(70)) {
    const auto& [name, value] = draws_.pick_of(parameters_);
    return {name, value};
  }
  Spelled number = spell(draws_.between(-9, 9), 3, 9);
  return number;
}

std::string LinuxCnc::expression(Spelled& number) {
  const Spelled part = parameter();
  const Spelled rest = spell(number.value - part.value, 4, 9);
  number.value = part.value + rest.value;
  if (draws_.chance(50)) return fmt::format("[{} + {}]", part.text, rest.text);
  return fmt::format("[{}-[0-{}]]", part.text, rest.text);
}

std::string LinuxCnc::label() {
  ++labels_;
  if (draws_.chance(50)) return fmt::format("o{}", (program_.seed % 9000) * 10 + static_cast<std::uint64_t>(labels_));
  return fmt::format("o<p{}_{}>", program_.seed, labels_);
}

void LinuxCnc::head() {
  if (draws_.chance(30)) put_as_it_is(comment());
  inches_ = draws_.chance(30);
  put({"G17", "G90", "G94", inches_ ? "G20" : "G21", draws_.chance(50) ? "G64" : "", draws_.chance(30) ? "G40" : ""});
  if (!known_ || draws_.chance(80)) go_to_known_place();
}

void LinuxCnc::tail() {
  if (draws_.chance(20)) put({"M9"});
  put_as_it_is(draws_.chance(50) ? "M2" : "M30");
  for (const std::string& program : programs_) put_as_it_is(program);
}

void LinuxCnc::piece() {
  const int kind = draws_.whole(0, 99);
  if (kind < 2) return skippable();
  if (kind < 4) return polar();
  if (kind < 38) return put(line(true));
  if (kind < 46) return put(line(false));
  if (kind < 60) return put(arc());
  if (kind < 68) return change_mode();
  if (kind < 75) return change_offset();
  if (kind < 78) return change_tool();
  if (kind < 81) return draws_.chance(30) ? length_by_words() : tool_length();
  if (kind < 84) return dwell();
  if (kind < 89) return cycle();
  if (kind < 94) return flow();
  if (kind < 96) return draws_.chance(20) ? go_home() : draws_.chance(30) ? nurbs() : spline();
  if (kind < 97) return stop();
  if (kind < 98) {
    const Spelled value = spell(draws_.between(-9, 9), 3, 9);
    const std::string name =
        draws_.chance(50) ? fmt::format("#{}", draws_.whole(31, 200)) : fmt::format("#<len{}>", draws_.whole(1, 9));
    std::erase_if(parameters_, [&](const auto& known) { return known.first == name; });
    parameters_.emplace_back(name, value.value);
    return put({fmt::format("{}={}", name, value.text)});
  }
  put_as_it_is(draws_.chance(50) ? comment() : draws_.chance(50) ? "; " + comment() : "");
}

void LinuxCnc::change_mode() {
  switch (draws_.whole(0, 8)) {
    case 7:
      centre_absolute_ = !centre_absolute_;
      return put({centre_absolute_ ? "G90.1" : "G91.1"});
    case 8: {
      static constexpr std::array<std::string_view, 6> kOutputs{"M64 P1",    "M65 P1",      "M62 P0",
                                                                "M68 E0 Q1", "M67 E1 Q0.5", "M50 P1"};
      return put({std::string(draws_.pick(kOutputs))});
    }
    case 0:
    case 1:
      return change_distance();
    case 2: {
      if (length_ != 0) {  // the control would take it for a length in the new unit
        at_[Axis::Z] += length_;
        length_ = 0;
        offsets_anew_ = true;
        put({"G49"});
      }
      inches_ = !inches_;
      feed_stated_ = feed_stated_ && draws_.chance(30);
      return put({inches_ ? "G20" : "G21"});
    }
    case 3: {
      const int next = draws_.whole(0, 2);
      feeds_ = static_cast<Feeds>(next);
      feed_stated_ = false;
      if (feeds_ == Feeds::per_revolution && !spindle_) {
        spindle_ = true;
        return put({"G95", "S1000", "M3"});
      }
      return put({next == 0 ? "G93" : next == 1 ? "G94" : "G95"});
    }
    case 4:
      return put({draws_.chance(50) ? "G61" : draws_.chance(50) ? "G61.1" : "G64 P0.01"});
    case 5:
      return change_plane();
    default:
      return put({switch_word()});
  }
}

void LinuxCnc::dwell() {
  Words words{code('G', 4), "P" + spell(draws_.between(0, 2), 2, 9).text};
  put(words);
}

// One hole or a row of them, and away from it.
void LinuxCnc::cycle() {
  static constexpr std::array<std::string_view, 6> kCodes{"G81", "G82", "G83", "G73", "G85", "G89"};
  static constexpr std::array<std::string_view, 3> kSpindleCodes{"G84", "G86", "G74"};
  if (feeds_ == Feeds::inverse_time) return;
  bool works_spindle = draws_.chance(20);
  if (works_spindle && !spindle_) {
    spindle_ = true;
    put({"M3", "S500"});
  }
  std::string cycle(works_spindle ? draws_.pick(kSpindleCodes) : draws_.pick(kCodes));
  if (cycle == "G74") cycle = "G84";
  const nc::Plane plane = plane_;
  if (plane != nc::Plane::xy && cycle == "G84") return;
  const nc::PlaneAxes axes = nc::axes_of(plane);
  const bool to_r = draws_.chance(50);
  const double from = at_[axes.third];
  const double r = from - draws_.between(0.5, 6);
  const double bottom = r - draws_.between(1, 8);
  Words words{to_r ? "G99" : "G98", cycle};
  motion_ = -1;
  AxisWords hole = at_;
  const auto place = [&](Axis axis) {
    const double to = target(axis);
    const Spelled number = length(incremental_ ? draws_.between(-5, 5) : to);
    hole[axis] = incremental_ ? hole[axis] + number.value : number.value;
    return letter(axis) + number.text;
  };
  if (draws_.chance(80)) words.push_back(place(axes.first));
  if (draws_.chance(80) || words.size() == 2) words.push_back(place(axes.second));
  const Spelled r_word = length(incremental_ ? r - from : r);
  const double r_at = incremental_ ? from + r_word.value : r_word.value;
  const Spelled z_word = length(incremental_ ? bottom - r_at : bottom);
  words.push_back(letter(axes.third) + z_word.text);
  words.push_back("R" + r_word.text);
  if (cycle == "G82" || cycle == "G86" || cycle == "G89") words.push_back("P0.1");
  if (cycle == "G84" && draws_.chance(30)) words.push_back("P0.2");
  if (cycle == "G83" || cycle == "G73") words.push_back("Q" + spell(draws_.between(0.7, 4) / unit(), 3, 9).text);
  feed_word(words);
  int repeats = 1;
  if (draws_.chance(12)) {
    repeats = draws_.whole(1, 3);
    words.push_back(fmt::format("L{}", repeats));
  }
  if (incremental_ && repeats > 1) {
    for (const Axis axis : {axes.first, axes.second}) hole[axis] = at_[axis] + repeats * (hole[axis] - at_[axis]);
  }
  at_ = hole;
  at_[axes.third] = to_r ? r_at : std::max(from, r_at);
  put(words);
  for (int more = draws_.whole(0, 2); more > 0; --more) {
    Words next{place(draws_.chance(50) ? axes.first : axes.second)};
    at_[axes.first] = hole[axes.first];
    at_[axes.second] = hole[axes.second];
    if (draws_.chance(15)) next.push_back(switch_word());
    known_ = known_ && !incremental_;  // R counts from where it stands then: left to the interpreter
    put(next);
  }
  put({"G80"});
  known_ = true;
  const bool was = incremental_;
  if (was) put({"G90"});
  incremental_ = false;
  go_to_known_place();
}

// Moves by increments and back to where it began, as text.
std::string LinuxCnc::there_and_back() {
  std::string there;
  std::string back;
  for (const Axis axis : kAllAxes) {
    if ((is_rotary(axis) && !uses_rotary_) || !draws_.chance(is_rotary(axis) ? 25 : 50)) continue;
    const double by = draws_.between(-3, 3) / (is_rotary(axis) ? 1 : unit());
    there += fmt::format(" {}{:.3f}", letter(axis), by);
    back += fmt::format(" {}[0-[{:.3f}]]", letter(axis), by);
  }
  if (there.empty()) {
    there = fmt::format(" X{:.3f}", 2 / unit());
    back = fmt::format(" X-{:.3f}", 2 / unit());
  }
  return fmt::format("G91 G1{}\nG1{}", there, back);
}

void LinuxCnc::flow() {
  if (feeds_ != Feeds::per_minute) return;
  Words feed{"F" + spell(draws_.between(200, 900) / unit(), 1, 9).text};
  feed_stated_ = true;
  put(feed);
  const std::string o = label();
  motion_ = -1;
  const std::string_view distance = incremental_ ? "G91" : "G90";
  switch (draws_.whole(0, 6)) {
    case 6: {
      const int number = 9000 + static_cast<int>(programs_.size());
      programs_.push_back(fmt::format("O{}\n{}\n{}\nM99", number, there_and_back(), distance));
      return put_as_it_is(fmt::format("M98 P{}{}", number, draws_.chance(50) ? " L2" : ""));
    }
    case 0:
      return put_as_it_is(
          fmt::format("{0} repeat [{1}]\n{2}\n{3}\n{0} endrepeat", o, draws_.whole(0, 3), there_and_back(), distance));
    case 1:
      return put_as_it_is(
          fmt::format("#<i> = 0\n{0} while [#<i> lt {1}]\n{2} F[{3} + #<i>]\n#<i> = [#<i> + 1]\n{4}\n{0} endwhile", o,
                      draws_.whole(1, 3), there_and_back(), draws_.whole(200, 500), distance));
    case 2:
      return put_as_it_is(fmt::format(
          "{0} sub\nM73\nG91 {1}\nG1 X[#1/3] Y[-#2/7] F[#3]\nG1 X[-#1/3] Y[#2/7]\n{0} endsub\n"
          "{0} call [{2:.3f}] [{3:.3f}] [{4:.1f}]\n{0} call [2] [1] [30]",
          o, inches_ ? "G21" : "G20", draws_.between(0.1, 0.4), draws_.between(0.1, 0.4), draws_.between(20, 50)));
    case 3:
      return put_as_it_is(fmt::format(
          "#{0} = {1:.3f}\n{2} if [#{0} gt 0.5]\n{3}\n{2} elseif [#{0} lt 0.2]\nG4 P0.1\n{2} else\nM8\n{2} endif\n{4}",
          draws_.whole(201, 300), draws_.between(0, 1), o, there_and_back(), distance));
    case 4:
      return put_as_it_is(fmt::format("#<j> = 0\n{0} do\n{1}\n#<j> = [#<j> + 1]\n{2}\n{0} while [#<j> lt {3}]", o,
                                      there_and_back(), distance, draws_.whole(1, 3)));
    default:
      return put_as_it_is(fmt::format(
          "{0} sub\n{1}\n{2}\n{0} if [#1 gt 1]\n{0} return\n{0} endif\n{3}\n{2}\n{0} endsub\n{0} call [{4}]", o,
          there_and_back(), distance, there_and_back(), draws_.whole(1, 2)));
  }
}

void LinuxCnc::stop() {
  if (!keeps_at_stop_) known_ = false;
  put({draws_.chance(50) ? code('M', 0) : code('M', 1)});
  if (!known_) go_to_known_place();
}

std::unique_ptr<Writer> linuxcnc_writer(std::uint64_t seed, const Scene& scene) {
  return std::make_unique<LinuxCnc>(seed, scene);
}

}  // namespace plumbline::drawn

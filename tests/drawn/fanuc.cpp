// Programs for Fanuc's controls.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "drawn/dialects.hpp"

namespace plumbline::drawn {
namespace {

Manners fanuc_manners() {
  Manners manners;
  manners.decimals_mm = manners.decimals_deg = 3;
  manners.decimals_inch = 4;
  manners.cut_mm = manners.cut_deg = 3;
  manners.cut_inch = 4;
  manners.increments_mm = manners.increments_deg = 3;
  manners.increments_inch = 4;
  manners.lower_case = false;
  manners.semicolon_comment = false;
  return manners;
}

constexpr std::size_t kFanucSystems = 8;  // G54 to G59, G54.1 P1 and P2

class Fanuc final : public Writer {
 public:
  Fanuc(std::uint64_t seed, const Scene& scene) : Writer("fanuc", seed, scene, fanuc_manners()) {
    draw_work_offsets(systems_);
    draw_what_stays();
    draw_rules(30);
    expressions_percent_ = draws_.chance(25) ? 8 : 0;
    if (draws_.chance(8)) turn_endlessly();
  }

 private:
  void head() override {
    put_as_it_is("%");
    put_as_it_is(fmt::format("O{:04} {}", draws_.whole(1, 999), draws_.chance(50) ? "(DRAWN)" : ""));
    inches_ = draws_.chance(25);
    put({inches_ ? "G20" : "G21"});
    put({"G17", "G90", "G94", "G40", draws_.chance(50) ? "G80" : "", draws_.chance(50) ? "G54" : "G49"});
    go_to_known_place();
  }

  void tail() override {
    put_as_it_is("M30");
    for (const std::string& program : programs_) put_as_it_is(program);
    put_as_it_is("%");
  }

  std::string switch_word() override { return draws_.chance(60) ? "M8" : draws_.chance(50) ? "G61" : "G64"; }

  std::string feed_text(double mm_min) override {
    std::string text = fmt::format("{:.{}f}", mm_min / unit(), inches_ ? 2 : draws_.whole(0, 1));
    if (text.find('.') == std::string::npos && draws_.chance(60)) text += ".";
    return "F" + text;
  }

  std::string expression(Spelled& number) override {
    const double part = draws_.whole(-9000, 9000) / 1000.0;
    const double rest = std::round((number.value - part) * 1000) / 1000;
    const std::string first = fmt::format("{:.3f}", part);
    const std::string second = fmt::format("{:.3f}", rest);
    number.value = std::round((part + rest) * 1000) / 1000;
    return draws_.chance(50) ? fmt::format("[{}+{}]", first, second)
                             : fmt::format("[{}-[{}]]", second, fmt::format("{:.3f}", -part));
  }

  void piece() override {
    const int kind = draws_.whole(0, 99);
    if (kind < 2) return skippable();
    if (kind < 5 && may_tilt()) return draws_.chance(60) ? directions() : tilted_plane();
    if (kind < 40) return put(feeding(line(true)));
    if (kind < 48) return put(line(false));
    if (kind < 61) return put(feeding(arc()));
    if (kind < 68) return change_mode();
    if (kind < 74) return change_offset();
    if (kind < 78) return change_tool();
    if (kind < 81)
      return put({code('G', 4), draws_.chance(50) ? fmt::format("X{:.2f}", draws_.between(0.1, 2))
                                                  : fmt::format("P{}", draws_.whole(1, 2000))});
    if (kind < 87) return cycle();
    if (kind < 93) return flow();
    if (kind < 94) return to_machine();
    if (kind < 95) return go_home();
    if (kind < 96) {
      if (!keeps_at_stop_) known_ = false;
      put({draws_.chance(50) ? "M01" : "M0"});
      if (!known_) go_to_known_place();
      return;
    }
    if (kind < 98) return put({draws_.chance(50) ? "M9" : draws_.chance(50) ? "G5.1 Q1" : "M8"});
    put_as_it_is(draws_.chance(60) ? comment() : draws_.chance(50) ? ";" : "");
  }

  Words move() override { return feeding(Writer::move()); }

  // F of inverse time has a point: without one it counts thousandths.
  static Words feeding(Words words) {
    for (std::string& word : words) {
      if (word.front() == 'F' && word.find('.') == std::string::npos) word += ".";
    }
    return words;
  }

  void change_mode() {
    switch (draws_.whole(0, 5)) {
      case 0:
      case 1:
        return change_distance();
      case 2:
        if (length_ != 0 || turned_deg_ != 0) return;
        return change_unit("G20", "G21");
      case 3:
        return change_feed_mode();
      case 4:
        return put({draws_.chance(50) ? "G61" : "G64"});
      default:
        if (turned_deg_ == 0) change_plane();
    }
  }

  void change_offset() {
    const int kind = draws_.whole(0, 9);
    const AxisWords box = to_box(at_);
    Words words;
    if (kind < 4) {
      if (turned_deg_ != 0) return;
      const auto system = static_cast<std::size_t>(draws_.whole(0, kFanucSystems - 1));
      origin_ = systems_[system];
      words.push_back(system < 6 ? fmt::format("G{}", 54 + system) : fmt::format("G54.1 P{}", system - 5));
      at_ = to_work(box);
    } else if (kind < 6) {
      if (turned_deg_ != 0 || incremental_) return;
      words.emplace_back("G52");
      for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        if (!draws_.chance(50)) continue;
        const Spelled number = length(draws_.whole(-500, 500) / 100.0);
        shift_[axis] = number.value;
        words.push_back(letter(axis) + number.text);
      }
      if (words.size() == 1) return;
      at_ = to_work(box);
    } else if (kind < 8) {
      if (turned_deg_ != 0) {
        turned_deg_ = 0;
        origin_ = origin_before_;
        shift_ = shift_before_;
        at_ = to_work(box);
        put({"G69"});
        return go_to_known_place();
      }
      if (plane_ != nc::Plane::xy || incremental_ || inches_) return;
      const Spelled x = length(draws_.between(-20, 20));
      const Spelled y = length(draws_.between(-20, 20));
      const int deg = draws_.whole(-90, 90);
      if (deg == 0) return;
      origin_before_ = origin_;
      shift_before_ = shift_;
      origin_ += shift_;
      origin_[Axis::X] += x.value;
      origin_[Axis::Y] += y.value;
      shift_ = {};
      shift_[Axis::X] = -x.value;
      shift_[Axis::Y] = -y.value;
      turned_deg_ = deg;
      at_ = to_work(box);
      put({"G68", "X" + x.text, "Y" + y.text, fmt::format("R{}.", deg)});
      return go_to_known_place();
    } else {
      if (turned_deg_ != 0 || incremental_) return;
      words.emplace_back("G92");
      for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
        if (!draws_.chance(40)) continue;
        const Spelled number = length(at_[axis] + draws_.whole(-300, 300) / 100.0);
        shift_[axis] += at_[axis] - number.value;
        at_[axis] = number.value;
        words.push_back(letter(axis) + number.text);
      }
      if (words.size() == 1) return;
    }
    put(words);
    if (incremental_ || draws_.chance(50)) go_to_known_place();
  }

  void change_tool() {
    const int tool = draws_.whole(1, 3);
    if (!keeps_at_tool_change_) known_ = false;
    const bool together = draws_.chance(60);
    if (!together) put({fmt::format("T{}", tool)});
    put({together ? fmt::format("T{}", tool) : "", code('M', 6)});
    if (incremental_) put({"G90"});
    incremental_ = false;
    const bool off = draws_.chance(15);
    const int sign = draws_.chance(8) ? -1 : 1;
    length_ = off ? 0 : sign * kToolLengths[tool - 1];
    Words words{off ? "G49" : sign < 0 ? "G44" : draws_.chance(80) ? "G43" : "G43.4"};
    if (words.front() == "G43.4" && feeds_ == Feeds::per_minute && uses_rotary_) words.front() = "G43";
    if (!off) words.push_back(fmt::format("H{}", tool));
    words.push_back(code('G', 0));
    motion_ = 0;
    words.push_back(axis_word(Axis::Z));
    put(words);
    if (!known_) go_to_known_place();
  }

  void directions() {
    if (feeds_ != Feeds::per_minute) return;
    const int tool = draws_.whole(1, 3);
    length_ = kToolLengths[tool - 1];
    put({"G43.5", fmt::format("H{}", tool), code('G', 0), axis_word(Axis::Z)});
    motion_ = 0;
    for (int left = draws_.whole(1, 4); left > 0; --left) {
      Words words{motion_code(draws_.chance(85) ? 1 : 0)};
      for (std::string& word : axes(some(50, 0))) words.push_back(std::move(word));
      const std::array<std::string, 3> d = direction();
      for (std::size_t i = 0; i < 3; ++i) words.push_back("IJK"[i] + d[i]);
      if (motion_ != 0) feed_word(words);
      put(feeding(words));
    }
    length_ = 0;
    put({"G49", code('G', 0), axis_word(Axis::Z)});
    motion_ = 0;
    go_to_known_place();
  }

  void tilted_plane() {
    if (feeds_ != Feeds::per_minute) return;
    const auto place = [&](Axis axis) { return letter(axis) + length(target(axis) / 2).text; };
    known_ = false;
    put({"G68.2", place(Axis::X), place(Axis::Y), place(Axis::Z), fmt::format("I{:.3f}", draws_.between(-180, 180)),
         fmt::format("J{:.3f}", draws_.between(0.5, 8)), fmt::format("K{:.3f}", draws_.between(-180, 180))});
    put({"G53.1"});
    moves_on_plane();
    put({"G69"});
    go_to_known_place();
  }

  // As programs end a tool: up to the reference point, which nobody gave.
  void go_home() {
    if (turned_deg_ != 0) return;
    known_ = false;
    put({"G91 G28 Z0."});
    incremental_ = true;
    motion_ = -1;
    go_to_known_place();
  }

  void to_machine() {
    if (incremental_ || turned_deg_ != 0 || inches_) return;
    const int z = draws_.whole(0, 30);
    known_ = false;
    put({"G53", "G0", fmt::format("Z{}.", z + static_cast<int>(kBox[Axis::Z]) + std::lround(length_))});
    motion_ = 0;
    go_to_known_place();
  }

  void cycle() {
    static constexpr std::array<std::string_view, 8> kCodes{"G81", "G82", "G83", "G73", "G85", "G86", "G89", "G84"};
    if (feeds_ != Feeds::per_minute || plane_ != nc::Plane::xy) return;
    const nc::PlaneAxes axes = nc::axes_of(plane_);
    const std::string cycle(draws_.pick(kCodes));
    if (cycle == "G84" || cycle == "G86") put({"S500", "M3"});
    const bool to_r = draws_.chance(50);
    const double from = at_[axes.third];
    const double r = from - draws_.between(0.5, 6);
    Words words{to_r ? "G99" : "G98", cycle};
    known_ = false;
    const auto place = [&](Axis axis) {
      return letter(axis) + length(incremental_ ? draws_.between(-5, 5) : target(axis)).text;
    };
    words.push_back(place(axes.first));
    words.push_back(place(axes.second));
    const Spelled r_word = length(incremental_ ? r - from : r);
    const double r_at = incremental_ ? from + r_word.value : r_word.value;
    const double bottom = r_at - draws_.between(1, 8);
    words.push_back(letter(axes.third) + length(incremental_ ? bottom - r_at : bottom).text);
    words.push_back("R" + r_word.text);
    if (cycle == "G82" || cycle == "G86" || cycle == "G89") words.push_back(fmt::format("P{}", draws_.whole(1, 900)));
    if (cycle == "G83" || cycle == "G73") words.push_back("Q" + length(draws_.between(0.7, 4)).text);
    words.push_back(feed_text(draws_.between(100, 900)));
    if (words.back().find('.') == std::string::npos) words.back() += ".";
    feed_stated_ = true;
    if (draws_.chance(12)) words.push_back(fmt::format("K{}", draws_.whole(1, 3)));
    put(words);
    for (int more = draws_.whole(0, 2); more > 0; --more) put({place(draws_.chance(50) ? axes.first : axes.second)});
    put({"G80"});
    go_to_known_place();
  }

  void flow() {
    if (feeds_ != Feeds::per_minute) return;
    put({feed_text(draws_.between(200, 900))});
    feed_stated_ = true;
    motion_ = -1;
    ++labels_;
    const int n = 9000 + labels_;
    switch (draws_.whole(0, 5)) {
      case 0:
        return put_as_it_is(fmt::format("#100=0\nWHILE [#100 LT {}] DO 1\n{}\n#100=#100+1\nEND 1", draws_.whole(0, 3),
                                        there_and_back()));
      case 1:
        return put_as_it_is(fmt::format("#101={}\nN{} #101=#101-1\n{}\nIF [#101 GT 0] GOTO {}", draws_.whole(1, 3), n,
                                        there_and_back(), n));
      case 2:
        return put_as_it_is(fmt::format("#102={}.\nIF [#102 EQ 2.] THEN #103=3.\nIF [#102 GT 1.] GOTO {}\n{}\nN{} M8",
                                        draws_.whole(1, 3), n, there_and_back(), n));
      case 3:
        programs_.push_back(fmt::format("O{}\n{}\nM99", n, there_and_back()));
        return put_as_it_is(fmt::format("M98 P{}{}", n, draws_.chance(50) ? " L2" : ""));
      case 4:
        programs_.push_back(
            fmt::format("O{}\nG91 G1 X#24 Y-#25\nG1 X-#24 Y#25\n{}\nM99", n, incremental_ ? "G91" : "G90"));
        return put_as_it_is(
            fmt::format("G65 P{} X{:.2f} Y{:.2f}", n, draws_.between(0.1, 0.4), draws_.between(0.1, 0.4)));
      default:
        return put_as_it_is(
            fmt::format("#104=0\nWHILE [#104 LT 2] DO 1\n#105=0\nWHILE [#105 LT 2] DO 2\n{}\n#105=#105+1\nEND "
                        "2\n#104=#104+1\nEND 1",
                        there_and_back()));
    }
  }

  std::array<AxisWords, kFanucSystems> systems_;
  AxisWords origin_before_, shift_before_;
  double length_ = 0;
  int labels_ = 0;
  std::vector<std::string> programs_;
};

}  // namespace

std::unique_ptr<Writer> fanuc_writer(std::uint64_t seed, const Scene& scene) {
  return std::make_unique<Fanuc>(seed, scene);
}

}  // namespace plumbline::drawn

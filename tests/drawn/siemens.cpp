// Programs for the SINUMERIK, in its own language.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.hpp"
#include "drawn/dialects.hpp"

namespace plumbline::drawn {
namespace {

Manners siemens_manners() {
  Manners manners;
  manners.comment_open = "; ";
  manners.comment_close = "";
  manners.comment_inside = false;
  manners.finer = false;
  return manners;
}

constexpr std::size_t kSiemensSystems = 6;  // G54 to G57, G505, G506

class Siemens final : public Writer {
 public:
  Siemens(std::uint64_t seed, const Scene& scene) : Writer("siemens", seed, scene, siemens_manners()) {
    draw_work_offsets(systems_);
    draw_what_stays();
    draw_rules(75);
    endless_ = uses_rotary_ && keeps_at_tool_change_ && keeps_at_stop_ && draws_.chance(12);
  }

 private:
  void head() override {
    if (draws_.chance(30)) put_as_it_is("; drawn");
    inches_ = draws_.chance(20);
    put({"G17", "G90", "G94", inches_ ? "G700" : draws_.chance(50) ? "G71" : "G710", "G54"});
    if (draws_.chance(20)) put({"TRAORI"});
    if (draws_.chance(15)) put({"FGROUP(X,Y,Z)"});
    go_to_known_place();
  }

  void tail() override { put_as_it_is(draws_.chance(50) ? "M30" : "M2"); }

  std::string comment() override { return Writer::comment(); }
  bool has_turns() const override { return true; }
  std::string radius_word(const std::string& number) override {
    return (number.front() == '=' ? "CR" : "CR=") + number;
  }
  std::string turns_word(int turns) override { return fmt::format("TURN={}", turns); }
  std::string switch_word() override {
    static constexpr std::array<std::string_view, 5> kWords{"M8", "M7", "G64", "G60", "G641"};
    return std::string(draws_.pick(kWords));
  }

  std::string expression(Spelled& number) override {
    const double part = draws_.whole(-9000, 9000) / 1000.0;
    const double rest = std::round((number.value - part) * 1000) / 1000;
    number.value = part + rest;
    return draws_.chance(50) ? fmt::format("={:.3f}+({:.3f})", part, rest)
                             : fmt::format("=({:.3f})+({:.3f})", rest, part);
  }

  // One axis by IC, AC or DC, whatever the mode; of an increment the control keeps three decimals.
  std::string axis_word(Axis axis) override {
    if (endless_ && axis == Axis::C && (known_ || direct_) && !incremental_) return direct_word();
    if (goes_to_known_place_ || !draws_.chance(4) || inches_) return Writer::axis_word(axis);
    const double to = target(axis);
    const bool within_turn = direct_ && axis == Axis::C;  // AC too says a place within the turn then
    if (draws_.chance(50) || within_turn) {
      const Spelled by = spell(to - at_[axis], 3, 3);
      at_[axis] += by.value;
      return fmt::format("{}=IC({})", letter(axis), by.text);
    }
    const Spelled place = spell(to, 3, 9);
    at_[axis] = place.value;
    return fmt::format("{}=AC({})", letter(axis), place.text);
  }

  // The shorter way, to a place within the turn.
  std::string direct_word() {
    constexpr double kTurn = 360;
    direct_ = true;
    double place = std::fmod(target(Axis::C), kTurn);
    if (place < 0) place += kTurn;
    const Spelled number = spell(std::min(place, 359.99), 3, 9);
    double way = std::fmod(number.value - at_[Axis::C], kTurn);
    if (way > kTurn / 2) way -= kTurn;
    if (way < -kTurn / 2) way += kTurn;
    at_[Axis::C] += way;
    return fmt::format("C=DC({})", number.text);
  }

  // A circle through a point on the way.
  void through_point() {
    if (incremental_ || turned_deg_ != 0) return;
    const nc::PlaneAxes axes = nc::axes_of(plane_);
    const double r = draws_.between(0.8, 12);
    const double begin = draws_.between(0, 360);
    const double sweep = draws_.between(20, 320) * (draws_.chance(50) ? 1 : -1);
    const auto at = [&](Axis axis, double deg) {
      const bool first = axis == axes.first;
      const double centre = at_[axis] - r * (first ? std::cos(begin * kDeg) : std::sin(begin * kDeg));
      return centre + r * (first ? std::cos(deg * kDeg) : std::sin(deg * kDeg));
    };
    const double middle = begin + sweep * draws_.between(0.3, 0.7);
    Words words{"CIP"};
    Words through;
    for (const Axis axis : {axes.first, axes.second}) {
      const std::string text = length(at(axis, middle)).text;
      through.push_back(fmt::format("{}1{}{}", "IJK"[index(axis)], text.front() == '=' ? "" : "=", text));
    }
    const double first = at(axes.first, begin + sweep);
    const double second = at(axes.second, begin + sweep);
    words.push_back(axis_word_to(axes.first, first));
    words.push_back(axis_word_to(axes.second, second));
    for (std::string& word : through) words.push_back(std::move(word));
    feed_word(words);
    motion_ = -1;
    put(words);
  }

  void piece() override {
    manners_.cut_mm = incremental_ ? 3 : 9;
    manners_.cut_deg = incremental_ ? 3 : 9;
    manners_.cut_inch = incremental_ ? 4 : 9;
    manners_.decimals_mm = manners_.decimals_deg = incremental_ ? 3 : 4;
    manners_.decimals_inch = incremental_ ? 4 : 5;
    const int kind = draws_.whole(0, 99);
    if (kind < 2) return skippable();
    if (kind < 5) return through_point();
    if (kind < 8 && may_tilt() && !shifted_) return draws_.chance(60) ? directions() : swivel();
    if (kind < 42) return put(line(true));
    if (kind < 50) return put(line(false));
    if (kind < 64) return put(arc());
    if (kind < 70) return change_mode();
    if (kind < 76) return change_offset();
    if (kind < 79) return change_tool();
    if (kind < 82) return put({code('G', 4), fmt::format("F{:.2f}", draws_.between(0.1, 2))});
    if (kind < 87) return cycle();
    if (kind < 93) return flow();
    if (kind < 95) {
      if (!keeps_at_stop_) known_ = false;
      put({draws_.chance(50) ? "M1" : "M0"});
      if (!known_) go_to_known_place();
      return;
    }
    if (kind < 96) return to_machine();
    if (kind < 98) return put({draws_.chance(50) ? switch_word() : draws_.chance(50) ? "M9" : "STOPRE"});
    put_as_it_is(draws_.chance(60) ? comment() : draws_.chance(50) ? "MSG(\"drawn\")" : "");
  }

  void change_mode() {
    switch (draws_.whole(0, 5)) {
      case 0:
      case 1:
        if (shifted_) return;
        return change_distance();
      case 2:
        if (shifted_ || length_ != 0) return;
        return change_unit("G700", "G710");
      case 3:
        return change_feed_mode();
      case 4:
        return put({draws_.chance(50) ? "G60" : "G64"});
      default:
        if (turned_deg_ == 0) change_plane();
    }
  }

  void directions() {
    if (feeds_ != Feeds::per_minute || endless_) return;
    for (int left = draws_.whole(1, 3); left > 0; --left) {
      Words words{motion_code(draws_.chance(85) ? 1 : 0)};
      for (std::string& word : axes(some(50, 0))) words.push_back(std::move(word));
      const std::array<std::string, 3> d = direction();
      for (std::size_t i = 0; i < 3; ++i) words.push_back(fmt::format("{}3={}", "ABC"[i], d[i]));
      if (motion_ != 0) feed_word(words);
      put(words);
    }
  }

  // A tilted plane, and back.
  void swivel() {
    if (feeds_ != Feeds::per_minute || endless_) return;
    static constexpr std::array kModes{57, 39, 27, 45, 30, 54};
    known_ = false;
    put({fmt::format("CYCLE800({},\"TABLE\",0,{},0,0,0,{:.3f},{:.3f},{:.3f},0,0,0,{})", draws_.whole(0, 1),
                     draws_.pick(kModes), draws_.between(-5, 5), draws_.between(-5, 5), draws_.between(-5, 5),
                     draws_.chance(50) ? 1 : -1)});
    moves_on_plane();
    put({"CYCLE800()"});
    go_to_known_place();
  }

  // As programs end a tool.
  void to_machine() {
    if (incremental_ || inches_) return;
    known_ = false;
    at_[Axis::Z] += length_;
    length_ = 0;
    edge_off_ = true;
    put({"SUPA", "G0", fmt::format("Z{}", draws_.whole(0, 30) + static_cast<int>(kBox[Axis::Z])), "D0"});
    motion_ = 0;
    go_to_known_place();
  }

  void change_offset() {
    if (incremental_) return;
    const AxisWords box = to_box(at_);
    const int kind = draws_.whole(0, 3);
    if (kind < 2 && !shifted_) {
      const auto system = static_cast<std::size_t>(draws_.whole(0, kSiemensSystems - 1));
      origin_ = systems_[system];
      at_ = to_work(box);
      put({system < 4 ? fmt::format("G{}", 54 + system) : fmt::format("G{}", 501 + system)});
      return go_to_known_place();
    }
    if (shifted_) {
      origin_ = origin_before_;
      turned_deg_ = 0;
      shift_ = {};
      shifted_ = false;
      at_ = to_work(box);
      put({"TRANS"});
      return go_to_known_place();
    }
    if (plane_ != nc::Plane::xy || inches_) return;
    origin_before_ = origin_;
    shifted_ = true;
    Words words{draws_.chance(50) ? "TRANS" : "ATRANS"};
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
      const double by = draws_.whole(-500, 500) / 100.0;
      origin_[axis] += by;
      words.push_back(fmt::format("{}{:.2f}", letter(axis), by));
    }
    at_ = to_work(box);
    put(words);
    if (draws_.chance(40)) {
      turned_deg_ = draws_.whole(1, 90);
      at_ = to_work(box);
      put({"AROT", fmt::format("RPL={}", turned_deg_)});
    }
    go_to_known_place();
  }

  void change_tool() {
    if (incremental_) return;
    const int tool = draws_.whole(1, 3);
    if (!keeps_at_tool_change_) known_ = false;
    put({draws_.chance(50) ? fmt::format("T{}", tool) : fmt::format("T=\"{}\"", tool)});
    const double next = kToolLengths[tool - 1];
    if (edge_off_) {  // D0 stays
      put({"M6"});
      edge_off_ = false;
      at_[Axis::Z] -= next;
      length_ = next;
      put({"D1"});
    } else {
      at_[Axis::Z] -= next - length_;
      length_ = next;
      put({"M6"});
      if (draws_.chance(50)) put({"D1"});
    }
    if (feeds_ == Feeds::per_revolution) put({"S1000", "M3"});
    go_to_known_place();
  }

  void cycle() {
    static constexpr std::array<std::string_view, 3> kCodes{"CYCLE81", "CYCLE82", "CYCLE83"};
    if (feeds_ != Feeds::per_minute || plane_ != nc::Plane::xy || incremental_ || turned_deg_ != 0) return;
    put({fmt::format("F{}", draws_.whole(200, 900))});
    feed_stated_ = true;
    const std::string name(draws_.pick(kCodes));
    const double level = at_[Axis::Z];
    const double u = unit();
    const double reference = level - draws_.between(2, 6);
    std::string call = fmt::format("{}({:.3f},{:.3f},{:.3f},{:.3f}", name, level / u, reference / u, 1 / u,
                                   (reference - draws_.between(2, 8)) / u);
    if (name == "CYCLE82") call += ",,0.2";
    if (name == "CYCLE83") call += fmt::format(",,{:.3f},,{:.3f},0,0,1,0", (reference - 1) / u, 1 / u);
    call += ")";
    known_ = false;
    if (draws_.chance(50)) {
      put({call});
    } else {
      put({"MCALL", call});
      for (int more = draws_.whole(1, 3); more > 0; --more)
        put({code('G', 0), "X" + length(target(Axis::X)).text, "Y" + length(target(Axis::Y)).text});
      put({"MCALL"});
    }
    motion_ = -1;
    go_to_known_place();
  }

  std::string increment_word(Axis axis, double by) override { return fmt::format(" {}=IC({:.3f})", letter(axis), by); }

  std::string there_and_back() override {
    const auto [there, back] = words_there_and_back();
    return fmt::format("G1{}\nG1{}", there, back);
  }

  void flow() {
    if (feeds_ != Feeds::per_minute) return;
    put({fmt::format("F{}", draws_.whole(200, 900))});
    feed_stated_ = true;
    motion_ = -1;
    ++labels_;
    switch (draws_.whole(0, 6)) {
      case 6:
        return put_as_it_is(fmt::format("FOR R7=1 TO {}\nFOR R8=3 TO {}\n{}\nENDFOR\nENDFOR", draws_.whole(1, 2),
                                        draws_.whole(2, 4), there_and_back()));
      case 0:
        return put_as_it_is(fmt::format("FOR R1=1 TO {}\n{}\nENDFOR", draws_.whole(1, 3), there_and_back()));
      case 1:
        return put_as_it_is(
            fmt::format("R2=0\nWHILE R2<{}\n{}\nR2=R2+1\nENDWHILE", draws_.whole(1, 3), there_and_back()));
      case 2:
        return put_as_it_is(fmt::format("R3={}\nIF R3>1\n{}\nELSE\nM8\nENDIF", draws_.whole(1, 2), there_and_back()));
      case 3:
        return put_as_it_is(fmt::format("R4=2\nREPEAT\n{}\nR4=R4-1\nUNTIL R4<=0", there_and_back()));
      case 4:
        return put_as_it_is(fmt::format("R5={}\nIF R5>1 GOTOF SKIP{}\n{}\nSKIP{}: M8", draws_.whole(1, 2), labels_,
                                        there_and_back(), labels_));
      default:
        return put_as_it_is(
            fmt::format("R6=2\nBACK{}: R6=R6-1\n{}\nIF R6>0 GOTOB BACK{}", labels_, there_and_back(), labels_));
    }
  }

  std::array<AxisWords, kSiemensSystems> systems_;
  AxisWords origin_before_;
  bool shifted_ = false;
  double length_ = 0;
  bool edge_off_ = false;
  bool endless_ = false;  // C
  bool direct_ = false;   // was written with DC
  int labels_ = 0;
};

}  // namespace

std::unique_ptr<Writer> siemens_writer(std::uint64_t seed, const Scene& scene) {
  return std::make_unique<Siemens>(seed, scene);
}

}  // namespace plumbline::drawn

// Programs for Okuma's OSP.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "drawn/dialects.hpp"
#include "settings/options.hpp"

namespace plumbline::drawn {
namespace {

Manners okuma_manners() {
  Manners manners;
  manners.decimals_mm = manners.decimals_deg = 3;
  manners.lower_case = false;
  manners.semicolon_comment = false;
  return manners;
}

constexpr std::size_t kOkumaSystems = 4;

class Okuma final : public Writer {
 public:
  Okuma(std::uint64_t seed, const Scene& scene) : Writer("okuma", seed, scene, okuma_manners()) {
    settings::Options& options = program_.options;
    draw_work_offsets(systems_);
    if (uses_rotary_ || draws_.chance(50))
      options.program.feed_rule = draws_.chance(50) ? nc::FeedRule::xyz_first : nc::FeedRule::all_axes_as_mm;
    draw_what_stays();
  }

 private:
  void head() override {
    if (draws_.chance(40)) put_as_it_is("$DRAWN.MIN%");
    if (draws_.chance(40)) put_as_it_is(fmt::format("O{:04}", draws_.whole(1, 999)));
    put({"G15 H1"});
    put({"G17", "G90", "G94", draws_.chance(50) ? "G40" : "", draws_.chance(30) ? "G21" : ""});
    go_to_known_place();
  }

  void tail() override {
    put_as_it_is(draws_.chance(50) ? "M2" : "M30");
    for (const std::string& program : programs_) put_as_it_is(program);
  }

  std::string switch_word() override {
    static constexpr std::array<std::string_view, 6> kWords{"M8", "M7", "M9", "G61", "G64", "M5"};
    return std::string(draws_.pick(kWords));
  }

  std::string expression(Spelled& number) override {
    const double part = draws_.whole(-9000, 9000) / 1000.0;
    const double rest = std::round((number.value - part) * 1000) / 1000;
    number.value = part + rest;
    return fmt::format("=[{:.3f}+[{:.3f}]]", part, rest);
  }

  void piece() override {
    const int kind = draws_.whole(0, 99);
    if (kind < 2) return skippable();
    if (kind < 42) return put(continued(line(true)));
    if (kind < 50) return put(line(false));
    if (kind < 64) return put(continued(arc()));
    if (kind < 70) return change_mode();
    if (kind < 75) return change_system();
    if (kind < 79) return change_tool();
    if (kind < 82) {
      if (feeds_ != Feeds::per_minute) return;
      return put({code('G', 4), fmt::format("F{:.2f}", draws_.between(0.1, 2))});
    }
    if (kind < 88) return cycle();
    if (kind < 94) return flow();
    if (kind < 96) {
      if (!keeps_at_stop_) known_ = false;
      put({draws_.chance(50) ? "M01" : "M0"});
      if (!known_) go_to_known_place();
      return;
    }
    if (kind < 97) return put({switch_word()});
    if (kind < 98) {
      if (incremental_) return;
      known_ = false;
      put({"G0", "Z9999"});
      motion_ = 0;
      return go_to_known_place();
    }
    put_as_it_is(draws_.chance(60) ? comment() : "");
  }

  // A block in two lines
  Words continued(Words words) {
    std::erase(words, "");
    if (spacing_ != 0 || words.size() < 3 || !draws_.chance(6)) return words;
    words[words.size() - 1].insert(0, "\n$ ");
    return words;
  }

  void change_mode() {
    switch (draws_.whole(0, 4)) {
      case 0:
      case 1:
        return change_distance();
      case 2:
        return change_feed_mode();
      case 3:
        return put({draws_.chance(50) ? "G61" : "G64"});
      default:
        change_plane();
    }
  }

  void change_system() {
    const AxisWords box = to_box(at_);
    const auto system = static_cast<std::size_t>(draws_.whole(0, kOkumaSystems - 1));
    origin_ = systems_[system];
    at_ = to_work(box);
    put({fmt::format("G15 H{}", system + 1)});
    go_to_known_place();
  }

  void change_tool() {
    const int tool = draws_.whole(1, 3);
    if (!keeps_at_tool_change_) known_ = false;
    put({fmt::format("T{}", tool), "M6"});
    if (feeds_ == Feeds::per_revolution) put({"S1000", "M3"});
    if (incremental_) put({"G90"});
    incremental_ = false;
    const bool off = draws_.chance(15);
    Words words{off ? "G53" : fmt::format("G56 H{}", tool)};
    words.push_back(code('G', 0));
    motion_ = 0;
    words.push_back(axis_word(Axis::Z));
    put(words);
    go_to_known_place();
  }

  void cycle() {
    static constexpr std::array<std::string_view, 7> kCodes{"G81", "G82", "G83", "G73", "G85", "G86", "G89"};
    if (feeds_ != Feeds::per_minute || plane_ != nc::Plane::xy || incremental_) return;
    const std::string cycle(draws_.pick(kCodes));
    if (draws_.chance(60) || cycle == "G86") put({"S500", "M3"});
    const bool to_r = draws_.chance(50);
    const double level = at_[Axis::Z];
    if (!to_r) put({fmt::format("G71 Z{:.3f}", level)});
    const auto kept = [](double mm) { return std::round(mm * 1000) / 1000; };  // as posts write it
    const double r = to_r ? level : kept(level - draws_.between(0.5, 6));
    known_ = false;
    const auto place = [&](Axis axis) { return letter(axis) + length(target(axis)).text; };
    Words words{cycle, place(Axis::X), place(Axis::Y)};
    words.push_back("Z" + length(kept(r - draws_.between(1, 8))).text);
    words.push_back(fmt::format("R{:.3f}", r));
    if (cycle == "G82" || cycle == "G86" || cycle == "G89") words.emplace_back("P1");
    if (cycle == "G83" || cycle == "G73") words.push_back("Q" + length(kept(draws_.between(0.7, 4))).text);
    words.push_back(fmt::format("F{}", draws_.whole(100, 900)));
    feed_stated_ = true;
    words.emplace_back(to_r ? "M54" : "M53");
    put(words);
    for (int more = draws_.whole(0, 2); more > 0; --more)
      put({draws_.chance(15) ? "NCYL" : "", place(draws_.chance(50) ? Axis::X : Axis::Y)});
    put({"G80"});
    go_to_known_place();
  }

  void flow() {
    if (feeds_ != Feeds::per_minute) return;
    put({fmt::format("F{}", draws_.whole(200, 900))});
    feed_stated_ = true;
    motion_ = -1;
    ++labels_;
    const int n = 9000 + labels_;
    switch (draws_.whole(0, 3)) {
      case 0:
        return put_as_it_is(fmt::format("VC1={}\nNLP{} VC1=VC1-1\n{}\nIF [VC1 GT 0] NLP{}", draws_.whole(1, 3), labels_,
                                        there_and_back(), labels_));
      case 1:
        return put_as_it_is(fmt::format("VC2={}\nIF [VC2 GT 1] NSK{}\n{}\nNSK{} M8", draws_.whole(1, 3), labels_,
                                        there_and_back(), labels_));
      case 2:
        programs_.push_back(fmt::format("O{}\n{}\nRTS", n, there_and_back()));
        return put_as_it_is(fmt::format("CALL O{}{}", n, draws_.chance(50) ? " Q2" : ""));
      default:
        programs_.push_back(
            fmt::format("O{}\nG91 G1 X=PX Y=-PY\nG1 X=-PX Y=PY\n{}\nRTS", n, incremental_ ? "G91" : "G90"));
        return put_as_it_is(
            fmt::format("CALL O{} PX={:.2f} PY={:.2f}", n, draws_.between(0.1, 0.4), draws_.between(0.1, 0.4)));
    }
  }

  std::array<AxisWords, kOkumaSystems> systems_;
  int labels_ = 0;
  std::vector<std::string> programs_;
};

}  // namespace

std::unique_ptr<Writer> okuma_writer(std::uint64_t seed, const Scene& scene) {
  return std::make_unique<Okuma>(seed, scene);
}

}  // namespace plumbline::drawn

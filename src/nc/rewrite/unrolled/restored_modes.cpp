#include "nc/rewrite/unrolled/restored_modes.hpp"

#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/text/number_text.hpp"

namespace plumbline::nc {
namespace {

// Codes and words of one block, spelt like the program.
class CodeText {
 public:
  CodeText(const CodeWriter& codes, const Spelling& spelling) : codes_(codes), spelling_(spelling) {}

  void code(std::string_view text) { append_code(text_, text, spelling_); }
  void code(std::string_view meaning, std::optional<int> value) { code(codes_.text_of(meaning, value)); }
  void word(char letter, double value) {
    Spelling spelling = spelling_;
    if (letter == 'S' || letter == 'H') spelling.point = false;  // whole numbers take none [Fanuc]
    append_word(text_, letter, value, kMostDecimals, spelling);
  }
  const CodeWriter& codes() const { return codes_; }
  std::string take() { return std::exchange(text_, {}); }

 private:
  const CodeWriter& codes_;
  const Spelling& spelling_;
  std::string text_;
};

// Units, plane, and how words count.
void append_geometry_modes(CodeText& text, const Modal& was, const Modal& is) {
  constexpr std::array kPlanes{"plane_xy", "plane_zx", "plane_yz"};
  const auto differs = [&](bool differ, std::string_view meaning, std::optional<int> value = std::nullopt) {
    if (differ) text.code(meaning, value);
  };
  differs(is.inches != was.inches, is.inches ? "inches" : "millimetres");
  differs(is.plane != was.plane, kPlanes[static_cast<std::size_t>(is.plane)]);
  differs(is.incremental != was.incremental, is.incremental ? "incremental" : "absolute");
  differs(is.arc_centre_absolute != was.arc_centre_absolute,
          is.arc_centre_absolute ? "arc_centre_absolute" : "arc_centre_incremental");
  differs(is.retract_to_r != was.retract_to_r, is.retract_to_r ? "retract_to_r" : "retract_to_start");
  differs(is.work_system != was.work_system, "work_system", is.work_system);
}

void append_path_control(CodeText& text, const Modal& was, const Modal& is) {
  const bool continuous = is.path_control == PathControl::continuous;
  const bool tolerances = is.switches.path_tolerance != was.switches.path_tolerance ||
                          is.switches.naive_tolerance != was.switches.naive_tolerance;
  if (is.path_control == was.path_control && !(tolerances && continuous)) return;
  text.code(text.codes().path_control(is.path_control));
  if (!continuous) return;
  text.word('P', is.switches.path_tolerance);
  text.word('Q', 0);  // each point counts
}

void append_tool_length(CodeText& text, const Step& step) {
  const Modal& is = *step.after;
  const AxisWords& length = step.frame->tool;
  if (length == AxisWords{}) return text.code("tool_length_off", std::nullopt);
  if (is.tool_of_offset >= 0) {
    text.code("tool_length", std::nullopt);
    return text.word('H', is.tool_of_offset);
  }
  text.code("tool_length_by_words", std::nullopt);
  for (const Axis axis : kAllAxes) {
    text.word(letter(axis), length[axis] / is.unit_of(axis));
  }
}

void write_switches(const Switches& was, const Switches& is, const CodeWriter& codes, const Spelling& spelling,
                    const WriteLine& write_line) {
  const auto write = [&](std::string_view meaning, int value) {
    write_line(in_spelling(codes.text_of(meaning, value), spelling));
  };
  const bool off = (was.mist && !is.mist) || (was.flood && !is.flood);
  if (off) write("coolant", kCoolantOff);
  if (is.mist && (off || !was.mist)) write("coolant", kMist);
  if (is.flood && (off || !was.flood)) write("coolant", kFlood);
  const auto override_switch = [&](bool before, bool after, int code) {
    if (before == after) return;
    write_line(in_spelling(fmt::format("{} P{}", codes.text_of("override", code), after ? 1 : 0), spelling));
  };
  override_switch(was.feed_override, is.feed_override, kFeedOverride);
  override_switch(was.speed_override, is.speed_override, kSpeedOverride);
  override_switch(was.adaptive_feed, is.adaptive_feed, kAdaptiveFeed);
  override_switch(was.feed_stop, is.feed_stop, kFeedStop);
}

}  // namespace

void write_restored_modes(const Step& step, bool other_length, const CodeWriter& codes, const Spelling& spelling,
                          OutputState& control, const WriteLine& write) {
  const Modal& was = *step.before;
  const Modal& is = *step.after;
  CodeText modes(codes, spelling);
  append_geometry_modes(modes, was, is);
  append_path_control(modes, was, is);
  if (is.feed_mode != control.feed_mode) {
    modes.code(codes.feed_mode(is.feed_mode));
    control.feed_mode = is.feed_mode;
    control.drop_feed();
  }
  control.change_unit(was, is);
  write(modes.take());
  // Where it stays as it was, a move that counts on it says it again: a block of F alone may be refused under MCALL.
  const bool feed_comes_back = step.saves_modes || is.feed != was.feed || is.feed_mode != was.feed_mode;
  if (feed_comes_back && is.feed > 0 && is.feed_mode != FeedMode::inverse_time && is.feed != control.feed) {
    modes.word('F', is.feed);
    control.set_feed(is.feed);
  }
  const bool other_speed = is.switches.surface_speed != was.switches.surface_speed;
  if (other_speed) modes.code("surface_speed", is.switches.surface_speed ? 1 : 0);
  if (is.switches.speed != was.switches.speed || (other_speed && is.switches.surface_speed))
    modes.word('S', is.switches.speed);
  if (is.switches.spindle != was.switches.spindle) modes.code(codes.text_of("spindle", is.switches.spindle));
  write(modes.take());
  write_switches(was.switches, is.switches, codes, spelling, write);
  if (other_length) append_tool_length(modes, step);
  write(modes.take());
  if (!step.g92_restored) return;
  modes.code(*step.g92_restored ? "restore_position" : "suspend_position", std::nullopt);
  write(modes.take());
}

}  // namespace plumbline::nc

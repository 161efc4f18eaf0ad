// What is written where a program steered or worked a cycle: entries, modes that come back, holes.
#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "nc/language/block_words.hpp"
#include "nc/rewrite/emit.hpp"

namespace plumbline::nc {
namespace {

std::string as_comment(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    const bool may_stand = c >= 0x20 && c < 0x7F && c != '(' && c != ')' && c != ';' && c != '%';
    plain += may_stand ? c : '_';
  }
  return plain;
}

std::string subprogram_name(std::string_view name) {
  const bool number = name.find_first_not_of("0123456789") == std::string_view::npos;
  return number ? fmt::format("o{}", name) : fmt::format("o<{}>", as_comment(name));
}

// Codes and words of one block, spelt like the program.
class CodeText {
 public:
  CodeText(const CodeWriter& codes, const Spelling& spelling) : codes_(codes), spelling_(spelling) {}

  void code(std::string_view text) { append_code(text_, text, spelling_); }
  void code(std::string_view meaning, std::optional<int> value) { code(codes_.text_of(meaning, value)); }
  void word(char letter, double value) { append_word(text_, letter, value, kMostDecimals, spelling_); }
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
  text.word('Q', is.switches.naive_tolerance);
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

}  // namespace

void Emitter::steer(const Step& step) {
  const Block& block = *step.block;
  if (step.saves_modes && block.words.size() > 1) {
    refuse_block(block, "emit-modes", "this block keeps or restores modes and does something else as well",
                 "put M70 to M73 into a block of its own");
  }
  const bool other_length = step.frame->tool != tool_;
  note_header(step);
  if (step.entry.kind != FlowEntry::Kind::none) note_entry(step.entry);
  restore_modes(step, other_length);
}

// An entry met again before any block was written takes the place of the one before, and of all that is inside it.
void Emitter::note_entry(const FlowEntry& entry) {
  const auto again = std::find_if(entries_.begin(), entries_.end(), [&](const Pending& p) {
    return p.kind == entry.kind && p.line == entry.line && p.name == entry.name;
  });
  entries_.erase(again, entries_.end());
  entries_.push_back({entry.kind, std::string(entry.name), entry.line, entry_text(entry)});
}

std::string Emitter::entry_text(const FlowEntry& entry) {
  if (entry.kind == FlowEntry::Kind::pass) return fmt::format("pass {} of the loop in line {}", entry.pass, entry.line);
  std::string text = fmt::format("{} called in line {}", subprogram_name(entry.name), entry.line);
  if (entry.pass > 1) text += fmt::format(", pass {}", entry.pass);
  const bool known =
      std::any_of(inlined_.begin(), inlined_.end(), [&](const InlinedFile& file) { return file.name == entry.file; });
  if (entry.file.empty() || known) return text;
  const InputFile file{std::string(entry.file)};
  inlined_.push_back({file.name(), hash_of(file)});
  const std::string plain_name = std::filesystem::path(file.name()).filename().string();
  return fmt::format("{}, from {}, hash {}", text, as_comment(plain_name), to_hex(inlined_.back().hash));
}

void Emitter::write_entries() {
  const std::size_t signs = dialect_.comment_open.size() + dialect_.comment_close.size();
  for (const Pending& entry : entries_) {
    const std::string_view text = std::string_view(entry.text).substr(0, dialect_.line_length - signs);
    out_.write(fmt::format("{}{}{}{}", dialect_.comment_open, text, dialect_.comment_close, newline_));
  }
  entries_.clear();
}

void Emitter::write_words(const std::string& text) {
  if (text.empty()) return;
  write_entries();
  out_.write(text + newline_);
}

// What M72 and the end of a subprogram with M73 bring back, said with codes. Units first, since F and G64 P count in
// them; F behind its mode, which drops it.
void Emitter::restore_modes(const Step& step, bool other_length) {
  const Modal& was = *step.before;
  const Modal& is = *step.after;
  CodeText modes(codes_, spelling_);
  append_geometry_modes(modes, was, is);
  append_path_control(modes, was, is);
  if (is.feed_mode != control_.feed_mode) {
    modes.code(codes_.feed_mode(is.feed_mode));
    control_.feed_mode = is.feed_mode;
    control_.drop_feed();
  }
  control_.change_unit(was, is);
  write_words(modes.take());
  if (is.feed > 0 && is.feed_mode != FeedMode::inverse_time && is.feed != control_.feed) {
    modes.word('F', is.feed);
    control_.set_feed(is.feed);
  }
  if (is.switches.speed != was.switches.speed) modes.word('S', is.switches.speed);
  if (is.switches.spindle != was.switches.spindle) modes.code(codes_.text_of("spindle", is.switches.spindle));
  write_words(modes.take());
  restore_switches(was.switches, is.switches);
  if (other_length) append_tool_length(modes, step);
  write_words(modes.take());
  if (!step.g92_restored) return;
  modes.code(*step.g92_restored ? "restore_position" : "suspend_position", std::nullopt);
  write_words(modes.take());
}

void Emitter::restore_switches(const Switches& was, const Switches& is) {
  const auto write = [&](std::string_view meaning, int value) {
    write_words(in_spelling(codes_.text_of(meaning, value), spelling_));
  };
  const bool off = (was.mist && !is.mist) || (was.flood && !is.flood);
  if (off) write("coolant", kCoolantOff);
  if (is.mist && (off || !was.mist)) write("coolant", kMist);
  if (is.flood && (off || !was.flood)) write("coolant", kFlood);
  const auto override_switch = [&](bool before, bool after, int code) {
    if (before == after) return;
    write_words(in_spelling(fmt::format("{} P{}", codes_.text_of("override", code), after ? 1 : 0), spelling_));
  };
  override_switch(was.feed_override, is.feed_override, kFeedOverride);
  override_switch(was.speed_override, is.speed_override, kSpeedOverride);
  override_switch(was.adaptive_feed, is.adaptive_feed, kAdaptiveFeed);
  override_switch(was.feed_stop, is.feed_stop, kFeedStop);
}

// How far the level is off that cycles go back to: where the first of them began.
void Emitter::note_cycle_level(const Step& step) {
  const Axis normal = axes_of(step.after->plane).third;
  if (control_.motion != MotionMode::cycle) cycle_level_shift_ = control_.work_shift(*step.frame)[normal];
}

EmittedMove Emitter::hole(const Step& step, const AxisWords& shift) {
  if (step.call != nullptr) return called_hole(step, shift);
  note_header(step);
  begin_change(step);
  restore_feed_state(step, find_word(*step.block, 'F') != nullptr);
  const PlaneAxes axes = axes_of(step.after->plane);
  note_cycle_level(step);
  AxisWords left = control_.work_shift(*step.frame);
  if (!step.after->retract_to_r) left[axes.third] = cycle_level_shift_;
  // It went up to R before the cycle then, and comes back to the higher of the two.
  const bool comes_from_below = !step.after->retract_to_r && !dialect_.behaviour.fanuc_cycles &&
                                std::abs(step.holes.front().clear - step.holes.front().r) <= kSameHeight;
  editor_.start(*step.block, spelling_);
  for (const Word& word : step.block->words) {
    std::optional<Axis> axis = axis_of(word.letter);
    const bool level = step.holes.front().ijk && word.letter == kCentreLetters[index(axes.third)];
    if (word.letter == 'R' || level) axis = axes.third;
    if (!axis) continue;
    const double per_unit = step.after->inches ? kMmPerInch : 1;
    const double value = planner_.rounded(step, *axis, word.value + shift[*axis] / per_unit);
    const double off = (value - word.value) * per_unit;
    const bool goes_back_there = word.letter == 'R' && step.after->retract_to_r;
    const bool in_plane = word.letter == letter(axes.first) || word.letter == letter(axes.second);
    if (goes_back_there || in_plane) left[*axis] = off;
    if (word.letter == 'R' && comes_from_below) left[*axis] = std::max(left[*axis], off);
    std::string text;
    append_word(text, word.letter, value, kMostDecimals,
                {spelling_.lower_case, false, spelling_.point, spelling_.most_digits});
    editor_.replace(word.span, text);
  }
  if (dialect_.behaviour.return_levels && !step.after->retract_to_r)
    left[axes.third] = 0;  // the level of G71, as it is
  line_.clear();
  editor_.apply(line_);
  write_line(step, line_);
  out_.write(unrolls() ? newline_ : step.block->line_end);
  control_.set_work_shift(*step.frame, left);
  control_.motion = MotionMode::cycle;
  if (find_word(*step.block, 'F') != nullptr) control_.set_feed(step.after->feed);
  return {true, 1, std::nullopt, 0};
}

}  // namespace plumbline::nc

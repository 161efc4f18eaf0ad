// What the generators of all dialects share: where the axes stand, how numbers are spelled, how a block is put
// together.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawn/drawn_program.hpp"
#include "drawn/draws.hpp"
#include "nc/control/state/motion.hpp"

namespace plumbline::drawn {

enum class Feeds : std::uint8_t { inverse_time, per_minute, per_revolution };

/// A number as it is written, and what it is worth.
struct Spelled {
  std::string text;
  double value = 0;
};

/// What a dialect lets a writer write.
struct Manners {
  int decimals_mm = 4, decimals_inch = 5, decimals_deg = 4;  // at most, mostly
  int cut_mm = 9, cut_inch = 9, cut_deg = 9;                 // further ones are not kept
  int increments_mm = 0, increments_inch = 0,
      increments_deg = 0;  // decimals that a number without a point has; 0: none
  bool finer = true;       // decimals that are not kept may be written
  bool lower_case = true;
  bool spaces_inside = false;  // X 1 . 5
  bool plus = true;
  std::string_view comment_open = "(", comment_close = ")";
  bool comment_inside = true;  // between words
  bool semicolon_comment = true;
  bool numbers_first = true;  // N before everything
};

class Writer {
 public:
  Writer(std::string_view dialect, std::uint64_t seed, const Scene& scene, const Manners& manners);
  virtual ~Writer() = default;
  DrawnProgram write();

 protected:
  using Words = std::vector<std::string>;

  virtual void head() = 0;   // up to where the axes stand at a known place
  virtual void piece() = 0;  // a block, or a few
  virtual void tail() = 0;
  virtual std::string comment();

  // Scene
  /// Where the work systems lie: the first in the box's corner. Given to the control as well.
  void draw_work_offsets(std::span<AxisWords> systems);
  /// Which rule F follows, and what C does where a direction leaves it open: given to the control as well.
  void draw_rules(int feed_rule_percent);
  /// Whether the axes stay where they are at M0, M1 and M6, and whether blocks with / are left out.
  void draw_what_stays();

  // Spelling
  double unit() const { return inches_ ? 25.4 : 1; }
  Spelled spell(double value, int most_decimals, int cut, int increments = 0);
  Spelled length(double mm);  // value in mm
  Spelled angle(double deg);
  virtual std::string expression(Spelled& number);  // an expression of its value; its text as it is
  std::string joined(Words words);
  std::string code(char letter, int number) const;  // G1 or G01

  // Blocks
  void put(const Words& words);
  void put_as_it_is(std::string text);
  void put_lines(std::string text);

  // Places
  AxisWords to_box(const AxisWords& work) const;
  AxisWords to_work(const AxisWords& box) const;
  double target(Axis axis);  // in the work system, within the box
  virtual std::string axis_word(Axis axis);
  std::string axis_word_to(Axis axis, double work);
  std::string endless_word(Axis axis, double work);
  void turn_endlessly();
  Words axes(AxisSet which);
  AxisSet some(int linear_percent, int rotary_percent);
  AxisSet used_axes() const { return uses_rotary_ ? AxisSet::all() : AxisSet::linear(); }

  // Modes
  void change_distance();  // G90, G91
  void change_unit(std::string_view inches, std::string_view millimetres);
  virtual void change_feed_mode();  // G93, G94, G95 with a turning spindle
  void change_plane();

  // Tilts: where words of X, Y, Z and the direction of the tool say all
  /// A direction near that of the tool, as three numbers; A, B and C stand there then.
  std::array<std::string, 3> direction();
  bool may_tilt() const;
  /// A few moves of X, Y and Z about the zero of a tilted plane, where the axes are not followed.
  void moves_on_plane();

  // Moves by increments, and back to where they began
  virtual std::string there_and_back();
  /// The same as words alone, there and back.
  std::array<std::string, 2> words_there_and_back();
  virtual std::string increment_word(Axis axis, double by);

  // Motion
  void go_to_known_place();  // all axes that are used, by absolute words
  virtual Words line(bool feeds);
  virtual Words arc();
  virtual Words move();  // a line or an arc
  /// One that begins with / and is left out, or is not.
  void skippable();
  void feed_word(Words& words);
  virtual std::string feed_text(double mm_min);
  virtual std::string radius_word(const std::string& number) { return "R" + number; }
  virtual std::string turns_word(int turns) { return "P" + std::to_string(turns); }
  virtual bool has_turns() const { return false; }
  std::string motion_code(int number);
  void mixed_in(Words& words);  // words that do not move
  virtual std::string switch_word() = 0;

  Draws draws_;
  Manners manners_;
  DrawnProgram program_;

  // What the control remembers
  AxisWords at_;        // in the work system
  bool known_ = false;  // all that is used
  bool goes_to_known_place_ = false;
  AxisWords origin_;       // of the work system in the box
  AxisWords shift_;        // G92, G52: added to the words
  double turned_deg_ = 0;  // about Z
  bool centre_absolute_ = false;
  bool inches_ = false;
  bool incremental_ = false;
  Feeds feeds_ = Feeds::per_minute;
  bool feed_stated_ = false;
  bool spindle_ = false;
  nc::Plane plane_ = nc::Plane::xy;
  int motion_ = -1;  // 0 to 3, -1: none
  bool uses_rotary_ = true;
  double reach_mm_ = 40, reach_deg_ = 6;
  bool keeps_at_tool_change_ = true, keeps_at_stop_ = true;

  // How this program is written
  int spacing_ = 0;  // 0: blanks, 1: none, 2: wild
  int case_ = 0;     // 0: upper, 1: lower, 2: mixed
  int numbering_ = 0;
  int number_ = 0;
  bool zeros_in_codes_ = false;
  int expressions_percent_ = 0;
  std::vector<DrawnBlock> blocks_;
};

}  // namespace plumbline::drawn

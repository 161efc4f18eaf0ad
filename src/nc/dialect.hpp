// What a control's language is made of: a table, read from grammar/<name>.toml, compiled into the program.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::nc {

/// Which length a feed per minute is the speed along.
enum class FeedRule : std::uint8_t {
  xyz_first,       // of X Y Z if any of them moves, else of A B C (deg) [RS274/NGC 2.1.2.5]
  all_axes_as_mm,  // of all six, degrees counted as millimetres
  path_group,      // of the axes of the path group
  unknown,         // blocks that mix linear and rotary words are refused
};

/// When inside its block a word is executed.
enum class Order : std::uint8_t { before_motion, with_motion, after_motion };

/// What the interpreter does at a code; the names that the tables use, word for word.
enum class Action : std::uint8_t {
  none,  // not interpreted yet: refused
  rapid,
  feed,
  arc_cw,
  arc_ccw,
  motion_off,
  dwell,
  plane_xy,
  plane_zx,
  plane_yz,
  inches,
  millimetres,
  absolute,
  incremental,
  arc_centre_absolute,
  arc_centre_incremental,
  inverse_time,
  per_minute,
  per_revolution,
  exact_path,
  exact_stop,
  continuous,
  compensation_off,
  work_system,
  set_table,
  set_position,
  clear_position,
  suspend_position,
  restore_position,
  machine_coordinates,
  go_home,
  store_home,
  tool_length,
  tool_length_by_words,
  tool_length_added,
  tool_length_off,
  change_tool,
  set_tool,
  stop,
  end,
  orient_spindle,
  set_output,
  read_input,
  set_analog_output,
  cycle,
  retract_to_start,
  retract_to_r,
  call_program,
  end_program,
  save_modes,
  forget_modes,
  restore_modes,
  save_modes_of_call,
  no_motion,         // changes nothing that motion depends on
  cubic_spline,      // G5
  quadratic_spline,  // G5.1
  nurbs_point,       // G5.2
  nurbs_end,         // G5.3
  synchronised,      // G33
  rigid_tap,         // G33.1
  probe,             // G38.2 to G38.5
  compensation_on,   // G41, G42: refused
  spindle,           // M3, M4, M5
  coolant,           // M7, M8, M9
  override_switch,   // M48 to M53
  feed_word,
  speed_word,
  tool_word,  // F, S and T, which take their turn among the codes
  user_code,  // a code of the machine's builder
};

/// A row of the table of G or M codes.
struct CodeRow {
  int code = 0;         // times ten: G5.1 is 51
  int group = 0;        // modal group: two of one group do not stand in one block
  std::string meaning;  // "feed", "plane_xy", ...: what the interpreter does at it
  std::string words;    // letters that belong to it
  Order order = Order::before_motion;
  Action action = Action::none;  // the meaning, to switch on
  int value = 0;                 // which one of several: of the work systems, of the homes
  std::uint8_t step = 0;         // its turn inside a block
  std::uint32_t word_mask = 0;   // the words, A is bit 0
  bool takes_axes = false;       // the axis words of the block are its own
  bool loses_position = false;   // the axes may stand elsewhere after it
  bool harmless = false;         // may stand behind / without a choice
};

struct Dialect {
  std::string name;
  std::vector<CodeRow> g_codes;  // by code
  std::vector<CodeRow> m_codes;
  FeedRule feed_rule = FeedRule::unknown;
  double feed_rate_min = 0;       // units/min under which length x F is lifted in inverse time mode
  std::size_t line_length = 255;  // characters, the line end not counted
  std::string comment_open = "(";
  std::string comment_close = ")";
  int first_user_m_code = 0, last_user_m_code = -1;  // codes of the machine's builder
  CodeRow feed_row, speed_row, tool_row, user_row;   // the turns of F, S, T and of user M codes
  std::vector<std::int16_t> g_index, m_index;        // code times ten -> place in g_codes, m_codes; -1: none

  const CodeRow* g_code(int times_ten) const;
  const CodeRow* m_code(int times_ten) const;
};

/// The dialects that there are.
std::span<const std::string_view> dialect_names();

/// The dialect of that name. Refuses with nc-unknown-dialect and the list of those that there are.
const Dialect& dialect(std::string_view name);

}  // namespace plumbline::nc

// What a control's language is made of: a table, read from grammar/<name>.toml, compiled into the program.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::nc {

/// Which length a feed per minute is the speed along.
enum class FeedRule : std::uint8_t {
  xyz_first,         // of X Y Z if any of them moves, else of A B C (deg) [RS274/NGC 2.1.2.5]
  all_axes_as_mm,    // of all six, degrees counted as millimetres
  path_group,        // of the axes of the path group
  unknown,           // blocks that mix linear and rotary words are refused
};

/// When inside its block a word is executed.
enum class Order : std::uint8_t { before_motion, with_motion, after_motion };

/// A row of the table of G or M codes.
struct CodeRow {
  int code = 0;           // times ten: G5.1 is 51
  int group = 0;          // modal group: two of one group do not stand in one block
  std::string meaning;    // "feed", "plane_xy", ...: what the interpreter does at it
  std::string words;      // letters that belong to it
  Order order = Order::before_motion;
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

  const CodeRow* g_code(int times_ten) const;
  const CodeRow* m_code(int times_ten) const;
};

/// The dialect of that name. Refuses with nc-unknown-dialect and the list of those that there are.
const Dialect& dialect(std::string_view name);

}  // namespace plumbline::nc

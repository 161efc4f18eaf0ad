#include "nc/language/guard_lines.hpp"

#include <algorithm>
#include <array>

#include "base/text/characters.hpp"

namespace plumbline::nc {
namespace {

bool begins_with_one_of(std::string_view line, const auto& begins) {
  return std::any_of(begins.begin(), begins.end(), [&](std::string_view begin) { return line.starts_with(begin); });
}

// G54 to G59, G500 and their like, alone.
bool chooses_system(std::string_view line) {
  const bool digits = line.size() > 2 && line.size() <= 5 && line.starts_with("G5") &&
                      std::all_of(line.begin() + 2, line.end(), [](char c) { return is_digit(c) || c == '.'; });
  return digits && line >= "G54";
}

bool is_linuxcnc(std::string_view line) {
  constexpr std::array<std::string_view, 4> kBegins{"#<plumbline_", "o<plumbline_", "(MSG, plumbline guard: ", "G43 H"};
  return begins_with_one_of(line, kBegins) || line == "M2" || line == "G49" || line == "G92.2" || line == "G92.3" ||
         chooses_system(line);
}

// An alarm or nothing.
bool is_macro_b(std::string_view line) {
  return line.starts_with("IF [") && line.find("] THEN #3000=101(PLUMBLINE: ") != std::string_view::npos &&
         line.find(')') + 1 == line.size();
}

bool is_sinumerik(std::string_view line) {
  constexpr std::array<std::string_view, 3> kBegins{"IF ABS($P_ACTFRAME[", "IF ABS($AA_IW[", "MSG(\"plumbline guard: "};
  return begins_with_one_of(line, kBegins) || line == "M0" || line == "M30" || line == "ENDIF" ||
         chooses_system(line) || (line.size() == 4 && line.starts_with("G5") && is_digit(line[2]) && is_digit(line[3]));
}

}  // namespace

bool is_guard_line(std::string_view line, std::string_view text, const Dialect& dialect) {
  const std::string_view open = dialect.comment_open;
  const std::string_view close = dialect.comment_close;
  return line.size() == open.size() + text.size() + close.size() && line.starts_with(open) && line.ends_with(close) &&
         std::equal(text.begin(), text.end(), line.begin() + static_cast<std::ptrdiff_t>(open.size()),
                    [](char a, char b) { return upper(a) == upper(b); });
}

bool is_part_of_guard(std::string_view line, const Dialect& dialect) {
  switch (dialect.guard) {
    case GuardLanguage::linuxcnc:
      return is_linuxcnc(line);
    case GuardLanguage::macro_b:
      return is_macro_b(line);
    case GuardLanguage::sinumerik:
      return is_sinumerik(line);
    case GuardLanguage::none:
      break;
  }
  return false;
}

}  // namespace plumbline::nc

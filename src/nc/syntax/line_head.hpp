// What a line begins with, found without parsing it: names of programs, labels, the statements that loops are made of.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "nc/language/dialect.hpp"

namespace plumbline::nc {

struct LineHead {
  std::string program;    // the name of a program that begins here, as program_name gives it
  std::string number;     // N100 as a label
  std::size_t zeros = 0;  // before the digits of that
  std::string label;      // NAME: of a high-level language
  FlowWord word = FlowWord::none;
  int loop = 0;          // the number after DO and END
  bool is_main = false;  // the program, by its name: %_N_NAME_MPF
  bool bare = false;     // nothing behind number and label, of a language with names
  bool empty = false;    // nothing but blanks, a comment, % or what ends files of DOS
  bool behind_slash = false;
};

LineHead head_of(std::string_view line, const Dialect& dialect);

/// True if the line holds M2 or M30, outside its comments.
bool holds_program_end(std::string_view line);

/// Labels and names of programs as they are compared: upper case, numbers without leading zeros.
std::string canonical_label(std::string_view text);
/// How many zeros before its number that leaves out.
std::size_t zeros_of_label(std::string_view text);
std::string canonical_program(std::string_view text);
/// The name of a program as the dialect compares it: canonical_program, but with its zeros where no source says that
/// those before a number are left out (user task 2).
std::string program_name(std::string_view text, const Dialect& dialect);

}  // namespace plumbline::nc

// What the commands that read a program can be told, and how each of it is written: on the command line as
// --work-offset G54=0,0,-1008,0,0,0, in a settings file under the same name with _ for -.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/files/source.hpp"
#include "compensate/settings.hpp"
#include "nc/control/state/program_settings.hpp"
#include "nc/rewrite/output/emit_settings.hpp"

namespace plumbline::settings {

/// What the options name to be read; empty: none.
struct Paths {
  Source model;
  Source tools;
  Source variables;
  std::vector<std::string> settings_files;  // that options come from, the one that counts most first
};

/// A work system by the name under which an offset was given for it.
struct NamedSystem {
  std::string name;
  int number = 0;  // what the name was taken for, 1 the first
  Place stated;    // in a settings file; no file: the command line states it
};

/// What --rotary has said so far, for all axes and for A, B and C each.
struct StatedRotary {
  std::optional<nc::RotaryRule> of_all;
  std::array<std::optional<nc::RotaryRule>, 3> of_axis;
};

struct Options {
  Paths paths;
  std::string machine;                // by its name in a settings file; empty: none was named
  std::vector<std::string> machines;  // that settings files describe
  std::string dialect;                // empty: seen from the program
  std::vector<NamedSystem> offset_systems;
  nc::ProgramSettings program;  // without what the files hold: see program_settings.hpp
  StatedRotary rotary;
  compensate::Settings compensation;
  nc::EmitSettings emit;     // without what the model says of the control
  bool steps_given = false;  // --step-angle or --step-length
  bool guard = false;
  bool undo = false;
  std::string output_pattern;  // of outputs that nobody names; empty: kOutputPattern
};

/// A text that is no value of its option; what() says what is expected.
class OptionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which commands an option belongs to.
enum class OptionGroup : std::uint8_t { program, model, step, bound, compensation };

/// One option. Repeated ones add up.
struct OptionRow {
  std::string_view name;   // without --
  std::string_view value;  // how help names its value; empty: a switch, whose text is "on" or "off"
  std::string_view help;   // help_of() gives it whole
  OptionGroup group;
  bool is_repeatable;
  bool is_path;
  void (*set)(Options& options, std::string_view text);
};

/// All options, in the order in which help lists them.
std::span<const OptionRow> option_rows();
/// What the option does, as help shows it: the names of the dialects come from the list of them.
std::string help_of(const OptionRow& row);
/// Null: there is none of that name.
const OptionRow* find_option(std::string_view name);

/// Sets one option from its text. Throws OptionError: "expected ...", or that it says another thing than was set before
/// for the same work system or axis.
void set_option(Options& options, const OptionRow& row, std::string_view text);

/// "G54" and so on: the name of work system 0..8 as programs write it.
std::string work_system_name(std::size_t system);

/// Six numbers between commas; nothing if it is anything else.
std::optional<std::array<double, kAxes>> six_numbers(std::string_view text);

}  // namespace plumbline::settings

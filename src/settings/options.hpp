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
#include <utility>
#include <vector>

#include "compensate/settings.hpp"
#include "machine/model.hpp"
#include "nc/sequence/program.hpp"

namespace plumbline::settings {

struct Options {
  // What the text of a program alone does not say
  std::string dialect;  // empty: seen from the program
  std::array<std::optional<nc::WorkOffset>, nc::kWorkSystems> work_offsets;
  std::vector<std::pair<std::string, int>>
      work_offset_names;  // as they were given, and which system they were taken for
  std::optional<bool> calculator_type;
  std::optional<double> input_increment;  // mm and deg
  std::optional<nc::FeedRule> feed_rule;
  std::optional<bool> helix_feed_along_circle;
  nc::RotaryRules rotary{};
  nc::FreeRotation free_rotation{};
  std::string tools;  // path of the tool table; empty: none
  std::optional<int> tool_in_spindle;
  std::array<std::optional<double>, kAxes> start;  // mm and deg, in the first work system
  std::string variables;                           // path of a variables file; empty: none
  std::set<int> pass;                              // M codes
  std::set<int> keeps_position;                    // M codes
  std::optional<bool> block_delete;
  int max_blocks = 10'000'000;

  // The machine, and how a program is compensated for it
  std::string model;  // path of the machine model
  compensate::Settings compensation;
  double time_tolerance = 1e-3;  // share of a block's time
  bool guard = false;
  bool undo = false;

  std::string settings_file;  // that some of these come from; empty: none
};

/// A text that is no value of its option; what() says what is expected.
class OptionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which commands an option belongs to.
enum class OptionGroup : std::uint8_t { program, model, step, compensation };

/// One option. Repeated ones add up.
struct OptionRow {
  std::string_view name;   // without --
  std::string_view value;  // how help names its value; empty: a switch, whose text is "on" or "off"
  std::string_view help;
  OptionGroup group;
  bool is_repeatable;
  bool is_path;
  void (*set)(Options& options, std::string_view text);
};

/// All options, in the order in which help lists them.
std::span<const OptionRow> option_rows();
/// Null: there is none of that name.
const OptionRow* find_option(std::string_view name);

/// Sets one option from its text. Throws OptionError: "expected ...".
void set_option(Options& options, const OptionRow& row, std::string_view text);

/// "G54" and so on: the name of work system 0..8 as programs write it.
std::string work_system_name(std::size_t system);

/// Six numbers between commas; nothing if it is anything else.
std::optional<std::array<double, kAxes>> six_numbers(std::string_view text);

/// The settings of the interpreter: tool table and variables file are read here. Refuses as their readers do.
nc::ProgramSettings program_settings(const Options& options);
/// The same for the machine of a model.
nc::ProgramSettings program_settings(const Options& options, const machine::MachineModel& model);

}  // namespace plumbline::settings

#include "nc/control/state/system_parameters.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "nc/control/state/modal_variables.hpp"
#include "nc/control/state/named_parameters.hpp"
#include "nc/control/state/tool_rows.hpp"
#include "nc/language/codes.hpp"
#include "nc/language/refusal.hpp"

namespace plumbline::nc {
namespace {

// Parameters of the control's tables, in the machine's unit (mm, deg) [LinuxCNC, "Parameters"].
constexpr int kHomes = 5161, kHomesEnd = 5190;
constexpr int kG92End = 5220;
constexpr int kActiveSystem = 5220, kSystems = 5221, kSystemsEnd = 5401 - 11;
constexpr int kTool = 5400, kToolEnd = 5413, kPosition = 5420, kPositionEnd = 5429;
constexpr int kRotation = 9;        // in the row of a work system, after X Y Z A B C U V W
constexpr int kToolChanger = 5600;  // and 5601: whether it failed, and why, whatever was set

// Variables of macro B [B-63174EN 13]
constexpr int kClocks = 3001, kClocksEnd = 3002, kDate = 3011, kTime = 3012;
constexpr int kSingleBlock = 3003, kFeedHold = 3004;  // whether stops act: no matter for the path
constexpr int kBlockEnd = 5001, kPositionNow = 5041, kMacroSystems = 5221, kMacroSystemsEnd = 5340;
constexpr int kKept = 500, kKeptEnd = 999;  // permanent common variables: the power may be off between
bool is_common(int number) { return (number >= 100 && number <= 199) || (number >= kKept && number <= kKeptEnd); }

// The numbers between the rows (#5170 to #5180, #5231 to #5240 and so on) are free: tool changers keep pockets in them.
bool is_in_row(int number, int first, int last, int used) {
  return number >= first && number <= last && (number - first) % kParametersPerRow < used;
}

bool is_of_tables(int number) {
  return is_in_row(number, kHomes, kHomesEnd, kRotation) || (number >= kG92InForce && number <= kActiveSystem) ||
         is_in_row(number, kSystems, kSystemsEnd, kRotation + 1) || (number >= kTool && number <= kToolEnd) ||
         (number >= kPosition && number < kPositionEnd);
}

// The axis of a number of a row that begins with X here; none: not one of it.
std::optional<Axis> axis_in_row(int number, int first) {
  const int at = number - first;
  if (at < 0 || at >= static_cast<int>(kAxes)) return std::nullopt;
  return kAllAxes[static_cast<std::size_t>(at)];
}

// The zero of an axis in one of the work systems, as macro B numbers them; none: another variable.
struct MacroOrigin {
  std::size_t system = 0;
  Axis axis = Axis::X;
};
std::optional<MacroOrigin> macro_origin(int number) {
  if (number < kMacroSystems || number > kMacroSystemsEnd) return std::nullopt;
  const int system = (number - kMacroSystems) / kParametersPerRow;
  const std::optional<Axis> axis = axis_in_row(number, kMacroSystems + system * kParametersPerRow);
  return axis ? std::optional(MacroOrigin{static_cast<std::size_t>(system), *axis}) : std::nullopt;
}

// Where the axis stands, in mm or deg.
std::optional<double> place(const Control& control, Axis axis) {
  return control.known.contains(axis) ? std::optional(control.position[axis]) : std::nullopt;
}

}  // namespace

std::string way_to_position(const Control& control) {
  const bool probed = control.parameters.has(kProbeSuccess) && !control.parameters.get(kProbeSuccess).known;
  if (!probed) return "move the axis to a programmed position first, or say where the axes start: --start";
  return "what the probe finds only the machine knows, and corrections depend on it: probe and set the offset in a "
         "program of its own, which is not compensated, and compensate what stands behind it with the offset that came "
         "out (--work-offset, --variables)";
}

ParameterLimits SystemParameters::limits() const {
  const Syntax& syntax = dialect_.syntax;
  const bool from_one =
      syntax.system_variables == SystemVariables::rs274 || syntax.statements == Statements::user_task;  // VC1
  return {from_one ? 1 : 0, syntax.last_variable};
}

bool SystemParameters::is_read_only(int number) const {
  const Syntax& syntax = dialect_.syntax;
  if (syntax.system_variables == SystemVariables::macro_b) {
    const bool free = (number >= 1 && number <= syntax.local_variables) || is_common(number);
    return !free && number != kSingleBlock && number != kFeedHold && number != syntax.alarm_variable &&
           number != syntax.message_variable;
  }
  return syntax.system_variables == SystemVariables::rs274 && is_of_tables(number);
}

bool SystemParameters::is_lasting(int number) const {
  const Syntax& syntax = dialect_.syntax;
  return syntax.last_lasting > 0 && number >= syntax.first_lasting && number <= syntax.last_lasting;
}

bool SystemParameters::goes_to_next_pass(int number) const {
  if (dialect_.syntax.system_variables == SystemVariables::none || number == 0 || is_read_only(number)) return false;
  return number > dialect_.syntax.local_variables || control_.parameters.numbers_are_of_main();
}

bool SystemParameters::is_kept(int number) const {
  return dialect_.syntax.system_variables == SystemVariables::macro_b &&
         ((number >= kKept && number <= kKeptEnd) || number == kSingleBlock || number == kFeedHold);
}

bool SystemParameters::is_read_only(std::string_view name) {
  if (dialect_.syntax.system_variables == SystemVariables::none) return false;
  return is_predefined(control_.parameters.plain(name));
}

// Names that begin with _ are kept from program to program, and those of the INI file and of HAL are the machine's.
Value SystemParameters::exists(const Block& block, std::string_view name, Span span) {
  if (is_made(block, std::string(control_.parameters.plain(name)), span)) return {1, true};
  if (is_read_only(name) || control_.parameters.find(name) != nullptr) return {1, true};
  const bool global = control_.parameters.plain(name).starts_with('_');
  return {0, !global || settings_.as_with_empty_tables};
}

Value SystemParameters::position(const Block& block, Axis axis, Span span) const {
  // Macro B reads where the axes are while they move; RS274/NGC where the program has put them, which a rewritten
  // program holds as a value.
  const bool programmed = dialect_.syntax.system_variables == SystemVariables::rs274;
  if (!programmed && !settings_.as_with_empty_tables && !settings_.position_may_be_read) {
    refuse_at(block, span, codes::kPositionRead, "the program reads where the control stands",
              "that changes when the program is compensated; write the position itself");
  }
  if (!control_.known.contains(axis)) {
    refuse_at(block, span, codes::kPositionUnknown, fmt::format("where {} stands is not known", letter(axis)),
              way_to_position(control_));
  }
  control_.position_read = true;
  return {control_.position_in_unit(axis), true};
}

// What the control's display shows: all offsets, the rotation and the tool's length in it.
Value SystemParameters::machine_position(const Block& block, Axis axis, Span span) const {
  const AxisWords& tool = control_.frame.tool;
  if (tool != AxisWords{} && control_.tool_in_inches != control_.modal.inches) {
    refuse_at(block, span, codes::kNotInterpreted, "the control takes the tool length in force for one in the new unit",
              "write G49 before the change of units (G20, G21) and G43 after it");
  }
  const AxisSet mixed = control_.frame.mixed();
  for (const Axis other : kAllAxes) {
    if (mixed.contains(axis) && mixed.contains(other) && other != axis) position(block, other, span);
  }
  position(block, axis, span);
  const double value = control_.frame.to_machine(control_.position)[axis];
  return {is_rotary(axis) ? value : value / control_.length_unit(), true};
}

// A value of the tables, if somebody gave it.
std::optional<double> SystemParameters::table_value(const Control& control, int number) const {
  const auto of = [](const AxisWords& words, int at) {
    return at < static_cast<int>(kAxes) ? words.values[static_cast<std::size_t>(at)] : 0.0;
  };
  const auto known = [](AxisSet set, int at) {
    return at >= static_cast<int>(kAxes) || set.contains(kAllAxes[static_cast<std::size_t>(at)]);
  };
  if (number >= kHomes && number <= kHomesEnd) {
    const Home& home = control.homes[static_cast<std::size_t>((number - kHomes) / kParametersPerRow)];
    const int at = (number - kHomes) % kParametersPerRow;
    return known(home.known, at) ? std::optional(of(home.machine, at)) : std::nullopt;
  }
  if (number < kG92End && !control.g92.known) return std::nullopt;
  if (number == kG92InForce) return control.g92.applied.value_or(false) ? 1 : 0;
  if (number < kG92End) return of(control.g92.suspended, number - kG92InForce - 1);
  if (number == kActiveSystem) return control.modal.work_system;
  if (number <= kSystemsEnd) {
    const WorkSystem& row = control.systems[static_cast<std::size_t>((number - kSystems) / kParametersPerRow)];
    const int at = (number - kSystems) % kParametersPerRow;
    if (at == kRotation) return row.known.empty() ? std::nullopt : std::optional(row.rotation_deg);
    return known(row.known, at) ? std::optional(of(row.origin, at)) : std::nullopt;
  }
  return number <= kToolEnd ? tool_parameter(control, settings_, number) : std::optional(0.0);
}

std::optional<double> SystemParameters::shown(const Control& control, int number) const {
  if (dialect_.syntax.system_variables == SystemVariables::rs274) {
    if (const std::optional<Axis> axis = axis_in_row(number, kPosition)) return place(control, *axis);
    return is_of_tables(number) ? table_value(control, number) : std::nullopt;
  }
  if (const std::optional<Axis> axis = axis_in_row(number, kBlockEnd)) return place(control, *axis);
  if (const std::optional<Axis> axis = axis_in_row(number, kPositionNow)) return place(control, *axis);
  if (const std::optional<MacroOrigin> origin = macro_origin(number)) {
    const WorkSystem& row = control.systems[origin->system];
    return row.known.contains(origin->axis) ? std::optional(row.origin[origin->axis]) : std::nullopt;
  }
  const std::optional<Value> modal = modal_variable(control, number);
  return modal ? std::optional(modal->number) : std::nullopt;
}

std::optional<double> SystemParameters::shown(const Control& control, std::string_view plain) const {
  if (const std::optional<Axis> axis = position_named(plain)) return place(control, *axis);
  if (const std::optional<Axis> axis = machine_position_named(plain)) {
    return control.known.contains(*axis) ? std::optional(control.frame.to_machine(control.position)[*axis])
                                         : std::nullopt;
  }
  if (plain == "_current_tool") return table_value(control, kTool);
  const std::optional<Value> value = predefined(control, settings_, plain);
  return value && value->known ? std::optional(value->number) : std::nullopt;
}

void SystemParameters::note_read(int number) {
  if (found_.contains(number)) return;
  const std::optional<double> value = shown(control_, number);
  if (value && value == shown(at_start_, number)) found_.emplace(number, *value);
}

void SystemParameters::note_read(std::string_view plain) {
  if (found_named_.contains(plain)) return;
  const std::optional<double> value = shown(control_, plain);
  if (value && value == shown(at_start_, plain)) found_named_.emplace(plain, *value);
}

std::string SystemParameters::changed_since_read() const {
  for (const auto& [number, value] : found_) {
    if (shown(control_, number) != value) return fmt::format("#{}", number);
  }
  for (const auto& [name, value] : found_named_) {
    if (shown(control_, name) != value) return fmt::format("#<{}>", name);
  }
  return {};
}

Value SystemParameters::unset(const Block& block, Span span) const {
  if (settings_.as_with_empty_tables) return {0, true, true};
  refuse_at(block, span, codes::kParameterUnset, fmt::format("{} was never given a value", block.at(span)),
            "set it in the program before, or give the control's variables: --variables FILE");
}

void refuse_of_other_program(const Block& block, Span span, std::string_view name) {
  refuse_at(
      block, span, codes::kParameterUnset,
      fmt::format("{} is a variable of another program, and is not known in this one", name),
      fmt::format("hand it over: PROC NAME(REAL {0}) here, and NAME({0}) where this program is called; or keep it "
                  "in an R parameter",
                  name));
}

// Also where tables that are not given count as zero: a name that the control does not know is a slip.
void SystemParameters::refuse_undeclared(const Block& block, Span span, std::string_view name) const {
  if (control_.parameters.was_local_elsewhere(name)) refuse_of_other_program(block, span, name);
  refuse_at(block, span, codes::kParameterUnset, fmt::format("{} was never given a value", block.at(span)),
            "declare it with DEF, and set it before");
}

void SystemParameters::refuse_left_over(const Block& block, Span span) {
  refuse_at(
      block, span, codes::kNotInterpreted,
      fmt::format("{} was set by the call before of the same block: whether it begins anew with each of them was "
                  "found in no source",
                  block.at(span)),
      "set it at the begin of what is called, count in a common variable, or write each call in a block of its own");
}

// A local variable that was not set is vacant; a common one may hold what another program left there.
Value SystemParameters::read_macro_variable(const Block& block, int number, Span span) const {
  if (number == 0) return {0, true, true};
  if (control_.parameters.is_left_over(number)) refuse_left_over(block, span);
  if (control_.parameters.has(number)) return control_.parameters.get(number);
  if (number <= dialect_.syntax.local_variables) return {0, true, true};
  if (is_common(number)) return unset(block, span);
  if ((number >= kClocks && number <= kClocksEnd) || number == kDate || number == kTime) return {0, false};
  if (const std::optional<Axis> axis = axis_in_row(number, kBlockEnd)) return position(block, *axis, span);
  if (const std::optional<Axis> axis = axis_in_row(number, kPositionNow)) {
    if (!is_rotary(*axis) && control_.frame.tool != AxisWords{}) {
      refuse_at(
          block, span, codes::kNotInterpreted,
          fmt::format("#{} is a position with the tool's length in it, which is in force here and not interpreted",
                      number),
          fmt::format("read #{}, the end of the block before without it, or write G49 before",
                      number - kPositionNow + kBlockEnd));
    }
    return position(block, *axis, span);
  }
  if (const std::optional<MacroOrigin> origin = macro_origin(number)) {
    const std::optional<double> value = shown(control_, number);
    if (!value) return unset(block, span);
    return {is_rotary(origin->axis) ? *value : *value / control_.length_unit(), true};
  }
  if (const std::optional<Value> shown = modal_variable(control_, number)) {
    control_.position_read = true;  // arcs become lines, and F another one
    return *shown;
  }
  refuse_unread_variable(block, number, span);
}

Value SystemParameters::read(const Block& block, int number, Span span) {
  const SystemVariables own = dialect_.syntax.system_variables;
  if (is_lasting(number)) control_.handed.note_read(number);
  if (goes_to_next_pass(number)) control_.of_main.note_read(number);
  if (is_read_only(number)) note_read(number);
  if (own == SystemVariables::macro_b) return read_macro_variable(block, number, span);
  if (own == SystemVariables::none) {
    if (control_.parameters.has(number)) return control_.parameters.get(number);
    const Value value = unset(block, span);
    return {value.number, value.known};  // zero, and not vacant as in macro B
  }
  if (number >= kToolChanger) return {0, settings_.as_with_empty_tables};
  if (const std::optional<Axis> axis = axis_in_row(number, kPosition)) {
    return position(block, *axis, span);
  }
  if (is_read_only(number)) {
    if (const std::optional<double> value = table_value(control_, number)) return {*value, true};
  } else if (control_.parameters.has(number)) {
    return control_.parameters.get(number);
  }
  if (settings_.as_with_empty_tables) return {0, true};
  const bool of_tool = number >= kTool && number <= kToolEnd;
  if (of_tool && control_.modal.tool_in_spindle < 0) {
    refuse_at(block, span, codes::kToolUnknown, "which tool is in the spindle is not known",
              "put T and M6 before it, or say which it is: --tool-in-spindle");
  }
  if (of_tool) {
    refuse_at(block, span, codes::kToolUnknown,
              fmt::format("#{} of tool {} was never given", number, control_.modal.tool_in_spindle),
              "add the tool and its diameter_mm to a tool table (--tools), or set it with G10 L1");
  }
  refuse_at(block, span, codes::kParameterUnset, fmt::format("#{} was never given a value", number),
            "set it in the program before, or give the control's variables: --variables FILE");
}

// The control makes a name, with 0, where it reads it in front of a "=": the first #<i>=[#<i>+1] sets 1
// [interp_read.cc].
bool SystemParameters::is_made(const Block& block, std::string_view plain, Span span) {
  for (const Setting& setting : block.settings) {
    if (setting.target != kLiteral || setting.span.begin >= span.begin) continue;
    if (std::string(control_.parameters.plain(block.at(block.names[setting.name]))) == plain) return true;
  }
  return false;
}

namespace {

// LX=7 in a subprogram, X=LX behind its CALL. What a CALL hands over ends with it, since macros ask whether they were
// handed it: IF [PX EQ EMPTY] [O].
[[noreturn]] void refuse_unclear_scope(const Block& block, Span span) {
  refuse_at(
      block, span, codes::kNotInterpreted,
      fmt::format("{} was set last in another program, which calls this one or was called: whether a program and "
                  "its subprograms share their local variables was found in no source",
                  block.at(span)),
      "set it here before it is read, hand it over as in CALL O10 PX=5, or write VC1 to VC200, which all programs "
      "share");
}

[[noreturn]] void refuse_of_caller(const Block& block, Span span) {
  refuse_at(
      block, span, codes::kParameterUnset,
      fmt::format("{} is a parameter of this program: a program that calls it gives its value, and none does here",
                  block.at(span)),
      "compensate the program that calls this one, or set it here before it is read");
}

}  // namespace

Value SystemParameters::read(const Block& block, std::string_view name, Span span) {
  if (control_.parameters.is_left_over(name)) refuse_left_over(block, span);
  if (control_.parameters.depends_on_scope(name)) refuse_unclear_scope(block, span);
  if (const Value* value = control_.parameters.find(name)) {
    if (value->of_caller && !settings_.as_with_empty_tables) refuse_of_caller(block, span);
    return *value;
  }
  if (dialect_.syntax.empty_names) return {0, true, true};
  if (dialect_.syntax.declared) refuse_undeclared(block, span, name);
  if (dialect_.syntax.system_variables == SystemVariables::none) return unset(block, span);
  const std::string plain(control_.parameters.plain(name));
  note_read(plain);
  if (const std::optional<Axis> axis = position_named(plain)) return position(block, *axis, span);
  if (const std::optional<Axis> axis = machine_position_named(plain)) return machine_position(block, *axis, span);
  if (plain == "_current_tool") return read(block, kTool, span);
  if (const std::optional<Value> value = predefined(control_, settings_, plain)) {
    control_.position_read = control_.position_read || is_rewritten(plain);
    return *value;
  }
  if (plain == "_line") return {static_cast<double>(block.line), settings_.as_with_empty_tables};  // of the text
  if (plain == "_call_level") return {static_cast<double>(control_.parameters.depth()), true};
  if (is_made(block, plain, span) && (!plain.starts_with('_') || settings_.as_with_empty_tables)) return {0, true};
  if (control_.parameters.was_local_elsewhere(plain)) {
    refuse_at(
        block, span, codes::kParameterUnset,
        fmt::format("#<{}> has no value here: each subprogram, and the program itself, has names of its own", plain),
        fmt::format("call it #<_{}> where it is set and where it is read: names with _ are seen everywhere", plain));
  }
  if (plain.starts_with("_hal[") || plain.starts_with("_ini[")) {
    refuse_at(block, span, codes::kParameterUnset,
              fmt::format("{} is a value of the machine ({}), which is not known here", block.at(span),
                          plain.starts_with("_hal[") ? "a pin of its HAL" : "an entry of its INI file"),
              "write the value itself into the program");
  }
  refuse_at(block, span, codes::kParameterUnset, fmt::format("#<{}> has no value here", plain),
            "set it in the program before it is read");
}

}  // namespace plumbline::nc

#include "settings/options.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/text/characters.hpp"
#include "base/text/nearest_name.hpp"
#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "nc/language/dialect.hpp"
#include "settings/output_name.hpp"

namespace plumbline::settings {
namespace {

constexpr double kLargestWord = 1e6;  // of an axis, mm and deg

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

// Calls `take` with each part between commas.
template <class Take>
void each_part(std::string_view text, const Take& take) {
  while (true) {
    const std::size_t comma = text.find(',');
    take(trimmed(text.substr(0, comma)));
    if (comma == std::string_view::npos) return;
    text.remove_prefix(comma + 1);
  }
}

double number_in(std::string_view text, double lower, double upper, std::string_view expected) {
  const std::optional<double> value = parse_number(trimmed(text));
  if (!value || *value < lower || *value > upper) throw OptionError(fmt::format("expected {}", expected));
  return *value;
}

int whole_number_in(std::string_view text, int lower, int upper, std::string_view expected) {
  const double value = number_in(text, lower, upper, expected);
  if (value != static_cast<int>(value)) throw OptionError(fmt::format("expected {}", expected));
  return static_cast<int>(value);
}

bool is_first(std::string_view text, std::string_view first, std::string_view second) {
  if (text == first) return true;
  if (text == second) return false;
  throw OptionError(fmt::format("expected {} or {}", first, second));
}
bool on_or_off(std::string_view text) { return is_first(text, "on", "off"); }

nc::FeedRule feed_rule_in(std::string_view text) {
  if (text == "xyz") return nc::FeedRule::xyz_first;
  if (text == "all") return nc::FeedRule::all_axes_as_mm;
  if (text == "unknown") return nc::FeedRule::unknown;
  throw OptionError("expected xyz, all or unknown");
}

nc::FreeRotation free_rotation_in(std::string_view text) {
  if (text == "c-stays") return nc::FreeRotation::c_stays;
  if (text == "c-zero") return nc::FreeRotation::c_zero;
  throw OptionError("expected c-stays or c-zero");
}

// What is said once more is no matter; another thing for the same leaves open which is meant.
template <class Value>
void set_once(std::optional<Value>& into, const Value& value, std::string_view what) {
  if (into && *into != value)
    throw OptionError(fmt::format("{} is given twice, and not the same: leave one of them", what));
  into = value;
}

// sign, or A=sign,C=shortest. A rule for all leaves the axes alone that have one of their own.
void set_rotary(Options& options, std::string_view text) {
  constexpr std::string_view kExpected =
      "expected linear, sign, shortest or one-turn, for one axis as in C=sign, several between commas";
  constexpr std::array<std::string_view, 4> kRules{"linear", "sign", "shortest", "one-turn"};
  each_part(text, [&](std::string_view part) {
    const std::size_t equals = part.find('=');
    const std::string_view name = equals == std::string_view::npos ? part : trimmed(part.substr(equals + 1));
    const auto* const rule = std::find(kRules.begin(), kRules.end(), name);
    if (rule == kRules.end()) throw OptionError(std::string(kExpected));
    const auto value = static_cast<nc::RotaryRule>(rule - kRules.begin());
    if (equals == std::string_view::npos) {
      set_once(options.rotary.of_all, value, "the rule for all axes");
      return;
    }
    const std::string axis_name = upper(trimmed(part.substr(0, equals)));
    const std::optional<Axis> axis = axis_name.size() == 1 ? axis_of(axis_name.front()) : std::nullopt;
    if (!axis || !is_rotary(*axis)) throw OptionError(std::string(kExpected));
    set_once(options.rotary.of_axis[index(*axis) - 3], value, axis_name);
  });
  for (std::size_t i = 0; i < options.program.rotary.size(); ++i) {
    options.program.rotary[i] = options.rotary.of_axis[i].value_or(options.rotary.of_all.value_or(nc::RotaryRule{}));
  }
}

void add_m_codes(std::set<int>& codes, std::string_view text) {
  constexpr std::string_view kExpected = "M codes between commas, as in M428,M429";
  each_part(text, [&](std::string_view part) {
    if (part.empty() || (part.front() != 'M' && part.front() != 'm')) {
      throw OptionError(fmt::format("expected {}", kExpected));
    }
    codes.insert(whole_number_in(part.substr(1), 0, 9999, kExpected));
  });
}

// What no machine is large enough for is a slip of units.
template <class Values>
void refuse_absurd(const Values& values) {
  if (std::any_of(values.begin(), values.end(), [](double x) { return std::abs(x) > kLargestWord; })) {
    throw OptionError(fmt::format("expected numbers of {:.0f} at most, in mm and deg", kLargestWord));
  }
}

std::array<double, kAxes> pose_in(std::string_view text) {
  const auto values = six_numbers(text);
  if (!values) throw OptionError("expected six numbers X,Y,Z,A,B,C in mm and deg");
  refuse_absurd(*values);
  return *values;
}

// Of the first dialect that has a work system of this name; 0: none has.
int system_of(const std::string& name) {
  for (const std::string_view dialect : nc::dialect_names()) {
    if (const int system = nc::dialect(dialect).system_of_name(name); system > 0) return system;
  }
  return 0;
}

void set_work_offset(Options& options, std::string_view text) {
  constexpr std::string_view kExpected =
      "expected SYSTEM=X,Y,Z,A,B,C with six numbers in mm and deg, as in G54=0,0,-1008,0,0,0; systems are G54 to G59 "
      "and, by dialect, G59.1 to G59.3, G54.1P1 to G54.1P300, G15H1 to G15H200, G500, G505 to G599";
  const std::size_t equals = text.find('=');
  std::string name = upper(trimmed(text.substr(0, equals)));
  std::erase(name, ' ');
  if (name.size() > 1 && name.front() == 'H') name.insert(0, "G15");
  const int system = system_of(name);
  if (system == 0 && name.starts_with("G15H")) {
    throw OptionError(fmt::format("there is no work system {}: an Okuma OSP has G15H1 to G15H200", name));
  }
  if (equals == std::string_view::npos || system == 0) throw OptionError(std::string(kExpected));
  const auto values = six_numbers(text.substr(equals + 1));
  if (!values) throw OptionError(std::string(kExpected));
  refuse_absurd(*values);
  set_once(options.program.work_offsets[static_cast<std::size_t>(system - 1)], nc::WorkOffset{{*values}, 0}, name);
  options.offset_systems.push_back({name, system, {}});
}

void set_start(Options& options, std::string_view text) {
  constexpr std::string_view kExpected =
      "expected six numbers X,Y,Z,A,B,C in mm and deg, or those of some axes as in A=0,B=0,C=0";
  if (const auto values = six_numbers(text)) {
    refuse_absurd(*values);
    for (const Axis axis : kAllAxes)
      set_once(options.program.start[index(axis)], (*values)[index(axis)], std::string(1, letter(axis)));
    return;
  }
  each_part(text, [&](std::string_view part) {
    const std::optional<Axis> axis = part.empty() ? std::nullopt : axis_of(upper(part.substr(0, 1)).front());
    if (!axis) throw OptionError(std::string(kExpected));
    std::string_view value = trimmed(part.substr(1));
    if (!value.empty() && value.front() == '=') value.remove_prefix(1);
    const std::optional<double> number = parse_number(trimmed(value));
    if (!number) throw OptionError(std::string(kExpected));
    refuse_absurd(std::array{*number});
    set_once(options.program.start[index(*axis)], *number, std::string(1, letter(*axis)));
  });
}

// 0.5um or 0.0005mm: a length whose unit is left out is a slip of a thousand.
double length_mm_in(std::string_view text, double lower_mm, double upper_mm, std::string_view expected) {
  constexpr std::array<std::pair<std::string_view, double>, 2> kUnits{{{"um", kUm / kMm}, {"mm", 1.0}}};
  const std::string_view whole = trimmed(text);
  for (const auto& [unit, mm] : kUnits) {
    if (!whole.ends_with(unit)) continue;
    const std::optional<double> value = parse_number(trimmed(whole.substr(0, whole.size() - unit.size())));
    if (value && *value * mm >= lower_mm && *value * mm <= upper_mm) return *value * mm;
  }
  throw OptionError(fmt::format("expected {}", expected));
}

compensate::BoundSettings::Yields yields_in(std::string_view text) {
  if (text == "bound") return compensate::BoundSettings::Yields::bound;
  if (text == "time") return compensate::BoundSettings::Yields::time;
  throw OptionError("expected bound or time");
}

void set_dialect(Options& options, std::string_view text) {
  const auto names = nc::dialect_names();
  if (std::find(names.begin(), names.end(), text) == names.end()) {
    const std::string_view nearest = nearest_name(text, {names.begin(), names.end()});
    throw OptionError(fmt::format("expected one of {}{}", fmt::join(names, ", "),
                                  nearest.empty() ? "" : fmt::format(": did you mean {}?", nearest)));
  }
  options.dialect = text;
}

void set_output_pattern(Options& options, std::string_view text) {
  check_output_pattern(text);
  options.output_pattern = text;
}

void set_touch_off(Options& options, std::string_view text) { options.compensation.touch_off = {pose_in(text)}; }

using Text = std::string_view;

constexpr std::string_view kDialects = "{dialects}";  // of a help

constexpr std::array kRows{
    OptionRow{"dialect", "NAME", "language of the program: {dialects} (default: as its text shows)",
              OptionGroup::program, false, false, set_dialect},
    OptionRow{"unit", "mm|inch",
              "linuxcnc, fanuc: the unit in force when a program begins that states neither G20 nor G21 (default: mm)",
              OptionGroup::program, false, false,
              [](Options& o, Text t) { o.program.inches = !is_first(t, "mm", "inch"); }},
    OptionRow{
        "calculator-type", "on|off",
        "fanuc: a number without a point counts mm, inches and degrees (on) or increments of the control (off, the "
        "default)",
        OptionGroup::program, false, false, [](Options& o, Text t) { o.program.calculator_type = on_or_off(t); }},
    OptionRow{"input-increment", "MM",
              "fanuc, okuma: what a number without a point counts, mm and deg (default: fanuc 0.001, okuma 1)",
              OptionGroup::program, false, false,
              [](Options& o, Text t) { o.program.input_increment = number_in(t, 1e-5, 1, "mm, 0.00001 to 1"); }},
    OptionRow{
        "feed-rule", "xyz|all|unknown",
        "F of a block that moves X, Y, Z and turns is the speed of X, Y, Z alone, or of all axes with degrees as mm "
        "(default: the dialect's)",
        OptionGroup::program, false, false, [](Options& o, Text t) { o.program.feed_rule = feed_rule_in(t); }},
    OptionRow{"helix-feed", "circle|path",
              "F of an arc beside which another axis moves is the speed along its circle, or along the whole path "
              "(default: the dialect's: fanuc circle, the others path)",
              OptionGroup::program, false, false,
              [](Options& o, Text t) { o.program.helix_feed_along_circle = is_first(t, "circle", "path"); }},
    OptionRow{"rotary", "sign|shortest|one-turn",
              "how absolute words of A, B and C count on axes that turn without end, or of one as C=sign; repeatable "
              "(default: "
              "linear)",
              OptionGroup::program, true, false, set_rotary},
    OptionRow{"free-rotation", "c-stays|c-zero",
              "what the control does with C where a program gives the direction of the tool alone (G68.2 with G53.1, "
              "CYCLE800, tool vectors): C stays where it stands, or goes to zero (default: such programs are refused)",
              OptionGroup::program, false, false,
              [](Options& o, Text t) { o.program.free_rotation = free_rotation_in(t); }},
    OptionRow{"work-offset", "G54=X,Y,Z,A,B,C",
              "where a work system's zero lies in the base frame W, mm and deg; named as the control does: G54 to G59, "
              "G59.1 to G59.3, G54.1P1, G15H1, G505; repeatable",
              OptionGroup::program, true, false, set_work_offset},
    OptionRow{"tools", "FILE", "tool table: length and diameter in mm, mass in kg", OptionGroup::program, false, true,
              [](Options& o, Text t) { o.paths.tools = std::string(t); }},
    OptionRow{"tool-in-spindle", "N", "number of the tool that is in the spindle at the start", OptionGroup::program,
              false, false,
              [](Options& o, Text t) {
                o.program.tool_in_spindle = whole_number_in(t, 0, 99999, "a tool number, 0 to 99999");
              }},
    OptionRow{"start", "X,Y,Z,A,B,C",
              "where the axes stand at the start, mm and deg, in the work system then active; "
              "some of them alone as A=0,B=0,C=0",
              OptionGroup::program, false, false, set_start},
    OptionRow{"variables", "FILE",
              "variables of the control, a line #NUMBER VALUE or NUMBER VALUE for each (a .var file); lengths in mm",
              OptionGroup::program, false, true, [](Options& o, Text t) { o.paths.variables = std::string(t); }},
    OptionRow{"pass", "M428,...", "M codes of the machine's builder that go through as they stand; repeatable",
              OptionGroup::program, true, false, [](Options& o, Text t) { add_m_codes(o.program.passed_m_codes, t); }},
    OptionRow{"keeps-position", "M6,...", "M codes after which the axes stand where they stood; repeatable",
              OptionGroup::program, true, false, [](Options& o, Text t) { add_m_codes(o.program.keeps_position, t); }},
    OptionRow{"block-delete", "on|off", "whether blocks that begin with / are left out (on) or executed (off)",
              OptionGroup::program, false, false, [](Options& o, Text t) { o.program.block_delete = on_or_off(t); }},
    OptionRow{"max-blocks", "N", "lines that a program with loops or subprograms may execute (default 10000000)",
              OptionGroup::program, false, false,
              [](Options& o, Text t) {
                o.program.max_blocks = static_cast<std::uint64_t>(
                    whole_number_in(t, 1, 2'000'000'000, "a number of lines, 1 to 2000000000"));
              }},
    OptionRow{"model", "MODEL", "the machine's model file", OptionGroup::model, false, true,
              [](Options& o, Text t) { o.paths.model = std::string(t); }},
    OptionRow{"step-angle", "DEG", "largest angle of a piece: of arc, or of the turn of the tool (default 0.1 deg)",
              OptionGroup::step, false, false,
              [](Options& o, Text t) {
                o.compensation.step.angle_deg = number_in(t, 1e-3, 90, "an angle in deg, 0.001 to 90");
                o.steps_given = true;
              }},
    OptionRow{"step-length", "MM", "largest length of a piece (default 1 mm)", OptionGroup::step, false, false,
              [](Options& o, Text t) {
                o.compensation.step.length_mm = number_in(t, 1e-3, 1e4, "a length in mm, 0.001 to 10000");
                o.steps_given = true;
              }},
    OptionRow{"tolerance", "LENGTH",
              "choose points by a bound instead of the steps: as few as keep the deformed tip within it of the "
              "programmed path everywhere, as 0.5um or 0.0005mm; its orientation within it over 100 mm",
              OptionGroup::bound, false, false,
              [](Options& o, Text t) {
                o.compensation.bound.tolerance_mm =
                    length_mm_in(t, 1e-5, 10, "a length with its unit, 0.01um to 10mm, as 0.5um or 0.0005mm");
              }},
    OptionRow{"yields", "bound|time",
              "with --tolerance, what gives way where it asks for blocks shorter than the control's block_time_ms "
              "(1 ms where the model states none): the bound (default), or the time, down to a twentieth",
              OptionGroup::bound, false, false, [](Options& o, Text t) { o.compensation.bound.yields = yields_in(t); }},
    OptionRow{"no-friction", "", "leave friction out of the model", OptionGroup::step, false, false,
              [](Options& o, Text t) { o.compensation.friction = !on_or_off(t); }},
    OptionRow{
        "friction-turn", "SHARE",
        "speed at which the friction of a strut that turns around has turned, as a share of the feed (default 0.01); "
        "less puts the correction nearer to the reversal, in a steeper path",
        OptionGroup::step, false, false,
        [](Options& o, Text t) {
          o.compensation.sign_width_of_feed = number_in(t, 0, 1, "a share of the feed, 0 to 1");
        }},
    OptionRow{"dynamic", "",
              "put inertia and the following error of the drives into the model, as if the control held the programmed "
              "feed everywhere",
              OptionGroup::step, false, false, [](Options& o, Text t) { o.compensation.dynamic = on_or_off(t); }},
    OptionRow{"at-time", "SECONDS",
              "when the program runs, on the clock of the measurements (time_s): for what drifts with time (default 0)",
              OptionGroup::step, false, false,
              [](Options& o, Text t) { o.compensation.time_s = number_in(t, 0, 1e7, "seconds, 0 to 10000000"); }},
    OptionRow{"first-order", "", "subtract the error instead of solving for it: leaves tens of um near singular poses",
              OptionGroup::compensation, false, false,
              [](Options& o, Text t) {
                o.compensation.method = on_or_off(t) ? compensate::Method::first_order : compensate::Method::exact;
              }},
    OptionRow{"touch-off", "X,Y,Z,A,B,C",
              "pose of the tool tip in W, mm and deg, at which the work offset was probed; its error is added",
              OptionGroup::compensation, false, false, set_touch_off},
    OptionRow{"time-tolerance", "SHARE",
              "share of a block's time that may change before its F is written anew (default 0.001)",
              OptionGroup::compensation, false, false,
              [](Options& o, Text t) { o.emit.time_tolerance = number_in(t, 0, 1, "a share of the time, 0 to 1"); }},
    OptionRow{
        "cycle-tolerance", "MM",
        "what the correction may vary along a hole of G74, G84, G86, G87 or G88, which stay cycles (default 0.005 mm)",
        OptionGroup::compensation, false, false,
        [](Options& o, Text t) { o.compensation.cycle_tolerance_mm = number_in(t, 0, 100, "mm, 0 to 100"); }},
    OptionRow{"guard", "",
              "put a block at the start that stops the control when its offsets differ from those given here",
              OptionGroup::compensation, false, false, [](Options& o, Text t) { o.guard = on_or_off(t); }},
    OptionRow{"no-read-back", "", "do not read the output again and hold it against what was meant",
              OptionGroup::compensation, false, false,
              [](Options& o, Text t) { o.compensation.read_back = !on_or_off(t); }},
    OptionRow{"output-name", "PATTERN",
              "how the output is named where -o does not say: {folder}, {name} and {ext} are those of the program, "
              "{machine} is the machine's name (default {folder}/{name}_straight{ext})",
              OptionGroup::compensation, false, true, set_output_pattern},
    OptionRow{"undo", "", "write OUTPUT.undo too, from which restore gives the original back",
              OptionGroup::compensation, false, false, [](Options& o, Text t) { o.undo = on_or_off(t); }},
};

}  // namespace

std::span<const OptionRow> option_rows() { return kRows; }

std::string help_of(const OptionRow& row) {
  std::string help(row.help);
  const std::size_t at = help.find(kDialects);
  if (at != std::string::npos) help.replace(at, kDialects.size(), nc::dialect_list());
  return help;
}

const OptionRow* find_option(std::string_view name) {
  const auto* const found =
      std::find_if(kRows.begin(), kRows.end(), [&](const OptionRow& r) { return r.name == name; });
  return found == kRows.end() ? nullptr : found;
}

void set_option(Options& options, const OptionRow& row, std::string_view text) {
  if (text.empty()) throw OptionError(fmt::format("expected {}", row.value.empty() ? "on or off" : row.value));
  row.set(options, text);
}

std::string work_system_name(std::size_t system) {
  return nc::dialect("linuxcnc").name_of_system(static_cast<int>(system) + 1);
}

std::optional<std::array<double, kAxes>> six_numbers(std::string_view text) {
  std::array<double, kAxes> values{};
  std::size_t count = 0;
  bool all_numbers = true;
  each_part(text, [&](std::string_view part) {
    const std::optional<double> value = parse_number(part);
    if (value && count < kAxes) values[count] = *value;
    all_numbers = all_numbers && value.has_value();
    ++count;
  });
  if (!all_numbers || count != kAxes) return std::nullopt;
  return values;
}

}  // namespace plumbline::settings

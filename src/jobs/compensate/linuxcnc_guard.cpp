#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/characters.hpp"
#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "jobs/compensate/guards.hpp"
#include "nc/control/parameters/parameters.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {
namespace {

constexpr int kActiveSystem = 5220;
constexpr int kFirstRotation = 5230;
constexpr int kToolInSpindle = 5400;
constexpr std::size_t kSystems = 9;
constexpr std::string_view kAxesOfControl = "xyzabcuvw";

// The values of G92 that are kept; nothing: not all of them were given.
std::optional<AxisWords> kept_g92(const nc::ProgramSettings& program) {
  AxisWords kept;
  for (const Axis axis : kAllAxes) {
    const auto found = program.variables.find(nc::kG92InForce + 1 + static_cast<int>(index(axis)));
    if (found == program.variables.end()) return std::nullopt;
    kept[axis] = found->second;
  }
  return kept;
}

bool g92_in_force(const nc::ProgramSettings& program) {
  const auto found = program.variables.find(nc::kG92InForce);
  return found != program.variables.end() && found->second != 0;
}

std::size_t active_system(const nc::ProgramSettings& program) {
  const auto found = program.variables.find(kActiveSystem);
  if (found == program.variables.end()) return 0;
  const double number = found->second;
  const bool is_one = number >= 1 && number <= kSystems && number == std::floor(number);
  return is_one ? static_cast<std::size_t>(number) - 1 : 0;
}

// LinuxCNC. Parameters #5211... and #5221... are in the machine's unit, which a program cannot ask for; so an origin is
// found as the difference of machine position (#<_abs_x>) and work position (#<_x>), both in the program's unit, and
// the shift of G92 or of a tool as what it takes from the work position. #<plumbline_u> is one millimetre in that unit.
class LinuxCncGuard {
 public:
  explicit LinuxCncGuard(bool g92) : g92_(g92), g92_now_(g92) {
    lines_.emplace_back("#<plumbline_u>=[#<_metric>+#<_imperial>/25.4]");
  }

  void check_start(std::size_t system) {
    stop_if("start",
            {fmt::format("[#{} NE {}]", kActiveSystem, system + 1),
             fmt::format("[#{} NE {}]", nc::kG92InForce, g92_ ? 1 : 0), "[#<_tool_offset> NE 0]"},
            fmt::format("start with {}, {} G92 and without tool offset", settings::work_system_name(system),
                        g92_ ? "with" : "without"));
  }

  void check_mode(const std::string& label, const std::string& name, const std::string& wanted) {
    stop_if(label, {fmt::format("[#<{}> NE 1]", name)},
            fmt::format("this program does not say {0}: set {0}, or write it before its first move", wanted));
  }

  void check_tool_in_spindle(int number) {
    stop_if("spindle", {fmt::format("[#{} NE {}]", kToolInSpindle, number)},
            fmt::format("this program was made for tool {} in the spindle", number));
  }

  void check_position(Axis axis, double wanted) {
    stop_if(fmt::format("axis{}", lower(letter(axis))),
            {differs(fmt::format("#<_{}>", lower(letter(axis))), wanted, !is_rotary(axis))},
            fmt::format("this program was made for {} at {} {}", letter(axis), to_decimal(wanted),
                        is_rotary(axis) ? "deg" : "mm"));
  }

  void check_system(std::size_t system, const nc::WorkOffset& offset) {
    const std::string name = settings::work_system_name(system);
    lines_.push_back(name);
    std::string wanted = name;
    std::vector<std::string> conditions;
    for (const Axis axis : kAllAxes) {
      wanted += fmt::format(" {}{}", letter(axis), to_decimal(offset.origin[axis]));
      conditions.push_back(differs(origin(axis, offset.rotation_deg), offset.origin[axis], !is_rotary(axis)));
    }
    const int rotation = kFirstRotation + nc::kParametersPerRow * static_cast<int>(system);
    conditions.push_back(differs(fmt::format("#{}", rotation), offset.rotation_deg, false));
    if (offset.rotation_deg != 0) wanted += " R" + to_decimal(offset.rotation_deg);
    stop_if(fmt::format("offset{}", system + 1), conditions, "this program was made for " + wanted);
  }

  void set_g92(bool in_force) {
    if (g92_now_ != in_force) lines_.emplace_back(in_force ? "G92.3" : "G92.2");
    g92_now_ = in_force;
  }

  void check_g92(const AxisWords& kept) {
    note_position();
    set_g92(true);
    std::string wanted;
    std::vector<std::string> conditions;
    for (const Axis axis : kAllAxes) {
      wanted += fmt::format(" {}{}", letter(axis), to_decimal(kept[axis]));
      conditions.push_back(differs(taken_from(lower(letter(axis))), kept[axis], !is_rotary(axis)));
    }
    stop_if("g92", conditions, "this program was made for a shift by G92 of" + wanted);
    set_g92(g92_);
  }

  void check_tool(const nc::Tool& tool) {
    note_position();
    lines_.push_back(fmt::format("G43 H{}", tool.number));
    std::vector<std::string> conditions;
    for (const char axis : kAxesOfControl) {
      const bool is_length = std::string_view("abc").find(axis) == std::string_view::npos;
      conditions.push_back(differs(taken_from(axis), axis == 'z' ? tool.length_mm : 0, is_length));
    }
    stop_if(fmt::format("tool{}", tool.number), conditions,
            fmt::format("this program was made for tool {} of length {} mm, without other offsets", tool.number,
                        to_decimal(tool.length_mm)));
    lines_.emplace_back("G49");
  }

  void add_line(std::string line) { lines_.push_back(std::move(line)); }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  void note_position() {
    for (const char axis : kAxesOfControl) lines_.push_back(fmt::format("#<plumbline_was_{0}>=#<_{0}>", axis));
  }
  static std::string taken_from(char axis) { return fmt::format("#<plumbline_was_{0}>-#<_{0}>", axis); }

  // wanted is in mm or deg
  static std::string differs(const std::string& expression, double wanted, bool is_length) {
    const std::string_view unit = is_length ? "*#<plumbline_u>" : "";
    return fmt::format("[ABS[{}-[{}]{}] GT {}{}]", expression, to_decimal(wanted), unit, kGuardTolerance, unit);
  }

  // p_machine = R(rotation) p_work + origin, of X and Y; the tool offset and G92 are off
  static std::string origin(Axis axis, double rotation_deg) {
    const char name = lower(letter(axis));
    if (rotation_deg == 0 || (axis != Axis::X && axis != Axis::Y)) return fmt::format("#<_abs_{0}>-#<_{0}>", name);
    const std::string c = to_decimal(std::cos(rotation_deg * kDeg));
    const std::string s = to_decimal(std::sin(rotation_deg * kDeg));
    if (axis == Axis::X) return fmt::format("#<_abs_x>-[{}]*#<_x>+[{}]*#<_y>", c, s);
    return fmt::format("#<_abs_y>-[{}]*#<_x>-[{}]*#<_y>", s, c);
  }

  // The lines of one comparison, each condition on a line of its own: none becomes too long. A control that is stopped
  // has the G92 that it had.
  void stop_if(const std::string& label, const std::vector<std::string>& conditions, const std::string& message) {
    lines_.emplace_back("#<plumbline_bad>=0");
    for (const std::string& condition : conditions) {
      lines_.push_back(fmt::format("#<plumbline_bad>=[#<plumbline_bad> OR {}]", condition));
    }
    lines_.push_back(fmt::format("o<plumbline_{}> if [#<plumbline_bad>]", label));
    if (g92_now_ != g92_) lines_.emplace_back(g92_ ? "G92.3" : "G92.2");
    lines_.push_back(fmt::format("(MSG, plumbline guard: {})", message));
    lines_.emplace_back("M2");
    lines_.push_back(fmt::format("o<plumbline_{}> endif", label));
  }

  bool g92_;  // at the start, and in the end
  bool g92_now_;
  std::vector<std::string> lines_;
};

void check_modes(LinuxCncGuard& guard, const nc::ProgramSettings& program, const compensate::Beginning& beginning) {
  const bool inches = program.inches.value_or(false);
  if (!beginning.states_unit) guard.check_mode("unit", inches ? "_imperial" : "_metric", inches ? "G20" : "G21");
  if (!beginning.states_distance) guard.check_mode("distance", "_absolute", "G90");
  if (!beginning.states_feed_mode) guard.check_mode("feed", "_units_per_minute", "G94");
}

void check_positions(LinuxCncGuard& guard, const nc::ProgramSettings& program,
                     const compensate::ProgramSurvey& survey) {
  for (const Axis axis : kAllAxes) {
    const std::optional<double>& start = program.start[index(axis)];
    const bool counts = start && !survey.beginning.reached.contains(axis);
    if (counts || survey.unnamed().contains(axis)) guard.check_position(axis, start.value_or(0));
  }
}

}  // namespace

std::vector<std::string> linuxcnc_guard(const nc::ProgramSettings& program, const compensate::ProgramSurvey& survey) {
  const bool in_force = g92_in_force(program);
  const std::optional<AxisWords> g92 = kept_g92(program);
  if (in_force && !g92) {
    refuse("guard-g92",
           "the variables put a G92 offset in force and do not say all of it, so the guard cannot compare it",
           "give #5211 to #5216 as well, clear it (G92.1) and put it into the work offset, or leave --guard out");
  }
  const std::size_t system = active_system(program);
  LinuxCncGuard guard(in_force);
  guard.check_start(system);
  check_modes(guard, program, survey.beginning);
  if (program.tool_in_spindle) guard.check_tool_in_spindle(*program.tool_in_spindle);
  check_positions(guard, program, survey);
  guard.set_g92(false);
  for (std::size_t i = 0; i < program.work_offsets.size(); ++i) {
    if (program.work_offsets[i]) guard.check_system(i, *program.work_offsets[i]);
  }
  guard.add_line(settings::work_system_name(system));
  if (in_force || (g92 && survey.beginning.may_restore_g92)) guard.check_g92(*g92);
  for (const nc::Tool& tool : survey.tools) guard.check_tool(tool);
  return guard.take();
}

}  // namespace plumbline::jobs

#include "jobs/compensate/stamp.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/text/hash.hpp"
#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "base/version.hpp"
#include "nc/control/parameters/parameters.hpp"
#include "nc/control/state/control.hpp"
#include "nc/language/comment_line.hpp"

namespace plumbline::jobs {
namespace {

constexpr std::size_t kWidth = 100;  // of a comment, where the dialect does not ask for less
constexpr std::string_view kFurther = ".. ";

std::string words(const AxisWords& values) {
  std::string text;
  for (const Axis axis : kAllAxes) text += fmt::format(" {}{}", letter(axis), to_decimal(values[axis]));
  return text;
}

std::string_view name_of(nc::FeedRule rule) {
  return rule == nc::FeedRule::xyz_first ? "xyz" : rule == nc::FeedRule::all_axes_as_mm ? "all" : "unknown";
}

std::string rotary_text(const nc::RotaryRules& rules) {
  constexpr std::array<std::string_view, 4> kNames{"linear", "sign", "shortest", "one turn"};
  std::string text;
  for (const Axis axis : {Axis::A, Axis::B, Axis::C}) {
    const nc::RotaryRule rule = rules[index(axis) - 3];
    if (rule != nc::RotaryRule::linear) {
      text += fmt::format(", {} {}", letter(axis), kNames[static_cast<std::size_t>(rule)]);
    }
  }
  return text;
}

std::string points_text(const compensate::Settings& c) {
  if (!c.bound.is_asked())
    return fmt::format("step {} deg or {} mm", to_decimal(c.step.angle_deg), to_decimal(c.step.length_mm));
  return fmt::format("tolerance {} um{}", to_decimal(c.bound.tolerance_mm * kMm / kUm),
                     c.bound.yields == compensate::BoundSettings::Yields::time ? ", time yields" : "");
}

std::string settings_line(const settings::Options& options) {
  const compensate::Settings& c = options.compensation;
  std::string line = fmt::format("method {}, friction {}, {}, time tolerance {} of a block",
                                 c.method == compensate::Method::exact ? "exact" : "first order",
                                 c.friction ? "on" : "off", points_text(c), to_decimal(options.emit.time_tolerance));
  if (c.dynamic) line += ", dynamic";
  if (c.time_s) line += fmt::format(", at {} s", to_decimal(*c.time_s));
  if (options.program.inches) line += fmt::format(", unit at the start {}", *options.program.inches ? "inch" : "mm");
  if (options.program.calculator_type)
    line += fmt::format(", calculator type {}", *options.program.calculator_type ? "on" : "off");
  if (options.program.input_increment)
    line += fmt::format(", input increment {} mm", to_decimal(*options.program.input_increment));
  if (options.program.feed_rule) line += fmt::format(", feed rule {}", name_of(*options.program.feed_rule));
  if (options.program.helix_feed_along_circle)
    line += fmt::format(", helix feed {}", *options.program.helix_feed_along_circle ? "circle" : "path");
  line += rotary_text(options.program.rotary);
  if (options.program.free_rotation != nc::FreeRotation::unknown) {
    line += fmt::format(", C {}", options.program.free_rotation == nc::FreeRotation::c_stays ? "stays" : "to zero");
  }
  if (options.program.block_delete)
    line += fmt::format(", block delete {}", *options.program.block_delete ? "on" : "off");
  return line;
}

std::string tool_line(const nc::Tool& tool) {
  std::string line = fmt::format("tool {}: length {} mm", tool.number, to_decimal(tool.length_mm));
  if (!tool.mass_kg) return line + ", mass not stated";
  return line + fmt::format(", mass {} kg at {} mm", to_decimal(*tool.mass_kg),
                            to_decimal(tool.centre_of_mass_mm.value_or(0)));
}

std::string start_line(const nc::ProgramSettings& program) {
  std::string line;
  for (const Axis axis : kAllAxes) {
    const auto& value = program.start[index(axis)];
    if (value) line += fmt::format(" {}{}", letter(axis), to_decimal(*value));
  }
  return line.empty() ? line : "start at" + line;
}

// What of the control's state at the start is not as usual, as its variables or the options say it.
std::vector<std::string> state_lines(const nc::ProgramSettings& program, const compensate::ProgramSurvey& survey) {
  std::vector<std::string> lines;
  const auto add = [&](std::string text) { lines.push_back(std::move(text)); };
  const auto variable = [&](int number) {
    const auto found = program.variables.find(number);
    return found == program.variables.end() ? 0 : found->second;
  };
  if (survey.dialect.syntax.system_variables == nc::SystemVariables::rs274) {
    const int system = nc::Control(survey.dialect, program).modal.work_system;
    if (system > 1) add("starts in " + survey.dialect.name_of_system(system));
    AxisWords g92;
    for (const Axis axis : kAllAxes) g92[axis] = variable(nc::kG92InForce + 1 + static_cast<int>(index(axis)));
    const bool in_force = variable(nc::kG92InForce) != 0;
    if (in_force || survey.beginning.may_restore_g92) {
      add(fmt::format("G92 {}: shift{}", in_force ? "in force" : "kept for G92.3", words(g92)));
    }
  }
  if (program.tool_in_spindle) add(fmt::format("tool {} in the spindle at the start", *program.tool_in_spindle));
  return lines;
}

// A text over as many comments as it takes.
void add_wrapped(std::vector<std::string>& lines, std::string text, std::size_t width) {
  text = comment_text(text);
  while (text.size() > width) {
    const std::size_t blank = text.rfind(' ', width);
    const std::size_t cut = blank == std::string::npos || blank <= kFurther.size() ? width : blank;
    lines.push_back(text.substr(0, cut));
    const std::size_t next = std::min(text.find_first_not_of(' ', cut), text.size());
    text = std::string(kFurther) + text.substr(next);
  }
  lines.push_back(std::move(text));
}

}  // namespace

std::string comment_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '(') {
      out += '[';
    } else if (c == ')') {
      out += ']';
    } else if (c == ';' || c == '%' || c < 0x20 || c > 0x7E) {
      out += '_';
    } else {
      out += c;
    }
  }
  return out;
}

std::vector<std::string> stamp(const settings::Options& options, const nc::ProgramSettings& program,
                               const machine::MachineModel& model, const compensate::ProgramSurvey& survey) {
  const nc::Dialect& dialect = survey.dialect;
  const std::size_t width = std::min(kWidth, nc::comment_room(dialect));
  std::vector<std::string> lines;
  const auto add = [&](std::string text) { add_wrapped(lines, std::move(text), width); };
  add(fmt::format("plumbline {} compensated this program", version()));
  add(fmt::format("model {}, hash {}", model.name, to_hex(model.hash)));
  add(settings_line(options));
  if (options.compensation.touch_off) add("touch-off at" + words(*options.compensation.touch_off));
  if (!options.machine.empty()) add("machine " + options.machine);
  for (const std::string& file : options.paths.settings_files) add("settings file " + file);
  if (!options.paths.variables.empty()) add("variables file " + options.paths.variables.name());
  if (const std::string start = start_line(program); !start.empty()) add(start);
  for (std::string& line : state_lines(program, survey)) add(std::move(line));
  for (std::size_t i = 0; i < program.work_offsets.size(); ++i) {
    const auto& offset = program.work_offsets[i];
    if (!offset) continue;
    const std::string turned = offset->rotation_deg == 0 ? "" : " R" + to_decimal(offset->rotation_deg);
    add(dialect.name_of_system(static_cast<int>(i) + 1) + words(offset->origin) + turned);
  }
  for (const nc::Tool& tool : survey.tools) add(tool_line(tool));
  return lines;
}

}  // namespace plumbline::jobs

#include "jobs/compensate/guard_block.hpp"

#include <cmath>

#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/text/number_text.hpp"
#include "base/units.hpp"
#include "jobs/compensate/guards.hpp"
#include "nc/control/parameters/parameters.hpp"
#include "nc/language/guard_lines.hpp"
#include "nc/syntax/line_head.hpp"
#include "nc/syntax/line_source.hpp"
#include "settings/options.hpp"

namespace plumbline::jobs {
namespace {

constexpr int kActiveSystem = 5220;
constexpr int kFirstRotation = 5230;

// LinuxCNC. Parameters #5221... are in the machine's unit, which a program cannot ask for; so an origin is found as the
// difference of machine position (#<_abs_x>) and work position (#<_x>), both in the program's unit. #<plumbline_u> is
// one millimetre in that unit.
class LinuxCncGuard {
 public:
  LinuxCncGuard() { lines_.emplace_back("#<plumbline_u>=[#<_metric>+#<_imperial>/25.4]"); }

  void check_start() {
    stop_if("start",
            {fmt::format("[#{} NE 1]", kActiveSystem), fmt::format("[#{} NE 0]", nc::kG92InForce),
             "[#<_tool_offset> NE 0]"},
            "start with G54, without G92 and without tool offset");
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

  void check_tool(const nc::Tool& tool) {
    lines_.emplace_back("#<plumbline_z>=#<_z>");
    lines_.push_back(fmt::format("G43 H{}", tool.number));
    stop_if(fmt::format("tool{}", tool.number), {differs("#<plumbline_z>-#<_z>", tool.length_mm, true)},
            fmt::format("this program was made for tool {} of length {} mm", tool.number, to_decimal(tool.length_mm)));
    lines_.emplace_back("G49");
  }

  void check_position(Axis axis, double wanted) {
    const auto lower = static_cast<char>(letter(axis) - 'A' + 'a');
    stop_if(fmt::format("axis{}", lower), {differs(fmt::format("#<_{}>", lower), wanted, false)},
            fmt::format("this program was made for {} at {} deg", letter(axis), to_decimal(wanted)));
  }

  void add_line(std::string line) { lines_.push_back(std::move(line)); }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  // wanted is in mm or deg
  static std::string differs(const std::string& expression, double wanted, bool is_length) {
    const std::string_view unit = is_length ? "*#<plumbline_u>" : "";
    return fmt::format("[ABS[{}-[{}]{}] GT {}{}]", expression, to_decimal(wanted), unit, kGuardTolerance, unit);
  }

  // p_machine = R(rotation) p_work + origin, of X and Y; the tool offset and G92 are off
  static std::string origin(Axis axis, double rotation_deg) {
    const auto lower = static_cast<char>(letter(axis) - 'A' + 'a');
    if (rotation_deg == 0 || (axis != Axis::X && axis != Axis::Y)) return fmt::format("#<_abs_{0}>-#<_{0}>", lower);
    const std::string c = to_decimal(std::cos(rotation_deg * kDeg));
    const std::string s = to_decimal(std::sin(rotation_deg * kDeg));
    if (axis == Axis::X) return fmt::format("#<_abs_x>-[{}]*#<_x>+[{}]*#<_y>", c, s);
    return fmt::format("#<_abs_y>-[{}]*#<_x>-[{}]*#<_y>", s, c);
  }

  // The lines of one comparison, each condition on a line of its own: none becomes too long.
  void stop_if(const std::string& label, const std::vector<std::string>& conditions, const std::string& message) {
    lines_.emplace_back("#<plumbline_bad>=0");
    for (const std::string& condition : conditions) {
      lines_.push_back(fmt::format("#<plumbline_bad>=[#<plumbline_bad> OR {}]", condition));
    }
    lines_.push_back(fmt::format("o<plumbline_{}> if [#<plumbline_bad>]", label));
    lines_.push_back(fmt::format("(MSG, plumbline guard: {})", message));
    lines_.emplace_back("M2");
    lines_.push_back(fmt::format("o<plumbline_{}> endif", label));
  }

  std::vector<std::string> lines_;
};

void refuse_g92(const nc::ProgramSettings& program) {
  const auto in_force = program.variables.find(nc::kG92InForce);
  if (in_force == program.variables.end() || in_force->second == 0) return;
  refuse("guard-g92", "the variables put a G92 offset in force, and the guard cannot compare that",
         "clear it (G92.1) and put it into the work offset, or leave --guard out");
}

std::vector<std::string> linuxcnc_guard(const nc::ProgramSettings& program, std::span<const nc::Tool> tools,
                                        AxisSet assumed) {
  refuse_g92(program);
  LinuxCncGuard guard;
  guard.check_start();
  for (const Axis axis : kAllAxes) {
    if (assumed.contains(axis)) guard.check_position(axis, program.start[index(axis)].value_or(0));
  }
  for (std::size_t i = 0; i < program.work_offsets.size(); ++i) {
    if (program.work_offsets[i]) guard.check_system(i, *program.work_offsets[i]);
  }
  guard.add_line("G54");
  for (const nc::Tool& tool : tools) guard.check_tool(tool);
  return guard.take();
}

std::vector<std::string> lines_of_guard(const nc::ProgramSettings& program, std::span<const nc::Tool> tools,
                                        AxisSet assumed, const nc::Dialect& dialect) {
  switch (dialect.guard) {
    case nc::GuardLanguage::linuxcnc:
      return linuxcnc_guard(program, tools, assumed);
    case nc::GuardLanguage::macro_b:
      return fanuc_guard(program, assumed, dialect);
    case nc::GuardLanguage::sinumerik:
      return siemens_guard(program, assumed, dialect);
    case nc::GuardLanguage::none:
      break;
  }
  refuse("guard-dialect", fmt::format("which variables of {} hold its offsets was found in no source", dialect.name),
         "leave --guard out; the offsets stand in the comments at the start of the output");
}

}  // namespace

std::vector<std::string> guard_block(const nc::ProgramSettings& program, const compensate::ProgramSurvey& survey) {
  const nc::Dialect& dialect = survey.dialect;
  std::vector<std::string> lines = lines_of_guard(program, survey.tools, survey.unnamed(), dialect);
  lines.insert(lines.begin(), nc::guard_line(nc::kGuardBegins, dialect));
  lines.push_back(nc::guard_line(nc::kGuardEnds, dialect));
  return lines;
}

void refuse_guard_before_definitions(const InputFile& source, const nc::Dialect& dialect) {
  if (!dialect.syntax.declared) return;
  nc::LineSource lines(source);
  nc::Line line;
  bool begun = false;
  bool body = false;
  while (lines.next(line)) {
    const nc::LineHead head = nc::head_of(line.text, dialect);
    if (begun && !head.program.empty()) return;  // the guard stands in the first program of an archive
    begun = begun || !head.empty;
    const nc::FlowWord word = head.word;
    if (word != nc::FlowWord::define && word != nc::FlowWord::sub) {
      body = body || (!head.empty && head.program.empty());
      continue;
    }
    if (!body) continue;  // the guard stands behind it
    Place place;
    place.file = source.name();
    place.line = line.place.line;
    place.column = 1;
    place.text = line.text;
    place.length = line.text.size();
    refuse("guard-definitions",
           "definitions stand before all else of a program, and the guard would stand before this one",
           "put it before the first other block, use R parameters in place of DEF, or leave --guard out",
           std::move(place));
  }
}

}  // namespace plumbline::jobs

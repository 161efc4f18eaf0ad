// Rows of the control's tool table: G10 L1, L10, L11.
#include <array>

#include <fmt/format.h>

#include "nc/control/execution.hpp"
#include "nc/control/state/tool_rows.hpp"
#include "nc/language/codes.hpp"

namespace plumbline::nc {
namespace {

constexpr int kProbeTableSystem = 9;                 // G59.3, which G10 L11 counts in [LinuxCNC, "G-codes"]
constexpr std::array kDetailLetters{'I', 'J', 'Q'};  // angles and orientation

// The row that the program writes, begun as the user's table has it.
ToolRow& row_to_write(Control& control, const ProgramSettings& settings, int number) {
  const auto [row, fresh] = control.tools.try_emplace(number);
  const Tool* const tool = settings.tools.find(number);
  if (!fresh || tool == nullptr) return row->second;
  row->second.offset[Axis::Z] = tool->length_mm;
  row->second.diameter_mm = tool->diameter_mm;
  return row->second;
}

// At others the control stops [rs274].
void check_orientation(const Execution& run) {
  constexpr int kLargest = 9;
  const Word* const word = run.words.find('Q');
  if (word == nullptr || run.whole(*word, -kNoLimit, kNoLimit) <= kLargest) return;
  run.refuse(*word, codes::kOutOfRange, fmt::format("a tool has no orientation {}", run.block->at(word->span)),
             fmt::format("write Q0 to Q{}", kLargest));
}

void set_details(const Execution& run, ToolRow& row) {
  check_orientation(run);
  if (const Word* radius = run.words.find('R')) row.diameter_mm = 2 * run.length(*radius);
  for (std::size_t i = 0; i < kDetailLetters.size(); ++i) {
    if (const Word* word = run.words.find(kDetailLetters[i])) row.details[i] = word->value;
  }
}

AxisWords named_words(const Execution& run) {
  AxisWords words;
  for (const Axis axis : kAllAxes) {
    if (run.axes.contains(axis)) words[axis] = run.value(axis);
  }
  return words;
}

}  // namespace

AxisWords needed_offset(const Execution& run, const Word& named, int number) {
  if (const std::optional<AxisWords> offset = offset_of_tool(run.control, run.settings, number)) return *offset;
  run.refuse(named, codes::kToolUnknown, fmt::format("the length of tool {} is not known", number),
             fmt::format("add a [[tool]] with number = {} to a tool table and name it with --tools", number));
}

void set_tool_row(Execution& run) {
  const int number = run.whole(run.need('P', "G10 L1"), 1, kNoLimit);
  if (run.axes.empty() && !run.words.has('R') && !run.words.has('I') && !run.words.has('J') && !run.words.has('Q')) {
    run.refuse(codes::kAxesMissing, "G10 L1 sets nothing", "add the words of the tool's offset");
  }
  ToolRow& row = row_to_write(run.control, run.settings, number);
  for (const Axis axis : kAllAxes) {
    if (run.axes.contains(axis)) row.offset[axis] = run.value(axis);
  }
  set_details(run, row);
}

// The tool gets the offset with which the axes would stand on the given words: L10 in the work system in force, L11 in
// G59.3 without G92. X and Y that are not named keep theirs as that system sees it [LinuxCNC, measured].
void set_tool_row_here(Execution& run, bool in_probe_table_system) {
  Control& control = run.control;
  const Word& tool = run.need('P', "G10");
  const int number = run.whole(tool, 1, kNoLimit);
  if (run.axes.empty())
    run.refuse(codes::kAxesMissing, "G10 sets nothing", "add the words that the axes shall stand on");
  needed_offset(run, tool, number);
  need_position(run, run.axes);
  need_offsets(run);
  check_tool_unit(run, tool);
  const WorkSystem& table = control.systems[kProbeTableSystem - 1];
  if (in_probe_table_system && !table.known.contains(AxisSet::linear() | run.axes)) {
    run.refuse(tool, codes::kWorkOffsetUnknown, "G10 L11 counts in G59.3, whose offset is not known",
               "give what stands in the control's table: --work-offset G59.3=X,Y,Z,A,B,C");
  }
  const double turned = in_probe_table_system ? table.rotation_deg : control.frame.rotation_deg;
  if (turned != 0) need_position(run, run.axes | kTurningAxes);
  const AxisWords machine = control.frame.to_machine(control.position);
  const AxisWords in_force = in_probe_table_system ? AxisWords{} : control.frame.tool;
  const AxisWords stands = in_probe_table_system ? turned_about_z(machine - table.origin, -turned) : control.position;
  ToolRow& row = row_to_write(control, run.settings, number);
  const AxisWords words = named_words(run);
  const AxisWords seen = turned_about_z(in_force, -turned);
  AxisWords offset = turned_about_z(row.offset, -turned);
  for (const Axis axis : kAllAxes) {
    if (run.axes.contains(axis)) offset[axis] = seen[axis] + stands[axis] - words[axis];
  }
  row.offset = turned_about_z(offset, turned);
  set_details(run, row);
  run.step.role = BlockRole::sets_offset;
  run.step.offset_rotation_deg = turned;
}

}  // namespace plumbline::nc

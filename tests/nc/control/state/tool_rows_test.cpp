#include "nc/control/state/tool_rows.hpp"

#include <catch2/catch.hpp>

#include "nc/programs.hpp"
#include "nc/syntax/parsed.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

ProgramSettings with_tool_three() {
  ProgramSettings settings = at_zero();
  settings.tools = ToolTable({Tool{3, 100, 8.0, {}, {}, {}}});
  return settings;
}

// Where the machine stands at the end of the last move.
AxisWords machine_after(std::string_view text, const ProgramSettings& settings = with_tool_three()) {
  return motions_of(text, settings).back().machine;
}

}  // namespace

TEST_CASE("a tool adds its length of the user's table, or the offset that the program wrote") {
  const ProgramSettings settings = with_tool_three();
  Control control(dialect("linuxcnc"), settings);
  CHECK(offset_of_tool(control, settings, 3) == AxisWords{{0, 0, 100, 0, 0, 0}});
  CHECK(offset_of_tool(control, settings, 0) == AxisWords{});
  CHECK_FALSE(offset_of_tool(control, settings, 4));
  control.tools[3].offset = {{1, 2, 50, 0, 0, 0}};
  control.tools[4].offset = {{0, 0, 40, 0, 0, 0}};
  CHECK(offset_of_tool(control, settings, 3) == AxisWords{{1, 2, 50, 0, 0, 0}});
  CHECK(offset_of_tool(control, settings, 4) == AxisWords{{0, 0, 40, 0, 0, 0}});
  CHECK(offset_of_tool(control, empty_tables(), 5) == AxisWords{});
}

TEST_CASE("a tool that no table has is refused under the word that names it") {
  const Parsed parsed("G43 H4");
  const ProgramSettings settings = with_tool_three();
  Control control(dialect("linuxcnc"), settings);
  Execution run{dialect("linuxcnc"), settings, control};
  run.block = &parsed.block;
  const Word& named = parsed.block.words.back();
  const Diagnostic refused = testing::refusal_of([&] { needed_offset(run, named, 4); });
  CHECK(refused.code == "nc-tool-unknown");
  CHECK(refused.place.column == 5);
  CHECK(needed_offset(run, named, 3)[Axis::Z] == 100);
}

TEST_CASE("parameters show the row of the tool in the spindle") {
  const ProgramSettings settings = with_tool_three();
  Control control(dialect("linuxcnc"), settings);
  CHECK_FALSE(tool_parameter(control, settings, 5400));
  control.modal.tool_in_spindle = 3;
  CHECK(tool_parameter(control, settings, 5400) == 3);
  CHECK(tool_parameter(control, settings, 5401) == 0);
  CHECK(tool_parameter(control, settings, 5403) == 100);
  CHECK(tool_parameter(control, settings, 5407) == 0);  // U, which no machine here has
  CHECK(tool_parameter(control, settings, 5410) == 8);
  CHECK_FALSE(tool_parameter(control, settings, 5411));
  control.tools[3].details[2] = 6;
  CHECK(tool_parameter(control, settings, 5413) == 6);
  CHECK_FALSE(tool_parameter(control, settings, 5410));  // the row that the program wrote has none
  control.modal.tool_in_spindle = 4;
  CHECK_FALSE(tool_parameter(control, settings, 5403));
  CHECK(tool_parameter(control, empty_tables(), 5403) == 0);
}

TEST_CASE("G10 L1 writes a row, begun as the user's table has it") {
  CHECK(machine_after("G10 L1 P3 Z25\nG43 H3\nG0 Z5\n")[Axis::Z] == 30);
  const AxisWords kept = machine_after("G10 L1 P3 X2\nG43 H3\nG0 X1 Z5\n");
  CHECK(kept[Axis::X] == 3);
  CHECK(kept[Axis::Z] == 105);
  CHECK(machine_after("G20\nG10 L1 P7 Z1\nG43 H7\nG0 Z2\n")[Axis::Z] == Approx(3 * 25.4));
  CHECK(motions_of("G10 L1 P3 R3\nT3 M6\nG53 G0 Z0\nG0 X#5410\n", with_tool_three()).back().to[Axis::X] == 6);
  CHECK(code_of("G10 L1 P3\n", with_tool_three()) == "nc-axes-missing");
  CHECK(code_of("G10 L1 Z5\n", with_tool_three()) == "nc-word-missing");
}

TEST_CASE("G10 L10 gives the tool the offset with which the axes stand on the words") {
  // Z stands on 20 without a length: with the tool it shall be 5, so the tool adds 15; back on 5 the machine is on 20.
  CHECK(machine_after("G0 Z20\nG10 L10 P3 Z5\nG43 H3\nG0 Z5\n")[Axis::Z] == 20);
  CHECK(machine_after("G0 Z20\nG10 L10 P3 Z5\nG43 H3\nG0 Z0\n")[Axis::Z] == 15);
  CHECK(machine_after("G43 H3\nG0 Z20\nG10 L10 P3 Z5\nG43 H3\nG0 Z5\n")[Axis::Z] == 120);
  CHECK(code_of("G0 Z20\nG10 L10 P4 Z5\n", with_tool_three()) == "nc-tool-unknown");
  CHECK(code_of("G0 Z20\nG10 L10 P3\n", with_tool_three()) == "nc-axes-missing");
}

TEST_CASE("G10 L11 counts in G59.3, whose offset must be known") {
  ProgramSettings settings = with_tool_three();
  CHECK(code_of("G0 Z20\nG10 L11 P3 Z5\n", settings) == "nc-work-offset-unknown");
  settings.work_offsets[8] = WorkOffset{{{0, 0, 12, 0, 0, 0}}, 0};
  CHECK(machine_after("G0 Z20\nG10 L11 P3 Z5\nG43 H3\nG0 Z0\n", settings)[Axis::Z] == 3);  // 20 - 12 - 5
}

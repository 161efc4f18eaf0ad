// What an OSP makes of its programs, case by case: where it is refused, or where its moves end.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;

namespace {

struct OspCase {
  const char* program;
  std::size_t line, column;  // 0: it is read
  const char* code = "nc-not-interpreted";
};

void check_osp(const std::vector<OspCase>& cases) {
  ProgramSettings settings = empty_tables();
  settings.as_with_empty_tables = false;
  settings.work_offsets[0] = settings.work_offsets[1] = WorkOffset{};
  settings.work_offsets[1]->origin[Axis::X] = 10;
  Tool tool;
  tool.number = 1;
  tool.length_mm = 100;
  settings.tools = ToolTable({tool});
  for (const OspCase& c : cases) {
    const ProgramFile text(c.program);
    const InputFile file(text.path());
    std::string code;
    std::size_t line = 0;
    std::size_t column = 0;
    std::string message;
    try {
      Program blocks(file, dialect("okuma"), settings);
      while (blocks.next() != nullptr) continue;
    } catch (const Refusal& refusal) {
      code = refusal.diagnostic().code;
      line = refusal.diagnostic().place.line;
      column = refusal.diagnostic().place.column;
      message = refusal.diagnostic().message;
      CHECK_FALSE(refusal.diagnostic().help.empty());
    }
    INFO(c.program << message);
    CHECK(code == (c.line == 0 ? "" : c.code));
    CHECK(line == c.line);
    CHECK(column == c.column);
  }
}

}  // namespace

TEST_CASE("OSP: an increment after a change of offsets is refused until an absolute word made the axis follow") {
  check_osp({{"G15 H1 G0 X0 Y0 Z50\nG91 G56 H1 Z-10\n", 2, 12},
             {"G15 H1 G0 X0 Y0 Z50\nG56 H1 Z40\nG91 Z-1\nG53 Z-1\n", 4, 5},
             {"G15 H1 G0 X0 Y0 Z50\nG15 H2\nG91 Y1\nX1\n", 4, 1},
             {"G15 H1 G0 X0 Y0 Z50\nG56 H1 Z40\nG91 Z-10 X1\nG90 G15 H2 X0\nG91 X1\n", 0, 0}});
}

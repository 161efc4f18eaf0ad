#include "nc/osp_cases.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

namespace plumbline::nc::tests {
namespace {

ProgramSettings osp_settings() {
  ProgramSettings settings = empty_tables();
  settings.as_with_empty_tables = false;
  settings.work_offsets[0] = settings.work_offsets[1] = WorkOffset{};
  settings.work_offsets[1]->origin[Axis::X] = 10;
  settings.work_offsets[1]->origin[Axis::Z] = 5;
  Tool first;
  first.number = 1;
  first.length_mm = 100;
  Tool third;
  third.number = 3;
  third.length_mm = 80;
  settings.tools = ToolTable({first, third});
  return settings;
}

}  // namespace

void check_osp(const std::vector<OspCase>& cases) {
  const ProgramSettings settings = osp_settings();
  for (const OspCase& c : cases) {
    const ProgramFile text(c.program);
    const InputFile file(text.path());
    Diagnostic refused;
    try {
      Program blocks(file, dialect("okuma"), settings);
      while (blocks.next() != nullptr) continue;
    } catch (const Refusal& refusal) {
      refused = refusal.diagnostic();
      CHECK_FALSE(refused.help.empty());
    }
    const std::string said = refused.message + "; " + refused.help;
    INFO(c.program << said);
    CHECK(refused.code == (c.line == 0 ? "" : c.code));
    CHECK(refused.place.line == c.line);
    CHECK(refused.place.column == c.column);
    CHECK(said.find(c.part) != std::string::npos);
  }
}

}  // namespace plumbline::nc::tests

#include "nc/language/tool_table.hpp"

#include <string>

#include <catch2/catch.hpp>

#include "nc/programs.hpp"

using namespace plumbline::nc;
using plumbline::nc::tests::ProgramFile;

TEST_CASE("a tool table gives length, diameter, mass and centre of mass") {
  const ProgramFile file(
      "plumbline = \"tools 1\"\n[[tool]]\nnumber = 3\nlength_mm = 120.5\nmass_kg = 1.2\ncentre_of_mass_mm = 40\n"
      "[[tool]]\nnumber = 4\nlength_mm = 80\ndiameter_mm = 10\n");
  const ToolTable tools = read_tool_table(file.path());
  REQUIRE(tools.find(3) != nullptr);
  CHECK(tools.find(3)->length_mm == 120.5);
  CHECK(tools.find(3)->mass_kg == 1.2);
  CHECK(tools.find(3)->centre_of_mass_mm == 40);
  CHECK_FALSE(tools.find(3)->diameter_mm.has_value());
  CHECK(tools.find(4)->diameter_mm == 10);
  CHECK_FALSE(tools.find(4)->mass_kg.has_value());
  CHECK(tools.find(5) == nullptr);
}

TEST_CASE("digits are a number as they are written in a T word alone") {
  for (const std::string number : {"0", "1", "12", "20000"}) CHECK(is_tool_number(number));
  for (const std::string name : {"01", "00", "007", "1A", "", "123456789"}) CHECK_FALSE(is_tool_number(name));
}

TEST_CASE("a tool may have a name") {
  const ProgramFile file(
      "plumbline = \"tools 1\"\n[[tool]]\nnumber = 3\nname = \"FR\xC3\x84SER 10\"\nlength_mm = 120.5\n"
      "[[tool]]\nnumber = 4\nlength_mm = 80\n");
  const ToolTable tools = read_tool_table(file.path());
  REQUIRE(tools.find("FR\xC3\x84SER 10") != nullptr);
  CHECK(tools.find("FR\xC3\x84SER 10")->number == 3);
  CHECK(tools.find("fr\xC3\x84ser 10") == nullptr);
  CHECK(tools.find("") == nullptr);
  CHECK(tools.find(4)->name.empty());
}

TEST_CASE("an empty tool table is one") {
  CHECK(read_tool_table(ProgramFile("plumbline = \"tools 1\"\n").path()).empty());
  CHECK(read_tool_table(plumbline::Source::held("hexapod.tbl", "\n")).empty());  // LinuxCNC's own
}

TEST_CASE("LinuxCNC's own tool table is read") {
  const ProgramFile file(
      "; tools of the hexapod\n\nT0 P0 ;no tool\nT1 P1 D+6.0 Z+85.5 ;end mill\r\nt98876 p543 z120 x0 i30 Q3\n  ;none\n"
      "T3 P7\n");
  const ToolTable tools = read_tool_table(file.path());
  REQUIRE(tools.all().size() == 3);
  CHECK(tools.find(1)->length_mm == 85.5);
  CHECK(tools.find(1)->diameter_mm == 6);
  CHECK_FALSE(tools.find(1)->mass_kg);
  CHECK(tools.find(98876)->length_mm == 120);
  CHECK(tools.find(3)->length_mm == 0);
  CHECK(tools.find(0) == nullptr);
}

TEST_CASE("what is meant as LinuxCNC's tool table is refused as one") {
  const auto refused = [](const char* text) {
    try {
      read_tool_table(plumbline::Source::held("tool.tbl", text));
    } catch (const plumbline::Refusal& refusal) {
      return refusal.diagnostic().code + ": " + refusal.diagnostic().message + "; " + refusal.diagnostic().help;
    }
    return std::string();
  };
  for (const char* const text :
       {"P1 Z100\nT1 P1 Z100\n", "; tools\nZ+100 D6\n", "POC FMS LEN DIAM\n1 1 100 10\n", "D+6.0 Z100 T1\n"}) {
    INFO(text << refused(text));
    CHECK(refused(text).starts_with("tools-value"));
    CHECK(refused(text).find("T1 P1 D+6.0 Z+85.0") != std::string::npos);
  }
  const std::string no_number = refused("plumbline = \"tools 1\"\n[[tool]]\nnumber = 1\nlength_mm = nan\n");
  CHECK(no_number.find("quotes") == std::string::npos);
}

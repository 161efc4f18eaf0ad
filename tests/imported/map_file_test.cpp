#include "imported/map_file.hpp"

#include <catch2/catch.hpp>

#include "imported/layouts.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using imported::parse_map;

TEST_CASE("maps to start from can be read") {
  for (const std::string_view name : imported::example_names()) {
    INFO(name);
    const imported::Map map = parse_map(std::string(imported::example_map(name)), "map.toml");
    CHECK(map.runs.size() == 1);
    CHECK_FALSE(map.source.columns.empty());
  }
  CHECK(refusal_of([] { imported::example_map("ballbar"); }).code == "import-value");
}

TEST_CASE("a flaw of a map is refused at its place") {
  const std::string run = map_run("one", "c.csv");
  struct Bad {
    std::string text, code;
    std::size_t line;
  };
  const std::vector<Bad> cases{
      {"machine = \"m\"\n", "import-map", 1},
      {kMapHead + run, "import-key", 1},
      {kMapHead + "[columns]\nradius = {name = \"r\", unit = \"um\"}\n" + run, "import-key", 4},
      {kMapHead + "[columns]\nradial = {name = \"r\"}\n" + run, "import-value", 4},
      {kMapHead + "[columns]\nradial = {name = \"r\", unit = \"furlong\"}\n" + run, "import-value", 4},
      {kMapHead + "[columns]\nradial = {unit = \"um\"}\n" + run, "import-value", 4},
      {kMapHead + "[columns]\nradial = {name = \"r\", column = 2, unit = \"um\"}\n" + run, "import-value", 4},
      {kMapHead + "[columns]\nradial = {name = \"r\", unit = \"um\", sign = 2}\n" + run, "import-value", 4},
      {kMapHead + "[columns]\ntorque1 = {name = \"r\", unit = \"A\"}\n" + run, "import-value", 4},
      {kMapHead + "[columns]\ntorque1 = {name = \"r\", unit = \"percent\"}\n" + run, "import-value", 4},
      {kMapHead + "[columns]\ntorque1 = {name = \"r\", unit = \"Nm\"}\n" + run, "import-value", 4},
      {kMapHead + "[columns]\nradial = {name = \"r\", unit = \"um\"}\ntorque6 = {name = \"t\", unit = \"Nm\"}\n" + run,
       "import-value", 5},
      {kMapHead + "[columns]\nangle = {name = \"a\", unit = \"deg\"}\n" + run, "import-value", 3},
      {kMapHead + "[columns]\nradial = {name = \"a\", unit = \"um\"}\nangle = {name = \"a\", unit = \"deg\"}\n" + run,
       "import-value", 5},
      {kMapHead + "[columns]\nradial = {column = 4, unit = \"um\"}\ntime = {column = 4, unit = \"s\"}\n" + run,
       "import-value", 5},
      {kMapHead + "[columns]\ntorque1 = {name = \"r\", unit = \"Nm\", Nm_per_A = 0.85}\n" + run, "import-key", 4},
      {kMapHead + "[columns]\ntorque1 = {name = \"r\", unit = \"A\", Nm_per_A = 1, rated_Nm = 3}\n" + run, "import-key",
       4},
      {kMapHead + "[columns]\nradial = {name = \"r\", unit = \"um\", rated_Nm = 3}\n" + run, "import-key", 4},
      {kMapHead + "[columns]\ntime = {name = \"t\", unit = \"s\", period_s = 0.1}\n" + run, "import-key", 4},
      {kMapHead + "[columns]\nx = {name = \"x\", unit = \"mm\"}\nradial = {name = \"r\", unit = \"um\"}\n" + run,
       "import-value", 4},
      {kMapHead + "[columns]\nradial = {name = \"r\", unit = \"um\"}\ny = {name = \"y\", unit = \"mm\"}\n" + run,
       "import-value", 5},
      {kMapHead + "[columns]\nangle = {name = \"a\", unit = \"deg\"}\nradial = {name = \"r\", unit = \"um\"}\n" + run +
           "start_angle_deg = 10\n",
       "import-value", 16},
      {kMapHead + "[table]\ndecimal = \",\"\n[columns]\n" + run, "import-value", 3},
      {kMapHead + "[table]\nheader = false\n[columns]\nradial = {name = \"r\", unit = \"um\"}\n" + run, "import-value",
       6},
      {kMapHead + "[columns]\nradial = {name = \"r\", unit = \"um\"}\n", "import-key", 1},
      {kMapHead + "[columns]\nradial = {name = \"r\", unit = \"um\"}\n" + run + run, "dataset-same-id", 16},
      {"preset = \"ballbar\"\n" + kMapHead + "[columns]\n" + run, "import-value", 1},
  };
  for (const Bad& bad : cases) {
    INFO(bad.text);
    const Diagnostic d = refusal_of([&] { parse_map(bad.text, "map.toml"); });
    INFO(to_text(d));
    CHECK(d.code == bad.code);
    CHECK(d.place.line == bad.line);
  }
}

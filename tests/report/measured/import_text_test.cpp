#include "report/measured/import_text.hpp"

#include <catch2/catch.hpp>

#include "imported/layouts.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("an import says what it took for what") {
  const Scratch scratch;
  const std::string file =
      scratch.file("c.csv", "a,r\n" + lines(way(-180, 540), [](const Moment& m) {
                              return fmt::format("{:.3f},{:.5f}", m.deg, m.deg == 30 ? 1.0 : radial_um(m.deg));
                            }));
  const std::string map =
      kMapHead + "[columns]\nangle = {name = \"a\", unit = \"deg\"}\nradial = {name = \"r\", unit = \"um\"}\n" +
      map_run("one", "c.csv");
  const imported::Imported made = imported::import_files(imported::parse_map(map, "map.toml"), {file});
  const std::string brief = report::import_text(made, false);
  CHECK(brief.find("run one: 120 samples, lines 62 to 181 of ") == 0);
  CHECK(brief.find("of 720 deg the first 180 and the last") != std::string::npos);
  const std::string full = report::import_text(made, true);
  CHECK(full.find("utf-8, 241 rows of 2 columns, lines 2 to 242") != std::string::npos);
  CHECK(full.find("\"a\"") != std::string::npos);
  CHECK(full.find("-180.00 deg to 540.00 deg") != std::string::npos);
  CHECK(full.find(brief) != std::string::npos);
}

#include "imported/foreign_table.hpp"

#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "imported/import.hpp"
#include "imported/layouts.hpp"

using namespace plumbline;
using namespace plumbline::testing;

TEST_CASE("a row with more values than the header has names is refused: a decimal comma makes two of a number") {
  const Scratch scratch;
  const std::string map =
      kMapHead + "[columns]\nangle = {name = \"a\", unit = \"deg\"}\nradial = {name = \"r\", unit = \"um\"}\n" +
      map_run("one", "c.csv");
  const auto import = [&](const std::string& behind) {
    scratch.file("c.csv", "a,r\n" + lines(way(0, 351), [](const Moment& m) { return fmt::format("{},1.5", m.deg); }) +
                              "354,1.5" + behind + "\n");
    return imported::import_files(imported::parse_map(map, "map.toml"), {scratch.path("c.csv")});
  };
  const Diagnostic d = refusal_of([&] { import(",25"); });
  CHECK(d.code == "import-columns");
  CHECK(d.place.line == 120);
  CHECK(d.help.find("decimal comma") != std::string::npos);
  CHECK(import(",").dataset.runs.size() == 1);  // many programs end each row with a delimiter
}

#include "imported/taken_rows.hpp"

#include <functional>

#include <catch2/catch.hpp>

#include "imported/import.hpp"
#include "imported/layouts.hpp"

using namespace plumbline;
using namespace plumbline::testing;

namespace {

struct Row {
  double seconds = 0, deg = 0;
  std::string radial;
};

// What is said of a table whose rows are spoiled one by one. `circle`: lines of the map.
Diagnostic refused(const std::function<void(std::size_t, Row&)>& spoil, const std::string& circle = "") {
  const Scratch scratch;
  std::size_t i = 0;
  scratch.file("c.csv", "t,a,r\n" + lines(way(0, 357), [&](const Moment& m) {
                          Row row{m.seconds, m.deg, fmt::format("{:.4f}", radial_um(m.deg))};
                          spoil(i++, row);
                          return fmt::format("{:.6f},{:.3f},{}", row.seconds, row.deg, row.radial);
                        }));
  const std::string map = kMapHead + circle +
                          "[columns]\ntime = {name = \"t\", unit = \"s\"}\nangle = {name = \"a\", unit = \"deg\"}\n"
                          "radial = {name = \"r\", unit = \"um\"}\n" +
                          map_run("one", "c.csv");
  return refusal_of([&] { imported::import_files(imported::parse_map(map, "map.toml"), {scratch.path("c.csv")}); });
}

}  // namespace

TEST_CASE("readings that no dataset holds are refused at their line") {
  for (const char* const value : {"150005", "-1e300", "20001"}) {
    const Diagnostic said = refused([&](std::size_t i, Row& row) {
      if (i == 40) row.radial = value;
    });
    CAPTURE(value, said.message);
    CHECK(said.code == "import-value");
    CHECK(said.place.line == 42);
    CHECK(said.help.find("minus") != std::string::npos);
  }
  CHECK(refused([](std::size_t, Row& row) { row.radial = "19999"; }).code.empty());
}

TEST_CASE("a row that is there twice is refused, and a coarse clock is not where means are taken") {
  double last = 0;
  const auto twice = [&](std::size_t i, Row& row) {
    if (i == 7) row.seconds = last;
    last = row.seconds;
  };
  const Diagnostic said = refused(twice);
  CHECK(said.code == "import-value");
  CHECK(said.place.line == 9);
  CHECK(refused(twice, "[circle]\nsamples = 40\n").code.empty());
}

TEST_CASE("a run of which many rows lack a reading is refused, and one of which few do is not") {
  for (const std::size_t every : {1U, 2U, 10U}) {
    const Diagnostic said = refused([&](std::size_t i, Row& row) {
      if (i % every == 0) row.radial = "";
    });
    CAPTURE(every, said.message);
    CHECK(said.code == "import-value");
    CHECK(said.message.find(" of 120 rows lack a reading") != std::string::npos);
  }
  CHECK(refused([](std::size_t i, Row& row) {
          if (i % 40 == 0) row.radial = "";
        }).code.empty());
}

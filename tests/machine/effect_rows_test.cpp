#include "machine/effect_rows.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::machine;

namespace {

std::vector<EffectRow> rows_of(std::string text) { return read_effect_rows(parse_toml(std::move(text), "m.toml")); }

Diagnostic refused_rows(const std::string& text) {
  return testing::refusal_of([&] { rows_of(text); });
}

}  // namespace

TEST_CASE("rows of effects come in their order, their numbers flat, and say how they were nested") {
  const std::vector<EffectRow> rows = rows_of(
      "[[effect]]\nname = \"joint-position\"\nbase_um = [[1, 2, 3], [4, 5, 6]]\n\n"
      "[[effect]]\nname = \"servo-lag\"\nlag_ms = 2.5\nwidth_um = [1, 2]\n");
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].name == "joint-position");
  CHECK(rows[0].place.line == 2);
  REQUIRE(rows[0].values.size() == 1);
  CHECK(rows[0].values[0].values == std::vector<double>{1, 2, 3, 4, 5, 6});
  CHECK(rows[0].values[0].shape == std::vector<std::size_t>{2, 3});
  REQUIRE(rows[1].values.size() == 2);
  CHECK(rows[1].values[0].key == "lag_ms");
  CHECK(rows[1].values[0].shape.empty());
  CHECK(rows[1].values[0].values == std::vector<double>{2.5});
  CHECK(rows[1].values[1].shape == std::vector<std::size_t>{2});
  CHECK(rows[1].values[1].place.line == 8);
  CHECK(rows[1].values[1].key_place.column == 1);
}

TEST_CASE("a file without effects has no rows") { CHECK(rows_of("name = \"plain\"\n").empty()); }

TEST_CASE("a row without a name, ragged or of no numbers is refused where that stands") {
  const Diagnostic nameless = refused_rows("[[effect]]\nlag_ms = 2\n");
  CHECK(nameless.code == "model-missing-key");
  CHECK(nameless.place.line == 1);
  CHECK(refused_rows("[[effect]]\nname = 5\n").code == "model-wrong-type");
  const Diagnostic ragged = refused_rows("[[effect]]\nname = \"a\"\nbase_um = [[1, 2], [3]]\n");
  CHECK(ragged.code == "model-wrong-size");
  CHECK(ragged.place.line == 3);
  CHECK(ragged.place.column == 20);
  CHECK(refused_rows("[[effect]]\nname = \"a\"\nlag_ms = \"2\"\n").code == "model-wrong-type");
  CHECK(refused_rows("[[effect]]\nname = \"a\"\nlag_ms = nan\n").code == "model-not-finite");
  CHECK(refused_rows("[effect]\nname = \"a\"\n").code == "model-effect-row");
}

// Files that each flaw is refused with are in bad/, where model_file_test.cpp reads them.
#include "machine/model_values.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "machine/machines.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::machine;

namespace {

// The model of the tests with one piece of its text replaced.
TomlDocument with_text(const std::string& piece, const std::string& by) {
  std::string text = read_text(testing::source_path("models/pm600-like.toml"));
  const std::size_t at = text.find(piece);
  REQUIRE(at != std::string::npos);
  return parse_toml(text.replace(at, piece.size(), by), "m.toml");
}

const ModelValue& value_of(const std::vector<ModelValue>& values, std::string_view table, std::string_view key) {
  return *std::find_if(values.begin(), values.end(),
                       [&](const ModelValue& value) { return value.table == table && value.key == key; });
}

}  // namespace

TEST_CASE("every key is there in its order, given or not, in SI") {
  const std::vector<ModelValue> values = read_values(with_text("ZYX", "ZYX"));
  REQUIRE(values.size() == kKeys.size());
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(values[i].key == kKeys[i].key);
  const ModelValue& friction = value_of(values, "strut", "coulomb_friction_N");
  CHECK(friction.given());
  CHECK(friction.values == std::vector<double>{110, 130, 160, 130, 160, 160});
  CHECK(value_of(values, "limits", "tilt_deg").values.at(0) == Approx(25 * kDeg));
  CHECK_FALSE(value_of(values, "limits", "condition_max").given());
}

TEST_CASE("one number for all struts is spread to six") {
  const std::vector<ModelValue> values =
      read_values(with_text("coulomb_friction_N = [110, 130, 160, 130, 160, 160]", "coulomb_friction_N = 120"));
  CHECK(value_of(values, "strut", "coulomb_friction_N").values == std::vector<double>(6, 120));
}

TEST_CASE("a key that is no key is refused with the one that was probably meant, or its table") {
  const auto refused = [](const std::string& piece, const std::string& by) {
    return testing::refusal_of([&] { read_values(with_text(piece, by)); });
  };
  const Diagnostic misspelt = refused("coulomb_friction_N", "coulomb_frition_N");
  CHECK(misspelt.code == "model-unknown-key");
  CHECK(misspelt.help.find("coulomb_friction_N") != std::string::npos);
  const Diagnostic misplaced = refused("[limits]", "[limits]\ncoulomb_friction_N = 1");
  CHECK(misplaced.code == "model-unknown-key");
  CHECK(misplaced.help == "it belongs into the table [strut]");
  CHECK(refused("[limits]", "[limit]").code == "model-unknown-table");
  CHECK(refused("machine 1", "machine 2").code == "model-marker");
  CHECK(refused("[110, 130, 160, 130, 160, 160]", "[110, 130, 160, 130, 160]").code == "model-wrong-size");
}

TEST_CASE("a value of another unit is told what it would be, where that is possible") {
  CHECK(slip_hint(units::mm, 1.2, 100, 5000) == "; if it was meant in m, write 1200");
  CHECK(slip_hint(units::mm, 1200000, 100, 5000) == "; if it was meant in um, write 1200");
  CHECK(slip_hint(units::mm, 1e9, 100, 5000).empty());
  CHECK(slip_hint(units::kg, 0, 0, 100, 0.001).empty());  // nil is nil in every unit
  CHECK(slip_hint(units::percent, 5, 0, 1).empty());      // nothing is mistaken for it
}

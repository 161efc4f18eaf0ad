#include "machine/numbers_hash.hpp"

#include <catch2/catch.hpp>

#include "machine/model_file.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::machine;

namespace {

std::uint64_t hash_with(std::string_view from, std::string_view to) {
  std::string text = read_text(testing::source_file("models/pm600-like.toml"));
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  text.replace(at, from.size(), to);
  return numbers_hash(parse_model(text, "m.toml"));
}

}  // namespace

TEST_CASE("numbers of the machine change the hash, comments and what it may do do not") {
  const std::uint64_t hash = hash_with("plumbline", "plumbline");
  CHECK(hash_with("plumbline", "# a comment\nplumbline") == hash);
  CHECK(hash_with("tilt_deg = 25", "tilt_deg = 26") == hash);
  CHECK(hash_with("joint_position_um = ", "joint_position_um = 1") == hash);
  CHECK(hash_with("[limits]", "[posterior]\nfile = \"a\"\nhash = \"b\"\n[limits]") == hash);
  CHECK(hash_with("mass_kg = 100", "mass_kg = 100.0") == hash);
  CHECK(hash_with("mass_kg = 100", "mass_kg = 101") != hash);
  CHECK(hash_with("ZYX", "XYZ") != hash);
  std::string text = read_text(testing::source_file("models/pm600-like.toml"));
  text += "\n[[effect]]\nname = \"backlash\"\nwidth_um = [1, 0, 0, 0, 0, 0]\n";
  CHECK(numbers_hash(parse_model(text, "m.toml")) != hash);
}

#include "batch/settings_by_folder.hpp"

#include <catch2/catch.hpp>

#include "batch/shop.hpp"

using namespace plumbline;
using namespace plumbline::testing;
using batch::SettingsByFolder;

namespace {

std::uint64_t hash_of(const Shop& shop, const char* program = "parts/a.nc") {
  settings::SettingsRequest request;
  request.file = shop.scratch.path("parts/plumbline.toml");
  return SettingsByFolder(request).of(shop.scratch.path(program)).hash;
}

}  // namespace

TEST_CASE("what holds for a folder is read once, and its model is shared") {
  const Shop shop;
  shop.scratch.file("parts/inner/plumbline.toml", "plumbline = \"settings 1\"\nstep_length = 0.5\n");
  SettingsByFolder settings({});
  const auto& outer = settings.of(shop.scratch.path("parts/a.nc"));
  const auto& inner = settings.of(shop.scratch.path("parts/inner/b.nc"));
  CHECK(&settings.of(shop.scratch.path("parts/other.nc")) == &outer);
  CHECK(outer.model == inner.model);
  CHECK(outer.hash != inner.hash);
  CHECK(inner.options.compensation.step.length_mm == 0.5);
  const auto files = settings.files();
  const std::string inner_file = shop.scratch.path("parts/inner/plumbline.toml");
  REQUIRE(files.contains(inner_file));
  CHECK(files.at(inner_file) == file_state(inner_file));
  CHECK(files.contains(source_file("models/pm600-like.toml")));
}

TEST_CASE("the fingerprint tells every file and option, and no more") {
  const Shop shop;
  const std::string settings = shop.scratch.text("parts/plumbline.toml");
  const std::uint64_t plain = hash_of(shop);
  CHECK(hash_of(shop, "parts/inner/b.nc") == plain);
  shop.scratch.file("parts/plumbline.toml", "output_name = \"{folder}/{name}.x\"\n" + settings);
  CHECK(hash_of(shop) == plain);  // where an output lies is known by itself
  shop.scratch.file("parts/plumbline.toml", "guard = true\n" + settings);
  CHECK(hash_of(shop) != plain);
  shop.scratch.file("parts/t.toml", "plumbline = \"tools 1\"\n[[tool]]\nnumber = 1\nlength_mm = 80\n");
  shop.scratch.file("parts/plumbline.toml", "tools = \"t.toml\"\n" + settings);
  const std::uint64_t with_tools = hash_of(shop);
  CHECK(with_tools != plain);
  shop.scratch.file("parts/t.toml", "plumbline = \"tools 1\"\n[[tool]]\nnumber = 1\nlength_mm = 81\n");
  CHECK(hash_of(shop) != with_tools);
  shop.scratch.file("parts/m.toml", read_text(source_file("models/pm600-like.toml")) + "\n# another\n");
  shop.scratch.file("parts/plumbline.toml",
                    "plumbline = \"settings 1\"\nmodel = \"m.toml\"\n[work_offset]\nG54 = [0, 0, -1008, 0, 0, 0]\n");
  CHECK(hash_of(shop) != plain);
}

TEST_CASE("settings that are refused are refused each time") {
  const Shop shop;
  shop.scratch.file("parts/plumbline.toml", "plumbline = \"settings 1\"\nnonsense = 1\n");
  SettingsByFolder settings({});
  for (int i = 0; i < 2; ++i) {
    CHECK(refusal_of([&] { settings.of(shop.scratch.path("parts/a.nc")); }).code == "settings-key");
  }
}

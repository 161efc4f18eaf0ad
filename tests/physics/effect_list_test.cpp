// One effect is one file and one line of the list: what it says of itself holds together, its row stands in
// docs/effects.md, and its name nowhere else in src.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "physics/effect_info.hpp"

using namespace plumbline::physics;
namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// The row of a table that begins with that name, or the section about it; empty: there is none.
std::string paragraph_of(const std::string& page, std::string_view name) {
  const std::size_t section = page.find(fmt::format("## `{}`", name));
  if (section != std::string::npos) return page.substr(section, page.find("\n## ", section + 1) - section);
  const std::size_t row = page.find(fmt::format("\n| {} |", name));
  return row == std::string::npos ? std::string() : page.substr(row + 1, page.find('\n', row + 1) - row - 1);
}

const ParameterSpec* spec_of(const EffectInfo& info, std::string_view key) {
  const auto spec = std::find_if(info.parameters.begin(), info.parameters.end(),
                                 [&](const ParameterSpec& s) { return s.key == key; });
  return spec == info.parameters.end() ? nullptr : &*spec;
}

}  // namespace

TEST_CASE("every effect of the catalogue has its paragraph in docs/effects.md, with all its keys") {
  const std::string page = text_of(fs::path(PLUMBLINE_SOURCE_DIR) / "docs" / "effects.md");
  int rows = 0;
  for (const EffectInfo& info : effect_infos()) {
    if (info.base) continue;
    INFO(info.name);
    const std::string paragraph = paragraph_of(page, info.name);
    REQUIRE_FALSE(paragraph.empty());
    ++rows;
    for (const ParameterSpec& spec : info.parameters) {
      INFO(spec.key);
      CHECK(paragraph.find(spec.key) != std::string::npos);
    }
  }
  CHECK(rows > 30);
}

TEST_CASE("no effect is named in src outside its file") {
  const std::set<std::string_view> words{"payload", "level", "centre-of-mass"};  // that mean other things, too
  const fs::path source = fs::path(PLUMBLINE_SOURCE_DIR) / "src";
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(source)) {
    const fs::path& file = entry.path();
    if (file.extension() != ".cpp" && file.extension() != ".hpp") continue;
    if (file.parent_path() == source / "physics" / "effects") continue;
    const std::string text = text_of(file);
    ++files;
    for (const EffectInfo& info : effect_infos()) {
      if (words.contains(info.name)) continue;
      INFO(file << " names " << info.name);
      CHECK(text.find(fmt::format("\"{}\"", info.name)) == std::string::npos);
    }
  }
  CHECK(files > 100);
}

TEST_CASE("what an effect says of how it bends fits its numbers, and those that it is made from") {
  int bending = 0;
  for (const EffectInfo& info : effect_infos()) {
    if (info.bend == nullptr) continue;
    ++bending;
    INFO(info.name);
    const Bend& bend = *info.bend;
    const ParameterSpec* size = spec_of(info, bend.size);
    const ParameterSpec* shape = spec_of(info, bend.shape);
    REQUIRE((size != nullptr && shape != nullptr));
    CHECK((bend.by == Bend::By::size) == (size == shape));
    CHECK(shape->shape == (bend.by != Bend::By::size));
    CHECK(shape->periodic == (bend.by == Bend::By::phase));
    CHECK(bend.tried.empty() == (bend.by == Bend::By::phase));
    CHECK((bend.quarter_turn_on != nullptr) == (bend.by == Bend::By::phase));
    for (const double tried : bend.tried) CHECK((tried >= shape->lower && tried <= shape->upper));
    const std::size_t of = effect_index(bend.of);
    REQUIRE(of < kEffects);
    const ParameterSpec* of_key = spec_of(effect_infos()[of], bend.of_key);
    REQUIRE(of_key != nullptr);
    CHECK(of_key->size() == 6);
  }
  CHECK(bending == 3);
}

TEST_CASE("an effect that shows in the torque readings alone is known by its hooks") {
  std::vector<std::string_view> alone;
  for (const EffectInfo& info : effect_infos()) {
    if (info.reading_alone) alone.push_back(info.name);
  }
  CHECK(alone == std::vector<std::string_view>{"torque-scale"});
}

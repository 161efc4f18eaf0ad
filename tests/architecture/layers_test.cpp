// src/layers.txt is the law: no module includes a header of a module that its line does not name.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>

namespace fs = std::filesystem;

namespace {

const fs::path kSource = fs::path(PLUMBLINE_SOURCE_DIR) / "src";
using Layers = std::map<std::string, std::set<std::string>>;

Layers read_layers() {
  Layers layers;
  std::ifstream in(kSource / "layers.txt");
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    const std::size_t colon = line.find(':');
    REQUIRE(colon != std::string::npos);
    std::istringstream names(line.substr(colon + 1));
    auto& allowed = layers[line.substr(0, colon)];
    for (std::string name; names >> name;) {
      INFO("a module may only name modules of the lines above it: " << name);
      REQUIRE(layers.contains(name));
      allowed.insert(name);
    }
  }
  return layers;
}

std::string module_of(const fs::path& file) { return fs::relative(file, kSource).begin()->string(); }

bool is_code(const fs::path& file) {
  return file.extension() == ".hpp" || file.extension() == ".cpp" || file.extension() == ".re";
}

}  // namespace

TEST_CASE("no include points up the layers") {
  const Layers layers = read_layers();
  const std::regex include(R"re(^\s*#\s*include\s*"([^"/]+)/[^"]+")re");
  int seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kSource)) {
    if (!is_code(entry.path())) continue;
    const std::string module = module_of(entry.path());
    INFO(entry.path());
    REQUIRE(layers.contains(module));
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      const std::string used = match[1];
      INFO(line);
      CHECK((used == module || layers.at(module).contains(used)));
      ++seen;
    }
  }
  CHECK(seen > 10);
}

TEST_CASE("quoted includes name their module") {
  const std::regex bare(R"re(^\s*#\s*include\s*"[^"/]+")re");
  for (const auto& entry : fs::recursive_directory_iterator(kSource)) {
    if (!is_code(entry.path())) continue;
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      INFO(entry.path() << ": " << line);
      CHECK_FALSE(std::regex_search(line, bare));
    }
  }
}

TEST_CASE("every folder of src is a layer, and has a README that a newcomer can read") {
  const Layers layers = read_layers();
  for (const auto& entry : fs::directory_iterator(kSource)) {
    if (!entry.is_directory()) continue;
    INFO(entry.path());
    CHECK(layers.contains(entry.path().filename().string()));
    CHECK(fs::exists(entry.path() / "README.md"));
  }
}

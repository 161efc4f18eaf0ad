// src/layers.txt is the law: no module includes a header of a module that its line does not name.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

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

/// The layer of a file, or of an included header, named from src: the deepest of its folders that has a line.
std::string layer_of(const Layers& layers, fs::path file) {
  do file = file.parent_path();
  while (file.has_parent_path() && !layers.contains(file.generic_string()));
  return file.generic_string();
}

/// Who may include `nc` may include each of its rooms and their rooms, as what stands beside these rooms may.
bool may_include(const Layers& layers, const std::string& module, const fs::path& used) {
  const std::set<std::string>& allowed = layers.at(module);
  for (fs::path house = used; !house.empty(); house = house.parent_path()) {
    if (house == module || allowed.contains(house.generic_string())) return true;
  }
  return false;
}

bool is_code(const fs::path& file) {
  return file.extension() == ".hpp" || file.extension() == ".cpp" || file.extension() == ".re";
}

}  // namespace

TEST_CASE("no include points up the layers") {
  const Layers layers = read_layers();
  const std::regex include(R"re(^\s*#\s*include\s*"([^"]+/[^"/]+)")re");
  int seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kSource)) {
    if (!is_code(entry.path())) continue;
    const std::string module = layer_of(layers, fs::relative(entry.path(), kSource));
    INFO(entry.path());
    REQUIRE(layers.contains(module));
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      const std::string used = layer_of(layers, match[1].str());
      INFO(line);
      CHECK(may_include(layers, module, used));
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

TEST_CASE("the public interface is seen by api alone, and stands on the standard library") {
  const std::regex include(R"re(^\s*#\s*include\s*[<"](.*/.*)[>"])re");
  int seen = 0;
  for (const fs::path& folder : {kSource, kSource.parent_path() / "include"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const bool is_public = folder != kSource;
      if (!entry.is_regular_file() || (!is_public && !is_code(entry.path()))) continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, include)) continue;
        const bool of_interface = match[1].str().starts_with("plumbline/");
        const fs::path module = *fs::relative(entry.path(), folder).begin();
        INFO(entry.path() << ": " << line);
        CHECK((is_public ? of_interface : !of_interface || module == "api"));
        seen += of_interface ? 1 : 0;
      }
    }
  }
  CHECK(seen >= 4);
}

TEST_CASE("every folder of src is a layer, and has a README that a newcomer can read") {
  const Layers layers = read_layers();
  for (const auto& entry : fs::directory_iterator(kSource)) {
    if (!entry.is_directory()) continue;
    INFO(entry.path());
    CHECK(layers.contains(entry.path().filename().string()));
  }
  for (const auto& [layer, _] : layers) {
    INFO(layer);
    CHECK(fs::exists(kSource / layer / "README.md"));
  }
}

TEST_CASE("no header includes itself by way of others") {
  std::map<std::string, std::vector<std::string>> includes;
  const std::regex include(R"re(^\s*#\s*include\s*"([^"]+)")re");
  for (const auto& entry : fs::recursive_directory_iterator(kSource)) {
    if (entry.path().extension() != ".hpp") continue;
    auto& of_this = includes[fs::relative(entry.path(), kSource).generic_string()];
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      if (std::smatch match; std::regex_search(line, match, include)) of_this.push_back(match[1]);
    }
  }
  enum class Seen : std::uint8_t { no, entered, left };
  std::map<std::string, Seen> seen;
  const std::function<void(const std::string&)> enter = [&](const std::string& header) {
    INFO(header);
    REQUIRE(seen[header] != Seen::entered);
    if (seen[header] == Seen::left) return;
    seen[header] = Seen::entered;
    for (const std::string& next : includes[header]) enter(next);
    seen[header] = Seen::left;
  };
  for (const auto& [header, _] : includes) enter(header);
  CHECK(seen.size() > 100);
}

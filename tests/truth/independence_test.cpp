// The stand-in proves nothing if it shares code with what it is held against.
#include <filesystem>
#include <fstream>
#include <regex>

#include <catch2/catch.hpp>

TEST_CASE("the stand-in includes no header of src/") {
  namespace fs = std::filesystem;
  const std::regex include(R"re(\s*#\s*include\s*"([^"]+)".*)re");
  int files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(PLUMBLINE_SOURCE_DIR) / "tests" / "truth")) {
    const fs::path& path = entry.path();
    const std::string name = path.filename().string();
    const bool test = name.size() > 9 && name.substr(name.size() - 9) == "_test.cpp";
    if (test || (path.extension() != ".cpp" && path.extension() != ".hpp")) continue;
    ++files;
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
      std::smatch found;
      if (!std::regex_match(line, found, include)) continue;
      INFO(path.string() << ": " << line);
      CHECK(found[1].str().rfind("truth/", 0) == 0);
    }
  }
  CHECK(files > 10);
}

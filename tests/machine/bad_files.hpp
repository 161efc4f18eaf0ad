// Files that must be refused: the first line of each says `# expect: CODE LINE COLUMN`.
#pragma once

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"

namespace plumbline::testing {

/// Runs `read(path)` on every file of the folder, and checks that it is refused as the file says, at a place, with a
/// way out.
template <class Read>
void check_bad_files(const std::string& folder, std::size_t at_least, Read read) {
  std::vector<std::filesystem::path> files(std::filesystem::directory_iterator(folder), {});
  std::sort(files.begin(), files.end());
  CHECK(files.size() >= at_least);
  for (const auto& file : files) {
    INFO(file.filename().string());
    std::istringstream first_line(read_text(file.string()));
    std::string hash;
    std::string expect;
    std::string code;
    std::size_t line = 0;
    std::size_t column = 0;
    first_line >> hash >> expect >> code >> line >> column;
    REQUIRE(expect == "expect:");
    try {
      read(file.string());
      FAIL_CHECK("was not refused");
    } catch (const Refusal& refusal) {
      const Diagnostic& d = refusal.diagnostic();
      INFO(to_text(d));
      CHECK(d.code == code);
      CHECK(d.place.line == line);
      CHECK(d.place.column == column);
      CHECK(d.place.file == file.string());
      CHECK_FALSE(d.help.empty());
    }
  }
}

}  // namespace plumbline::testing

// Programs that use every word of the language mean what LinuxCNC's own interpreter makes of them: NAME.canon beside a
// program is its output; where rs274 is installed it is run afresh as well.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "base/diagnostic.hpp"
#include "base/files/files.hpp"
#include "nc/canon.hpp"
#include "nc/language/tool_table.hpp"
#include "nc/programs.hpp"
#include "support/skip.hpp"

using namespace plumbline;
using namespace plumbline::nc;
using namespace plumbline::nc::tests;
namespace fs = std::filesystem;

namespace {

constexpr double kTolerance = 1e-4;  // of the program's unit: what four decimals hold

ProgramSettings with_tools() {
  ProgramSettings settings = empty_tables();
  settings.tools = read_tool_table((folder("programs") / "tools.toml").string());
  return settings;
}

std::vector<fs::path> programs_in(const fs::path& path) {
  std::vector<fs::path> programs;
  for (const auto& entry : fs::directory_iterator(path)) {
    if (entry.path().extension() == ".ngc") programs.push_back(entry.path());
  }
  std::sort(programs.begin(), programs.end());
  return programs;
}

void compare(const fs::path& program, const std::string& canon) {
  INFO(program);
  const std::string difference =
      first_difference(motions_of_file(program.string(), with_tools()), read_canon(canon), kTolerance);
  INFO(difference);
  CHECK(difference.empty());
}

// Runs rs274 beside the program, where it looks for subprograms, and with a home of its own; false: it complains.
bool run_rs274(const fs::path& program, const fs::path& scratch, std::string& canon) {
  fs::create_directories(scratch);
  fs::copy_file(folder("programs") / "tools.tbl", scratch / "tools.tbl", fs::copy_options::overwrite_existing);
  fs::remove(scratch / "variables.var");
  std::ofstream(scratch / "variables.var").close();
  canon = (scratch / "out.canon").string();
  // What never ends is stopped by the seconds that it computes, which other work on the machine does not lengthen.
  const std::string command = fmt::format(
      "cd '{}' && ulimit -t 20 && HOME='{}' timeout 600 rs274 -g -n 2 -t '{}/tools.tbl' -v '{}/variables.var' '{}' "
      "'{}' </dev/null >/dev/null 2>&1",
      program.parent_path().string(), scratch.string(), scratch.string(), scratch.string(), program.string(), canon);
  return std::system(command.c_str()) == 0;
}

std::string fresh_canon(const fs::path& program, const fs::path& scratch) {
  std::string canon;
  if (!run_rs274(program, scratch, canon)) WARN("rs274 complains about " << program);
  return canon;
}

// The samples that come with LinuxCNC, unpacked where they are packed, and those of the corpus.
std::vector<fs::path> samples(const fs::path& scratch) {
  std::vector<fs::path> programs;
  for (const fs::path& root : {fs::path("/usr/share/doc/linuxcnc"), fs::path("/usr/share/axis"),
                               fs::path("/usr/share/linuxcnc"), corpus().empty() ? corpus() : corpus() / "linuxcnc"}) {
    if (root.empty() || !fs::is_directory(root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      const fs::path& path = entry.path();
      if (path.extension() == ".ngc") programs.push_back(path);
      if (path.extension() != ".gz" || path.stem().extension() != ".ngc") continue;
      const fs::path unpacked = scratch / path.relative_path().parent_path() / path.stem();
      fs::create_directories(unpacked.parent_path());
      const std::string command = fmt::format("gzip -dc '{}' > '{}'", path.string(), unpacked.string());
      if (std::system(command.c_str()) == 0) programs.push_back(unpacked);
    }
  }
  std::sort(programs.begin(), programs.end());
  std::set<std::string> seen;
  std::erase_if(programs, [&](const fs::path& path) { return !seen.insert(read_text(path.string())).second; });
  return programs;
}

std::string to_upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// What is not traced as rs274 runs it, and why: docs/corpus.md says it file by file.
bool is_explained(const Diagnostic& diagnostic) {
  constexpr std::array kCodes{"G70", "G72", "G8", "G42"};
  return diagnostic.code == "nc-not-interpreted" &&
         std::any_of(kCodes.begin(), kCodes.end(),
                     [&](std::string_view code) { return to_upper(diagnostic.message).starts_with(code); });
}

// rs274 forgets the tool length where a tool change and G43 stand in one block; the control itself does not.
bool is_explained(const fs::path& program) { return program.filename() == "skeleton.ngc"; }

}  // namespace

TEST_CASE("programs mean what the canonical calls kept beside them say") {
  const std::vector<fs::path> programs = programs_in(folder("programs"));
  CHECK(programs.size() >= 30);
  for (const fs::path& program : programs) compare(program, fs::path(program).replace_extension(".canon").string());
}

TEST_CASE("programs mean what rs274 makes of them now") {
  if (!testing::has_rs274_or_skips()) return;
  const ProgramFile unique("");
  const fs::path scratch = unique.path() + ".d";
  for (const fs::path& program : programs_in(folder("programs"))) compare(program, fresh_canon(program, scratch));
  fs::remove_all(scratch);
}

TEST_CASE("programs of others mean what the canonical calls beside them say") {
  if (corpus().empty()) return testing::skip_without_corpus();
  for (const char* name :
       {"arcspiral", "b-index", "abc_tangent", "daisy", "factorial", "flowsnake", "g20sub", "hole-circle"}) {
    const fs::path program = corpus() / "linuxcnc" / (std::string(name) + ".ngc");
    if (!fs::exists(program)) continue;
    compare(program, fs::path(program).replace_extension(".canon").string());
  }
}

TEST_CASE("programs that rs274 runs clean are traced as it runs them") {
  if (!testing::has_rs274_or_skips()) return;
  const ProgramFile unique("");
  const fs::path scratch = unique.path() + ".d";
  fs::create_directories(scratch);
  int clean = 0;
  int equal = 0;
  std::string refused;
  for (const fs::path& program : samples(scratch)) {
    std::string canon;
    if (!run_rs274(program, scratch, canon)) continue;
    ++clean;
    INFO(program);
    try {
      const std::string difference =
          first_difference(motions_of_file(program.string(), with_tools()), read_canon(canon), kTolerance);
      INFO(difference);
      CHECK((difference.empty() || is_explained(program)));
      if (difference.empty()) ++equal;
    } catch (const Refusal& refusal) {
      refused += program.filename().string() + ": " + to_text(refusal.diagnostic()) + "\n";
      CHECK(is_explained(refusal.diagnostic()));
    }
  }
  fs::remove_all(scratch);
  WARN(equal << " of " << clean << " programs equal\n" << refused);
  CHECK(equal >= 0.97 * clean);
}

TEST_CASE("a five-axis program passes when its user code is let through, and not without") {
  const fs::path program = corpus() / "linuxcnc/impeller-7bl-xyzac.ngc";
  if (corpus().empty() || !fs::exists(program)) return testing::skip_without_corpus();
  ProgramSettings settings = at_zero();
  CHECK(refusal_of_file(program.string(), settings).value().code == "nc-user-code");
  settings.passed_m_codes = {428, 429};
  CHECK(motions_of_file(program.string(), settings).size() > 4000);
}

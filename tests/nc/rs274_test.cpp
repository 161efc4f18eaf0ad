// Programs that use every word of the language mean what LinuxCNC's own interpreter makes of them: NAME.canon beside a
// program is its output; where rs274 is installed it is run afresh as well.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "nc/canon.hpp"
#include "nc/programs.hpp"
#include "nc/tool_table.hpp"

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

bool has_rs274() { return std::system("command -v rs274 >/dev/null 2>&1") == 0; }

// Runs rs274 beside the program, where it looks for subprograms, and with a home of its own.
std::string fresh_canon(const fs::path& program, const fs::path& scratch) {
  fs::create_directories(scratch);
  fs::copy_file(folder("programs") / "tools.tbl", scratch / "tools.tbl", fs::copy_options::overwrite_existing);
  fs::remove(scratch / "variables.var");
  std::ofstream(scratch / "variables.var").close();
  const std::string canon = (scratch / "out.canon").string();
  const std::string command = fmt::format(
      "cd '{}' && HOME='{}' rs274 -g -n 2 -t '{}/tools.tbl' -v '{}/variables.var' '{}' '{}' >/dev/null 2>&1",
      program.parent_path().string(), scratch.string(), scratch.string(), scratch.string(), program.string(), canon);
  if (std::system(command.c_str()) != 0) WARN("rs274 complains about " << program);
  return canon;
}

}  // namespace

TEST_CASE("programs mean what the canonical calls kept beside them say") {
  const std::vector<fs::path> programs = programs_in(folder("programs"));
  CHECK(programs.size() >= 30);
  for (const fs::path& program : programs) compare(program, fs::path(program).replace_extension(".canon").string());
}

TEST_CASE("programs mean what rs274 makes of them now") {
  if (!has_rs274()) {
    WARN("rs274 is not installed: compared with its kept output only");
    return;
  }
  const ProgramFile unique("");
  const fs::path scratch = unique.path() + ".d";
  for (const fs::path& program : programs_in(folder("programs"))) compare(program, fresh_canon(program, scratch));
  fs::remove_all(scratch);
}

TEST_CASE("programs of others mean what the canonical calls beside them say") {
  if (corpus().empty()) {
    WARN("no corpus: name its folder in PLUMBLINE_NC_CORPUS");
    return;
  }
  for (const char* name :
       {"arcspiral", "b-index", "abc_tangent", "daisy", "factorial", "flowsnake", "g20sub", "hole-circle"}) {
    const fs::path program = corpus() / "linuxcnc" / (std::string(name) + ".ngc");
    if (!fs::exists(program)) continue;
    compare(program, fs::path(program).replace_extension(".canon").string());
  }
}

TEST_CASE("a five-axis program passes when its user code is let through, and not without") {
  const fs::path program = corpus() / "linuxcnc/impeller-7bl-xyzac.ngc";
  if (corpus().empty() || !fs::exists(program)) return;
  ProgramSettings settings = at_zero();
  CHECK(refusal_of_file(program.string(), settings).value().code == "nc-user-code");
  settings.passed_m_codes = {428, 429};
  CHECK(motions_of_file(program.string(), settings).size() > 4000);
}

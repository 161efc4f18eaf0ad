// What comes out is read by another interpreter too: rs274 takes every compensated program, and moves as we say it
// does.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "compensate/bound/drawn_arcs.hpp"
#include "compensate/play.hpp"
#include "nc/canon.hpp"
#include "support/skip.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

constexpr double kTolerance = 1e-4;  // of the program's unit: what four decimals hold
const fs::path kPrograms = fs::path(PLUMBLINE_SOURCE_DIR) / "tests/nc/programs";

// False: it complains.
bool run_rs274(const Folder& folder, const std::string& program, const std::string& canon) {
  std::ofstream(folder / "variables.var").close();
  const std::string command = fmt::format(
      "cd '{0}' && ulimit -t 60 && HOME='{0}' timeout 600 rs274 -g -n 2 -t '{1}/tools.tbl' -v variables.var {2} {3} "
      ">/dev/null 2>&1",
      fs::path(folder / ".").parent_path().string(), kPrograms.string(), program, canon);
  return std::system(command.c_str()) == 0;
}

// The machine of the example, its table low enough for most programs, with all that they ask for.
Job within_reach() {
  Job job;
  job.settings.step.length_mm = 5;
  for (auto& offset : job.program.work_offsets) offset = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  for (auto& start : job.program.start) start = 0;
  job.program.keeps_position = {0, 1, 6, 60};
  job.program.tools = nc::read_tool_table((kPrograms / "tools.toml").string());
  job.program.block_delete = false;
  job.program.max_blocks = 200'000;
  return job;
}

std::vector<fs::path> programs() {
  std::vector<fs::path> found;
  const char* const named = std::getenv("PLUMBLINE_NC_CORPUS");
  for (const fs::path& root : {kPrograms, fs::path("/usr/share/linuxcnc/ncfiles"),
                               named != nullptr ? fs::path(named) / "linuxcnc" : fs::path()}) {
    if (root.empty() || !fs::is_directory(root)) continue;
    for (const auto& entry : fs::directory_iterator(root)) {
      if (entry.path().extension() == ".ngc") found.push_back(entry.path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Compensates a file where it stands, since its subprograms stand beside it; false: it is refused.
bool compensated(const fs::path& program, const std::string& output, const Job& job, bool& changed) {
  try {
    const InputFile source(program.string());
    OutputFile out(output);
    const compensate::Summary summary =
        compensate::Stream(source, surveyed(source, job), job.program, job.model, job.settings, job.emit, out).run();
    changed = !summary.identical;
    out.commit();
    return true;
  } catch (const Refusal& refusal) {
    INFO(program << ": " << refusal.what());
    CHECK(refusal.diagnostic().code != "compensate-read-back");
    return false;
  }
}

std::vector<nc::Motion> traced(const std::string& path) {
  nc::ProgramSettings settings;
  settings.as_with_empty_tables = true;
  settings.tools = nc::read_tool_table((kPrograms / "tools.toml").string());
  const InputFile file(path);
  nc::Program program(file, nc::dialect("linuxcnc"), settings);
  std::vector<nc::Motion> motions;
  while (const nc::Step* step = program.next())
    motions.insert(motions.end(), step->motions.begin(), step->motions.end());
  return motions;
}

}  // namespace

TEST_CASE("rs274 takes arcs that stay arcs, and makes of their words what we make of them") {
  if (!testing::has_rs274_or_skips()) return;
  for (unsigned seed = 41; seed <= 48; ++seed) {
    for (const bool friction : {false, true}) {
      const Folder folder;
      write_text(folder / "in.ngc", DrawnArcs(seed).text(12));
      Job job = within_reach();
      job.settings.bound.tolerance_mm = 1e-3;
      job.settings.friction = friction;
      bool changed = false;
      INFO("seed " << seed << "\n" << read_text(folder / "in.ngc"));
      REQUIRE(compensated(folder / "in.ngc", folder / "out.ngc", job, changed));
      CHECK(changed);
      INFO(read_text(folder / "out.ngc"));
      REQUIRE(run_rs274(folder, "out.ngc", "out.canon"));
      const std::vector<nc::Motion> ours = traced(folder / "out.ngc");
      CHECK(std::count_if(ours.begin(), ours.end(),
                          [](const nc::Motion& m) { return m.kind == nc::MotionKind::arc; }) >= 12);
      CHECK(nc::tests::first_difference(ours, nc::tests::read_canon(folder / "out.canon"), kTolerance).empty());
    }
  }
}

TEST_CASE("rs274 takes what comes out, and moves as it says") {
  if (!testing::has_rs274_or_skips()) return;
  const Job job = within_reach();
  int taken = 0;
  for (const fs::path& program : programs()) {
    const Folder folder;
    bool changed = false;
    if (!compensated(program, folder / "out.ngc", job, changed) || !changed) continue;
    INFO(program);
    const bool accepted = run_rs274(folder, "out.ngc", "out.canon");
    CHECK(accepted);
    if (!accepted) continue;
    const std::string difference = nc::tests::first_difference(traced(folder / "out.ngc"),
                                                               nc::tests::read_canon(folder / "out.canon"), kTolerance);
    INFO(difference);
    CHECK(difference.empty());
    ++taken;
  }
  WARN(taken << " compensated programs run by rs274");
  CHECK(taken >= 10);
}

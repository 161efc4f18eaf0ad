// Programs of real length: the first example, and whatever the folder of other people's programs holds.
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"
#include "support/skip.hpp"

using namespace plumbline;
namespace fs = std::filesystem;

namespace {

fs::path corpus() {
  const char* named = std::getenv("PLUMBLINE_NC_CORPUS");
  return named != nullptr ? fs::path(named) : fs::path(PLUMBLINE_SOURCE_DIR).parent_path() / "shared" / "nc";
}

// Whatever a program asks for is given, and no limit stops it: what is left is whether its bytes survive.
Job without_errors() {
  Job job;
  job.model.gravity.setZero();
  job.settings.friction = false;
  machine::Limits& limits = job.model.limits;
  limits.tilt = 7;
  limits.travel.fill({});
  limits.length_min.setConstant(0);
  limits.length_max.setConstant(1e9);
  for (auto& offset : job.program.work_offsets) offset = nc::WorkOffset{{{0, 0, -1008, 0, 0, 0}}, 0};
  for (auto& start : job.program.start) start = 0;
  job.program.passed_m_codes = {428, 429};
  job.program.keeps_position = {0, 1, 6, 60, 428, 429};
  job.program.block_delete = false;
  job.program.max_blocks = 200'000;
  return job;
}

}  // namespace

TEST_CASE("the example's deformed tip stays on its path, at the points and between them") {
  const Folder folder;
  const std::string example = PLUMBLINE_SOURCE_DIR "/examples/01_compensate_a_program/";
  const std::string command = "python3 -B " + example + "make_program.py " + (folder / "crown.ngc");
  REQUIRE(std::system(command.c_str()) == 0);  // NOLINT(concurrency-mt-unsafe)
  Job job;
  job.settings.friction = false;
  job.program.tools = nc::read_tool_table(example + "tools.toml");
  const std::string text = read_text(folder / "crown.ngc");
  const Result result = run(text, job);
  const nc::Tool& tool = *job.program.tools.find(1);
  const Played played = play(
      text, result.text, job,
      {.length = tool.length_mm * kMm, .mass = tool.mass_kg.value(), .along = tool.centre_of_mass_mm.value() * kMm});
  WARN("example: " << result.summary.points << " points, " << played.at_points_um << " um at them, "
                   << played.between_points_um << " um between, time " << played.time_change);
  CHECK(played.blocks >= 5000);
  CHECK(played.at_points_um <= 0.15);
  CHECK(played.between_points_um <= 0.5);
  CHECK(played.time_change <= 1e-3);
}

TEST_CASE("a model without errors gives every program of the corpus back") {
  std::vector<fs::path> programs;
  for (const fs::path& root : {corpus(), fs::path("/usr/share/linuxcnc/ncfiles")}) {
    if (!fs::is_directory(root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (entry.path().extension() == ".ngc") programs.push_back(entry.path());
    }
  }
  if (programs.empty()) return testing::skip_without_corpus();
  const Job job = without_errors();
  int same = 0;
  for (const fs::path& program : programs) {
    const std::string text = read_text(program.string());
    INFO(program);
    try {
      const Result result = run(text, job, program.parent_path());
      CHECK(result.text == text);
      CHECK(result.summary.identical);
      ++same;
    } catch (const Refusal& refusal) {
      INFO(to_text(refusal.diagnostic()));
      const std::string& code = refusal.diagnostic().code;
      CHECK((code.starts_with("nc-") || code == "compensate-position-unknown"));  // not one for what was changed
    }
  }
  WARN(same << " programs came out as they went in");
  CHECK(same >= 4);
}

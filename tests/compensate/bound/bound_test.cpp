// Programs compensated by a bound: the deformed tip is within it, played densely by code that knows nothing of it.
#include <array>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "compensate/bound/held_bound.hpp"
#include "compensate/random_program.hpp"
#include "machine/machines.hpp"

using namespace plumbline;

namespace {

constexpr std::array kTolerancesUm{0.25, 0.5, 1.0, 5.0};

std::string drawn(unsigned seed, int blocks = 12) { return RandomProgram(seed).text(blocks); }

}  // namespace

TEST_CASE("without friction the deformed tip is within the tolerance everywhere") {
  for (const double tolerance_um : kTolerancesUm) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const std::string text = drawn(seed);
      Job job = job_within(tolerance_um, false);
      job.settings.bound.yields = compensate::BoundSettings::Yields::time;
      const HeldBound held = held_bound(text, job, kDense);
      INFO("seed " << seed << " at " << tolerance_um << " um: " << held.worst_um);
      CHECK(held.said_over() == 0);
      CHECK(held.over == 0);
    }
  }
}

TEST_CASE("with friction the tip is within the tolerance but on the pieces that the summary counts") {
  for (const double tolerance_um : kTolerancesUm) {
    for (unsigned seed = 11; seed <= 13; ++seed) {
      const std::string text = drawn(seed);
      INFO("seed " << seed << " at " << tolerance_um << " um");
      check_held(held_bound(text, job_within(tolerance_um, true), kDense), text);
    }
  }
}

TEST_CASE("a bound holds on other machines") {
  for (const machine::MachineModel& model : testing::three_machines()) {
    for (const bool friction : {false, true}) {
      Job job = job_within(0.5, friction);
      job.model = model;
      const std::string text = drawn(21);
      INFO(model.name << (friction ? " with friction" : ""));
      check_held(held_bound(text, job, kDense), text);
    }
  }
}

TEST_CASE("a block that goes nowhere has one point, whatever its time") {
  for (const bool friction : {false, true}) {
    const std::string text =
        "G21 G90\nG0 X1 Y2 Z3 A1 B2 C3\nG93\nG1 X1 F200\nG1 X4 F200\nX4 F200\nG94\nG1 X4 F100\nM2\n";
    const HeldBound held = held_bound(text, job_within(0.5, friction), kDense);
    check_held(held, text);
    CHECK(held.over <= 2);
  }
}

TEST_CASE("where struts turn at a feed so slow that a block hardly moves, some points are enough") {
  for (const std::string text : {"G21 G90\nG0 X72 Y0 Z100 A0 B0 C0\nG2 X97 Y25 I25 J0 F30\nM2\n",
                                 "G20 G90\nG0 X2.84 Y0 Z4 A0 B0 C0\nG2 X3.84 Y1 I1 J0 F1.18\nM2\n",
                                 "G21 G90\nG0 X72 Y0 Z100 A0 B0 C0\nG1 X60 Y20 Z95 A2 F25\nM2\n"}) {
    for (const double tolerance_um : {1.0, 2.0, 5.0}) {
      const HeldBound held = held_bound(text, job_within(tolerance_um, true), kDense);
      check_held(held, text);
      INFO(tolerance_um << " um");
      CHECK(held.result.summary.points < 60);
    }
  }
}

TEST_CASE("no piece under G93 is shorter than the time of the largest F that the control takes") {
  Job job = job_within(2, true);
  job.dialect = "fanuc";
  const std::string text =
      "O1\nG21 G90 G54\nG0 X0 Y0 Z50. A0 B0 C0\nG93 G1 X15. Y2. A1. F20.\nX30. Y5. A2. B1. F20.\nX60. F1000.\nM30\n";
  CHECK(code_of(text, job) == "emit-feed-range");
  for (const auto yields : {compensate::BoundSettings::Yields::bound, compensate::BoundSettings::Yields::time}) {
    job.settings.bound.yields = yields;
    job.settings.bound.least_inverse_time_s = 6.02e-3;
    const Result result = run(text, job);
    for (const Move& move : moves_of(result.text, job.program, job.dialect)) CHECK(move.motion.feed <= 9999.999);
    CHECK(result.summary.points > 10);
  }
  job.settings.bound = {};
  job.settings.step.length_mm = 0.01;
  CHECK(code_of(text, job) == "emit-feed-range");
  job.settings.step.least_inverse_time_s = 6.02e-3;
  CHECK(code_of(text, job).empty());
}

TEST_CASE("axes that get no word do not ask for points") {
  const std::string text = "G21 G90 G94\nG0 X0 Y0 Z0\nG1 X40 Y10 F1000\nX0 Z-20\nM2\n";  // A, B, C are never named
  Job job = job_within(0.5, false);
  const HeldBound held = held_bound(text, job, kDense);
  CHECK(held.said_over() == 0);
  CHECK(held.played.tip_um <= 0.5);
  CHECK(held.result.summary.points < 20);
}

TEST_CASE("effects of a short pitch are met at a bound as well") {
  Job job = job_within(0.5, false);
  const std::string model = testing::source_path("models/pm600-like.toml");
  const Folder folder;
  job.model = machine::read_model(folder.file(
      "model.toml",
      read_text(model) + "\n[[effect]]\nname = \"generic\"\nlength_um = [0, 3, 0, 0, 0, 0]\npitch_mm = 4\n"));
  const std::string text = "G21 G90 G94\nG0 X-30 Y0 Z0 A0 B0 C0\nG1 X30 Y20 F1000\nM2\n";
  const HeldBound held = held_bound(text, job, kDense);
  CHECK(held.said_over() == 0);
  CHECK(held.over == 0);
  CHECK(held.result.summary.points > 30);  // of eleven waves
}

TEST_CASE("two hundred drawn programs are within their tolerances", "[.long]") {
  const std::vector<machine::MachineModel> machines = testing::three_machines();
  std::uint64_t pieces = 0;
  std::uint64_t over = 0;
  int drifted = 0;
  for (unsigned seed = 100; seed < 300; ++seed) {
    Job job = job_within(kTolerancesUm[seed % kTolerancesUm.size()], seed % 3 != 0);
    job.model = machines[seed % machines.size()];
    const std::string text = drawn(seed, 20);
    INFO("seed " << seed);
    const HeldBound held = held_bound(text, job, kDense);
    drifted += held.drifted ? 1 : 0;
    if (held.drifted) continue;
    check_held(held, text);
    pieces += held.played.pieces.size();
    over += held.over;
  }
  CHECK(drifted <= 2);
  WARN(over << " of " << pieces << " pieces are not within it, all of them counted");
}

TEST_CASE("the program of the first example is within its tolerance, with a fifth of the points", "[.long]") {
  const Folder folder;
  const std::string example = std::string(PLUMBLINE_SOURCE_DIR) + "/examples/01_compensate_a_program/";
  const std::string command = "python3 -B " + example + "make_program.py " + (folder / "crown.ngc");
  REQUIRE(std::system(command.c_str()) == 0);
  const std::string text = read_text(folder / "crown.ngc");
  const compensate::ToolInSpindle tool{0.085, 1.4, 0.022};
  for (const bool friction : {false, true}) {
    Job job = job_within(0.5, friction);
    job.program.tools = nc::read_tool_table(example + "tools.toml");
    const HeldBound held = held_bound(text, job, kDense, tool);
    INFO(held.over << " pieces of " << held.played.pieces.size() << " over for " << held.over_s << " s, up to "
                   << held.worst_um << " um; the others within " << held.kept_um << " um");
    CHECK(held.result.summary.points <= 24'100);  // of the fixed steps: 120,504
    CHECK(held.short_pieces == 0);
    CHECK(held.over <= held.said_over());
    CHECK(held.over_s <= held.said_over_s() * 1.01);
    CHECK(held.worst_um <= held.said_worst_um() * 1.01);
    CHECK(static_cast<double>(held.result.text.size()) <= 2.2 * static_cast<double>(text.size()));
    if (!friction) CHECK(held.over == 0);
    WARN(held.over << " pieces of " << held.played.pieces.size() << " over for " << held.over_s << " s, up to "
                   << held.worst_um << " um; the others within " << held.kept_um << " um");
  }
}

TEST_CASE("a move on which the struts creep is refused soon, with its feed") {
  const Job job = job_within(0.5, true);
  const std::string begin = "G21 G90 G94 G54\nG0 X0 Y0 Z20 A0 B0 C0\n";
  for (const char* const cut : {"G1 X100 F1\n", "G1 X100 F1.5\n", "G0 A-4.89 B-2.54 C3\nG1 Y-28.39 F0.001\n"}) {
    INFO(cut);
    const Diagnostic refused = testing::refusal_of([&] { run(begin + cut + "M2\n", job); });
    CHECK(refused.code == "compensate-tolerance");
    CHECK(refused.message.find("mm/min") != std::string::npos);
    CHECK(refused.help.find("feed") != std::string::npos);
  }
  for (const char* const cut : {"G1 X100 F3\n", "G1 X100 F10\n", "G1 X9 F2\n"}) {
    CHECK(code_of(begin + cut + "M2\n", job).empty());
  }
}

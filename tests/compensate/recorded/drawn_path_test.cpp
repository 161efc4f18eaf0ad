// Whole programs: what path_record.cpp and output_record.cpp do shows in a path that is drawn.
#include "compensate/recorded/drawn_path.hpp"

#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "compensate/play.hpp"

using namespace plumbline;
using compensate::DrawnPath;
using compensate::DrawnPoint;
using compensate::WayKind;

namespace {

struct Drawn {
  DrawnPath path;
  compensate::Summary summary;
};

Drawn drawn(const std::string& text, const Job& job = {}) {
  const Folder folder;
  write_text(folder / "program.in", text);
  const InputFile source(folder / "program.in");
  OutputFile out(folder / "program.out");
  const compensate::ProgramSurvey survey = surveyed(source, job);
  compensate::Stream stream(source, survey, job.program, job.model, job.settings, job.emit, out);
  compensate::PathRecord record(job.model, job.settings);
  stream.record(record);
  Drawn result;
  result.summary = stream.run();
  out.flush();
  result.path = compensate::drawn_path(record, job.model, job.settings, [&](std::uint64_t begin, std::uint64_t end) {
    std::string bytes(end - begin, '\0');
    bytes.resize(out.read(begin, bytes.data(), bytes.size()));
    return bytes;
  });
  return result;
}

const std::string kDrawnProgram =
    "G21 G90 G94 G17\n"
    "G0 X0 Y0 Z20 A0 B0 C0\n"
    "G1 X20 Y10 Z0 A-12 B5 C3 F900\n"
    "G3 X-20 Y10 I-20 J15 A-5\n"
    "G53 G0 Z-900\n"
    "G0 X0 Y0 Z20 A0 B0 C0\n"
    "G1 X30 F1200\n"
    "M2\n";

}  // namespace

TEST_CASE("each point of a short program is drawn, with its line, its text and what replaced it") {
  const auto [path, summary] = drawn(kDrawnProgram);
  REQUIRE(path.points.size() > 50);
  CHECK(path.of_points == path.points.size());
  CHECK(path.points.front().recorded.kind == WayKind::gap);
  const DrawnPoint& last = path.points.back();
  CHECK(last.recorded.line == 7);
  CHECK(last.recorded.text == "G1 X30 F1200");
  CHECK(last.recorded.after.find('X') != std::string::npos);
  CHECK(last.recorded.asked.pose[Axis::X] == Approx(30));
  CHECK(last.recorded.mm_s == Approx(20));
  CHECK(last.recorded.time_s == Approx(summary.seconds_before));
  const auto arcs = std::count_if(path.points.begin(), path.points.end(),
                                  [](const DrawnPoint& p) { return p.recorded.kind == WayKind::arc; });
  CHECK(arcs > 10);
}

TEST_CASE("where nobody follows the machine the path has a gap") {
  const auto [path, summary] = drawn(kDrawnProgram);
  std::vector<std::size_t> gaps;
  for (const DrawnPoint& point : path.points) {
    if (point.recorded.kind == WayKind::gap) gaps.push_back(point.recorded.line);
  }
  CHECK(gaps == std::vector<std::size_t>{2, 6});  // from nowhere, and after G53
}

TEST_CASE("the largest correction of the summary is drawn, and what is left is small beside what would be") {
  Job job;
  job.settings.friction = false;
  const auto [path, summary] = drawn(kDrawnProgram, job);
  double largest = 0;
  for (const DrawnPoint& point : path.points) {
    REQUIRE_FALSE(point.gives_way);
    if (point.recorded.kind == WayKind::rapid || point.recorded.kind == WayKind::gap) continue;
    largest = std::max(largest, length_mm(point.recorded.commanded - point.recorded.asked.pose));
    CHECK(point.left.head<3>().norm() / kUm < 0.25);
    CHECK(point.uncorrected.head<3>().norm() / kUm > 5);
    CHECK(point.condition > 1);
    CHECK((point.lengths - job.model.limits.length_min).minCoeff() > 0);
  }
  // Written words are rounded.
  CHECK(largest == Approx(summary.correction_mm.value).margin(1e-4));
}

TEST_CASE("of a long program few points are drawn, its extremes among them") {
  std::string text = "G21 G90 G94 G17\nG0 X0 Y0 Z20 A0 B0 C0\nG1 F1000\n";
  constexpr int kBlocks = 4000;
  for (int i = 0; i < kBlocks; ++i) {
    // One block sticks out.
    const double z = i == 2345 ? 31 : 20 + 0.001 * (i % 7);
    text += "G1 X" + std::to_string(0.02 * (i % 100)) + " Z" + std::to_string(z) + "\n";
  }
  const auto [path, summary] = drawn(text + "M2\n");
  CHECK(path.of_points > kBlocks);
  const double highest = std::max_element(path.points.begin(), path.points.end(), [](const auto& a, const auto& b) {
                           return a.recorded.asked.pose[Axis::Z] < b.recorded.asked.pose[Axis::Z];
                         })->recorded.asked.pose[Axis::Z];
  CHECK(highest == Approx(31 - 1008));
  CHECK(path.points.size() < 40000);
}

TEST_CASE("a hole of a cycle that is shifted as a whole is drawn, down and up") {
  Job job;
  job.dialect = "fanuc";
  job.settings.friction = false;
  const auto [path, summary] = drawn(
      "O0001\nG21 G17 G90 G54 G94\nG0 X0. Y0. Z50. A0. B0. C0.\nM29 S500\nG99 G84 X5. Y0. Z-10. R2. F500.\nG80\n"
      "G0 Z60.\nM30\n",
      job);
  REQUIRE(summary.changed_blocks > 0);
  std::size_t at_bottom = 0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const compensate::RecordedPoint& point = path.points[i].recorded;
    CHECK((point.kind == WayKind::gap) == (i == 0));
    if (point.line != 5) continue;
    CHECK(point.text.substr(0, 7) == "G99 G84");
    CHECK(point.after.substr(0, 5) == "G99 G");
    CHECK(length_mm(point.commanded - point.asked.pose) > 1e-3);
    at_bottom += std::abs(point.asked.pose[Axis::Z] + 1018) < 1e-6 ? 1 : 0;
  }
  CHECK(at_bottom == 1);
}

TEST_CASE("a point of a subprogram in another file says which") {
  const Folder folder;
  write_text(folder / "sub.ngc", "o<sub> sub\nG1 X5 F500\no<sub> endsub\nM2\n");
  write_text(folder / "program.in", "G21 G90 G94\nG0 X0 Y0 Z20 A0 B0 C0\no<sub> call\nM2\n");
  const Job job;
  const InputFile source(folder / "program.in");
  OutputFile out(folder / "program.out");
  const compensate::ProgramSurvey survey = surveyed(source, job);
  compensate::Stream stream(source, survey, job.program, job.model, job.settings, job.emit, out);
  compensate::PathRecord record(job.model, job.settings);
  stream.record(record);
  stream.run();
  const DrawnPath path = compensate::drawn_path(record, job.model, job.settings);
  REQUIRE(path.points.size() >= 2);
  CHECK(path.points.front().recorded.file.ends_with("program.in"));
  CHECK(path.points.back().recorded.file.ends_with("sub.ngc"));
  CHECK(path.points.back().recorded.line == 2);
}

TEST_CASE("a tool that comes into the spindle is drawn with its length and number") {
  Job job;
  nc::Tool tool;
  tool.number = 3;
  tool.length_mm = 60;
  tool.mass_kg = 1.5;
  job.program.tools = nc::ToolTable({tool});
  const auto [path, summary] = drawn("G21 G90 G94\nT3 M6 G43\nG0 X0 Y0 Z20 A0 B0 C0\nG1 X5 F500\nM2\n", job);
  REQUIRE_FALSE(path.points.empty());
  CHECK(path.points.back().recorded.tool == 3);
  CHECK(path.points.back().tip_z == Approx(job.model.geometry.tool_tip_P.z() - 0.060));
}

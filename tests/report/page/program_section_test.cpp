#include "report/page/program_section.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <catch2/catch.hpp>

#include "base/units.hpp"
#include "machine/model_file.hpp"

namespace plumbline {
namespace {

machine::MachineModel model() { return machine::read_model(PLUMBLINE_SOURCE_DIR "/models/pm600-like.toml"); }

compensate::DrawnPoint point(const machine::MachineModel& model, double x, double correction_mm) {
  compensate::DrawnPoint point;
  point.recorded.kind = compensate::WayKind::line;
  point.recorded.line = 7;
  point.recorded.text = "G1 X1";
  point.recorded.asked.pose = {{x, 0, -1000, 0, 0, 0}};
  point.recorded.commanded = {{x + correction_mm, 0, -1000, 0, 0, 0}};
  point.uncorrected.setZero();
  point.uncorrected[0] = -correction_mm * kMm;
  point.left.setZero();
  point.lengths.setConstant(1.2);
  point.tension.setConstant(-100);
  point.tip_z = model.geometry.tool_tip_P.z();
  point.stands.R_WP.setIdentity();
  return point;
}

double number(const report::Json& column, std::size_t at) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string text = column["data"];
  std::uint32_t bits = 0;
  for (std::size_t byte = 4 * at; byte < 4 * at + 4; ++byte) {
    const std::size_t group = byte / 3 * 4;
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t digit = kDigits.find(text.at(group + k));
      three = three << 6 | static_cast<std::uint32_t>(digit == std::string_view::npos ? 0 : digit);
    }
    bits |= (three >> (16 - 8 * (byte % 3)) & 255) << (8 * (byte - 4 * at));
  }
  return static_cast<std::int32_t>(bits) * column["quantum"].get<double>();
}

TEST_CASE("the lines of a subprogram are shown with the name of its file") {
  const machine::MachineModel machine = model();
  compensate::DrawnPath path{{point(machine, 0, 0.01), point(machine, 1, 0.01)}, 2};
  path.points[0].recorded.file = "parts/part.ngc";
  path.points[1].recorded.file = "parts/sub.ngc";
  const report::Json section =
      report::program_section(path, &machine, {.corrected = true, .program = "parts/part.ngc"});
  REQUIRE(section["blocks"].size() == 2);
  CHECK(section["blocks"][0].size() == 4);
  CHECK(section["blocks"][1][4] == "sub.ngc");
}

TEST_CASE("a path on a page has its columns in their units") {
  const machine::MachineModel machine = model();
  compensate::DrawnPath path{{point(machine, 1, 0.05), point(machine, 2, 0.08), point(machine, 3, 0.02)}, 3};
  path.points[1].recorded.piece_s = 0.02;
  path.points[1].recorded.mm_s = 10;
  const report::Json section = report::program_section(path, &machine, {.corrected = true});
  const report::Json& columns = section["columns"];
  CHECK(number(columns["x"], 2) == Approx(3));
  CHECK(number(columns["cx"], 1) == Approx(80));  // um
  CHECK(number(columns["error"], 0) == Approx(50));
  CHECK(number(columns["s4"], 0) == Approx(1200));  // mm
  CHECK(number(columns["force"], 0) == Approx(100));
  CHECK(number(columns["block"], 1) == Approx(20));  // ms
  CHECK(number(columns["feed"], 1) == Approx(600));  // mm/min
  CHECK(number(columns["qw"], 0) == Approx(1));
  CHECK(columns["cx"]["unit"] == "um");
  CHECK(section["blocks"].size() == 1);
  CHECK(section["blocks"][0][1] == "G1 X1");
}

TEST_CASE("the worst places of a path point at it") {
  const machine::MachineModel machine = model();
  compensate::DrawnPath path{{point(machine, 1, 0.05), point(machine, 2, 0.08), point(machine, 3, 0.02)}, 3};
  path.points[2].tension[4] = 400;
  const report::Json section = report::program_section(path, &machine, {.corrected = true});
  std::size_t met = 0;
  for (const report::Json& place : section["worst"]) {
    if (place["what"] == "largest correction") {
      ++met;
      CHECK(place["point"] == 1);
      CHECK(place["value"].get<double>() == Approx(80));
    }
    if (place["what"] == "largest strut force") {
      ++met;
      CHECK(place["point"] == 2);
    }
    CHECK(place["what"] != "fastest");  // nobody knows a speed
  }
  CHECK(met == 2);
}

TEST_CASE("a path that nothing corrects has no columns of it") {
  const machine::MachineModel machine = model();
  const compensate::DrawnPath path{{point(machine, 1, 0)}, 1};
  const report::Json section = report::program_section(path, &machine, {});
  CHECK_FALSE(section["columns"].contains("cx"));
  CHECK_FALSE(section["columns"].contains("left"));
  for (const report::Json& track : section["tracks"]) {
    for (const report::Json& key : track["keys"]) CHECK(section["columns"].contains(key.get<std::string>()));
  }
  for (const report::Json& key : section["colours"]) CHECK(section["columns"].contains(key.get<std::string>()));
}

TEST_CASE("a path is coloured by its tools where there are several") {
  const machine::MachineModel machine = model();
  compensate::DrawnPath path{{point(machine, 1, 0), point(machine, 2, 0)}, 2};
  const auto is_colour = [&](std::string_view wanted) {
    const report::Json section = report::program_section(path, &machine, {});
    const report::Json& keys = section["colours"];
    return std::find(keys.begin(), keys.end(), wanted) != keys.end();
  };
  CHECK(is_colour("kind"));
  CHECK_FALSE(is_colour("tool"));
  path.points.back().recorded.tool = 7;
  CHECK(is_colour("tool"));
}

}  // namespace
}  // namespace plumbline

// move.cpp is tested here as well, since the reader alone makes moves.
#include "compensate/move_reader.hpp"

#include <vector>

#include <catch2/catch.hpp>

#include "compensate/opened.hpp"

using namespace plumbline;

namespace {

// The end of each move in W.
std::vector<AxisWords> ends_of(const std::string& text, const Job& job) {
  const Opened opened(text, job);
  compensate::MoveReader reader = reader_of(opened);
  std::vector<AxisWords> ends;
  while (const compensate::Move* const move = reader.next_move()) {
    ends.push_back(move->path.target(1, move->seconds).pose);
  }
  return ends;
}

}  // namespace

TEST_CASE("a move has its way through W, its time and its pieces") {
  const Opened opened("G21 G90 G94 S100 M3\nG1 X6 F360\nG95 G1 X0 F0.5\nM2\n", standing_at_zero());
  compensate::MoveReader reader = reader_of(opened);
  const compensate::Move* move = reader.next_move();
  REQUIRE(move != nullptr);
  CHECK(move->seconds.value() == Approx(1));
  CHECK(move->pieces == 6);  // of 1 mm
  CHECK(move->path.line == 2);
  CHECK(move->path.target(0.5, move->seconds).pose == AxisWords{{3, 0, -1008, 0, 0, 0}});
  CHECK(reader.begin_s() == 0);
  move = reader.next_move();
  REQUIRE(move != nullptr);
  CHECK(move->duration.value() == Approx(12));  // revolutions
  CHECK_FALSE(move->seconds.has_value());
  CHECK(reader.begin_s() == Approx(1));
  CHECK(reader.next_move() == nullptr);
  CHECK(reader.blocks() == 4);
}

TEST_CASE("a rapid is looked at every 10 mm, where it is known where it begins") {
  const Opened opened("G21 G90\nG0 X0 Y0 Z0 A0 B0 C0\nG0 X25\nM2\n");
  compensate::MoveReader reader = reader_of(opened);
  const compensate::Move* move = reader.next_move();
  REQUIRE(move != nullptr);
  CHECK_FALSE(move->begin_known);
  CHECK(move->pieces == 1);
  move = reader.next_move();
  REQUIRE(move != nullptr);
  CHECK(move->begin_known);
  CHECK(move->pieces == 3);
  CHECK_FALSE(move->seconds.has_value());
}

TEST_CASE("moves in machine coordinates and to unknown positions are left out, and waits take their time") {
  const Opened opened("G21 G90 G94\nG0 X1\nG0 X0 Y0 Z0 A0 B0 C0\nG4 P2\nG53 G0 Z0\nG0 Z3\nM2\n");
  compensate::MoveReader reader = reader_of(opened);
  REQUIRE(reader.next_move() != nullptr);
  CHECK(reader.passed_moves() == 1);
  const compensate::Move* const move = reader.next_move();
  REQUIRE(move != nullptr);
  CHECK(move->path.line == 6);
  CHECK(reader.passed_moves() == 2);
  CHECK(reader.begin_s() == Approx(2));
}

TEST_CASE("a tool is told once, before the first move that it makes") {
  Job job = standing_at_zero();
  job.program.tools = nc::ToolTable({{1, 85, {}, 2.5, 30, {}}});
  job.program.keeps_position = {6};
  const Opened opened("G21 G90 G94\nG1 X1 F100\nT1 M6 G43 H1\nG4 P1\nG1 X2\nG1 X3\nM2\n", job);
  compensate::MoveReader reader = reader_of(opened);
  REQUIRE(reader.next_move() != nullptr);
  REQUIRE(reader.new_tool().has_value());  // the first always is
  REQUIRE(reader.next_move() != nullptr);
  const std::optional<compensate::ToolInSpindle> tool = reader.new_tool();
  REQUIRE(tool.has_value());
  CHECK(tool->length == Approx(0.085));
  CHECK(tool->mass == Approx(2.5));
  CHECK(tool->along == Approx(0.03));
  REQUIRE(reader.next_move() != nullptr);
  CHECK_FALSE(reader.new_tool().has_value());
}

TEST_CASE("rotary axes that no word names are taken to stand at zero from the first move of which one is not known") {
  const Opened opened("G21 G90 G94\nG0 X0 Y0 Z0\nG1 X5 F100\nM2\n");
  compensate::MoveReader reader = reader_of(opened);
  CHECK(reader.at_zero().empty());
  const compensate::Move* const move = reader.next_move();
  REQUIRE(move != nullptr);
  CHECK(reader.at_zero() == AxisSet::rotary());
  CHECK(move->path.fixed == AxisSet::rotary());
  CHECK(move->path.writable() == AxisSet::linear());

  const Opened known("G21 G90 G94\nG0 X0 Y0 Z0\nG1 X5 F100\nM2\n", standing_at_zero());
  compensate::MoveReader of_known = reader_of(known);
  REQUIRE(of_known.next_move() != nullptr);
  CHECK(of_known.at_zero().empty());
}

TEST_CASE("an axis that the work offset turns is not taken to stand at zero") {
  Job job;
  job.program.work_offsets[0]->origin[Axis::B] = 3;
  const Opened opened("G21 G90 G94\nG0 X0 Y0 Z0\nM2\n", job);
  compensate::MoveReader reader = reader_of(opened);
  reader.next();
  const nc::Step* const step = reader.next();
  REQUIRE(step != nullptr);
  const compensate::UnknownPosition unknown = reader.unknown(*step, step->motions.front());
  CHECK(unknown.turned == AxisSet{Axis::B});
  CHECK(unknown.missing == AxisSet{Axis::B});
  CHECK(unknown.moved.empty());
  CHECK_FALSE(unknown.none());
}

TEST_CASE("a cut from where nobody knows cannot be followed") {
  const auto read = [](const std::string& text) { return testing::refusal_of([&] { ends_of(text, {}); }); };
  const Diagnostic cut = read("G21 G90 G94\nG1 X5 F100\nM2\n");
  CHECK(cut.code == "walk-position-unknown");
  CHECK(cut.place.line == 2);
  CHECK(read("G21 G90 G94\nG0 X0 Y0 Z0\nG1 X5 F100\nM2\n").code.empty());
}

TEST_CASE("every pose gets the error at the touch-off") {
  const Opened opened("G21 G90\nG0 X1 Y2 Z3\nM2\n", standing_at_zero());
  compensate::ReaderSettings settings = opened.reader_settings();
  settings.touch_off_error = {{0.5, 0, 0.25, 0, 0, 0}};
  compensate::MoveReader reader(opened.source, opened.dialect, opened.job.program, settings);
  const compensate::Move* const move = reader.next_move();
  REQUIRE(move != nullptr);
  CHECK(move->path.at_rest(move->motion->to).pose == AxisWords{{1.5, 2, -1004.75, 0, 0, 0}});
  CHECK(move->path.in_base_frame(move->motion->to) == AxisWords{{1, 2, -1005, 0, 0, 0}});
}

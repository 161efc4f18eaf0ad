#include "measure/run_table.hpp"

#include <catch2/catch.hpp>

#include "measure/runs.hpp"
#include "support/scratch.hpp"

using namespace plumbline;
using namespace plumbline::measure;
using namespace plumbline::testing;

namespace {

Run empty_run(Direction direction) {
  Run run = circle_run({0, 0, -1}, {0, 0, 0}, direction, 0);
  for (auto& torque : run.torque) torque.clear();
  return run;
}

Run read(const std::string& text, Direction direction = Direction::ccw) {
  const Scratch scratch;
  Run run = empty_run(direction);
  read_run_table(scratch.file("run.csv", text), run);
  return run;
}

// Rows with time, every 30 deg at 1000 mm/min on 144 mm.
std::string timed_table(double seconds_per_row = 4.5239) {
  std::string text = "time_s,angle_deg,radial_um\n";
  for (int i = 0; i < 12; ++i) text += std::to_string(seconds_per_row * i) + "," + std::to_string(30 * i) + ",1\n";
  return text;
}

// Twelve rows with time alone.
std::string by_time(double seconds_per_row) {
  std::string text = "time_s,radial_um\n";
  for (int i = 0; i < 12; ++i) text += std::to_string(seconds_per_row * i) + ",1\n";
  return text;
}

constexpr const char* kTorques = "torque1_Nm,torque2_Nm,torque3_Nm,torque4_Nm,torque5_Nm,torque6_Nm";

}  // namespace

TEST_CASE("columns may come in any order, with blanks, a byte order mark and Windows line ends") {
  std::string text = "\xEF\xBB\xBF radial_um , angle_deg\r\n";
  for (int i = 0; i < 12; ++i) text += std::to_string(i) + ", " + std::to_string(30 * i) + "\r\n\r\n";
  const Run run = read(text);
  REQUIRE(run.samples() == 12);
  CHECK(run.radial[5] == Approx(5e-6));
  CHECK(run.angle[5] == Approx(150 * kDeg));
}

TEST_CASE("time follows from the angle and the feed, and the angle from the time") {
  const Run ccw = read(table_text());
  CHECK(ccw.time[3] == Approx(90 * kDeg * 0.144 / ccw.feed));
  const Run cw = read(table_text(-1), Direction::cw);
  CHECK(cw.time[3] == Approx(ccw.time[3]));
  CHECK(read(by_time(4.5239), Direction::cw).angle[3] == Approx(-90 * kDeg).epsilon(1e-4));
}

TEST_CASE("tables go out as they came in") {
  const std::string text = table_text();
  const Run run = read(text);
  const std::string again = run_table_text(run);
  CHECK(again.starts_with("angle_deg,radial_um\n0,0.2500\n30,1.2500\n"));
  CHECK(read(again).radial == run.radial);
}

TEST_CASE("a number with an exponent keeps its digits") {
  std::string text = "time_s,radial_um\n0,5e-3\n";
  for (int i = 1; i < 12; ++i) text += std::to_string(45239 * i) + "e-4,1\n";
  const Run run = read(text);
  const Run again = read(run_table_text(run));
  CHECK(again.time == run.time);
  CHECK(again.radial[0] == Approx(5e-9));
}

TEST_CASE("every flaw of a table is refused at its row and column") {
  struct Bad {
    std::string text, code;
    std::size_t line, column;
    std::string says;
    Direction direction = Direction::ccw;
  };
  const std::string good = table_text();
  const auto with = [&](const std::string& from, const std::string& into) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), into);
  };
  const std::vector<Bad> cases{
      {with("radial_um", "radial_mm"), "table-unknown-column", 1, 11, "did you mean `radial_um`"},
      {"angle_deg;radial_um\n0;1\n", "table-unknown-column", 1, 1, "separated by semicolons"},
      {"angle_deg,radial_um\r0,1\r", "csv-line-end", 1, 20, "line ends of Unix"},
      {with("radial_um", "angle_deg"), "table-same-column", 1, 11, "leave one"},
      {"radial_um\n1\n", "table-missing-column", 1, 1, "where on the circle"},
      {"angle_deg\n1\n", "table-missing-column", 1, 1, "nothing was measured"},
      {"angle_deg,torque1_Nm,torque2_Nm\n1,2,3\n", "table-missing-column", 1, 1, "torque3_Nm, torque4_Nm"},
      {with("60,2.25", "60,2.25,3"), "table-columns", 4, 1, "3 columns"},
      {with("60,2.25", "60,nan"), "table-number", 4, 4, "no finite number"},
      {with("60,2.25", "60,"), "table-number", 4, 4, "leave the whole column out"},
      {with("60,2.25", "60,2.25e6"), "table-number", 4, 4, "beyond 20000 um"},
      {with("60,2.25", "15,2.25"), "table-angle", 4, 1, "from 30 to 15"},
      {table_text(-1), "table-angle", 3, 1, "direction"},
      {good, "table-angle", 3, 1, "the run is cw", Direction::cw},
      {good + "0,1\n30,1\n", "table-angle", 15, 1, "one turn"},
      {"angle_deg,radial_um\n0,1\n30,1\n", "table-too-few", 1, 1, "at least 8"},
      {"", "table-missing-column", 0, 1, ""},
      {timed_table(-1), "table-time", 3, 1, "does not go on"},
      {by_time(4.5239 * 12), "table-time", 13, 1, "11 times around"},
      {by_time(0.01), "table-too-few", 1, 1, "of the circle"},
      {"angle_deg,radial_um\n0,1\n1,1\n2,1\n3,1\n4,1\n5,1\n6,1\n7,1\n", "table-too-few", 1, 1, "cover 7 deg"},
      {timed_table(4523.9), "table-feed", 1, 1, "time_s in seconds"},
  };
  for (const Bad& bad : cases) {
    INFO(bad.text.substr(0, 60) << " " << bad.code);
    const Diagnostic d = refusal_of([&] { read(bad.text, bad.direction); });
    INFO(to_text(d));
    CHECK(d.code == bad.code);
    CHECK(d.place.line == bad.line);
    CHECK(d.place.column == bad.column);
    CHECK((d.message + d.help).find(bad.says) != std::string::npos);
  }
  CHECK(read(timed_table()).samples() == 12);
}

TEST_CASE("single rows without a reading are left out and listed") {
  std::string text = "angle_deg,radial_um\n";
  for (int i = 0; i < 60; ++i) {
    text += std::to_string(6 * i) + "," + (i == 10 ? "" : i == 20 ? "NaN" : std::to_string(i)) + "\n";
  }
  const Run run = read(text);
  CHECK(run.samples() == 58);
  CHECK(run.left_out == std::vector<std::size_t>{12, 22});
  CHECK(run.angle[10] / kDeg == Approx(66));
  // where it was taken has to be there
  text.replace(text.find("\n66,"), 4, "\n,");
  CHECK(refusal_of([&] { read(text); }).code == "table-number");
}

TEST_CASE("who judges data takes what a table says otherwise than the dataset, and knows of it") {
  const Scratch scratch;
  Run run = empty_run(Direction::cw);
  measure::TableOptions options;
  options.believe = measure::Believe::the_table;
  measure::read_run_table(scratch.file("run.csv", table_text()), run, options);
  CHECK(run.direction == Direction::ccw);
  CHECK(run.contradictions == std::vector<measure::Contradiction>{measure::Contradiction::direction});
  Run fast = empty_run(Direction::ccw);
  measure::read_run_table(scratch.file("fast.csv", timed_table(4523.9)), fast, options);
  CHECK(fast.contradictions == std::vector<measure::Contradiction>{measure::Contradiction::feed});
}

TEST_CASE("torques alone are a run, too") {
  std::string text = std::string("angle_deg,") + kTorques + "\n";
  for (int i = 0; i < 12; ++i) text += std::to_string(30 * i) + ",1,2,3,4,5,6.5\n";
  const Run run = read(text);
  CHECK_FALSE(run.has_radial());
  REQUIRE(run.has_torque());
  CHECK(run.torque[5][11] == 6.5);
}

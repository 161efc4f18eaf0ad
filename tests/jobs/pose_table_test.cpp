// More tables that are none, each with its place, are in error_table_test.cpp.
#include "jobs/pose_table.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

TEST_CASE("poses are read in the order of the axes, wherever their columns stand") {
  const testing::Scratch scratch;
  const std::vector<jobs::PoseRow> rows = jobs::read_poses(
      scratch.file("p.csv", "c_deg,x_mm,y_mm,z_mm,a_deg,b_deg,note\n6,1,2,-1000.5,4,5,99\n\n0,0,0,0,0,0,0\n"));
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].pose == AxisWords{{1, 2, -1000.5, 4, 5, 6}});
  CHECK(rows[0].place.line == 2);
  CHECK(rows[1].place.line == 4);
  CHECK(rows[1].place.file == scratch / "p.csv");
}

TEST_CASE("a table without rows, or without one of the six columns, is refused") {
  const testing::Scratch scratch;
  const Diagnostic empty = testing::refusal_of(
      [&] { jobs::read_poses(scratch.file("p.csv", "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n,,,,,\n")); });
  CHECK(empty.code == "csv-no-rows");
  CHECK(empty.place.line == 1);
  const Diagnostic header =
      testing::refusal_of([&] { jobs::read_poses(scratch.file("p.csv", "x_mm,y_mm,z_mm,a_deg,b_deg\n1,2,3,4,5\n")); });
  CHECK(header.code == "csv-header");
  CHECK(header.message == "the first line does not name a column c_deg");
  CHECK(header.help == "begin the file with the line x_mm,y_mm,z_mm,a_deg,b_deg,c_deg");
  CHECK(testing::refusal_of([&] { jobs::read_poses(scratch / "none.csv"); }).code == "file-missing");
}

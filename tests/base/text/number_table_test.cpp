#include "base/text/number_table.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

using namespace plumbline;

namespace {

const std::vector<NumberColumn> kForceColumns{{"x_mm", "mm"}, {"force_N", "N"}, {"tilt_deg", "deg", false}};

NumberTable forces_in(std::string_view text) {
  return read_number_table("forces.csv", text, kForceColumns, "x_mm,force_N");
}

Diagnostic refused_forces(std::string_view text) {
  return testing::refusal_of([&] { forces_in(text); });
}

}  // namespace

TEST_CASE("columns come in the order that was asked for, wherever they stand") {
  const NumberTable table = forces_in("force_N,note,x_mm\n-3.5,17,1e2\n4,x,0\n");
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0].values[0] == 100);
  CHECK(table.rows[0].values[1] == -3.5);
  CHECK(table.rows[1].values[1] == 4);
  CHECK(table.rows[1].place.line == 3);
  CHECK(table.header.line == 1);
}

TEST_CASE("a column that may be missing has no numbers where it is") {
  const NumberTable without = forces_in("x_mm,force_N\n1,2\n");
  CHECK(without.has == std::vector<bool>{true, true, false});
  CHECK(std::isnan(without.rows.at(0).values.at(2)));
  const NumberTable with = forces_in("x_mm,force_N,tilt_deg\n1,2,-5\n");
  CHECK(with.has == std::vector<bool>{true, true, true});
  CHECK(with.rows.at(0).values.at(2) == -5);
}

TEST_CASE("rows of empty fields are passed over, and the others keep their line") {
  const NumberTable table = forces_in("x_mm,force_N\n,\n1,2\n , \n,,,\n3,4\n");
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0].place.line == 3);
  CHECK(table.rows[1].place.line == 6);
}

TEST_CASE("a table that lacks a column, a field or a number is refused there") {
  const Diagnostic header = refused_forces("x_mm,torque\n1,2\n");
  CHECK(header.code == "csv-header");
  CHECK(header.message == "the first line does not name a column force_N");
  CHECK(header.help == "begin the file with the line x_mm,force_N");
  CHECK(refused_forces("x_mm;force_N\n1;2\n").help.find("semicolons") != std::string::npos);
  for (const char* const twice :
       {"x_mm,force_N,x_mm\n1,2,3\n", "force_N,x_mm,force_N\n", "x_mm,force_N,tilt_deg,tilt_deg\n"})
    CHECK(refused_forces(twice).code == "csv-same-column");
  CHECK(forces_in("x_mm,note,force_N,note\n1,2,3,4\n").rows.size() == 1);
  const Diagnostic columns = refused_forces("x_mm,force_N\n1,2\n1,2,3\n");
  CHECK(columns.code == "csv-columns");
  CHECK(columns.message == "row 3 has 3 columns, and the first line names 2");
  const Diagnostic number = refused_forces("x_mm,force_N\n1,2;5\n");
  CHECK(number.code == "csv-number");
  CHECK(number.place.line == 2);
  CHECK(number.place.column == 3);
  CHECK(number.help == "expected a finite number in N, as in -12.5");
}

TEST_CASE("a million is the largest number that a table may hold") {
  CHECK(forces_in("x_mm,force_N\n1000000,-1000000\n").rows.at(0).values[1] == -1e6);
  CHECK(refused_forces("x_mm,force_N\n1000001,0\n").code == "csv-number");
  CHECK(refused_forces("x_mm,force_N\n0,inf\n").code == "csv-number");
  CHECK(forces_in("x_mm,force_N,unread\n1,2,1e9\n").rows.size() == 1);  // of a column that nobody asked for
}

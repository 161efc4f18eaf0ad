#include "base/text/csv.hpp"

#include <catch2/catch.hpp>

#include "support/scratch.hpp"

namespace plumbline {
namespace {

TEST_CASE("lines of a table are told with their fields, places and numbers") {
  CsvLines lines("table.csv", "\xEF\xBB\xBF a ,b\r\n\n  \t\n1, -2 ,\n");
  REQUIRE(lines.next());
  CHECK(lines.number() == 1);
  REQUIRE(lines.fields().size() == 2);
  CHECK(lines.fields()[0].text == "a");
  CHECK(lines.fields()[0].column == 2);
  CHECK(lines.fields()[1].text == "b");
  REQUIRE(lines.next());
  CHECK(lines.number() == 4);
  const std::vector<CsvField> fields = lines.fields();
  REQUIRE(fields.size() == 3);
  CHECK(fields[1].text == "-2");
  CHECK(fields[2].text.empty());
  const Place place = lines.place(fields[1]);
  CHECK(place.file == "table.csv");
  CHECK(place.line == 4);
  CHECK(place.column == 4);
  CHECK(place.length == 2);
  CHECK(place.text == "1, -2 ,");
  CHECK_FALSE(lines.next());
}

TEST_CASE("a carriage return inside a line is refused, at its end it is none") {
  for (const char* const text : {"a,b\r1,2\r", "a,b\n1\r,2\n", "\ra,b\r\n"}) {
    INFO(text);
    const Diagnostic refused = testing::refusal_of([&] {
      CsvLines lines("table.csv", text);
      while (lines.next()) continue;
    });
    CHECK(refused.code == "csv-line-end");
    CHECK(refused.help.find("line ends") != std::string::npos);
  }
  CsvLines lines("table.csv", "a,b\r\r\n1,2\r");
  CHECK(lines.next());
  CHECK(lines.next());
}

TEST_CASE("columns between semicolons or tabs are told") {
  CHECK(other_separator("x_mm;y_mm").find("semicolons") != std::string::npos);
  CHECK(other_separator("1,5;2,5").find("semicolons") != std::string::npos);
  CHECK(other_separator("x_mm\ty_mm").find("tabs") != std::string::npos);
  CHECK(other_separator("x_mm,y_mm\t").empty());
  CHECK(other_separator("x_mm").empty());
}

TEST_CASE("an empty table has a first line to point at") {
  CsvLines lines("empty.csv", "");
  CHECK_FALSE(lines.next());
  CHECK(lines.place().line == 1);
}

}  // namespace
}  // namespace plumbline

#include "jobs/error_table.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "base/text/number_text.hpp"
#include "machine/model_file.hpp"
#include "report/program/error_text.hpp"
#include "support/scratch.hpp"

using namespace plumbline;

namespace {

std::vector<std::vector<std::string>> cells_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, {""});
  for (const char c : text) {
    if (c == '\n') {
      rows.push_back({""});
    } else if (c == ',') {
      rows.back().emplace_back();
    } else {
      rows.back().back() += c;
    }
  }
  rows.pop_back();
  return rows;
}

machine::MachineModel pm600() { return machine::read_model(testing::source_file("models/pm600-like.toml")); }

std::string table_of(const testing::Scratch& scratch, const std::string& poses) {
  OutputFile out(scratch.path("out.csv"));
  report::ErrorTable table(out);
  jobs::error_table(pm600(), jobs::read_poses(scratch.file("in.csv", poses)),
                    [&](const jobs::PoseError& error) { table.add(error); });
  out.commit();
  return scratch.text("out.csv");
}

}  // namespace

TEST_CASE("the golden table comes out, to its own digits") {
  const testing::Scratch scratch;
  const std::string golden = read_text(testing::source_file("tests/golden/pm600-like-static.csv"));
  const auto expected = cells_of(golden);
  const auto got = cells_of(table_of(scratch, golden));
  REQUIRE(got.size() == expected.size());
  CHECK(got.front() == expected.front());
  for (std::size_t row = 1; row < got.size(); ++row) {
    REQUIRE(got[row].size() == expected[row].size());
    for (std::size_t i = 0; i < got[row].size(); ++i) {
      INFO("row " << row + 1 << ", " << expected.front()[i]);
      CHECK(got[row][i].size() - got[row][i].find('.') == expected[row][i].size() - expected[row][i].find('.'));
      CHECK(std::abs(*parse_number(got[row][i]) - *parse_number(expected[row][i])) <= 1e-6);
    }
  }
}

TEST_CASE("columns are found by name, others are left out") {
  const testing::Scratch scratch;
  const std::string plain = table_of(scratch, "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n1,2,-1000,3,4,5\n");
  CHECK(table_of(scratch, "\xEF\xBB\xBFnote, c_deg,b_deg,a_deg,z_mm,y_mm,x_mm\r\nhello,5,4,3, -1000 ,2,1\r\n\r\n") ==
        plain);
}

TEST_CASE("a table of poses that is none is refused at its place") {
  struct Case {
    const char* text;
    const char* code;
    std::size_t line, column;
  };
  const testing::Scratch scratch;
  const std::string header = "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n";
  for (const Case& c : {Case{"", "csv-header", 1, 1}, Case{"x,y,z,a,b,c\n1,2,3,4,5,6\n", "csv-header", 1, 1},
                        Case{"x_mm;y_mm;z_mm;a_deg;b_deg;c_deg\n", "csv-header", 1, 1}}) {
    INFO(c.text);
    const Diagnostic d = testing::refusal_of([&] { table_of(scratch, c.text); });
    CHECK(d.code == c.code);
    CHECK(d.place.line == c.line);
  }
  for (const Case& c : {Case{"0,0,-1008,0,0,0\n1,2,3\n", "csv-columns", 3, 1},
                        Case{"0,0,-1008,nan,0,0\n", "csv-number", 2, 11}, Case{"0,0,-1008,0,0,\n", "csv-number", 2, 15},
                        Case{"0,0,-1008,0,0,1e9\n", "csv-number", 2, 15}, Case{"0,0,x,0,0,0\n", "csv-number", 2, 5},
                        Case{"", "csv-no-rows", 1, 1}, Case{",,,,,\n", "csv-no-rows", 1, 1}}) {
    INFO(c.text);
    const Diagnostic d = testing::refusal_of([&] { table_of(scratch, header + c.text); });
    CHECK(d.code == c.code);
    CHECK(d.place.line == c.line);
    CHECK(d.place.column == c.column);
    CHECK_FALSE(d.help.empty());
  }
}

TEST_CASE("a pose beyond the limits is in the table, and warned of") {
  const testing::Scratch scratch;
  scratch.file("p.csv", "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n0,0,-1008,0,0,0\n0,0,-1300,0,0,0\n0,0,-1350,0,0,0\n");
  const machine::MachineModel model = pm600();
  std::size_t rows = 0;
  const jobs::ErrorTableSummary summary =
      jobs::error_table(model, jobs::read_poses(scratch.path("p.csv")), [&](const jobs::PoseError&) { ++rows; });
  CHECK(rows == 3);
  CHECK(summary.beyond_travel == 2);
  REQUIRE(summary.first_beyond);
  CHECK(summary.first_beyond->place.line == 3);
  CHECK(summary.first_beyond->severity == Severity::warning);
}

TEST_CASE("a pose where the machine cannot stand is refused with its row") {
  const testing::Scratch scratch;
  const Diagnostic d = testing::refusal_of(
      [&] { table_of(scratch, "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg\n0,0,-1008,0,0,0\n0,0,-1008,0,0,90\n"); });
  CHECK(d.code == "error-unreachable");
  CHECK(d.place.line == 3);
}
